// Edges and corners: seen, and sampled

#include "inputs.h"

#include <CGAL/Curvature_aware_simplification_3/internal/features/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Neighborhood.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/bent_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/projection/fit_fold.h>
#include <CGAL/Curvature_aware_simplification_3/internal/projection/move_to_corners.h>
#include <CGAL/Curvature_aware_simplification_3/internal/projection/move_to_edges.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Uninitialized_vector.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <vector>

namespace {

using namespace inputs;

// two half planes that meet in the y-axis, one of them z = 0, with the angle between their normals
std::vector<Point> folded(std::size_t n, unsigned int seed, double angle)
{
  std::vector<Point> points = surfaces::square(n, seed);
  for (Point& p : points)
  {
    const double x = p.x() - 0.5, y = p.y() - 0.5;
    p = x < 0. ? Point(x, y, 0.) : Point(x * std::cos(angle), y, -x * std::sin(angle));
  }
  return points;
}

Neighborhood neighborhood_of(const std::vector<Point>& points, const Point& center, std::size_t k)
{
  Neighborhood neighborhood;
  neighborhood.collect(Neighbor_search(points, Tag()), center, k);
  neighborhood.weight_by_distance();
  return neighborhood;
}

TEST(Fold, has_an_edge)
{
  // x = 1 and y = 2 meet in a line, nearest to the origin at (1, 2, 0)
  Fold fold;
  fold.planes[0] = {Vector(1., 0., 0.), 1.};
  fold.planes[1] = {Vector(0., 1., 0.), 2.};
  EXPECT_EQ(fold.way_to_edge(Vector(0., 0., 0.)), Vector(1., 2., 0.));
  EXPECT_EQ(fold.way_to_edge(Vector(1., 2., 5.)), Vector(0., 0., 0.));
  EXPECT_EQ(fold.distance(Vector(0.5, 0., 0.)), 0.5);
  // x = 0 and x + z = 1, normals 45 degrees apart, meet in z = 1
  const double r = std::sqrt(0.5);
  fold.planes[0] = {Vector(1., 0., 0.), 0.};
  fold.planes[1] = {Vector(r, 0., r), r};
  const Vector way = fold.way_to_edge(Vector(0.5, 7., -1.));
  EXPECT_NEAR(way.x(), -0.5, 1e-14);
  EXPECT_NEAR(way.y(), 0., 1e-14);
  EXPECT_NEAR(way.z(), 2., 1e-14);
}

TEST(Fold, is_fitted_exactly)
{
  for (double angle : {0.9, 1.57, 2.2}) // of 0.79 to 2.36
    for (double x : {-0.01, 0., 0.01})  // 33 points are in a ball of 0.1
    {
      const std::vector<Point> points = folded(1000, 80, angle);
      const Point center(std::min(x, x * std::cos(angle)), 0.1, x > 0. ? -x * std::sin(angle) : 0.);
      const Neighborhood neighborhood = neighborhood_of(points, center, 33);
      Fold fold;
      ASSERT_TRUE(fit_fold(neighborhood, 0.03 * neighborhood.radius, fold)) << angle << ' ' << x;
      const Point on_edge = center + fold.way_to_edge(Vector(0., 0., 0.));
      EXPECT_NEAR(on_edge.x(), 0., 1e-9);
      EXPECT_NEAR(on_edge.y(), 0.1, 1e-9);
      EXPECT_NEAR(on_edge.z(), 0., 1e-9);
    }
}

TEST(Fold, is_fitted_to_noisy_points)
{
  const double sigma = 0.004;
  const std::vector<Point> points = with_noise(folded(3000, 81, 1.57), sigma, 82);
  const Neighborhood neighborhood = neighborhood_of(points, Point(0., 0., 0.), 97);
  Fold fold;
  ASSERT_TRUE(fit_fold(neighborhood, 3. * sigma, fold));
  const Vector way = fold.way_to_edge(Vector(0., 0., 0.));
  EXPECT_LT(std::abs(way.x()), sigma);
  EXPECT_LT(std::abs(way.z()), sigma);
}

TEST(Fold, is_not_fitted_to_other_surfaces)
{
  const auto has_fold = [](const std::vector<Point>& points, const Point& center, double noise) {
    const Neighborhood neighborhood = neighborhood_of(points, center, 33);
    Fold fold;
    return fit_fold(neighborhood, std::max(0.03 * neighborhood.radius, 3. * noise), fold);
  };
  const Point origin(0., 0., 0.);
  EXPECT_FALSE(has_fold(folded(1000, 83, 0.), origin, 0.));
  EXPECT_FALSE(has_fold(folded(1000, 84, 0.6), origin, 0.)); // 34 degrees
  EXPECT_FALSE(has_fold(with_noise(folded(1000, 83, 0.), 0.005, 85), origin, 0.005));
  int found = 0;
  const std::vector<Point> sphere = surfaces::sphere(1000, 86); // 21 degrees from center to border
  for (std::size_t i = 0; i < 200; ++i)
    found += has_fold(sphere, sphere[i], 0.) ? 1 : 0;
  EXPECT_EQ(found, 0);
  std::vector<Point> line, coinciding(40, origin);
  for (int i = 0; i < 40; ++i)
    line.emplace_back(i, 0., 0.);
  EXPECT_FALSE(has_fold(line, line[20], 0.));
  EXPECT_FALSE(has_fold(coinciding, origin, 0.));
  EXPECT_FALSE(has_fold({origin, Point(1., 0., 0.), Point(0., 1., 0.)}, origin, 0.));
}

TEST(Bent_points, are_those_that_noise_does_not_explain)
{
  // r^2 = 16 / rho = 1; sigma = 0.1 explains kappa = 0.02
  const Features features{
      {0.019, 0.021, 0.039, 0.041}, Uninitialized_vector<double>(4, 1. / 16.), 16};
  EXPECT_EQ(bent_points<Tag>(features, uniform_noise(0., 4)),
            (std::vector<std::uint8_t>{0, 1, 1, 1}));
  EXPECT_EQ(bent_points<Tag>(features, uniform_noise(0.1, 4)),
            (std::vector<std::uint8_t>{0, 0, 0, 1}));
}

TEST(Fold, is_seen_by_samples_on_both_sides)
{
  // the planes x = 0 and y = 0, samples with a spacing of 1
  Fold fold;
  fold.planes[0] = {Vector(1., 0., 0.), 0.};
  fold.planes[1] = {Vector(0., 1., 0.), 0.};
  const Point first(0.1, 2., 0.), second(2., -0.1, 0.), none(2., 2., 0.);
  const auto is_seen = [&](const std::vector<Point>& points, double distance = 0.5) {
    std::vector<std::size_t> neighbors(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      neighbors[i] = i;
    return is_seen_by_samples(fold, Point(0., 0., 0.), neighbor_indices(neighbors), points, 1.,
                              distance);
  };
  EXPECT_TRUE(is_seen({first, first, second, second, none}));
  EXPECT_FALSE(is_seen({first, second, none}));
  EXPECT_FALSE(is_seen({first, first, first}));
  EXPECT_FALSE(is_seen({}));
  // only the nearest 12 count
  std::vector<Point> many(12, first);
  many.push_back(second);
  EXPECT_FALSE(is_seen(many));
  // three of 12 may be elsewhere, one if the sample is in the first row beside the edge
  const auto with_others = [&](std::size_t number) {
    std::vector<Point> points(12, first);
    points[0] = second;
    std::fill_n(points.rbegin(), number, none);
    return points;
  };
  EXPECT_TRUE(is_seen(with_others(3)));
  EXPECT_FALSE(is_seen(with_others(4)));
  EXPECT_TRUE(is_seen(with_others(1), 0.7));
  EXPECT_FALSE(is_seen(with_others(2), 0.7));
}

TEST(Adaptive, leaves_few_gaps_on_sharp_edges)
{
  // 0.5 % of the gaps are longer than the 0.054 between uniform samples, and 4 % if only samples
  // within 0.65 spacings move onto an edge.
  std::size_t gaps = 0, wide_gaps = 0;
  for (unsigned int seed : {1u, 2u, 3u})
  {
    const std::vector<Point> result =
        simplified(cube(30000, seed), np::number_of_output_points(3000));
    for (int axis = 0; axis < 3; ++axis)
      for (double side : {0., 1.})
        for (double other_side : {0., 1.})
        {
          std::vector<double> along = {0., 1.};
          for (const Point& p : result)
            if (std::abs(p[(axis + 1) % 3] - side) < 1e-4 &&
                std::abs(p[(axis + 2) % 3] - other_side) < 1e-4)
              along.push_back(p[axis]);
          std::sort(along.begin(), along.end());
          gaps += along.size() - 1;
          for (std::size_t i = 1; i < along.size(); ++i)
            wide_gaps += along[i] - along[i - 1] > 0.054;
        }
  }
  EXPECT_GT(gaps, 1000u);
  EXPECT_LT(static_cast<double>(wide_gaps), 0.01 * static_cast<double>(gaps));
}

TEST(Adaptive, puts_samples_on_sharp_edges)
{
  // The samples are 0.054 apart if uniform, edges have a length of 12.
  const auto on_edges = [](const std::vector<Point>& points, double tolerance) {
    return std::count_if(points.begin(), points.end(),
                         [&](const Point& p) { return distance_to_edge(p) < tolerance; });
  };
  for (std::size_t n : {30000u, 100000u})
  {
    const std::vector<Point> result = simplified(cube(n, 87), np::number_of_output_points(3000));
    EXPECT_GT(on_edges(result, 1e-4), 12. / 0.054) << n;
    // along one of them, no hole, and none closer than a quarter of the least spacing, a half of
    // the mean: of 15,000 gaps in 40 such cubes, 19 are below 0.3 of it, and the least is 0.26
    std::vector<double> along;
    for (const Point& p : result)
      if (p.x() < 1e-4 && p.y() < 1e-4)
        along.push_back(p.z());
    along.insert(along.end(), {0., 1.});
    std::sort(along.begin(), along.end());
    for (std::size_t i = 1; i < along.size(); ++i)
      EXPECT_LT(along[i] - along[i - 1], 0.15) << n;
    for (std::size_t i = 2; i + 1 < along.size(); ++i)
      EXPECT_GT(along[i] - along[i - 1], 0.25 * 0.5 * 0.054) << n;
  }
  // fewer with noise: 175 to 228 for 12 such cubes; that of 0.001 is below 2 % of the spacing, not
  // visible
  for (double sigma : {0.001, 0.002})
    EXPECT_GT(on_edges(simplified(with_noise(cube(100000, 88), sigma, 89),
                                  np::number_of_output_points(3000)),
                       0.002),
              0.75 * 12. / 0.054);
}

TEST(Adaptive, puts_one_sample_into_each_corner_of_an_open_surface)
{
  const auto squared_distances = [](const std::vector<Point>& points, double x, double y) {
    std::vector<double> result;
    for (const Point& p : points)
      result.push_back((p.x() - x) * (p.x() - x) + (p.y() - y) * (p.y() - y));
    std::sort(result.begin(), result.end());
    return result;
  };
  // of 36 corners
  const auto check = [&](double sigma, double farthest, int least_filled, int most_crowded) {
    int filled = 0, crowded = 0;
    for (std::size_t n : {300u, 1000u, 3000u})
      for (unsigned int seed : {91u, 92u, 93u})
      {
        const std::vector<Point> output =
            simplified(with_noise(surfaces::square(30000, seed), sigma, seed + 10),
                       np::number_of_output_points(n));
        const double spacing = std::sqrt(2. / (std::sqrt(3.) * static_cast<double>(n)));
        for (double x : {0., 1.})
          for (double y : {0., 1.})
          {
            const std::vector<double> found = squared_distances(output, x, y);
            EXPECT_LT(std::sqrt(found[0]), farthest * spacing) << n << ' ' << sigma << ' ' << seed;
            filled += std::sqrt(found[0]) < 0.45 * spacing ? 1 : 0;
            crowded += std::sqrt(found[1]) < 0.45 * spacing ? 1 : 0;
          }
      }
    EXPECT_GE(filled, least_filled) << sigma;
    EXPECT_LE(crowded, most_crowded) << sigma;
  };
  // of 480 corners with other seeds, 7 to 10 are crowded
  check(0., 1., 35, 2);
  // a sixth of the input's spacing, that far a corner is blurred: of 480, one has no sample within
  // 1 spacing
  check(0.001, 1.2, 30, 5);
}

// There, the balls of all samples would each hold most of the input.
TEST(Adaptive, looks_for_no_corners_where_samples_are_crowded)
{
  std::vector<Point> points;
  for (int i = 0; i <= 100; ++i)
    for (int j = 0; j <= 100; ++j)
      points.emplace_back(0.01 * i, 0.01 * j, 0.);
  const Neighbor_search search(points, Tag());
  const Surface_fit fit{search};
  Surface_sample x;
  x.place(fit, Point(0.2, 0.2, 0.), CGAL::NULL_VECTOR, 1);
  x.spacing = 0.3;
  const std::vector<std::size_t> neighbors = {0, 1, 2};
  const auto corner = [&](double d) {
    const std::vector<Point> samples = {Point(0.2 + d, 0.2, 0.), Point(0.2, 0.2 + d, 0.),
                                        Point(0.2 + d, 0.2 + d, 0.)};
    return nearest_corner(x, neighbor_indices(neighbors), samples, fit);
  };
  const std::optional<Target> found = corner(0.3);
  ASSERT_TRUE(found);
  EXPECT_LT(std::sqrt(CGAL::squared_distance(found->point, Point(0., 0., 0.))), 1e-9);
  EXPECT_NEAR(found->distance, std::sqrt(0.08) / 0.3, 1e-9);
  EXPECT_FALSE(corner(0.02));
}

TEST(Corner, is_left_to_the_nearest_sample)
{
  // also to one that comes to be near without being a neighbor; of two that are equally near, one
  const Point corner(0., 0., 0.);
  const std::vector<Point> points = {Point(0.3, 0., 0.), Point(0., 0.2, 0.), Point(1., 1., 0.),
                                     Point(0.9, 1., 0.), Point(2., 2.1, 0.), Point(2., 2.1, 0.)};
  const Target crowded{Point(1., 1.1, 0.), 1.}, twice{Point(2., 2., 0.), 1.};
  std::vector<std::optional<Target>> targets = {
      Target{corner, 0.3}, Target{corner, 0.2}, std::nullopt, crowded, twice, twice};
  leave_to_nearest<Tag>(targets, points);
  EXPECT_FALSE(targets[0]);
  EXPECT_TRUE(targets[1] && targets[1]->point == corner);
  EXPECT_FALSE(targets[2]);
  EXPECT_FALSE(targets[3]) << "a sample without a target is nearer";
  EXPECT_NE(targets[4].has_value(), targets[5].has_value());
}

// Seen from above, all points of a plane are to one side, and one that noise had carried there was
// a corner.
TEST(Corner, is_in_the_plane_of_its_neighbors)
{
  const auto corner_at = [](const Point& place) {
    const std::vector<Point> points = surfaces::square(20000, 91);
    const Neighbor_search search(points, Tag());
    Neighborhood neighborhood;
    neighborhood.collect(search, place, 65);
    return is_corner(neighborhood, Vector(0., 0., 1.));
  };
  EXPECT_TRUE(corner_at(Point(0., 0., 0.)));
  EXPECT_TRUE(corner_at(Point(1., 1., 0.02)));
  EXPECT_FALSE(corner_at(Point(0.5, 0.5, 0.)));
  EXPECT_FALSE(corner_at(Point(0.5, 0.5, 0.1)));
  EXPECT_FALSE(corner_at(Point(0.5, 0., 0.02)));
}

TEST(Adaptive, takes_hardly_any_part_of_a_round_border_for_a_corner)
{
  std::vector<Point> disk;
  for (const Point& p : surfaces::square(60000, 94))
    if ((p.x() - 0.5) * (p.x() - 0.5) + (p.y() - 0.5) * (p.y() - 0.5) < 0.25)
      disk.push_back(p);
  Adaptive_settings without;
  without.move_to_corners = false;
  for (std::size_t n : {500u, 4000u})
  {
    std::vector<Point> output, expected;
    simplify_point_set<Tag>(disk, std::back_inserter(output), np::number_of_output_points(n),
                            Adaptive_settings());
    simplify_point_set<Tag>(disk, std::back_inserter(expected), np::number_of_output_points(n),
                            without);
    const double spacing = std::sqrt(CGAL_PI / (2. * std::sqrt(3.) * static_cast<double>(n)));
    double moved = 0.;
    for (std::size_t i = 0; i < n; ++i)
    {
      moved += output[i] != expected[i] ? 1. : 0.;
      EXPECT_LT(std::sqrt(CGAL::squared_distance(output[i], expected[i])), 0.8 * spacing);
    }
    EXPECT_LE(moved, 0.03 * CGAL_PI / spacing) << "of the samples on the border";
  }
}

TEST(Adaptive, sees_no_edges_and_no_corners_where_there_are_none)
{
  // as if there were no search for them
  const std::vector<Point> points = surfaces::torus(20000, 3., 1., 90);
  Adaptive_settings without;
  without.move_to_edges = false;
  without.move_to_corners = false;
  const auto result = [&](const Adaptive_settings& settings) {
    std::vector<Point> output;
    simplify_point_set<Tag>(points, std::back_inserter(output), np::default_values(), settings);
    return output;
  };
  EXPECT_EQ(result(without), result(Adaptive_settings()));
}

} // namespace
