// Point sets that several tests take, and what they ask of them

#ifndef CURVATURE_AWARE_SIMPLIFICATION_3_INPUTS_H
#define CURVATURE_AWARE_SIMPLIFICATION_3_INPUTS_H

#include "surfaces.h"

#include <CGAL/Curvature_aware_simplification_3/internal/features/shared_features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/Sample_neighbors.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>
#include <CGAL/curvature_aware_simplify_point_set.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <vector>

namespace inputs {

using namespace CGAL::Curvature_aware_simplification_3::internal;
using Tag = CGAL::Parallel_if_available_tag;
namespace np = CGAL::parameters;

inline const std::function<bool(double)> no_callback;

inline std::vector<Point> with_noise(std::vector<Point> points, double sigma, unsigned int seed)
{
  CGAL::Random random(seed);
  for (Point& p : points)
  {
    const double x = surfaces::normal_deviate(random), y = surfaces::normal_deviate(random);
    p = p + sigma * Vector(x, y, surfaces::normal_deviate(random));
  }
  return points;
}

// uniform in the box [-w, w]^3, put behind the points
inline void add_outliers(std::vector<Point>& points, std::size_t n, double w, unsigned int seed)
{
  CGAL::Random random(seed);
  for (std::size_t i = 0; i < n; ++i)
  {
    const double x = random.uniform_real(-w, w), y = random.uniform_real(-w, w);
    points.emplace_back(x, y, random.uniform_real(-w, w));
  }
}

inline double distance_to_sphere(const Point& p)
{
  return std::abs(std::sqrt((p - CGAL::ORIGIN).squared_length()) - 1.);
}

template <typename NamedParameters = np::Default_named_parameters>
std::vector<Point> simplified(const std::vector<Point>& points,
                              const NamedParameters& parameters = np::default_values())
{
  std::vector<Point> output;
  CGAL::curvature_aware_simplify_point_set<Tag>(points, std::back_inserter(output), parameters);
  return output;
}

template <typename Distance>
double mean_distance(const std::vector<Point>& points, const Distance& distance)
{
  double sum = 0.;
  for (const Point& p : points)
    sum += distance(p);
  return sum / static_cast<double>(points.size());
}

template <typename Function>
std::vector<Point> each(std::vector<Point> points, const Function& function)
{
  for (Point& p : points)
    p = function(p);
  return points;
}

// about all axes
inline Point turned(const Point& p)
{
  const double c = std::cos(0.7), s = std::sin(0.7);
  return Point(p.y(), c * p.z() - s * p.x(), s * p.z() + c * p.x());
}

inline Point turned_back(const Point& p)
{
  const double c = std::cos(0.7), s = std::sin(0.7);
  return Point(-s * p.y() + c * p.z(), p.x(), c * p.y() + s * p.z());
}

inline double waves(double x, double y)
{
  return 40. * std::sin(0.03 * x) * std::cos(0.025 * y) + 0.2 * x;
}

inline std::vector<Point> cube(std::size_t n, unsigned int seed)
{
  return surfaces::sample(n, seed, [](CGAL::Random& r) {
    const double a = r.uniform_real(0., 1.), b = r.uniform_real(0., 1.), c = r.uniform_int(0, 1);
    const int axis = r.uniform_int(0, 2);
    return axis == 0 ? Point(c, a, b) : axis == 1 ? Point(a, c, b) : Point(a, b, c);
  });
}

// a random patch of z = f(x, y) around the origin
template <typename Height>
std::vector<Point> patch(std::size_t n, unsigned int seed, const Height& height)
{
  std::vector<Point> points = surfaces::square(n, seed);
  for (Point& p : points)
    p = Point(p.x() - 0.5, p.y() - 0.5, height(p.x() - 0.5, p.y() - 0.5));
  return points;
}

// n x n directions a distance of 1 apart, measured again and again, with noise along them
inline std::vector<Point> frames_of_a_scanner_at_rest(int n, int frames, double sigma,
                                                      unsigned int seed)
{
  CGAL::Random random(seed);
  std::vector<Point> points;
  for (int frame = 0; frame < frames; ++frame)
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        points.emplace_back(i, j, waves(i, j) + sigma * surfaces::normal_deviate(random));
  return points;
}

inline Cloud cloud_of(const std::vector<Point>& points, double relative_error = 1e-16)
{
  return make_cloud<Tag>(points, relative_error, Progress(no_callback));
}

// They stay those of the vector.
inline Neighbor_indices neighbor_indices(const std::vector<std::size_t>& indices)
{
  return CGAL::make_range(indices.data(), indices.data() + indices.size());
}

// These points, in this order
inline Searchable_points searchable(const std::vector<Point>& points)
{
  Searchable_points result;
  result.points = points;
  result.rebuild_search<Tag>();
  return result;
}

inline Shared_features shared_features_of(const Searchable_points& cloud, std::size_t k = 16)
{
  return compute_shared_features<Tag, CGAL::Default_diagonalize_traits<double, 3>>(
      cloud, k, Progress(no_callback));
}

// distance to the nearest edge of the cube [0, 1]^3: the two smaller distances to its planes
inline double distance_to_edge(const Point& p)
{
  double d[3];
  for (int i = 0; i < 3; ++i)
    d[i] = std::min(std::abs(p[i]), std::abs(1. - p[i]));
  std::sort(d, d + 3);
  return std::sqrt(d[0] * d[0] + d[1] * d[1]);
}

// A frame of a depth camera: n x n pixels a distance of 1 apart, with depth rounded to multiples of
// `step`
template <typename Depth>
std::vector<Point> depth_frame(int n, double step, const Depth& depth)
{
  std::vector<Point> points;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      points.emplace_back(i, j, step * std::round(depth(i, j) / step));
  return points;
}

inline Vector unit_vector(double x, double y, double z)
{
  return Vector(x, y, z) / std::sqrt(x * x + y * y + z * z);
}

inline const std::vector<Vector> axes_of_cameras = {
    unit_vector(1., 2., 4.), unit_vector(-3., 1., 4.), unit_vector(1., -4., 5.)};

inline Point rounded_along(const Vector& axis, const Point& p, double step)
{
  const double depth = (p - CGAL::ORIGIN) * axis;
  return p + (step * std::round(depth / step) - depth) * axis;
}

// Points of waves, one spacing apart, each as one of some cameras sees it; camera(point) is which
template <typename Camera>
std::vector<Point> seen_by_cameras(double step, const Camera& camera)
{
  CGAL::Random random(71);
  std::vector<Point> points;
  for (int i = 0; i < 30000; ++i)
  {
    const double x = random.uniform_real(0., 173.), y = random.uniform_real(0., 173.);
    const Point p(x, y, waves(x, y));
    points.push_back(rounded_along(axes_of_cameras[camera(p)], p, step));
  }
  return points;
}

// Each camera sees a strip of 100, and the strips overlap by a third of that.
inline std::size_t camera_of_strip(const Point& p)
{
  const std::size_t strip = static_cast<std::size_t>(p.x() * 5. / 173.);
  const std::size_t first = (std::min)(strip / 2, std::size_t(2));
  const bool is_either = strip % 2 == 1;
  return is_either && std::fmod(1000. * p.y(), 1.) < 0.5 ? first + 1 : first;
}

// Random points on both sides of a square plate, which is so many of their spacings thick
inline std::vector<Point> thin_plate(double thickness_in_spacings)
{
  const std::size_t number = 20000;
  const double spacing = std::sqrt(2. / std::sqrt(3.) / static_cast<double>(number));
  std::vector<Point> points;
  for (double z : {0., thickness_in_spacings * spacing})
    for (const Point& p : surfaces::square(number, z > 0. ? 39u : 40u))
      points.emplace_back(p.x(), p.y(), z);
  return points;
}

} // namespace inputs

#endif // CURVATURE_AWARE_SIMPLIFICATION_3_INPUTS_H
