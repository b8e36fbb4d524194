// Surface variation, against closed forms

#include "inputs.h"

#include <CGAL/Curvature_aware_simplification_3/internal/features/features.h>
#include <CGAL/estimate_surface_variation.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace {

using namespace inputs;
using Point_and_value = std::pair<Point, double>;

// kappa at the first of `points`, by the public function
double variation_at_first(const std::vector<Point>& points, unsigned int k)
{
  std::vector<Point_and_value> range;
  for (const Point& p : points)
    range.emplace_back(p, -1.);
  const bool done = CGAL::estimate_surface_variation<Tag>(
      range, k, CGAL::Second_of_pair_property_map<Point_and_value>(),
      CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Point_and_value>()));
  EXPECT_TRUE(done);
  return range.front().second;
}

// A square lattice of step `step`, 2 n + 1 points wide, mapped to space by `map`, its center first
template <typename Map>
std::vector<Point> mapped_lattice(int n, double step, const Map& map)
{
  std::vector<Point> points = {map(0., 0.)};
  for (int i = -n; i <= n; ++i)
    for (int j = -n; j <= n; ++j)
      if (i != 0 || j != 0)
        points.push_back(map(i * step, j * step));
  return points;
}

TEST(Surface_variation, of_a_plane_is_zero)
{
  const auto plane = mapped_lattice(10, 0.1, [](double u, double v) { return Point(u, v, 0.); });
  EXPECT_EQ(variation_at_first(plane, 16), 0.);
  // tilted and far away: all that is left is rounding error
  const auto far_away = mapped_lattice(10, 0.1, [](double u, double v) {
    return Point(4e5 + u, 5e6 + v, 100. + 0.3 * u - 0.7 * v);
  });
  EXPECT_EQ(variation_at_first(far_away, 16), 0.);
}

TEST(Surface_variation, counts_duplicates_once_and_has_no_unit)
{
  std::vector<Point> points = surfaces::sphere(500, 27);
  const double expected = variation_at_first(points, 16);
  std::vector<Point> in_other_unit;
  for (const Point& p : points)
    in_other_unit.emplace_back(1024. * p.x(), 1024. * p.y(), 1024. * p.z());
  EXPECT_EQ(variation_at_first(in_other_unit, 16), expected);
  points.insert(points.end(), 100, points[0]);
  EXPECT_EQ(variation_at_first(points, 16), expected);
}

TEST(Surface_variation, of_a_sphere)
{
  // spiral lattice, of equal area per point, from the pole
  std::vector<Point> points;
  const std::size_t n = 20000, k = 200;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double z = 1. - 2. * static_cast<double>(i) / n;
    const double angle = static_cast<double>(i) * CGAL_PI * (3. - std::sqrt(5.));
    const double r = std::sqrt(1. - z * z);
    points.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
  }
  // The neighborhood is a cap of height H; the area of a sphere is uniform in the height. So the
  // variance along the axis is H^2 / 12, and across R H - H^2 / 3 for both directions together.
  const double H = 2. * (k + 1.) / n;
  const double axial = H * H / 12., across = H - H * H / 3.;
  EXPECT_NEAR(variation_at_first(points, k) / (axial / (axial + across)), 1., 0.02);
  // and r^2 / (24 R^2) in the limit, with r^2 = 2 R H, as the manual says
  EXPECT_NEAR(variation_at_first(points, k) / (2. * H / 24.), 1., 0.03);
}

TEST(Surface_variation, of_a_cylinder)
{
  // r^2 / (32 R^2), as the manual says; within 25 steps of the lattice there are 1961 points
  const double step = 0.004;
  const unsigned int k = 1960;
  const double kappa = variation_at_first(
      mapped_lattice(30, step,
                     [](double u, double v) { return Point(v, std::sin(u), std::cos(u)); }),
      k);
  const double squared_radius = (k + 1.) * step * step / CGAL_PI;
  EXPECT_NEAR(kappa / (squared_radius / 32.), 1., 0.02);
}

TEST(Surface_variation, of_the_apex_of_a_cone)
{
  // spiral lattice on the unrolled cone of opening angle 90 degrees. With the distance s to the
  // apex, mean(s) = 2/3 and mean(s^2) = 1/2: variance (1/2 - 4/9) / 2 = 1/36 along the axis, and
  // 1/2 / 2 = 1/4 across, hence kappa = 1/10.
  std::vector<Point> points = {Point(0., 0., 0.)};
  const std::size_t n = 10000;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double s = std::sqrt((static_cast<double>(i) + 0.5) / n) / std::sqrt(2.);
    const double angle = static_cast<double>(i) * CGAL_PI * (3. - std::sqrt(5.));
    points.emplace_back(s * std::cos(angle), s * std::sin(angle), s);
  }
  EXPECT_NEAR(variation_at_first(points, n), 0.1, 1e-4);
}

TEST(Surface_variation, of_a_noisy_plane)
{
  CGAL::Random random(1);
  const double step = 0.01, sigma = 0.01, k = 500.;
  double sum = 0.;
  for (int repetition = 0; repetition < 20; ++repetition)
    sum += variation_at_first(mapped_lattice(30, step,
                                             [&](double u, double v) {
                                               return Point(
                                                   u, v, 0.01 * surfaces::normal_deviate(random));
                                             }),
                              static_cast<unsigned int>(k));
  // a disk of radius r has variance r^2 / 4 in both directions
  const double squared_radius = (k + 1.) * step * step / CGAL_PI;
  const double expected = sigma * sigma / (sigma * sigma + squared_radius / 2.);
  EXPECT_NEAR(sum / 20. / expected, 1., 0.03);
}

TEST(Surface_variation, is_at_most_one_third)
{
  EXPECT_NEAR(variation_at_first({Point(0, 0, 0), Point(1, 0, 0), Point(-1, 0, 0), Point(0, 1, 0),
                                  Point(0, -1, 0), Point(0, 0, 1), Point(0, 0, -1)},
                                 6),
              1. / 3., 1e-12);
}

TEST(Surface_variation, of_more_neighbors_than_there_are_takes_all)
{
  const std::vector<Point> points = surfaces::sphere(50, 26);
  const double expected = variation_at_first(points, 49);
  EXPECT_EQ(variation_at_first(points, 50), expected);
  EXPECT_EQ(variation_at_first(points, (std::numeric_limits<unsigned int>::max)()), expected);
}

TEST(Surface_variation, is_not_changed_by_a_far_point)
{
  std::vector<Point> points = surfaces::sphere(5000, 24);
  const double expected = variation_at_first(points, 16);
  ASSERT_GT(expected, 0.);
  for (double far : {1e3, 1e9, 1e18, 1e40})
  {
    points.resize(5000);
    points.emplace_back(far, far, far);
    EXPECT_NEAR(variation_at_first(points, 16) / expected, 1., 1e-9) << far;
  }
}

} // namespace
