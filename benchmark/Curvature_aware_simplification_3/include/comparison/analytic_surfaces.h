#ifndef CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_ANALYTIC_SURFACES_H
#define CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_ANALYTIC_SURFACES_H

#include <comparison/types.h>

#include <surfaces.h>

#include <CGAL/Random.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace comparison {

// A surface of which everything is known: a random point uniform per area, the exact distance, and
// a parametrization of its border over [0, 1), if it has one
struct Analytic_surface
{
  std::function<Point(CGAL::Random&)> random_point;
  std::function<double(const Point&)> distance;
  std::function<Point(double)> border;
};

// Calls `propose` until a uniform number falls below the value of `density`, at most `bound`.
template <typename Propose, typename Density>
auto rejection_sampling(CGAL::Random& random, double bound, const Propose& propose,
                        const Density& density)
{
  while (true)
  {
    const auto candidate = propose();
    if (random.uniform_real(0., bound) < density(candidate))
      return candidate;
  }
}

inline Analytic_surface sphere()
{
  return {
      [](CGAL::Random& random) { return CGAL::ORIGIN + surfaces::random_direction(random); },
      [](const Point& p) { return std::abs(std::sqrt((p - CGAL::ORIGIN).squared_length()) - 1.); },
      nullptr};
}

// radii 3 and 1
inline Analytic_surface torus()
{
  return {[](CGAL::Random& random) { return surfaces::random_point_on_torus(random, 3., 1.); },
          [](const Point& p) { return surfaces::distance_to_torus(p, 3., 1.); }, nullptr};
}

// The distance to an ellipse with half axes a and b from a point of the first quadrant, by Newton's
// method in the angle of the nearest point, from the best of a few angles
inline double distance_to_ellipse(double x, double y, double a, double b)
{
  const auto squared_distance = [=](double t) {
    return std::pow(a * std::cos(t) - x, 2) + std::pow(b * std::sin(t) - y, 2);
  };
  double best = 0.;
  for (int i = 0; i <= 32; ++i)
    if (squared_distance(i * CGAL_PI / 64.) < squared_distance(best))
      best = i * CGAL_PI / 64.;
  for (int i = 0; i < 20; ++i)
  {
    const double c = std::cos(best), s = std::sin(best);
    const double first = (b * b - a * a) * s * c + a * x * s - b * y * c;
    const double second = (b * b - a * a) * (c * c - s * s) + a * x * c + b * y * s;
    if (second > 0.)
      best = std::min(std::max(best - first / second, 0.), CGAL_PI / 2.);
  }
  return std::sqrt(squared_distance(best));
}

// half axes 1, 1, 3
inline Analytic_surface ellipsoid()
{
  return {[](CGAL::Random& random) { return surfaces::random_point_on_ellipsoid(random, 3.); },
          [](const Point& p) {
            return distance_to_ellipse(std::hypot(p.x(), p.y()), std::abs(p.z()), 1., 3.);
          },
          nullptr};
}

// A prism over the square [-1, 1]^2, |z| <= 0.5: sharp edges around top and bottom, and the four
// vertical ones rounded with radius 0.4
inline Analytic_surface rounded_box()
{
  const double half = 1., radius = 0.4, height = 0.5, straight = half - radius;
  // signed distance to the outline of the base: a square grown by a disk
  const auto outline_distance = [=](double x, double y) {
    const double u = std::abs(x) - straight, v = std::abs(y) - straight;
    return std::hypot(std::max(u, 0.), std::max(v, 0.)) + std::min(std::max(u, v), 0.) - radius;
  };
  const auto distance = [=](const Point& p) {
    const double d = outline_distance(p.x(), p.y()), e = std::abs(p.z()) - height;
    return std::abs(std::hypot(std::max(d, 0.), std::max(e, 0.)) + std::min(std::max(d, e), 0.));
  };
  const double arcs = 2. * CGAL_PI * radius, perimeter = 8. * straight + arcs;
  const double cap = 4. * half * half - (4. - CGAL_PI) * radius * radius;
  const auto random_point = [=](CGAL::Random& random) {
    const double sign = random.uniform_real(0., 1.) < 0.5 ? -1. : 1.;
    if (random.uniform_real(0., 2. * cap + 2. * height * perimeter) < 2. * cap)
    {
      double x, y;
      do
      {
        x = random.uniform_real(-half, half);
        y = random.uniform_real(-half, half);
      } while (outline_distance(x, y) > 0.);
      return Point(x, y, sign * height);
    }
    const double z = random.uniform_real(-height, height);
    if (random.uniform_real(0., perimeter) < arcs)
    {
      const double angle = random.uniform_real(0., 2. * CGAL_PI);
      const double x = radius * std::cos(angle), y = radius * std::sin(angle);
      return Point(x + std::copysign(straight, x), y + std::copysign(straight, y), z);
    }
    const double t = random.uniform_real(-straight, straight);
    return random.uniform_real(0., 1.) < 0.5 ? Point(t, sign * half, z) : Point(sign * half, t, z);
  };
  return {random_point, distance, nullptr};
}

// z = 0.1 sin(2 pi x) cos(2 pi y) over the unit square, with its border
inline Analytic_surface wavy_patch()
{
  const double a = 0.1, w = 2. * CGAL_PI;
  const auto height = [=](double x, double y) { return a * std::sin(w * x) * std::cos(w * y); };
  const auto dx = [=](double x, double y) { return a * w * std::cos(w * x) * std::cos(w * y); };
  const auto dy = [=](double x, double y) { return -a * w * std::sin(w * x) * std::sin(w * y); };
  const auto random_point = [=](CGAL::Random& random) {
    const auto [x, y] = rejection_sampling(
        random, std::hypot(1., a * w),
        [&] {
          const double u = random.uniform_real(0., 1.);
          return std::make_pair(u, random.uniform_real(0., 1.));
        },
        [=](const auto& uv) {
          return std::hypot(1., dx(uv.first, uv.second), dy(uv.first, uv.second));
        });
    return Point(x, y, height(x, y));
  };
  // Gauss-Newton in (x, y), kept inside the square
  const auto distance = [=](const Point& p) {
    double x = std::clamp(p.x(), 0., 1.), y = std::clamp(p.y(), 0., 1.);
    for (int i = 0; i < 30; ++i)
    {
      const double zx = dx(x, y), zy = dy(x, y), e = height(x, y) - p.z();
      const double gx = x - p.x() + e * zx, gy = y - p.y() + e * zy;
      const double xx = 1. + zx * zx, xy = zx * zy, yy = 1. + zy * zy;
      const double determinant = xx * yy - xy * xy;
      x = std::clamp(x - (yy * gx - xy * gy) / determinant, 0., 1.);
      y = std::clamp(y - (xx * gy - xy * gx) / determinant, 0., 1.);
    }
    return std::sqrt(CGAL::squared_distance(p, Point(x, y, height(x, y))));
  };
  const auto border = [=](double t) {
    const double s = 4. * t - std::floor(4. * t);
    const double x = t < 0.25 ? s : t < 0.5 ? 1. : t < 0.75 ? 1. - s : 0.;
    const double y = t < 0.25 ? 0. : t < 0.5 ? s : t < 0.75 ? 1. : 1. - s;
    return Point(x, y, height(x, y));
  };
  return {random_point, distance, border};
}

// A tube of radius r around the segment from a to b, with round ends
struct Tube
{
  Point a, b;
  double radius;

  double length() const { return std::sqrt(CGAL::squared_distance(a, b)); }

  double signed_distance(const Point& p) const
  {
    const Vector axis = b - a;
    const double t = std::clamp(((p - a) * axis) / axis.squared_length(), 0., 1.);
    return std::sqrt(CGAL::squared_distance(p, a + t * axis)) - radius;
  }

  // uniform per area: r times a direction, on the half sphere of an end or on the circle around
  Point random_point(CGAL::Random& random) const
  {
    const Vector axis = (b - a) / length();
    const Vector direction = surfaces::random_direction(random);
    if (random.uniform_real(0., length() + 2. * radius) < 2. * radius)
      return (direction * axis < 0. ? a : b) + radius * direction;
    const Vector across = direction - (direction * axis) * axis;
    return a + random.uniform_real(0., 1.) * (b - a) +
           radius / std::sqrt(across.squared_length()) * across;
  }
};

// The tubes that grow from the outer part of a tube, at equal angles of about 50 degrees with it.
// That one is a copy, since it may be one of `tubes`, which grow.
inline void grow(Tube from, int number, double length, double radius, std::vector<Tube>& tubes)
{
  const Vector axis = (from.b - from.a) / from.length();
  Vector u = CGAL::cross_product(axis, Vector(0.36, 0.48, 0.8)); // along none of the tubes
  u = u / std::sqrt(u.squared_length());
  const Vector v = CGAL::cross_product(axis, u);
  for (int i = 0; i < number; ++i)
  {
    const double angle = 2.4 * i; // golden
    const Point start = from.a + (0.35 + 0.65 * i / (number - 1.)) * (from.b - from.a);
    const Vector direction = 0.64 * axis + 0.77 * (std::cos(angle) * u + std::sin(angle) * v);
    tubes.push_back({start, start + length * direction, radius});
  }
}

// A stem, 6 branches and 24 twigs. These are a third of the area, and 1 % of the diagonal thick. The
// distance is too small inside the forks.
inline Analytic_surface tree()
{
  std::vector<Tube> tubes = {{Point(0., 0., 0.), Point(0., 0., 1.), 0.04}};
  grow(tubes[0], 6, 0.45, 0.012, tubes);
  for (std::size_t branch = 1; branch <= 6; ++branch)
    grow(tubes[branch], 4, 0.2, 0.008, tubes);
  const auto signed_distance = [tubes](const Point& p) {
    double distance = tubes[0].signed_distance(p);
    for (const Tube& tube : tubes)
      distance = std::min(distance, tube.signed_distance(p));
    return distance;
  };
  std::vector<double> area; // up to 2 pi, of the tubes up to each
  for (const Tube& tube : tubes)
    area.push_back((area.empty() ? 0. : area.back()) +
                   tube.radius * (tube.length() + 2. * tube.radius));
  const auto random_point = [=](CGAL::Random& random) {
    while (true) // until it is in no other tube
    {
      const auto of_tube =
          std::lower_bound(area.begin(), area.end(), random.uniform_real(0., area.back()));
      const Point p = tubes[static_cast<std::size_t>(of_tube - area.begin())].random_point(random);
      if (signed_distance(p) > -1e-9)
        return p;
    }
  };
  return {random_point, [=](const Point& p) { return std::abs(signed_distance(p)); }, nullptr};
}

// Of a surface with that signed distance, the first point on a ray, by steps as long as the
// distance, or none within `farthest`
template <typename SignedDistance>
std::optional<Point> first_point_on_ray(const Point& start, const Vector& direction,
                                        double farthest, const SignedDistance& signed_distance)
{
  constexpr double close_enough = 1e-10;
  for (double t = 0.; t < farthest;)
  {
    const Point p = start + t * direction;
    const double distance = signed_distance(p);
    if (distance < close_enough)
      return p;
    t += distance;
  }
  return std::nullopt;
}

// What a rotating laser scanner in a street sees of the ground, of 30 posts and of four wires, in
// meters, with rays in random directions in rings of half a degree: points are 1 / r^2 as dense,
// and of thin parts they are few. The density varies 1 : 1,000.
inline Analytic_surface street()
{
  const Point scanner(0., 0., 1.7);
  constexpr double farthest = 25., between_rings = CGAL_PI / 360.;
  std::vector<Tube> tubes;
  for (int i = 0; i < 30; ++i)
  {
    const double angle = 2.4 * i, distance = 4. + 0.53 * i; // golden
    const Point foot(distance * std::cos(angle), distance * std::sin(angle), 0.);
    tubes.push_back({foot, foot + Vector(0., 0., 6.), 0.1});
  }
  for (double y : {-7., 7.})
    for (double z : {4., 5.5})
      tubes.push_back({Point(-20., y, z), Point(20., y, z), 0.03});
  const auto signed_distance = [tubes](const Point& p) {
    double distance = p.z();
    for (const Tube& tube : tubes)
      distance = std::min(distance, tube.signed_distance(p));
    return distance;
  };
  const auto random_point = [=](CGAL::Random& random) {
    while (true)
    {
      const Vector direction = surfaces::random_direction(random);
      const double up = between_rings * std::round(std::asin(direction.z()) / between_rings);
      const double around = std::atan2(direction.y(), direction.x());
      const Vector ray(std::cos(up) * std::cos(around), std::cos(up) * std::sin(around),
                       std::sin(up));
      if (const auto p = first_point_on_ray(scanner, ray, farthest, signed_distance))
        return *p;
    }
  };
  return {random_point, [=](const Point& p) { return std::abs(signed_distance(p)); }, nullptr};
}

inline std::vector<std::string> analytic_surface_names()
{
  return {"sphere", "torus", "ellipsoid", "rounded_box", "wavy_patch", "tree", "street"};
}

inline Analytic_surface analytic_surface(const std::string& name)
{
  if (name == "sphere")
    return sphere();
  if (name == "torus")
    return torus();
  if (name == "ellipsoid")
    return ellipsoid();
  if (name == "rounded_box")
    return rounded_box();
  if (name == "wavy_patch")
    return wavy_patch();
  if (name == "tree")
    return tree();
  if (name == "street")
    return street();
  throw std::invalid_argument("there is no analytic surface " + name);
}

inline Points sample(const Analytic_surface& surface, std::size_t n, unsigned int seed)
{
  return surfaces::sample(n, seed, surface.random_point);
}

} // namespace comparison

#endif // CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_ANALYTIC_SURFACES_H
