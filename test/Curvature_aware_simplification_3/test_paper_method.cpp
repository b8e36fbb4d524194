// The stages of the paper, against numbers worked out by hand

#include "inputs.h"

#include <CGAL/Curvature_aware_simplification_3/internal/features/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/paper/Curvature_weights.h>
#include <CGAL/Curvature_aware_simplification_3/internal/paper/density_weights.h>
#include <CGAL/Curvature_aware_simplification_3/internal/paper/relax.h>
#include <CGAL/Curvature_aware_simplification_3/internal/paper/sample_spacing.h>
#include <CGAL/Curvature_aware_simplification_3/internal/paper/select_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/read_parameters.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

namespace {

using namespace inputs;

TEST(Curvature_weights, at_the_ends_and_at_one)
{
  const Curvature_weights weights(2.);
  EXPECT_DOUBLE_EQ(weights.attraction(0.), 0.1);
  EXPECT_DOUBLE_EQ(weights.attraction(1.), 0.1 + 1. / 1.75);
  EXPECT_NEAR(weights.attraction(20.), 1.42890365448505, 1e-14);
  EXPECT_NEAR(weights.repulsion_amplitude(0.), 1.43333333333333, 1e-14);
  EXPECT_DOUBLE_EQ(weights.repulsion_amplitude(1.), 0.1 + 1. / 1.75);
  EXPECT_NEAR(weights.repulsion_amplitude(20.), 0.10249532127261, 1e-14);
  EXPECT_DOUBLE_EQ(Curvature_weights::repulsion(0.2, 0.6), 0.4);
}

TEST(Curvature_weights, do_not_depend_on_curvature_for_exponent_zero)
{
  const Curvature_weights weights(0.);
  for (double curvature : {0., 1e-300, 1e-3, 1., 20.})
  {
    EXPECT_EQ(weights.attraction(curvature), weights.attraction(1.));
    EXPECT_EQ(weights.repulsion_amplitude(curvature), weights.attraction(1.));
  }
}

TEST(Selection_probability, of_four_points_by_hand)
{
  const std::vector<double> curvature = {0., 0.1, 0.2, 0.1}, inverse_density = {1., 1., 2., 4.};
  const Selection_probability F(2. / 4., 0.75, 2. / 3., 0.1, 2.);
  EXPECT_NEAR(F(curvature[0], inverse_density[0]), 0.5 * (0.25 * 2. / 3. + 0.75 / 3.), 1e-15);
  EXPECT_NEAR(F(curvature[0], inverse_density[0]), 0.2083333333333333, 1e-15);
  EXPECT_NEAR(F(curvature[1], inverse_density[1]), 0.4583333333333333, 1e-15);
  EXPECT_NEAR(F(curvature[2], inverse_density[2]), 0.75, 1e-15);
  EXPECT_NEAR(F(curvature[3], inverse_density[3]), 0.5833333333333333, 1e-15);
  // a plane: no curvature anywhere, so that its term is that of a constant
  EXPECT_DOUBLE_EQ(Selection_probability(0.5, 0.75, 2. / 3., 0., 2.)(0., 2.), 0.5);
}

Parameters selection_parameters(std::size_t n, std::uint64_t seed)
{
  const auto np = CGAL::parameters::number_of_output_points(n).random_seed(seed);
  return read_parameters(np, n);
}

TEST(Selection, is_exact_and_follows_the_probabilities)
{
  // features made by hand on a cloud of 40 points
  const std::vector<Point> points = surfaces::sphere(40, 2);
  const Cloud cloud = cloud_of(points);
  Features features;
  for (std::size_t i = 0; i < cloud.size(); ++i)
  {
    features.surface_variation.push_back(0.01 * static_cast<double>(cloud.input_index[i] % 4));
    features.inverse_density.push_back(1. + static_cast<double>(cloud.input_index[i] % 2));
  }
  const Selection_probability F(0.25, 0.75, 2. / 3., 0.015, 1.5);

  const int seeds = 4000;
  std::vector<double> frequency(points.size(), 0.);
  for (int seed = 0; seed < seeds; ++seed)
  {
    const std::vector<std::size_t> selected = select_points<Tag>(
        cloud, features, selection_parameters(10, static_cast<std::uint64_t>(seed)));
    ASSERT_EQ(selected.size(), 10u);
    ASSERT_TRUE(std::is_sorted(selected.begin(), selected.end()));
    ASSERT_EQ(std::adjacent_find(selected.begin(), selected.end()), selected.end());
    for (std::size_t i : selected)
      frequency[i] += 1. / seeds;
  }
  // Removing and inserting at random pulls the frequencies a little towards N / M.
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const double probability =
        F(0.01 * static_cast<double>(i % 4), 1. + static_cast<double>(i % 2));
    EXPECT_NEAR(frequency[i], probability, 0.04) << i;
    EXPECT_LT(std::abs(frequency[i] - 0.25), std::abs(probability - 0.25) + 0.03) << i;
  }
}

TEST(Selection, takes_duplicates_only_when_it_must)
{
  std::vector<Point> points = surfaces::sphere(30, 4);
  points.insert(points.end(), 270, points.front());
  const Cloud cloud = cloud_of(points);
  const Features features = compute_features<Tag, CGAL::Default_diagonalize_traits<double, 3>>(
      cloud, 8, Progress(no_callback));
  EXPECT_EQ(features.number_of_neighbors, 8u);
  const Features with_all = compute_features<Tag, CGAL::Default_diagonalize_traits<double, 3>>(
      cloud, 100, Progress(no_callback));
  EXPECT_EQ(with_all.number_of_neighbors, 29u);
  const std::vector<std::size_t> few =
      select_points<Tag>(cloud, features, selection_parameters(30, 1));
  EXPECT_TRUE(few.back() < 30u);
  const std::vector<std::size_t> many =
      select_points<Tag>(cloud, features, selection_parameters(100, 1));
  EXPECT_EQ(many.size(), 100u);
  EXPECT_EQ(many[29], 29u);
}

TEST(Sample_spacing, of_random_points_and_of_a_lattice)
{
  // 4 pi area for 2000 points; a hexagonal lattice has sqrt(3) / 2 s^2 per point
  const double s = std::sqrt(4. * CGAL_PI / 2000. * 2. / std::sqrt(3.));
  EXPECT_NEAR(sample_spacing<Tag>(surfaces::sphere(2000, 6)) / s, 1., 0.03);

  // the 18th neighbor is at 2 s, where 14.5 others are expected: sqrt(14.5 / 18) = 0.898
  std::vector<Point> points;
  for (int i = 0; i < 60; ++i)
    for (int j = 0; j < 60; ++j)
      points.emplace_back(0.01 * (i + 0.5 * (j % 2)), 0.01 * j * std::sqrt(3.) / 2., 0.);
  EXPECT_NEAR(sample_spacing<Tag>(points), 0.00898, 1e-5);

  // one neighbor in a disk of radius 1: sqrt(2 pi / sqrt(3))
  EXPECT_NEAR(sample_spacing<Tag>({Point(0, 0, 0), Point(1, 0, 0)}), 1.90463, 1e-5);

  EXPECT_EQ(sample_spacing<Tag>({Point(1, 1, 1)}), 0.);
  EXPECT_EQ(sample_spacing<Tag>({Point(1, 1, 1), Point(1, 1, 1)}), 0.);
}

TEST(Relaxation, of_one_sample_among_three_points_by_hand)
{
  // h = 4, hence theta(r) = exp(-r^2). The sample at the origin has kappa = 1.
  const std::vector<Point> points = {Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 2)};
  const Curvature_weights weights(2.);
  const Neighbor_search search(points, Tag());
  const Attractors attractors{
      search, {weights.attraction(0.), weights.attraction(20.), weights.attraction(1.)}};
  const Vector attracted = attraction(attractors, Point(0, 0, 0), 4.).mean;
  // (w1, w2, 2 w3) / (w1 + w2 + w3) with w1 = 0.1 / e, w2 = 1.42890365 / e, w3 = 0.67142857 / e^4 /
  // 2
  EXPECT_NEAR(attracted.x(), 0.0646990443, 1e-6);
  EXPECT_NEAR(attracted.y(), 0.9244870086, 1e-6);
  EXPECT_NEAR(attracted.z(), 0.0216278943, 1e-6);

  EXPECT_EQ(attraction(attractors, Point(0.5, 0, 0), 4.).nearest, std::size_t(0));
  EXPECT_EQ(attraction(attractors, Point(0, 0, 2.5), 4.).nearest, std::size_t(2));

  const std::vector<Point> samples = {Point(0, 0, 0), Point(0.5, 0, 0), Point(0, -1, 0)};
  const Neighbor_search sample_search(samples, Tag());
  const std::vector<double> amplitude = {weights.repulsion_amplitude(1.),
                                         weights.repulsion_amplitude(0.),
                                         weights.repulsion_amplitude(20.)};
  const Vector repelled = repulsion(samples, sample_search, amplitude, {}, 4., 0);
  EXPECT_NEAR(repelled.x(), -0.4600472344, 1e-9);
  EXPECT_NEAR(repelled.y(), 0.0799055312, 1e-9);
  EXPECT_NEAR(repelled.z(), 0., 1e-15);

  // both together, mu = 0.45
  const auto curvature_at = [](const Point& x, const std::optional<std::size_t>& nearest) {
    EXPECT_TRUE(nearest);
    return x.x() > 0. ? 0. : x.y() < 0. ? 20. : 1.;
  };
  const std::vector<Point> moved =
      relax<Tag>(samples, attractors, weights, Relaxation{4., 0.45, false}, curvature_at,
                 Progress(no_callback));
  EXPECT_NEAR(moved[0].x(), -0.1423222112, 1e-6);
  EXPECT_NEAR(moved[0].y(), 0.9604444976, 1e-6);
  EXPECT_NEAR(moved[0].z(), 0.0216278943, 1e-6);
}

TEST(Relaxation, without_anything_in_reach_stays)
{
  const std::vector<Point> far = {Point(100, 0, 0)};
  const Neighbor_search search(far, Tag());
  const auto curvature_at = [](const Point&, const std::optional<std::size_t>& nearest) {
    EXPECT_FALSE(nearest);
    return 0.;
  };
  const std::vector<Point> moved =
      relax<Tag>({Point(0, 0, 0)}, Attractors{search, {1.}}, Curvature_weights(2.),
                 Relaxation{1., 0.45, true}, curvature_at, Progress(no_callback));
  EXPECT_EQ(moved[0], Point(0, 0, 0));
}

TEST(Density_weights, of_two_points_by_hand)
{
  const std::vector<Point> points = {Point(0, 0, 0), Point(1, 0, 0), Point(9, 0, 0)};
  const Neighbor_search search(points, Tag());
  const std::vector<double> weights =
      density_weights<Tag>(points, search, 4., Progress(no_callback));
  EXPECT_NEAR(weights[0], 1. + std::exp(-1.), 1e-15);
  EXPECT_NEAR(weights[1], 1. + std::exp(-1.), 1e-15);
  EXPECT_EQ(weights[2], 1.);
}

} // namespace
