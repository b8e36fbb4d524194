// The stages one by one, against closed forms, numbers worked out by hand, and brute force

#include "surfaces.h"

#include <CGAL/Curvature_aware_simplification_3/internal/Cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Counter_based_random.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Curvature_weights.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/density_weights.h>
#include <CGAL/Curvature_aware_simplification_3/internal/equal_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/prefix_sums.h>
#include <CGAL/Curvature_aware_simplification_3/internal/read_parameters.h>
#include <CGAL/Curvature_aware_simplification_3/internal/relax.h>
#include <CGAL/Curvature_aware_simplification_3/internal/sample_spacing.h>
#include <CGAL/Curvature_aware_simplification_3/internal/select_along_curve.h>
#include <CGAL/Curvature_aware_simplification_3/internal/select_points.h>
#include <CGAL/estimate_surface_variation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Curvature_aware_simplification_3::internal;
using Tag = CGAL::Parallel_if_available_tag;
using Point_and_value = std::pair<Point, double>;

const std::function<bool(double)> no_callback;

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

TEST(Random, is_uniform_and_independent_of_index_seed_and_stream)
{
  const Counter_based_random random(7, 0), other_seed(8, 0), other_stream(7, 1);
  double sum = 0., product = 0., product_seed = 0., product_stream = 0.;
  std::vector<int> histogram(16, 0);
  const int n = 100000;
  for (int i = 0; i < n; ++i)
  {
    const std::uint64_t index = static_cast<std::uint64_t>(i);
    const double u = random.uniform(index);
    ASSERT_GE(u, 0.);
    ASSERT_LT(u, 1.);
    sum += u;
    product += (u - 0.5) * (random.uniform(index + 1) - 0.5);
    product_seed += (u - 0.5) * (other_seed.uniform(index) - 0.5);
    product_stream += (u - 0.5) * (other_stream.uniform(index) - 0.5);
    ++histogram[static_cast<std::size_t>(16. * u)];
  }
  // five standard deviations: of the mean sqrt(1/12/n), of the correlations 1/12/sqrt(n)
  EXPECT_NEAR(sum / n, 0.5, 5. * std::sqrt(1. / 12. / n));
  for (double p : {product, product_seed, product_stream})
    EXPECT_NEAR(p / n, 0., 5. / 12. / std::sqrt(n));
  for (int count : histogram)
    EXPECT_NEAR(count, n / 16., 5. * std::sqrt(n / 16.));
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

Cloud cloud_of(const std::vector<Point>& points)
{
  return make_cloud<Tag>(points, std::numeric_limits<double>::epsilon());
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

TEST(Cloud, selects_duplicates_only_when_it_must)
{
  std::vector<Point> points = surfaces::sphere(30, 4);
  points.insert(points.end(), 270, points.front());
  const Cloud cloud = cloud_of(points);
  const Neighbor_search search(cloud.points, Tag());
  const Features features = compute_features<Tag, CGAL::Default_diagonalize_traits<double, 3>>(
      cloud, search, 8, Progress(no_callback));
  EXPECT_EQ(features.number_of_neighbors, 8u);
  const Features with_all = compute_features<Tag, CGAL::Default_diagonalize_traits<double, 3>>(
      cloud, search, 100, Progress(no_callback));
  EXPECT_EQ(with_all.number_of_neighbors, 29u);
  const std::vector<std::size_t> few =
      select_points<Tag>(cloud, features, selection_parameters(30, 1));
  EXPECT_TRUE(few.back() < 30u);
  const std::vector<std::size_t> many =
      select_points<Tag>(cloud, features, selection_parameters(100, 1));
  EXPECT_EQ(many.size(), 100u);
  EXPECT_EQ(many[29], 29u);
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

TEST(Curve_ranges, are_even_for_any_number_of_points)
{
  const auto expect_even = [](const Curve_ranges& ranges) {
    const std::size_t n = ranges.number_of_points;
    EXPECT_EQ(ranges.first_point(0), 0u);
    EXPECT_EQ(ranges.first_point(ranges.number), n);
    for (std::size_t i : {std::size_t(0), n / 7, n / 2, n - 2, n - 1})
    {
      const std::size_t range = ranges.range_of(i);
      EXPECT_LE(ranges.first_point(range), i);
      EXPECT_LT(i, ranges.first_point(range + 1));
      EXPECT_LE(ranges.size(range), n / ranges.number + 1);
    }
  };
  for (std::size_t number : {1u, 3u, 10u, 19u})
    expect_even({number, 10});
  for (std::size_t number :
       {7u, 1000003u, 2147483649u}) // the number of points times that of ranges has 71 bits
    expect_even({number, std::size_t(1) << 40});
  EXPECT_EQ((Curve_ranges{3, 10}.range_of(3)), 0u); // points 0 to 3, 4 to 6, 7 to 9
  EXPECT_EQ((Curve_ranges{3, 10}.range_of(4)), 1u);
  EXPECT_EQ((Curve_ranges{3, 10}.range_of(7)), 2u);
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

// Distributions that trouble search structures
std::vector<std::vector<Point>> distributions()
{
  CGAL::Random random(5);
  std::vector<Point> cube, lattice, line, clusters;
  for (int i = 0; i < 500; ++i)
  {
    const double x = random.uniform_real(0., 1.), y = random.uniform_real(0., 1.);
    cube.emplace_back(x, y, random.uniform_real(0., 1.));
    lattice.emplace_back(i % 8, (i / 8) % 8, i / 64);
    line.emplace_back(x, 2. * x, -x);
    clusters.emplace_back(x * 1e-8 + i % 2, y * 1e-8, 0.);
  }
  return {cube, lattice, line, clusters, {Point(1, 2, 3)}};
}

// without the points that are hidden
void expect_neighbors_as_by_brute_force(const Neighbor_search& search,
                                        const std::vector<Point>& points,
                                        const std::vector<std::uint8_t>& is_hidden)
{
  for (std::size_t q = 0; q < points.size(); q += 17)
  {
    const Point query = points[q] + Vector(1e-3, 0., 0.);
    std::vector<double> all, sorted;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      all.push_back(CGAL::squared_distance(query, points[i]));
      if (is_hidden[i] == 0)
        sorted.push_back(all[i]);
    }
    std::sort(sorted.begin(), sorted.end());

    const std::size_t k = 17; // or as many as there are
    std::vector<double> nearest;
    search.for_each_nearest(query, k, [&](std::size_t i, const Point& p, double squared_distance) {
      EXPECT_EQ(is_hidden[i], 0);
      EXPECT_EQ(p, points[i]);
      EXPECT_DOUBLE_EQ(squared_distance, all[i]);
      nearest.push_back(all[i]);
    });
    std::sort(nearest.begin(), nearest.end());
    sorted.resize((std::min)(k, sorted.size()));
    EXPECT_EQ(nearest, sorted); // distances and not indices: ties have no order

    const double radius = 1.001 * std::sqrt(sorted.back());
    std::set<std::size_t> expected, found;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (is_hidden[i] == 0 && all[i] <= radius * radius)
        expected.insert(i);
    search.for_each_within(query, radius,
                           [&](std::size_t i, const Point&, double) { found.insert(i); });
    EXPECT_EQ(found, expected);
    for (std::size_t most : {std::size_t(0), std::size_t(3), expected.size(), points.size()})
    {
      found.clear();
      search.for_each_within(
          query, radius, [&](std::size_t i, const Point&, double) { found.insert(i); }, most);
      EXPECT_EQ(found.size(), (std::min)(most + 1, expected.size()));
      EXPECT_TRUE(std::includes(expected.begin(), expected.end(), found.begin(), found.end()));
    }
    std::size_t asked = 0, even = 0;
    const auto is_even = [&](std::size_t i, const Point&, double) {
      ++asked;
      even += i % 2 == 0 ? 1 : 0;
      return i % 2 == 0;
    };
    const auto expected_even = static_cast<std::size_t>(
        std::count_if(expected.begin(), expected.end(), [](std::size_t i) { return i % 2 == 0; }));
    EXPECT_FALSE(search.are_more_within(query, radius, expected_even, is_even));
    EXPECT_EQ(asked, expected.size());
    EXPECT_EQ(even, expected_even);
    if (expected_even > 0)
    {
      even = 0;
      EXPECT_TRUE(search.are_more_within(query, radius, expected_even / 2, is_even));
      EXPECT_EQ(even, expected_even / 2 + 1); // and it stops
    }
  }
}

TEST(Neighbor_search, agrees_with_brute_force)
{
  for (const std::vector<Point>& points : distributions())
  {
    Neighbor_search search(points, Tag());
    const std::size_t n = points.size();
    std::vector<std::uint8_t> is_hidden(n, 0);
    expect_neighbors_as_by_brute_force(search, points, is_hidden);
    // every third; all near one; all but one
    for (std::size_t i = 1; i < n; i += 3)
      is_hidden[i] = 1;
    search.hide(is_hidden);
    expect_neighbors_as_by_brute_force(search, points, is_hidden);
    std::vector<std::size_t> by_distance(n);
    std::iota(by_distance.begin(), by_distance.end(), std::size_t(0));
    std::sort(by_distance.begin(), by_distance.end(), [&](std::size_t i, std::size_t j) {
      return CGAL::has_smaller_distance_to_point(points[0], points[i], points[j]);
    });
    for (std::size_t hidden : {n / 2, n - 1})
    {
      std::fill(is_hidden.begin(), is_hidden.end(), std::uint8_t(0));
      for (std::size_t i = 0; i < hidden; ++i)
        is_hidden[by_distance[i]] = 1;
      search.hide(is_hidden);
      EXPECT_EQ(search.size(), n - hidden);
      expect_neighbors_as_by_brute_force(search, points, is_hidden);
    }
    std::size_t found = 0;
    search.for_each_nearest(points[0], n + 1, [&](std::size_t, const Point&, double) { ++found; });
    EXPECT_EQ(found, 1u); // all that are left
  }
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

TEST(Neighbor_search, of_equal_points_is_not_as_deep_as_they_are_many)
{
  // with one point less at each level, the stack would overflow
  std::vector<Point> points(300000, Point(1., 2., 3.));
  const auto number_at = [](const std::vector<Point>& at, const Point& x, std::size_t k) {
    const Neighbor_search search(at, Tag());
    std::size_t number = 0;
    search.for_each_nearest(x, k, [&](std::size_t, const Point&, double squared_distance) {
      number += squared_distance == 0. ? 1 : 0;
    });
    return number;
  };
  EXPECT_EQ(number_at(points, points.front(), 20), 20u);
  EXPECT_EQ(number_at(points, points.front(), points.size()), points.size());

  // nor if they are at two places with no number in between
  const Point other(std::nextafter(1., 2.), 2., 3.);
  std::fill_n(points.begin(), 100000, other);
  EXPECT_EQ(number_at(points, other, 200000), 100000u);
  EXPECT_EQ(number_at(points, points.back(), points.size()), 200000u);
}

TEST(Neighbor_search, tells_how_far_the_nearest_are)
{
  const std::vector<Point> points = {Point(0., 0., 0.), Point(3., 0., 0.), Point(0., 1., 0.)};
  const Neighbor_search search(points, Tag());
  EXPECT_EQ(search.squared_distance_of_nearest(points[0], 1), 0.);
  EXPECT_EQ(search.squared_distance_of_nearest(points[0], 2), 1.);
  EXPECT_EQ(search.squared_distance_of_nearest(points[0], 3), 9.);
  EXPECT_EQ(search.squared_distance_of_nearest(points[0], 4), 9.);
}

// sizes around those where a call of a loop takes one, two and at most 64 indices
TEST(Loops, visit_each_index_once)
{
  for (std::size_t size : {0u, 1u, 1023u, 1024u, 1025u, 2049u, 65535u, 65536u, 100001u})
  {
    const std::size_t begin = 7;
    std::vector<int> visits(begin + size + 100, 0), expected = visits;
    std::fill_n(expected.begin() + 7, size, 1);
    for_each_index<Tag>(begin, begin + size, [&](std::size_t i) { ++visits[i]; });
    EXPECT_EQ(visits, expected) << size;
  }
}

TEST(Loops, report_progress_after_blocks_that_threads_can_share)
{
  const auto reports = [](std::size_t size) {
    std::vector<double> result;
    const std::function<bool(double)> record = [&](double share) {
      result.push_back(share);
      return true;
    };
    std::vector<int> visits(size);
    for_each_index<Tag>(size, Progress(record), [&](std::size_t i) { ++visits[i]; });
    EXPECT_EQ(visits, std::vector<int>(size, 1));
    return result;
  };
  EXPECT_EQ(reports(20), std::vector<double>({1.}));
  EXPECT_EQ(reports(127), std::vector<double>({64. / 127., 1.}));
  EXPECT_EQ(reports(1000).size(), 16u);
  EXPECT_EQ(reports(100000).size(), 20u);
}

// Beyond 2^32, without as many points: loops hand out the indices they are given, counts and random
// numbers tell apart what is equal in 32 bits, and whatever stores an index has room for it.
TEST(Loops, count_in_64_bits)
{
  const std::size_t across = (std::size_t(1) << 32) - 500;
  std::vector<int> visits(1000, 0);
  for_each_index<Tag>(across, across + visits.size(), [&](std::size_t i) { ++visits[i - across]; });
  EXPECT_EQ(visits, std::vector<int>(1000, 1));

  EXPECT_EQ(percentage_of(50., std::size_t(1) << 36), std::size_t(1) << 35);
  const std::size_t five_billions = 5000000000u;
  EXPECT_EQ(checked_count("n", five_billions, 1, (std::numeric_limits<std::size_t>::max)(), ""),
            five_billions);

  const Counter_based_random random(0, 0);
  EXPECT_NE(random.bits(7), random.bits((std::uint64_t(1) << 32) + 7));

  static_assert(sizeof(decltype(Cloud::input_index)::value_type) == 8, "indices of input points");
  static_assert(sizeof(Duplicate::index) == 8 && sizeof(Duplicate::first) == 8, "of duplicates");
  static_assert(sizeof(decltype(select_along_curve<Tag>({1, 1}, {}, 0, 0))::value_type) == 8,
                "of samples");
}

// sizes around that of a block, in which the rounds meet
TEST(Scan, finds_indices_in_order)
{
  for (std::size_t size : {0u, 1u, 4095u, 4096u, 4097u, 100003u})
  {
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < size; ++i)
      if (i % 7 == 3 || i / 4096 == 2)
        expected.push_back(i);
    const auto predicate = [](std::size_t i) { return i % 7 == 3 || i / 4096 == 2; };
    EXPECT_EQ(indices_where<Tag>(size, predicate), expected);
    EXPECT_EQ(indices_where<CGAL::Sequential_tag>(size, predicate), expected);
  }
  EXPECT_EQ(elements_at<Tag>({2, 0}, std::vector<int>{7, 8, 9}), (std::vector<int>{9, 7}));
}

TEST(Scan, keeps_elements_in_place)
{
  for (std::size_t size : {0u, 1u, 4097u, 900001u})
  {
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < size; ++i)
      if (i % 7 != 3 && i / 4096 != 2)
        kept.push_back(i);
    std::vector<std::size_t> elements(size), sequential(size);
    for (std::size_t i = 0; i < size; ++i)
      elements[i] = sequential[i] = 3 * i + 1;
    const std::size_t* memory = elements.data();
    keep_elements<Tag>(kept, elements);
    keep_elements<CGAL::Sequential_tag>(kept, sequential);
    EXPECT_EQ(elements.data(), memory);
    ASSERT_EQ(elements.size(), kept.size());
    for (std::size_t i = 0; i < kept.size(); ++i)
      ASSERT_EQ(elements[i], 3 * kept[i] + 1);
    EXPECT_EQ(sequential, elements);
  }
}

TEST(Scan, sums_up)
{
  for (std::size_t size : {0u, 1u, 4096u, 4097u, 100003u})
  {
    std::vector<double> values(size), expected(size);
    double sum = 0.;
    for (std::size_t i = 0; i < size; ++i)
      expected[i] = sum += values[i] = static_cast<double>(i % 11); // exact: integers
    sum_up<Tag>(values);
    EXPECT_EQ(values, expected);
  }
  std::vector<double> parallel(100003, 0.1), sequential(100003, 0.1);
  sum_up<Tag>(parallel);
  sum_up<CGAL::Sequential_tag>(sequential);
  EXPECT_EQ(parallel, sequential);
  EXPECT_TRUE(std::is_sorted(parallel.begin(), parallel.end()));
}

TEST(Loops, sums_do_not_depend_on_the_tag)
{
  const auto value = [](std::size_t i) { return 1. / (1. + static_cast<double>(i)); };
  const double sequential = mean<CGAL::Sequential_tag>(100003, value);
  EXPECT_EQ(sequential, mean<Tag>(100003, value));
  EXPECT_NEAR(sequential * 100003., std::log(100003.) + 0.5772156649, 1e-5);
}

} // namespace
