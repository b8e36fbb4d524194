// How dense samples are, and their selection by it

#include "inputs.h"

#include <CGAL/Curvature_aware_simplification_3/internal/Scan.h>
#include <CGAL/Curvature_aware_simplification_3/internal/density/even_density.h>
#include <CGAL/Curvature_aware_simplification_3/internal/density/sampling_density.h>
#include <CGAL/Curvature_aware_simplification_3/internal/density/scale_to_number.h>
#include <CGAL/Curvature_aware_simplification_3/internal/density/surface_curvature.h>
#include <CGAL/Curvature_aware_simplification_3/internal/density/surface_pieces.h>
#include <CGAL/Curvature_aware_simplification_3/internal/features/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/select_along_curve.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Curve_ranges.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Uninitialized_vector.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/lattice_spacing.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/median.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace {

using namespace inputs;

Sampling_density density_of(const Cloud& cloud, std::size_t n, double alpha, double noise)
{
  Features features = compute_features<Tag, CGAL::Default_diagonalize_traits<double, 3>>(
      cloud, 16, Progress(no_callback));
  const double density = even_density<Tag>(features.inverse_density, n, 0.85);
  const Scan scan{{cloud.points, nullptr, cloud.coordinate_error},
                  std::move(features.inverse_density),
                  uniform_noise(cloud.frame.length_to_frame(noise), cloud.size()),
                  density,
                  {},
                  infinite_inverse_density,
                  false};
  return sampling_density<Tag>(scan, n, alpha, Adaptive_settings(), Progress(no_callback));
}

TEST(Sampling_density, integrates_to_the_number_of_samples)
{
  const Cloud cloud = cloud_of(surfaces::ellipsoid(20000, 3., 18));
  for (double alpha : {0., 2. / 3., 1.})
  {
    const Sampling_density wanted = density_of(cloud, 2000, alpha, 0.);
    double sum = 0.;
    for (std::size_t i = 0; i < cloud.size(); ++i)
      sum += wanted.weight[wanted.ranges.range_of(i)];
    EXPECT_NEAR(sum / 2000., 1., 0.1) << alpha; // the areas are measured at another scale
  }
}

// The middles of the faces are flat: c is 0, and the bound of c decides.
TEST(Sampling_density, tends_to_uniform_with_alpha)
{
  const Cloud cloud = cloud_of(cube(36000, 21));
  double last = std::numeric_limits<double>::infinity();
  for (double alpha : {1., 2. / 3., 0.1, 0.01, 1e-4, 1e-300})
  {
    const Sampling_density wanted = density_of(cloud, 1000, alpha, 0.);
    const auto range = std::minmax_element(wanted.density.begin(), wanted.density.end());
    ASSERT_GT(*range.first, 0.) << alpha;
    EXPECT_LT(*range.second / *range.first, last) << alpha;
    last = *range.second / *range.first;
  }
  EXPECT_NEAR(last, 1., 1e-9);
}

// Five ranges of 100 points and area 1, with at most 85 samples: how many each gets
std::vector<double> samples_of_ranges(std::vector<double> wanted, double number)
{
  scale_to_number<Tag>(wanted, number, Curve_ranges{5, 500}, std::vector<double>(5, 1.), 0.85);
  return wanted;
}

void expect_samples(const std::vector<double>& samples, const std::vector<double>& expected)
{
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(samples[i], expected[i], 1e-9 * expected[i]) << i;
}

// 100 points that stand for an area of 1 each, and one that is far
TEST(Even_density, does_not_count_areas_without_samples)
{
  Uninitialized_vector<double> inverse_density(101, 1. / CGAL_PI);
  const auto density = [&](std::size_t number) {
    EXPECT_EQ(even_density<Tag>(inverse_density, number, 0.85),
              even_density<CGAL::Sequential_tag>(inverse_density, number, 0.85));
    return even_density<Tag>(inverse_density, number, 0.85);
  };
  EXPECT_NEAR(density(10), 10. / 101., 1e-12);
  EXPECT_NEAR(density(100), 100. / 101., 1e-12); // of more than 0.85 for each point
  inverse_density[50] = 1e6 / CGAL_PI;
  EXPECT_NEAR(density(10), 9.15 / 100., 1e-12);
  EXPECT_NEAR(density(80), (80. - 160. / 101.) / 100., 1e-12); // twice its share
}

TEST(Sampling_density, gives_what_the_limit_takes_to_all_others)
{
  expect_samples(samples_of_ranges({3., 1., 1., 1., 1.}, 70.), {30., 10., 10., 10., 10.});
  expect_samples(samples_of_ranges({60., 1., 1., 1., 2.}, 105.), {85., 4., 4., 4., 8.});
  expect_samples(samples_of_ranges({1e12, 1e9, 1e6, 1e3, 1.}, 225.),
                 {85., 85., 55e6 / 1001001., 55e3 / 1001001., 55. / 1001001.});
}

TEST(Sampling_density, exceeds_the_limit_alike_if_all_must)
{
  expect_samples(samples_of_ranges({1e12, 1., 5., 1e3, 1.}, 425.), {85., 85., 85., 85., 85.});
  expect_samples(samples_of_ranges({1e12, 1., 5., 1e3, 1.}, 450.), {90., 90., 90., 90., 90.});
}

TEST(Sampling_density, takes_the_mean_over_the_ball_by_area)
{
  // pieces on a line, at distances that differ so that it is clear which are nearest
  const std::vector<Point> places = {Point(0., 0., 0.), Point(1., 0., 0.),  Point(2.1, 0., 0.),
                                     Point(3., 0., 0.), Point(4.1, 0., 0.), Point(5., 0., 0.)};
  Uninitialized_vector<Surface_piece> pieces;
  for (const Point& p : places)
    pieces.push_back({p, {}, 1., p.x() == 4.1 ? 3. : 1.}); // the area is the last
  const auto balls_of = [&](const std::vector<Point>& centers, std::size_t number) {
    return Surface_balls(centers, pieces, std::vector<std::size_t>(centers.size(), number),
                         Progress(no_callback), Tag());
  };
  // one piece in each range: 0 up to x = 3, 8 from x = 4 on
  const std::vector<double> value = {0., 0., 0., 0., 8., 8.};
  const auto mean = [&](double p, std::size_t number) {
    return mean_over_balls<Tag>(value, p, pieces, 1, balls_of(places, number));
  };
  EXPECT_EQ(mean(1., 1), value);
  const std::vector<double> expected = {0., 0., 0., 8. * 3. / 5., 8. * 4. / 5., 8. * 4. / 5.};
  const std::vector<double> found = mean(1., 3);
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(found[i], expected[i], 1e-12) << i;
  for (double x : mean(2. / 3., 6)) // all of them: half of the area
    EXPECT_NEAR(x, 8. * std::pow(0.5, 1.5), 1e-12);

  // two pieces in each range
  const std::vector<double> of_pairs = mean_over_balls<Tag>(
      {0., 5., 10.}, 1., pieces, 2, balls_of({places[0], places[2], places[4]}, 3));
  EXPECT_NEAR(of_pairs[0], 5. / 3., 1e-12);                    // 0, 1, 2.1
  EXPECT_NEAR(of_pairs[1], 2. * 5. / 3., 1e-12);               // 1, 2.1, 3
  EXPECT_NEAR(of_pairs[2], (5. + 3. * 10. + 10.) / 5., 1e-12); // 3, 4.1, 5
}

// Two halves of a plane, one with 10 times as many points. The density is even, as long as samples
// are no more than 0.85 times as dense as the points of the sparse half, of which there are 4000.
TEST(Sampling_density, is_even_where_samples_are_nearly_as_dense_as_points)
{
  std::vector<Point> points;
  CGAL::Random random(97);
  for (int i = 0; i < 44000; ++i)
    points.emplace_back(random.uniform_real(0., 1.) + (i < 40000 ? 0. : 1.),
                        random.uniform_real(0., 1.), 0.);
  const Cloud cloud = cloud_of(points);
  for (const auto& [n, ratio] :
       {std::pair(1000u, 1.), {3600u, 1.}, {5600u, 1.}, {16000u, 3400. / 12600.}})
  {
    const Sampling_density wanted = density_of(cloud, n, 2. / 3., 0.);
    std::vector<double> dense, sparse;
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
      const double x = cloud.frame.from_frame(cloud.points[i]).x();
      if (std::abs(x - 1.) > 0.2)
        (x < 1. ? dense : sparse).push_back(wanted.density[wanted.ranges.range_of(i)]);
    }
    EXPECT_NEAR(median(sparse) / median(dense) / ratio, 1., 0.1) << n;
  }
}

TEST(Sampling_density, follows_the_curvature)
{
  // a torus with radii 3 and 1 has the principal curvatures 1 and 1/4 on the outer side, 1 and -1/2
  // on the inner side
  const Cloud cloud = cloud_of(surfaces::torus(100000, 3., 1., 19));
  const auto ratio = [&](double alpha) {
    const Sampling_density wanted = density_of(cloud, 4000, alpha, 0.);
    double inner = 0., outer = 0., inner_count = 0., outer_count = 0.;
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
      const Point p = cloud.frame.from_frame(cloud.points[i]);
      const double r = std::hypot(p.x(), p.y());
      if (r < 2.1)
      {
        inner += wanted.density[wanted.ranges.range_of(i)];
        inner_count += 1.;
      }
      if (r > 3.9)
      {
        outer += wanted.density[wanted.ranges.range_of(i)];
        outer_count += 1.;
      }
    }
    return inner / inner_count / (outer / outer_count);
  };
  EXPECT_NEAR(ratio(0.), 1., 0.02);
  // the standard deviation of the heights (k1 x^2 + k2 y^2) / 2 over a disk, drawn
  const auto deviation = [](double k1, double k2) {
    CGAL::Random random(20);
    double sum = 0., squares = 0.;
    const int n = 100000;
    for (int i = 0; i < n; ++i)
    {
      const double r = std::sqrt(random.uniform_real(0., 1.));
      const double t = random.uniform_real(0., 2. * CGAL_PI);
      const double h = (k1 * std::pow(r * std::cos(t), 2) + k2 * std::pow(r * std::sin(t), 2)) / 2.;
      sum += h;
      squares += h * h;
    }
    return std::sqrt(squares / n - sum * sum / n / n);
  };
  const double inner = deviation(1., -0.5), outer = deviation(1., 0.25);
  const double expected = std::pow(inner / outer, 2. / 3.);
  // the lower bound, half of the mean, is added in squares and evens out a little
  EXPECT_GT(ratio(2. / 3.), 1. + 0.5 * (expected - 1.));
  EXPECT_LT(ratio(2. / 3.), 1.1 * expected);
}

TEST(Surface_pieces, know_the_covariance_of_all_their_points)
{
  const std::vector<Point> points = surfaces::ellipsoid(1000, 3., 95);
  Uninitialized_vector<double> inverse_density(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    inverse_density[i] = 0.01 * static_cast<double>(i % 7);
  for (std::size_t number : {1u, 37u, 1000u})
  {
    const Uninitialized_vector<Surface_piece> pieces =
        surface_pieces<Tag>(points, inverse_density, number);
    const Point x(0.1, 0.2, 0.3);
    const Surface_balls ball({x}, pieces, {number}, Progress(no_callback), Tag());
    const Deviation found = deviation_from_plane(pieces, ball.of(0), x, 0.);

    const auto offset = [&](const Point& p) {
      return Eigen::Vector3d(p.x() - x.x(), p.y() - x.y(), p.z() - x.z());
    };
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Point& p : points)
      mean += offset(p) / 1000.;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (const Point& p : points)
      covariance += (offset(p) - mean) * (offset(p) - mean).transpose() / 1000.;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
    EXPECT_NEAR(found.squared_height / solver.eigenvalues()(0), 1., 1e-12) << number;
    EXPECT_NEAR(found.trace / covariance.trace(), 1., 1e-12) << number;
    EXPECT_NEAR(found.squared_offset / mean.squaredNorm(), 1., 1e-10) << number;
    EXPECT_DOUBLE_EQ(found.number, 1000.);
    EXPECT_NEAR(found.area, CGAL_PI * 0.01 * (142. * 21. + 15.), 1e-9)
        << number; // 0 to 6, and 0 to 5
  }
}

TEST(Sampling_density, counts_borders_twice)
{
  const Cloud cloud = cloud_of(surfaces::square(100000, 96));
  const Sampling_density wanted = density_of(cloud, 1000, 2. / 3., 0.);
  const double spacing = std::sqrt(2. / std::sqrt(3.) / 1000.);
  double border = 0., inside = 0., border_count = 0., inside_count = 0.;
  for (std::size_t i = 0; i < cloud.size(); ++i)
  {
    const Point p = cloud.frame.from_frame(cloud.points[i]);
    const double along = std::min(p.y(), 1. - p.y());
    const double distance = std::min(p.x(), 1. - p.x());
    if (along < 2. * spacing)
      continue;
    if (distance < 0.1 * spacing)
    {
      border += wanted.weight[wanted.ranges.range_of(i)];
      border_count += 1.;
    }
    if (distance > 2. * spacing)
    {
      inside += wanted.weight[wanted.ranges.range_of(i)];
      inside_count += 1.;
    }
  }
  // less than 2, since whole ranges of the curve have one weight
  EXPECT_GT(border / border_count / (inside / inside_count), 1.2);
  EXPECT_LT(border / border_count / (inside / inside_count), 2.);
}

// Otherwise the density follows the rounding errors of the heights, which are larger far from the
// origin.
TEST(Sampling_density, of_planes_and_lines_is_even)
{
  const auto largest_over_smallest = [](const std::vector<Point>& points) {
    const Cloud cloud = cloud_of(points);
    const std::vector<double> density = density_of(cloud, 500, 1., 0.).density;
    return *std::max_element(density.begin(), density.end()) /
           *std::min_element(density.begin(), density.end());
  };
  std::vector<Point> tilted, far_away, line;
  for (const Point& p : surfaces::square(5000, 47))
  {
    tilted.emplace_back(p.x(), p.y(), p.x() / 3. + p.y() / 7.);
    far_away.emplace_back(p.x() + 1e6, p.y(), p.x() / 3. - p.y() / 7. + 1e6);
    line.emplace_back(p.x(), p.x() / 3., p.x() / 7.);
  }
  EXPECT_DOUBLE_EQ(largest_over_smallest(tilted), 1.);
  EXPECT_DOUBLE_EQ(largest_over_smallest(far_away), 1.);
  EXPECT_DOUBLE_EQ(largest_over_smallest(line), 1.);
}

TEST(Sampling_density, of_a_noisy_plane_is_even)
{
  const double sigma = 0.003;
  const Cloud cloud = cloud_of(with_noise(surfaces::square(40000, 21), sigma, 22));
  const Sampling_density wanted = density_of(cloud, 2000, 2. / 3., sigma);
  const auto range = std::minmax_element(wanted.density.begin(), wanted.density.end());
  EXPECT_LT(*range.second / *range.first, 1.5);
}

// lambda_0 is 4 sigma^2, of which noise explains one, and 2 sqrt(2 / 8) by chance; if points share
// it so that they tell as much as half of them, 2 sqrt(2 / 4)
TEST(Sampling_density, takes_less_for_curvature_where_points_share_their_noise)
{
  const Deviation deviation{0.04, 2., 0., 8., 1.};
  const double sigma = 0.1, shared_sigma = std::sqrt(2.) * sigma;
  const auto expect = [&](const Noise& noise, double squared_height, double possible) {
    const Local_curvature local = curvature_of(deviation, noise);
    EXPECT_NEAR(local.curvature, std::sqrt(squared_height) / 2., 1e-12);
    EXPECT_NEAR(local.possible_curvature, std::sqrt(possible) / 2., 1e-12);
  };
  expect(no_noise, 0.04, 0.04);
  expect(Noise{sigma, sigma}, 0.02, 0.03);
  expect(Noise{sigma, shared_sigma}, 0.03 - 0.01 * std::sqrt(2.), 0.03);
  expect(Noise{sigma, 0.5 * sigma}, 0.02, 0.03);
  expect(Noise{sigma, 4. * sigma}, 0., 0.04);
}

std::vector<std::size_t> selected_along_curve(const std::vector<double>& weight, std::size_t number,
                                              std::uint64_t seed)
{
  return select_along_curve<Tag>(Curve_ranges{weight.size(), weight.size()}, weight, number, seed);
}

TEST(Select_along_curve, takes_one_of_each_piece)
{
  const std::vector<double> weight = {1., 1., 1., 1., 1., 1., 1., 1.};
  for (std::uint64_t seed = 0; seed < 20; ++seed)
  {
    const std::vector<std::size_t> selected = selected_along_curve(weight, 4, seed);
    ASSERT_EQ(selected.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_EQ(selected[i] / 2, i);
  }
}

TEST(Select_along_curve, has_probabilities_as_the_weights)
{
  const std::vector<double> weight = {0.1, 0.4, 0.2, 0.8, 0.3, 0.2};
  std::vector<double> frequency(weight.size(), 0.);
  const int seeds = 20000;
  for (int seed = 0; seed < seeds; ++seed)
  {
    const std::vector<std::size_t> selected =
        selected_along_curve(weight, 2, static_cast<std::uint64_t>(seed));
    ASSERT_EQ(selected.size(), 2u);
    for (std::size_t i : selected)
      frequency[i] += 1. / seeds;
  }
  for (std::size_t i = 0; i < weight.size(); ++i)
    EXPECT_NEAR(frequency[i], weight[i], 5. * std::sqrt(0.25 / seeds)) << i;
}

TEST(Select_along_curve, is_exact_for_extreme_weights)
{
  using Indices = std::vector<std::size_t>;
  EXPECT_EQ(selected_along_curve({0., 0., 1e9, 0., 0.}, 3, 1), (Indices{2, 3, 4}));
  EXPECT_EQ(selected_along_curve({1., 0., 0., 0., 0.}, 5, 1), (Indices{0, 1, 2, 3, 4}));
  EXPECT_EQ(selected_along_curve({0., 0., 0., 1e-300}, 2, 1), (Indices{2, 3}));
}

TEST(Select_along_curve, is_the_same_with_weights_by_range)
{
  // 3 ranges of 10 points: 0 to 3, 4 to 6, 7 to 9
  const Curve_ranges ranges{3, 10};
  EXPECT_EQ(ranges.first_point(1), 4u);
  EXPECT_EQ(ranges.first_point(2), 7u);
  EXPECT_EQ(ranges.first_point(3), 10u);
  const std::vector<double> weight_of_range = {0.25, 2., 0.5};
  std::vector<double> weight;
  for (std::size_t i = 0; i < 10; ++i)
    weight.push_back(weight_of_range[ranges.range_of(i)]);
  EXPECT_EQ(weight, (std::vector<double>{0.25, 0.25, 0.25, 0.25, 2., 2., 2., 0.5, 0.5, 0.5}));
  for (std::uint64_t seed = 0; seed < 100; ++seed)
    for (std::size_t number = 1; number <= 10; ++number)
      EXPECT_EQ(select_along_curve<Tag>(ranges, weight_of_range, number, seed),
                selected_along_curve(weight, number, seed));
}

} // namespace
