// The points as the stages see them: their frame, their order, and what they must not be

#include "inputs.h"

#include <CGAL/Curvature_aware_simplification_3/internal/input/Cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Frame.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/box_of_most_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/check_that_all_are_measurements.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/find_duplicates.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace inputs;

TEST(Cloud, merges_duplicates_and_keeps_track)
{
  std::vector<Point> points = surfaces::sphere(300, 3);
  for (std::size_t i = 0; i < 200; ++i)
    points.push_back(points[i / 2]);
  const Cloud cloud = cloud_of(points);
  ASSERT_EQ(cloud.size(), 300u);
  ASSERT_EQ(cloud.input_size(), 500u);
  EXPECT_EQ(cloud.duplicates.size(), 200u);
  const std::vector<std::size_t> distinct_index = distinct_indices<Tag>(cloud);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const std::size_t j = distinct_index[i];
    EXPECT_EQ(cloud.input_index[j], i < 300 ? i : (i - 300) / 2);
    EXPECT_LT(CGAL::squared_distance(cloud.frame.from_frame(cloud.points[j]), points[i]), 1e-30);
  }
}

TEST(Cloud, finds_duplicates_and_the_first_of_each)
{
  const auto first_equal = [](const std::vector<Point>& points, const auto& tag) {
    std::vector<std::size_t> result(points.size());
    std::iota(result.begin(), result.end(), std::size_t(0));
    for (const Duplicate& d : find_duplicates<std::decay_t<decltype(tag)>>(points))
    {
      EXPECT_EQ(result[d.index], d.index) << "found twice";
      EXPECT_LT(d.first, d.index);
      result[d.index] = d.first;
    }
    return result;
  };

  // all equal, none equal, many equal on a lattice, zeros of both signs; against a search by brute
  // force
  std::vector<Point> lattice, zeros;
  for (std::size_t i = 0; i < 1000; ++i)
    lattice.emplace_back(static_cast<double>(i * i % 17), static_cast<double>(i % 5),
                         static_cast<double>(i % 3));
  for (int i = 0; i < 8; ++i)
    zeros.emplace_back(i % 2 == 0 ? 0. : -0., i % 4 < 2 ? 0. : -0., i < 4 ? 0. : -0.);
  for (const std::vector<Point>& points :
       {lattice, zeros, surfaces::sphere(1000, 3), std::vector<Point>(1000, Point(1., 2., 3.)),
        std::vector<Point>(1, Point(1., 2., 3.))})
  {
    std::vector<std::size_t> expected;
    for (const Point& p : points)
      expected.push_back(
          static_cast<std::size_t>(std::find(points.begin(), points.end(), p) - points.begin()));
    EXPECT_EQ(first_equal(points, CGAL::Sequential_tag()), expected);
    EXPECT_EQ(first_equal(points, Tag()), expected);
  }
}

TEST(Cloud, looks_for_duplicates_among_few_points)
{
  std::vector<Point> points = surfaces::sphere(100000, 3);
  points.push_back(points[5]);
  const std::vector<std::size_t> found = points_with_equal_hash<Tag>(points);
  EXPECT_LT(found.size(), points.size() / 10);
  EXPECT_TRUE(std::binary_search(found.begin(), found.end(), 5u));
  EXPECT_TRUE(std::binary_search(found.begin(), found.end(), points.size() - 1));
}

TEST(Cloud, has_an_order_that_does_not_depend_on_that_of_the_input)
{
  // on a lattice, most points have the coordinates of others
  std::vector<Point> points;
  for (int i = 0; i < 8000; ++i)
    points.emplace_back(i % 20, i / 20 % 20, i / 400);
  const Cloud cloud = cloud_of(points);
  std::shuffle(points.begin(), points.end(), std::mt19937(1));
  EXPECT_EQ(cloud_of(points).points, cloud.points);
}

TEST(Box_of_most_points, leaves_out_what_is_far_only)
{
  CGAL::Random random(25);
  std::vector<Point> points;
  for (int i = 0; i < 10000; ++i)
    points.emplace_back(random.uniform_real(0., 1.), random.uniform_real(0., 1.), 0.);
  const auto box_of = [&] {
    return box_of_most_points(points, CGAL::bbox_3(points.begin(), points.end()));
  };
  EXPECT_EQ(box_of(), CGAL::bbox_3(points.begin(), points.end()));
  points.emplace_back(50., 0., 0.);
  EXPECT_EQ(box_of().xmax(), 50.);
  points.emplace_back(500., 0., 0.);
  // twice as large as from 0.05 to 0.95
  EXPECT_NEAR(box_of().xmin(), -0.4, 0.03);
  EXPECT_NEAR(box_of().xmax(), 1.4, 0.03);
  EXPECT_EQ(box_of().zmax(), 0.);
  // a tenth of the points elsewhere is not a few
  for (int i = 0; i < 1200; ++i)
    points.emplace_back(500., 0., 0.);
  EXPECT_EQ(box_of().xmax(), 500.);
  // where all others coincide, there is no other size
  points.assign(1000, Point(1., 2., 3.));
  points.emplace_back(500., 0., 0.);
  EXPECT_EQ(box_of().xmax(), 500.);
}

TEST(Box_of_most_points, does_not_depend_on_the_order)
{
  CGAL::Random random(26);
  std::vector<Point> points;
  for (int i = 0; i < 20000; ++i) // nearly one in twenty is far
    points.emplace_back(random.uniform_real(0., 1.) + (i < 960 ? 500. : 0.), 0., 0.);
  const CGAL::Bbox_3 box = CGAL::bbox_3(points.begin(), points.end());
  for (int i = 0; i < 50; ++i)
  {
    CGAL::cpp98::random_shuffle(points.begin(), points.end(), random);
    EXPECT_LT(box_of_most_points(points, box).xmax(), 3.);
  }
}

TEST(Box_of_most_points, does_not_keep_step_with_the_rows_of_a_scan)
{
  CGAL::Random random(28);
  std::vector<Point> points;
  for (int i = 0; i < 20000; ++i) // every 42nd is far: every other one of 1000 evenly spread
    points.emplace_back(random.uniform_real(0., 1.) + (i % 42 == 0 ? 500. : 0.), 0., 0.);
  const CGAL::Bbox_3 box = CGAL::bbox_3(points.begin(), points.end());
  EXPECT_LT(box_of_most_points(points, box).xmax(), 3.);
}

// of what is asked of points before their box
std::string message_about(const std::vector<Point>& points)
{
  try
  {
    const CGAL::Bbox_3 box = CGAL::bbox_3(points.begin(), points.end());
    check_that_all_are_measurements(points, box, box_of_most_points(points, box) == box);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "none";
}

TEST(Measurements, that_are_far_are_named)
{
  CGAL::Random random(27);
  std::vector<Point> points;
  for (int i = 0; i < 1000; ++i) // a plate with a bump
    points.emplace_back(random.uniform_real(0., 1.), random.uniform_real(0., 1.),
                        i < 40 ? 0.1 : 0.);
  EXPECT_EQ(message_about(points), "none");
  points.emplace_back(0.5, -1e139, 0.);
  EXPECT_EQ(message_about(points), "none");
  points.emplace_back(0.5, -1e200, 0.);
  EXPECT_NE(message_about(points).find("index 1001 "), std::string::npos);
}

// as where a scanner writes the largest number for each direction that nothing came back from
TEST(Measurements, may_be_missing_nearly_everywhere)
{
  CGAL::Random random(29);
  const double most = (std::numeric_limits<double>::max)();
  for (std::size_t missing : {1U, 60U, 300U, 750U, 1000U, 1500U, 8000U})
    for (const Point& marker : {Point(most, most, most), Point(0.5, 0.5, most)})
    {
      std::vector<Point> points;
      for (int i = 0; i < 1000; ++i)
        points.emplace_back(random.uniform_real(0., 1.), random.uniform_real(0., 1.), 0.);
      points.insert(points.end(), missing, marker);
      EXPECT_NE(message_about(points).find("index 1000 "), std::string::npos) << missing;
      std::reverse(points.begin(), points.end());
      EXPECT_NE(message_about(points).find("index 0 "), std::string::npos) << missing;
    }
}

// The largest float is not too far for squares, but the others would be one point.
TEST(Measurements, may_be_missing_as_floats)
{
  CGAL::Random random(32);
  const double most = (std::numeric_limits<float>::max)();
  for (std::size_t missing : {1U, 60U, 300U, 1500U, 8000U})
  {
    std::vector<Point> points;
    for (int i = 0; i < 1000; ++i)
      points.emplace_back(random.uniform_real(0., 1.), random.uniform_real(0., 1.), 0.);
    points.insert(points.end(), missing, Point(most, most, most));
    // a few far ones do not decide over the others
    EXPECT_EQ(message_about(points),
              missing == 1U ? "none"
                            : "points: the point at index 1000 is more than 1e15 times as far from "
                              "many others as these are from each other");
  }
  // two dense clusters are measurements, and so are copies of a point that differ by rounding
  std::vector<Point> clusters, copies;
  for (int i = 0; i < 1000; ++i)
    clusters.emplace_back(random.uniform_real(0., 1e-9) + i % 2, 0., 0.);
  for (int i = 0; i < 40; ++i)
    copies.emplace_back(i % 4 == 0 ? 1e-20 * i : 0.1 * i, 0.01 * i * i, 0.);
  EXPECT_EQ(message_about(clusters), "none");
  EXPECT_EQ(message_about(copies), "none");
}

// A random thousand may say this or that of a half, and of a tenth that is left.
TEST(Measurements, are_checked_in_any_order)
{
  CGAL::Random random(31);
  for (double share : {0.45, 0.5, 0.9})
  {
    std::vector<Point> points;
    for (int i = 0; i < 20000; ++i)
      if (i < share * 20000.)
        points.emplace_back(1e300, 1e300, 1e300);
      else
        points.emplace_back(random.uniform_real(0., 1.), random.uniform_real(0., 1.), 0.);
    for (int i = 0; i < 20; ++i)
    {
      CGAL::cpp98::random_shuffle(points.begin(), points.end(), random);
      EXPECT_NE(message_about(points), "none") << share;
    }
  }
}

// A quarter of the points in a spot, anywhere: in a unit of theirs, all others are as far.
TEST(Measurements, have_one_scale)
{
  CGAL::Random random(30);
  for (double place : {0., 0.3, 1.})
  {
    std::vector<Point> points;
    for (int i = 0; i < 1000; ++i)
      if (i % 4 == 0)
        points.emplace_back(1e-150 * i, place, 1e-150 * (i % 17));
      else
        points.emplace_back(random.uniform_real(0., 1.), random.uniform_real(0., 1.), 0.);
    EXPECT_NE(message_about(points).find("from many others"), std::string::npos) << place;
    for (Point& p : points)
      if (p.y() == place)
        p = Point(0., place, 0.); // equal points are one
    EXPECT_EQ(message_about(points), "none") << place;
  }
}

TEST(Frame, has_a_diagonal_near_one_for_any_unit)
{
  for (double scale : {1e-320, 1e-300, 1e-6, 1., 1e6, 1e300})
  {
    const CGAL::Bbox_3 box(-scale, 0., 0., scale, 0., 0.);
    const Frame frame(box, box);
    const double diagonal = frame.length_to_frame(2. * scale);
    EXPECT_GE(diagonal, 0.5);
    EXPECT_LT(diagonal, 1.);
    EXPECT_EQ(frame.length_from_frame(diagonal), 2. * scale);
  }
  // longer than any number
  const double most = (std::numeric_limits<double>::max)();
  const CGAL::Bbox_3 largest(-most, -most, -most, most, most, most);
  const Frame frame(largest, largest);
  const Point corner = frame.to_frame(most, most, most);
  EXPECT_GE(corner.x(), 0.5 / (2. * std::sqrt(3.)));
  EXPECT_LT(corner.x(), 1. / (2. * std::sqrt(3.)));
  EXPECT_EQ(frame.from_frame(corner), Point(most, most, most));
}

} // namespace
