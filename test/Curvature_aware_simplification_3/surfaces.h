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

// unit sphere, uniform per area
inline std::vector<Point> sphere(std::size_t n, unsigned int seed)
{
  CGAL::Random random(seed);
  std::vector<Point> points;
  while (points.size() < n)
    points.push_back(CGAL::ORIGIN + random_direction(random));
  return points;
}

// torus around the z axis, uniform per area: its area element grows with the distance to the axis
inline std::vector<Point> torus(std::size_t n, double major, double minor, unsigned int seed)
{
  CGAL::Random random(seed);
  std::vector<Point> points;
  while (points.size() < n)
  {
    const double u = random.uniform_real(0., 2. * CGAL_PI);
    const double v = random.uniform_real(0., 2. * CGAL_PI);
    const double distance_to_axis = major + minor * std::cos(v);
    if (random.uniform_real(0., major + minor) < distance_to_axis)
      points.emplace_back(distance_to_axis * std::cos(u), distance_to_axis * std::sin(u),
                          minor * std::sin(v));
  }
  return points;
}

inline double distance_to_torus(const Point& p, double major, double minor)
{
  return std::abs(std::hypot(std::hypot(p.x(), p.y()) - major, p.z()) - minor);
}

// ellipsoid of revolution with half axes 1, 1, c > 1, uniform per area: the sphere's area element is
// stretched by c sqrt(x^2 + y^2 + z^2 / c^2), z on the sphere
inline std::vector<Point> ellipsoid(std::size_t n, double c, unsigned int seed)
{
  CGAL::Random random(seed);
  std::vector<Point> points;
  while (points.size() < n)
  {
    const Vector v = random_direction(random);
    const double stretch = std::sqrt(1. - v.z() * v.z() + v.z() * v.z() / (c * c));
    if (random.uniform_real(0., 1.) < stretch)
      points.emplace_back(v.x(), v.y(), c * v.z());
  }
  return points;
}

// the square [0, 1]^2 in the plane z = 0, uniform per area
inline std::vector<Point> square(std::size_t n, unsigned int seed)
{
  CGAL::Random random(seed);
  std::vector<Point> points;
  while (points.size() < n)
  {
    const double x = random.uniform_real(0., 1.);
    points.emplace_back(x, random.uniform_real(0., 1.), 0.);
  }
  return points;
}

// normally distributed with mean 0 and variance 1 (Box and Muller)
inline double normal_deviate(CGAL::Random& random)
{
  const double u = 1. - random.uniform_real(0., 1.);
  return std::sqrt(-2. * std::log(u)) * std::cos(random.uniform_real(0., 2. * CGAL_PI));
}

} // namespace surfaces

#endif // CURVATURE_AWARE_SIMPLIFICATION_3_SURFACES_H
