// Points on surfaces of which everything is known, for tests and benchmarks

#ifndef CURVATURE_AWARE_SIMPLIFICATION_3_SURFACES_H
#define CURVATURE_AWARE_SIMPLIFICATION_3_SURFACES_H

#include <CGAL/Origin.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace surfaces {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;

inline Vector random_direction(CGAL::Random& random)
{
  const double z = random.uniform_real(-1., 1.);
  const double angle = random.uniform_real(0., 2. * CGAL_PI);
  const double r = std::sqrt(1. - z * z);
  return Vector(r * std::cos(angle), r * std::sin(angle), z);
}

// on the torus around the z axis, uniform per area: the area element grows with the distance to the
// axis
inline Point random_point_on_torus(CGAL::Random& random, double major, double minor)
{
  while (true)
  {
    const double u = random.uniform_real(0., 2. * CGAL_PI);
    const double v = random.uniform_real(0., 2. * CGAL_PI);
    const double distance_to_axis = major + minor * std::cos(v);
    if (random.uniform_real(0., major + minor) < distance_to_axis)
      return Point(distance_to_axis * std::cos(u), distance_to_axis * std::sin(u),
                   minor * std::sin(v));
  }
}

inline double distance_to_torus(const Point& p, double major, double minor)
{
  return std::abs(std::hypot(std::hypot(p.x(), p.y()) - major, p.z()) - minor);
}

// on the ellipsoid of revolution with half axes 1, 1, c > 1, uniform per area: the sphere's area
// element is stretched by c sqrt(x^2 + y^2 + z^2 / c^2), z on the sphere
inline Point random_point_on_ellipsoid(CGAL::Random& random, double c)
{
  while (true)
  {
    const Vector v = random_direction(random);
    const double stretch = std::sqrt(1. - v.z() * v.z() + v.z() * v.z() / (c * c));
    if (random.uniform_real(0., 1.) < stretch)
      return Point(v.x(), v.y(), c * v.z());
  }
}

// n points that `random_point` makes of a generator with this seed
template <typename Random_point>
std::vector<Point> sample(std::size_t n, unsigned int seed, const Random_point& random_point)
{
  CGAL::Random random(seed);
  std::vector<Point> points;
  points.reserve(n);
  while (points.size() < n)
    points.push_back(random_point(random));
  return points;
}

// unit sphere
inline std::vector<Point> sphere(std::size_t n, unsigned int seed)
{
  return sample(n, seed, [](CGAL::Random& r) { return CGAL::ORIGIN + random_direction(r); });
}

inline std::vector<Point> torus(std::size_t n, double major, double minor, unsigned int seed)
{
  return sample(n, seed, [=](CGAL::Random& r) { return random_point_on_torus(r, major, minor); });
}

inline std::vector<Point> ellipsoid(std::size_t n, double c, unsigned int seed)
{
  return sample(n, seed, [=](CGAL::Random& r) { return random_point_on_ellipsoid(r, c); });
}

// the square [0, 1]^2 in the plane z = 0, uniform per area
inline std::vector<Point> square(std::size_t n, unsigned int seed)
{
  return sample(n, seed, [](CGAL::Random& random) {
    const double x = random.uniform_real(0., 1.);
    return Point(x, random.uniform_real(0., 1.), 0.);
  });
}

// normally distributed with mean 0 and variance 1 (Box and Muller)
inline double normal_deviate(CGAL::Random& random)
{
  const double u = 1. - random.uniform_real(0., 1.);
  return std::sqrt(-2. * std::log(u)) * std::cos(random.uniform_real(0., 2. * CGAL_PI));
}

} // namespace surfaces

#endif // CURVATURE_AWARE_SIMPLIFICATION_3_SURFACES_H
