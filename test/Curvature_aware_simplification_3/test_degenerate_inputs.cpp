// What is degenerate must still give the exact count, finite, near the input

#include "both_methods.h"

#include <CGAL/bounding_box.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace {

using namespace both_methods;

// What is degenerate must still give the exact count, finite, inside the box grown by 1.5
// spacings.
void check_degenerate(const std::string& name, const std::vector<Point>& points,
                      const std::vector<std::size_t>& counts)
{
  const CGAL::Bbox_3 box = CGAL::bbox_3(points.begin(), points.end());
  for (std::size_t count : counts)
    for (bool option : {false, true})
    {
      CGAL::Curvature_aware_simplification_report report;
      const std::vector<Point> output =
          simplified(points, np::number_of_output_points(count)
                                 .simplification_report(std::ref(report))
                                 .require_uniform_sampling(option)
                                 .recompute_curvature(option));
      ASSERT_EQ(output.size(), count) << name;
      ASSERT_TRUE(std::isfinite(report.output_spacing));
      const double margin = 1.5 * report.output_spacing;
      const double rounding = 1e-12 * (1. + std::abs(box.xmax()) + std::abs(box.ymax()));
      for (const Point& p : output)
        for (int i = 0; i < 3; ++i)
        {
          ASSERT_TRUE(std::isfinite(p[i])) << name;
          ASSERT_GE(p[i], box.min(i) - margin - rounding) << name << " " << count;
          ASSERT_LE(p[i], box.max(i) + margin + rounding) << name << " " << count;
        }
      EXPECT_EQ(subset(points, np::number_of_output_points(count)).size(), count) << name;
    }
}

TEST_P(Both_methods, degenerate_few_points)
{
  check_degenerate("one", {Point(1, 2, 3)}, {1});
  check_degenerate("two", {Point(1, 2, 3), Point(2, 2, 3)}, {1, 2});
  check_degenerate("two equal", {Point(1, 2, 3), Point(1, 2, 3)}, {1, 2});
  check_degenerate("three", {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)}, {1, 2, 3});
}

TEST_P(Both_methods, degenerate_duplicates)
{
  check_degenerate("all equal", std::vector<Point>(1000, Point(0.1, 0.2, 0.3)), {1, 10, 1000});
  std::vector<Point> points = surfaces::sphere(200, 18);
  for (std::size_t i = 0; i < 1800; ++i)
    points.push_back(points[i % 200]);
  check_degenerate("90 % duplicates", points, {20, 200, 201, 1000, 2000});
  points = surfaces::sphere(200, 18);
  points.insert(points.end(), 1800, points[7]);
  check_degenerate("one point 1,801 times", points, {20, 200, 201, 2000});
}

TEST_P(Both_methods, degenerate_a_million_equal_points)
{
  // a search tree over equal points would be a million levels deep
  const std::vector<Point> points(1000000, Point(1, 2, 3));
  for (std::size_t n : {1u, 50000u, 1000000u})
  {
    const std::vector<Point> output = simplified(points, np::number_of_output_points(n));
    EXPECT_EQ(output, std::vector<Point>(n, Point(1, 2, 3)));
  }
}

TEST_P(Both_methods, degenerate_lines_and_planes)
{
  CGAL::Random random(19);
  std::vector<Point> line, axis, lattice, tilted;
  for (int i = 0; i < 2000; ++i)
  {
    const double t = random.uniform_real(0., 1.), u = random.uniform_real(0., 1.);
    line.emplace_back(t, 2. * t, -3. * t);
    axis.emplace_back(0., t, 0.);
    lattice.emplace_back(i % 50, i / 50, 7.);
    tilted.emplace_back(t, u, 0.3 * t + 0.2 * u);
  }
  for (const std::vector<Point>* points : {&line, &axis, &lattice, &tilted})
    check_degenerate(std::to_string(points - &line), *points, {1, 2, 3, 4, 100, 1000, 2000});
  for (const Point& p : simplified(lattice))
    EXPECT_NEAR(p.z(), 7., 1e-14); // a plane stays a plane
  for (const Point& p : simplified(tilted))
    EXPECT_NEAR(p.z(), 0.3 * p.x() + 0.2 * p.y(), 1e-14);
}

TEST_P(Both_methods, degenerate_clusters_far_apart_and_points_of_all_scales)
{
  CGAL::Random random(20);
  std::vector<Point> clusters, scales;
  for (int i = 0; i < 1000; ++i)
  {
    const double far = i % 2 == 0 ? 0. : 1e8;
    const double x = random.uniform_real(0., 1.);
    clusters.emplace_back(far + x, random.uniform_real(0., 1.), 0.);
    scales.emplace_back(std::pow(0.97, i), std::pow(0.97, 2 * i), 0.);
  }
  check_degenerate("clusters", clusters, {1, 2, 50, 1000});
  check_degenerate("scales", scales, {1, 50, 1000});
}

TEST_P(Both_methods, degenerate_count_equal_to_the_number_of_points)
{
  check_degenerate("sphere", surfaces::sphere(1000, 21), {999, 1000});
  check_degenerate("square", surfaces::square(1000, 21), {999, 1000});
}

// as markers of invalid measurements may be
TEST_F(Defaults, far_points_cost_the_others_no_digits)
{
  for (double far : {1e3, 1e8, 1e16, 1e30, 1e139})
  {
    std::vector<Point> points = surfaces::sphere(5000, 23);
    points.emplace_back(far, far, far);
    points.emplace_back(-far, 2. * far, 0.);
    CGAL::Curvature_aware_simplification_report report;
    const std::vector<Point> result = simplified(
        points, np::number_of_output_points(500).simplification_report(std::ref(report)));
    EXPECT_EQ(report.number_of_distinct_points, 5002u) << far;
    EXPECT_EQ(report.number_of_outliers, 2u) << far;
    EXPECT_LT(report.noise_level, 1e-3) << far;
    ASSERT_EQ(result.size(), 500u);
    for (const Point& p : result)
      ASSERT_NEAR(std::sqrt((p - CGAL::ORIGIN).squared_length()), 1., 1e-3) << far;
    EXPECT_EQ(std::set<Point>(result.begin(), result.end()).size(), 500u);
  }
}

TEST_F(Paper, far_points_leave_the_literal_method_at_work)
{
  for (double far : {1e3, 1e16, 1e30, 1e139})
  {
    std::vector<Point> points = surfaces::sphere(5000, 23);
    points.emplace_back(far, far, far);
    const std::set<Point> input(points.begin(), points.end());
    std::size_t moved = 0;
    for (const Point& p : simplified(points, np::number_of_output_points(500)))
      moved += 1 - input.count(p);
    EXPECT_GT(moved, 490u) << far;
  }
}

TEST_P(Both_methods, degenerate_coordinates_at_the_ends_of_their_range)
{
  std::vector<Point> tiny, huge;
  for (const Point& p : surfaces::sphere(1000, 24))
  {
    // squares underflow in the frame, and the area of all of them is 0
    tiny.emplace_back(1e-200 * p.x(), 1e-200 * p.y(), 1e-200 * p.z());
    huge.emplace_back(-1.7e308 + 1e305 * p.x(), 0., 1e305 * p.z());
  }
  for (int i = 0; i < 9600; ++i) // less than a tenth is tiny, so that this is no mistake
    tiny.emplace_back(i % 2 == 0 ? -1. : 1., 0., 1e-4 * i);
  huge.emplace_back(1.7e308, 0., 0.);
  for (std::size_t n : {1u, 50u, 900u})
    for (const std::vector<Point>* input : {&tiny, &huge})
    {
      // the literal method pushes samples beyond the ends
      const CGAL::Bbox_3 box = CGAL::bbox_3(input->begin(), input->end());
      const std::vector<Point> output = simplified(*input, np::number_of_output_points(n));
      EXPECT_EQ(output.size(), n);
      for (const Point& p : output)
        for (int axis = 0; axis < 3; ++axis)
        {
          const double beyond = 0.2 * (box.max(axis) / 2. - box.min(axis) / 2.);
          EXPECT_GE(p[axis], box.min(axis) - beyond);
          EXPECT_LE(p[axis], box.max(axis) + beyond);
        }
    }
}

// Without an area, their density was no number, nor was that of all others then: the samples were
// the last points of the curve, 1,750 in one quarter of the line and all 2,400 in another.
TEST_F(Defaults, places_without_area_leave_the_others_their_samples)
{
  std::vector<Point> points;
  for (const Point& p : surfaces::sphere(1000, 24))
    points.emplace_back(1e-200 * p.x(), 1e-200 * p.y(), 1e-200 * p.z());
  for (int i = 0; i < 9600; ++i)
    points.emplace_back(i % 2 == 0 ? -1. : 1., 0., 1e-4 * i);
  int in_quarter[4] = {0, 0, 0, 0};
  for (const Point& p : simplified(points, np::number_of_output_points(8500)))
    ++in_quarter[static_cast<std::size_t>((std::min)((std::max)(p.z() / 0.24, 0.), 3.))];
  for (int number : in_quarter)
    EXPECT_NEAR(number, 8500 / 4, 100);
}

// Repulsion pushed samples out of the box, where there are no numbers.
TEST_P(Both_methods, output_is_finite_next_to_the_largest_number)
{
  CGAL::Random random(26);
  const auto coordinate = [&] { return 1.7e308 * random.uniform_real(-1., 1.); };
  std::vector<Point> points;
  for (int i = 0; i < 2000; ++i)
  {
    const double x = coordinate(), y = coordinate();
    points.emplace_back(x, y, coordinate());
  }
  for (const Point& p : simplified(points, np::number_of_output_points(100)))
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_TRUE(std::isfinite(p[axis])) << p;
}

// Two points that are 10^81 to 10^138 times as far away as the others decide the unit. There, the
// fourth powers of residuals and the squares of areas underflowed, and no noise was found.
TEST_F(Defaults, result_does_not_depend_on_how_far_a_few_points_are)
{
  for (double sigma : {0., 0.05})
  {
    CGAL::Random random(27);
    std::vector<Point> cube;
    for (int i = 0; i < 6000; ++i)
    {
      double c[3];
      for (int axis = 0; axis < 3; ++axis)
        c[axis] = axis == i % 3 ? (i % 2 == 0 ? -1. : 1.) : random.uniform_real(-1., 1.);
      for (double& x : c)
        x += sigma * surfaces::normal_deviate(random);
      cube.emplace_back(c[0], c[1], c[2]);
    }
    std::vector<std::vector<Point>> results;
    for (int exponent : {20, 270, 460})
    {
      std::vector<Point> points = cube;
      points.emplace_back(std::ldexp(1., exponent), 0., 0.);
      points.emplace_back(-std::ldexp(1., exponent), 0., 0.);
      results.push_back(simplified(points, np::number_of_output_points(600)));
    }
    for (std::size_t other : {1u, 2u})
      for (std::size_t i = 0; i < 600; ++i)
        ASSERT_LT(CGAL::squared_distance(results[0][i], results[other][i]), 1e-12)
            << sigma << ' ' << other << ' ' << i;
  }
}

// Fits to more than a third of the points were made all the same if these were 57 with the
// outliers.
TEST_F(Defaults, does_not_move_samples_of_few_points_among_outliers)
{
  std::vector<Point> points = surfaces::sphere(50, 61);
  for (int i = 0; i < 8; ++i)
    points.emplace_back(20. * std::cos(i), 20. * std::sin(i), i - 4.);
  CGAL::Curvature_aware_simplification_report report;
  const std::vector<Point> output =
      simplified(points, np::number_of_output_points(12).simplification_report(std::ref(report)));
  EXPECT_EQ(report.number_of_outliers, 8u);
  for (const Point& p : output)
    EXPECT_NEAR(std::sqrt((p - CGAL::ORIGIN).squared_length()), 1., 1e-12);

  // nor are those with noise smoothed, which can be seen on a plane
  CGAL::Random random(62);
  points.erase(points.begin(), points.begin() + 50);
  for (int i = 0; i < 50; ++i)
  {
    const double x = random.get_double(0., 6.), y = random.get_double(0., 6.);
    points.emplace_back(x, y, 0.1 * surfaces::normal_deviate(random));
  }
  for (const Point& p : simplified(points, np::number_of_output_points(12)))
    EXPECT_TRUE(std::any_of(points.begin(), points.end(), [&](const Point& q) {
      return CGAL::squared_distance(p, q) < 1e-20;
    })) << p;
}

// Random points of a curve leave gaps, from which samples go back to the same point: of 4500, 520
// were at the place of another, and 48 with outliers, where these were not looked for.
TEST_F(Defaults, samples_of_a_curve_are_at_different_places)
{
  CGAL::Random random(28);
  std::vector<Point> circle;
  for (int i = 0; i < 5000; ++i)
  {
    const double t = random.uniform_real(0., 2. * CGAL_PI);
    circle.emplace_back(std::cos(t), std::sin(t), 0.);
  }
  for (int outliers : {0, 50})
  {
    for (int i = 0; i < outliers; ++i)
      circle.push_back(CGAL::ORIGIN + 0.5 * surfaces::random_direction(random));
    for (std::size_t n : {1500u, 2500u, 4500u})
    {
      std::vector<double> angles;
      for (const Point& p : simplified(circle, np::number_of_output_points(n)))
        angles.push_back(std::atan2(p.y(), p.x()));
      std::sort(angles.begin(), angles.end());
      for (std::size_t i = 1; i < n; ++i)
        EXPECT_GT(angles[i] - angles[i - 1], 1e-9) << n << ' ' << outliers;
    }
  }
}

} // namespace
