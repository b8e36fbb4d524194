#ifndef CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_DEGRADATIONS_H
#define CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_DEGRADATIONS_H

#include <comparison/types.h>

#include <CGAL/Random.h>
#include <CGAL/centroid.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

// What scanning does to points. Lengths are fractions of the diagonal of the bounding box.
namespace comparison {

// normally distributed with mean 0 and variance 1 (Box and Muller)
inline double normal_deviate(CGAL::Random& random)
{
  const double u = 1. - random.uniform_real(0., 1.);
  return std::sqrt(-2. * std::log(u)) * std::cos(random.uniform_real(0., 2. * CGAL_PI));
}

// of three independent normal deviates
inline Vector normal_vector(CGAL::Random& random)
{
  const double x = normal_deviate(random), y = normal_deviate(random);
  return Vector(x, y, normal_deviate(random));
}

// Gaussian noise of standard deviation `sigma` in each coordinate
inline Points with_noise(Points points, double sigma, CGAL::Random& random)
{
  const double length = sigma * diagonal(points);
  for (Point& p : points)
    p = p + length * normal_vector(random);
  return points;
}

// Noise that grows along x, as with the distance from a scanner: from 0.2 to 1.8 times `sigma`
inline Points with_uneven_noise(Points points, double sigma, CGAL::Random& random)
{
  const CGAL::Bbox_3 box = CGAL::bbox_3(points.begin(), points.end());
  const double length = sigma * diagonal(points);
  for (Point& p : points)
  {
    const double here = length * (0.2 + 1.6 * (p.x() - box.xmin()) / box.x_span());
    p = p + here * normal_vector(random);
  }
  return points;
}

// uniform in the box grown by 5 % of its extent on every side
inline Point random_point_around(const CGAL::Bbox_3& box, CGAL::Random& random)
{
  double c[3];
  for (int j = 0; j < 3; ++j)
  {
    const double margin = 0.05 * (box.max(j) - box.min(j));
    c[j] = random.uniform_real(box.min(j) - margin, box.max(j) + margin);
  }
  return Point(c[0], c[1], c[2]);
}

// A noise of 0.05 %, and `share` times the number of points more, anywhere
inline Points with_outliers(const Points& points, double share, CGAL::Random& random)
{
  const CGAL::Bbox_3 box = CGAL::bbox_3(points.begin(), points.end());
  Points result = with_noise(points, 0.0005, random);
  const double count = share * static_cast<double>(points.size());
  for (double i = 0.; i < count; i += 1.)
    result.push_back(random_point_around(box, random));
  return result;
}

// A noise of 0.05 %, and `share` times the number of points more, in clusters of 5 to 59 normally
// distributed ones, as matching photographs leaves in the air
inline Points with_clusters(const Points& points, double share, CGAL::Random& random)
{
  const CGAL::Bbox_3 box = CGAL::bbox_3(points.begin(), points.end());
  const double sigma = 0.005 * diagonal(points);
  Points result = with_noise(points, 0.0005, random);
  const double count = static_cast<double>(points.size()) * (1. + share);
  while (static_cast<double>(result.size()) < count)
  {
    const Point center = random_point_around(box, random);
    for (int left = random.get_int(5, 60); left > 0; --left)
      result.push_back(center + sigma * normal_vector(random));
  }
  return result;
}

// Points are kept with a probability that falls exponentially along x, from 1 to 1 / `factor`.
inline Points with_falling_density(const Points& points, double factor, CGAL::Random& random)
{
  const CGAL::Bbox_3 box = CGAL::bbox_3(points.begin(), points.end());
  Points result;
  for (const Point& p : points)
    if (random.uniform_real(0., 1.) < std::pow(factor, -(p.x() - box.xmin()) / box.x_span()))
      result.push_back(p);
  return result;
}

// Without the points within `radius` of one of them
inline Points with_hole(const Points& points, double radius, CGAL::Random& random)
{
  const Point center =
      points[static_cast<std::size_t>(random.get_int(0, static_cast<int>(points.size())))];
  const double length = radius * diagonal(points);
  Points result;
  for (const Point& p : points)
    if (CGAL::squared_distance(p, center) > length * length)
      result.push_back(p);
  return result;
}

// `share` times the number of points more, exact copies of random ones
inline Points with_duplicates(const Points& points, double share, CGAL::Random& random)
{
  Points result = points;
  const double count = share * static_cast<double>(points.size());
  for (double i = 0.; i < count; i += 1.)
    result.push_back(
        points[static_cast<std::size_t>(random.get_int(0, static_cast<int>(points.size())))]);
  return result;
}

// The direction of a scanner: oblique, so that it sees all faces of a part at an angle
inline Vector oblique_direction()
{
  return Vector(1., 2., 3.) / std::sqrt(14.);
}

// Only the points on planes that are `distance` apart, within 5 % of that: the lines of a scanner,
// which measures points more densely along them than across
inline Points with_scan_lines(const Points& points, double distance)
{
  const double length = distance * diagonal(points);
  const Vector across = oblique_direction();
  Points result;
  for (const Point& p : points)
  {
    const double line = across * (p - CGAL::ORIGIN) / length;
    if (std::abs(line - std::round(line)) < 0.05)
      result.push_back(p);
  }
  return result;
}

// Gaussian noise of standard deviation `sigma` along the rays of a scanner, which are in the planes
// of its lines: these stay what they are
inline Points with_range_noise(Points points, double sigma, CGAL::Random& random)
{
  const double length = sigma * diagonal(points);
  const Vector ray = Vector(3., 0., -1.) / std::sqrt(10.);
  for (Point& p : points)
    p = p + length * normal_deviate(random) * ray;
  return points;
}

// Coordinates rounded to multiples of `step`, as file formats with integers do
inline Points with_rounding(Points points, double step)
{
  const double length = step * diagonal(points);
  const auto rounded = [&](double x) { return length * std::round(x / length); };
  for (Point& p : points)
    p = Point(rounded(p.x()), rounded(p.y()), rounded(p.z()));
  return points;
}

// Depth rounded to multiples of `step`, as depth cameras do
inline Points with_rounded_depth(Points points, double step)
{
  const double length = step * diagonal(points);
  const Vector direction = oblique_direction();
  for (Point& p : points)
  {
    const double depth = direction * (p - CGAL::ORIGIN);
    p = p + (length * std::round(depth / length) - depth) * direction;
  }
  return points;
}

// The same as of three depth cameras that were merged. Each sees its side, with a quarter of the size
// where either of two sees a point.
inline Points with_depth_of_cameras(Points points, double step, CGAL::Random& random)
{
  const double size = diagonal(points);
  const std::array<Vector, 3> directions = {oblique_direction(),
                                            Vector(-4., 1., 1.) / std::sqrt(18.),
                                            Vector(2., -3., -2.) / std::sqrt(17.)};
  const Point center = CGAL::centroid(points.begin(), points.end());
  for (Point& p : points)
  {
    std::array<double, 3> nearness;
    for (std::size_t camera = 0; camera < 3; ++camera)
      nearness[camera] = directions[camera] * (p - center) + random.uniform_real(0., 0.25) * size;
    const Vector& direction = directions[static_cast<std::size_t>(
        std::max_element(nearness.begin(), nearness.end()) - nearness.begin())];
    const double depth = direction * (p - CGAL::ORIGIN);
    p = p + (step * size * std::round(depth / (step * size)) - depth) * direction;
  }
  return points;
}

// Each point ten times, as of a scanner at rest, with Gaussian noise of standard deviation `sigma`
// along its direction
inline Points with_frames(const Points& points, double sigma, CGAL::Random& random)
{
  const double length = sigma * diagonal(points);
  Points result;
  for (int frame = 0; frame < 10; ++frame)
    for (const Point& p : points)
      result.push_back(p + length * normal_deviate(random) * oblique_direction());
  return result;
}

// Each point twenty times, with normally distributed errors of standard deviation `sigma` in each
// coordinate, as of scans that were registered well
inline Points with_copies(const Points& points, double sigma, CGAL::Random& random)
{
  const double length = sigma * diagonal(points);
  Points result;
  for (int copy = 0; copy < 20; ++copy)
    for (const Point& p : points)
      result.push_back(p + length * normal_vector(random));
  return result;
}

// Every second point is of another scan, which is `distance` off
inline Points with_shift(Points points, double distance, CGAL::Random& random)
{
  const Vector direction = normal_vector(random);
  const Vector shift =
      distance * diagonal(points) / std::sqrt(direction.squared_length()) * direction;
  for (std::size_t i = 1; i < points.size(); i += 2)
    points[i] = points[i] + shift;
  return points;
}

// By name: clean, noise:PERCENT, uneven_noise:PERCENT, outliers:PERCENT, clusters:PERCENT,
// density:FACTOR, hole:PERCENT, duplicates:PERCENT, lines:PERCENT, range_noise:PERCENT,
// rounding:PERCENT, depth:PERCENT, cameras:PERCENT, frames:PERCENT, copies:PERCENT, shift:PERCENT,
// or several of them one after the other, as in density:10+noise:0.2
inline Points degraded(const Points& points, const std::string& degradation, unsigned int seed)
{
  const std::size_t plus = degradation.find('+');
  if (plus != std::string::npos)
    return degraded(degraded(points, degradation.substr(0, plus), seed),
                    degradation.substr(plus + 1), seed + 1);
  const std::size_t colon = degradation.find(':');
  const std::string name = degradation.substr(0, colon);
  const double value = colon == std::string::npos ? 0. : std::stod(degradation.substr(colon + 1));
  CGAL::Random random(seed);
  if (name == "clean")
    return points;
  if (name == "noise")
    return with_noise(points, value / 100., random);
  if (name == "uneven_noise")
    return with_uneven_noise(points, value / 100., random);
  if (name == "outliers")
    return with_outliers(points, value / 100., random);
  if (name == "clusters")
    return with_clusters(points, value / 100., random);
  if (name == "density")
    return with_falling_density(points, value, random);
  if (name == "hole")
    return with_hole(points, value / 100., random);
  if (name == "duplicates")
    return with_duplicates(points, value / 100., random);
  if (name == "lines")
    return with_scan_lines(points, value / 100.);
  if (name == "range_noise")
    return with_range_noise(points, value / 100., random);
  if (name == "rounding")
    return with_rounding(points, value / 100.);
  if (name == "depth")
    return with_rounded_depth(points, value / 100.);
  if (name == "cameras")
    return with_depth_of_cameras(points, value / 100., random);
  if (name == "frames")
    return with_frames(points, value / 100., random);
  if (name == "copies")
    return with_copies(points, value / 100., random);
  if (name == "shift")
    return with_shift(points, value / 100., random);
  throw std::invalid_argument("there is no degradation " + degradation);
}

} // namespace comparison

#endif // CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_DEGRADATIONS_H
