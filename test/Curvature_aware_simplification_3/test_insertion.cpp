// Samples that are inserted at tips and ridges that the others miss

#include "inputs.h"

#include <CGAL/Curvature_aware_simplification_3/internal/projection/insert_samples.h>
#include <CGAL/Curvature_aware_simplification_3/internal/projection/triangles_around.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace {

using namespace inputs;

// at the origin, with the normal z
Surface_sample sample_at_origin(double spacing)
{
  Surface_sample x;
  x.spacing = spacing;
  return x;
}

// of all the points
std::vector<Triangle> triangles_of(const Surface_sample& x, const std::vector<Point>& points)
{
  std::vector<std::size_t> all(points.size());
  std::iota(all.begin(), all.end(), std::size_t(0));
  return triangles_around(x, neighbor_indices(all), points);
}

std::vector<Point> hexagon(double radius)
{
  std::vector<Point> points;
  for (int i = 0; i < 6; ++i)
    points.emplace_back(radius * std::cos(i * CGAL_PI / 3.), radius * std::sin(i * CGAL_PI / 3.),
                        0.);
  return points;
}

TEST(Triangles_around, are_those_of_a_delaunay_triangulation)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Base = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
  using Delaunay =
      CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Base>>;
  CGAL::Random random(70);
  for (int round = 0; round < 200; ++round)
  {
    // amid its neighbors, and beside them
    const double shift = round % 2 == 0 ? 0. : 0.7;
    std::vector<Point> points;
    Delaunay triangulation;
    const std::size_t center = 16;
    const auto vertex = triangulation.insert(Kernel::Point_2(0., 0.));
    vertex->info() = center;
    for (std::size_t i = 0; i < center; ++i)
    {
      const double x = random.uniform_real(-1., 1.) + shift, y = random.uniform_real(-1., 1.);
      points.emplace_back(x, y, 0.1 * random.uniform_real(0., 1.) * std::hypot(x, y));
      triangulation.insert(Kernel::Point_2(x, y))->info() = i;
    }
    std::set<std::set<Point>> expected, found;
    auto face = triangulation.incident_faces(vertex);
    const auto first = face;
    do
      if (!triangulation.is_infinite(face))
      {
        std::set<Point> corners;
        for (int i = 0; i < 3; ++i)
          if (face->vertex(i)->info() != center)
            corners.insert(points[face->vertex(i)->info()]);
        expected.insert(corners);
      }
    while (++face != first);
    for (const Triangle& t : triangles_of(sample_at_origin(1.), points))
    {
      EXPECT_EQ(t[0], Point(CGAL::ORIGIN));
      found.insert({t[1], t[2]});
    }
    EXPECT_EQ(found, expected) << round;
  }
}

TEST(Triangles_around, leave_out_another_sheet)
{
  std::vector<Point> points = hexagon(1.);
  points.emplace_back(0.1, 0., -0.3); // a thin part's other side
  points.emplace_back(0., 0., 0.);    // another sample at the same place
  const std::vector<Triangle> triangles = triangles_of(sample_at_origin(1.), points);
  ASSERT_EQ(triangles.size(), 6u);
  for (const Triangle& t : triangles)
    EXPECT_NEAR(std::sqrt(t.squared_area()), std::sqrt(3.) / 4., 1e-12);
}

TEST(Triangles_around, are_none_of_a_line)
{
  const std::vector<Point> points = {Point(-1., 0., 0.), Point(1., 0., 0.), Point(2., 0., 0.)};
  EXPECT_TRUE(triangles_of(sample_at_origin(1.), points).empty());
  EXPECT_TRUE(triangles_around(sample_at_origin(1.), neighbor_indices({}), points).empty());
}

// Where densities overflow, spacings are 0, and nothing in their unit is a number.
TEST(Triangles_around, are_none_without_a_unit)
{
  const std::vector<Point> points = hexagon(1.);
  EXPECT_TRUE(triangles_of(sample_at_origin(0.), points).empty());
}

TEST(Missed_points, are_as_far_as_from_the_triangles)
{
  // in any unit: squares and products of the smaller one underflow
  for (double unit : {1., 1e-120})
  {
    const std::vector<Point> points = hexagon(2. * unit);
    const Surface_sample x = sample_at_origin(unit);
    const std::vector<Triangle> triangles = triangles_of(x, points);
    const auto distance = [&](double a, double b, double c) {
      return distance_from_triangles(Point(a * unit, b * unit, c * unit), x, triangles) / unit;
    };
    EXPECT_NEAR(distance(0.5, 0.3, 0.25), 0.25, 1e-12);
    EXPECT_NEAR(distance(0., 0., -2.), 2., 1e-12);
    EXPECT_NEAR(distance(5., 0., 4.), 5., 1e-12); // 3, 0, 4 from the corner
  }
  EXPECT_EQ(distance_from_triangles(Point(3., 4., 0.), sample_at_origin(2.), {}), 5.);
}

// samples of a lattice, their neighbors, and a scan with these bent points
struct Lattice
{
  std::vector<Surface_sample> samples;
  Sample_neighbors neighbors;
  Scan scan;

  explicit Lattice(const std::vector<Point>& bent_points)
    : scan{without_positions(cloud_of(surfaces::square(2000, 71))),
           {},
           uniform_noise(0., 2000),
           1.,
           bent_points,
           infinite_inverse_density,
           false}
  {
    for (int i = 0; i < 10; ++i)
      for (int j = 0; j < 10; ++j)
      {
        samples.push_back(sample_at_origin(1.));
        samples.back().point = Point(i, j, 0.);
      }
    neighbors.search(points_of<Tag>(samples), Sample_neighbors::most, Tag());
  }
};

TEST(Insertion, is_where_samples_miss_most)
{
  // a tip and a point of its flank, a lower one, and points that are hardly missed
  const std::vector<Point> bent = {Point(2.5, 2.4, 0.5), Point(2.5, 2.5, 0.8), Point(7.3, 6.4, 0.3),
                                   Point(5.5, 5.5, 0.01), Point(8., 2., 0.)};
  Lattice lattice(bent);
  insert_samples<Tag>(lattice.samples, 3, lattice.neighbors, lattice.scan);
  ASSERT_EQ(lattice.samples.size(), 103u);
  EXPECT_EQ(lattice.samples[100].point, bent[1]);
  EXPECT_EQ(lattice.samples[101].point, bent[2]);
  EXPECT_EQ(lattice.samples[102].point, bent[3]);
}

TEST(Insertion, needs_no_unit)
{
  Lattice lattice({Point(2.5, 2.5, 0.8), Point(3., 3., 0.), Point(5.5, 5.5, 0.01)});
  for (Surface_sample& x : lattice.samples)
    x.spacing = 0.;
  for (const Missed_point& p :
       missed_points<Tag>(lattice.samples, lattice.neighbors, lattice.scan.bent_points))
    EXPECT_EQ(p.distance, 0.);
  insert_samples<Tag>(lattice.samples, 3, lattice.neighbors, lattice.scan);
  EXPECT_EQ(lattice.samples.size(), 103u);
}

TEST(Insertion, fills_gaps_where_no_other_place_is_missed)
{
  const std::vector<Point> bent = {Point(2.5, 2.4, 0.5), Point(2.5, 2.5, 0.8)};
  Lattice lattice(bent);
  insert_samples<Tag>(lattice.samples, 2, lattice.neighbors, lattice.scan);
  ASSERT_EQ(lattice.samples.size(), 102u);
  EXPECT_EQ(lattice.samples[100].point, bent[1]);
  const std::vector<Point>& input = lattice.scan.points; // in the unit square
  EXPECT_EQ(std::count(input.begin(), input.end(), lattice.samples[101].point), 1);
}

TEST(Insertion, takes_no_more_samples_than_bent_points_have)
{
  const auto number = [](std::size_t bent, bool is_noisy, bool had_outliers) {
    Lattice lattice(std::vector<Point>(bent, Point(0., 0., 0.)));
    lattice.scan.had_more_than_a_few_outliers = had_outliers;
    lattice.scan.noise.of_range[0].is_visible = is_noisy;
    return samples_to_insert(lattice.scan, 1000, 0.03);
  };
  EXPECT_EQ(number(0, false, false), 0u);
  EXPECT_EQ(number(20, false, false), 10u); // of 2000 points
  EXPECT_EQ(number(500, false, false), 30u);
  EXPECT_EQ(number(500, true, false), 0u);
  EXPECT_EQ(number(500, false, true), 0u);
}

// Cones that are narrower than samples are apart: their flanks have samples, and few tips had one.
TEST(Insertion, brings_samples_to_tips)
{
  constexpr double height = 0.04, apart = 0.2;
  const auto tip = [&](double x) { return std::lround(x / apart); };
  const auto from_tip = [&](double x) { return x - apart * static_cast<double>(tip(x)); };
  const std::vector<Point> points = patch(40000, 72, [&](double x, double y) {
    return (std::max)(height - 2. * std::hypot(from_tip(x), from_tip(y)), 0.);
  });
  // the mean over the tips of what the highest point on each is below it
  const auto missing = [&](const std::vector<Point>& on_surface) {
    std::map<std::pair<long, long>, double> highest;
    for (const Point& p : on_surface)
      if (std::hypot(from_tip(p.x()), from_tip(p.y())) < height / 2.)
      {
        double& z = highest[{tip(p.x()), tip(p.y())}];
        z = (std::max)(z, p.z());
      }
    EXPECT_EQ(highest.size(), 25u);
    double sum = 0.;
    for (const auto& tip_and_height : highest)
      sum += height - tip_and_height.second;
    return sum / static_cast<double>(highest.size());
  };
  const auto output = [&](double share_to_insert, double adaptivity = 2. / 3.) {
    Adaptive_settings settings;
    settings.share_to_insert = share_to_insert;
    std::vector<Point> result;
    simplify_point_set<Tag>(points, std::back_inserter(result),
                            np::number_of_output_points(2000).adaptivity(adaptivity), settings);
    EXPECT_EQ(result.size(), 2000u);
    return result;
  };
  EXPECT_LT(missing(output(0.045)), 1.1 * missing(points));
  EXPECT_GT(missing(output(0.)), 1.4 * missing(points));
  EXPECT_EQ(output(0.045, 0.), output(0., 0.)); // even samples are asked for
}

} // namespace
