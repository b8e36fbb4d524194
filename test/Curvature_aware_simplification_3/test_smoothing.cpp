// Points smoothed before the samples move, and how few of them are

#include "inputs.h"

#include <CGAL/Curvature_aware_simplification_3/internal/features/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/bias_of_noise.h>
#include <CGAL/Curvature_aware_simplification_3/internal/simplify_point_set.h>
#include <CGAL/Curvature_aware_simplification_3/internal/smoothing/smooth_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/smoothing/smoothing_radii.h>
#include <CGAL/Curvature_aware_simplification_3/internal/smoothing/spare_thin_parts.h>
#include <CGAL/Curvature_aware_simplification_3/internal/smoothing/thin_dense_noise.h>
#include <CGAL/Curvature_aware_simplification_3/internal/smoothing/thin_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Uninitialized_vector.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace {

using namespace inputs;

struct Smoothed
{
  std::vector<Point> points;
  Uninitialized_vector<double> inverse_density;
  std::vector<std::uint8_t> is_bent;
  double noise;
};

// samples so far from each other that the noise alone decides how far smoothing reaches
constexpr double far_samples = std::numeric_limits<double>::infinity();

// in balls of 4 sigma
void smooth_as_usual(Noise_levels& noise)
{
  for (Noise& here : noise.of_range)
    here.smoothing_radius = usual_smoothing_radius(here.level, far_samples);
}

double height_of_ripples(double x)
{
  return 0.012 * std::sin(2. * CGAL_PI * x / 0.04);
}

Smoothed smoothed(const std::vector<Point>& points, double noise, std::size_t number_of_samples,
                  const Adaptive_settings& settings = Adaptive_settings())
{
  const Neighbor_search search(points, Tag());
  Smoothed result{points, Uninitialized_vector<double>(points.size()),
                  std::vector<std::uint8_t>(points.size()), 0.};
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    result.inverse_density[i] =
        local_features<CGAL::Default_diagonalize_traits<double, 3>>(search, points[i], 17, 0.)
            .inverse_density;
    result.is_bent[i] = points[i].x() > 0.5 ? 1 : 0;
  }
  Noise_levels levels = uniform_noise(noise, points.size());
  levels.make_visible_above(0.);
  smooth_as_usual(levels);
  result.noise = smooth_points<Tag>(result.points, result.inverse_density, result.is_bent, search,
                                    levels, number_of_samples, settings, Progress(no_callback))
                     .at(0)
                     .level;
  return result;
}

TEST(Smoothing, leaves_as_much_noise_as_it_says)
{
  // a neighborhood of 25 points has a radius of 0.07
  for (double sigma : {0.002, 0.01, 0.02, 0.04})
  {
    const Smoothed result =
        smoothed(with_noise(surfaces::sphere(20000, 70), sigma, 71), sigma, 10000);
    ASSERT_EQ(result.points.size(), 20000u);
    double sum = 0.;
    for (const Point& p : result.points)
      sum += std::pow(distance_to_sphere(p), 2);
    EXPECT_NEAR(std::sqrt(sum / 20000.) / result.noise, 1., 0.2) << sigma;
    EXPECT_LT(result.noise, 0.7 * sigma);
  }
}

TEST(Smoothing, is_where_noise_is_visible)
{
  // in the second of three ranges
  const std::vector<Point> points = with_noise(surfaces::square(30000, 74), 0.002, 75);
  const Neighbor_search search(points, Tag());
  std::vector<Point> result = points;
  Uninitialized_vector<double> inverse_density(points.size(), 1. / (CGAL_PI * 30000.));
  std::vector<std::uint8_t> is_bent(points.size(), 0);
  Noise_levels noise{{{0.001, 0.001}, {0.002, 0.002}, {0.0015, 0.0015}}, points.size()};
  noise.make_visible_above(0.00075);
  smooth_as_usual(noise);
  const Noise_levels left = smooth_points<Tag>(result, inverse_density, is_bent, search, noise,
                                               1000, Adaptive_settings(), Progress(no_callback));
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ(result[i] != points[i], i >= 10000 && i < 20000) << i;
  EXPECT_EQ(left.at(0).level, 0.001);
  EXPECT_EQ(left.at(29999).level, 0.0015);
  EXPECT_LT(left.at(15000).level, 0.0015);
  EXPECT_EQ(left.at(15000).independent_level, 0.002);
}

TEST(Smoothing_radius, is_less_where_noise_is_strong_against_the_spacing_of_the_samples)
{
  EXPECT_DOUBLE_EQ(usual_smoothing_radius(0.1, far_samples), 0.4);
  EXPECT_DOUBLE_EQ(usual_smoothing_radius(0.1, 0.4), 0.4);
  EXPECT_DOUBLE_EQ(usual_smoothing_radius(0.1, 0.1), 0.16); // as wide as the spacing
  EXPECT_DOUBLE_EQ(usual_smoothing_radius(0.1, 0.0125), 0.04);
  EXPECT_DOUBLE_EQ(usual_smoothing_radius(0., 0.2), 0.);
}

TEST(Smoothing_radius, balances_what_fits_miss_and_the_noise_that_they_leave)
{
  const double most = std::sqrt(2.);
  // (q - v) / v = 1, 27, 1/8, and less than that
  EXPECT_DOUBLE_EQ(factor_of_radius({{2., 1.}}, {0}), 1.);
  EXPECT_DOUBLE_EQ(factor_of_radius({{28., 1.}}, {0}), 1. / std::sqrt(3.));
  EXPECT_DOUBLE_EQ(factor_of_radius({{1.125, 1.}}, {0}), most);
  EXPECT_DOUBLE_EQ(factor_of_radius({{1.0625, 1.}}, {0}), most);
  EXPECT_DOUBLE_EQ(factor_of_radius({{0., 1.}}, {0}), most);
  // another sheet
  EXPECT_DOUBLE_EQ(factor_of_radius({{1e9, 0.01}}, {0}), std::pow(49., -1. / 6.));
  // by sums, of what is known
  EXPECT_DOUBLE_EQ(factor_of_radius({{3., 2.}, {1e9, 0.}, {3., 1.}, {1e9, 1.}}, {0, 1, 2}), 1.);
  EXPECT_DOUBLE_EQ(factor_of_radius({{0., 0.}, {0., 0.}}, {0, 1}), 1.);
  EXPECT_DOUBLE_EQ(factor_of_radius({{9., 1.}}, {}), 1.);
}

// A sheet that is flat for x < 0.5, and has ripples 8 sigma long beyond
std::vector<Point> half_rippled_sheet(std::size_t n)
{
  std::vector<Point> points;
  for (const Point& p : surfaces::square(n, 90))
    points.emplace_back(p.x(), p.y(), p.x() < 0.5 ? 0. : height_of_ripples(p.x()));
  return points;
}

TEST(Smoothing_radius, is_small_where_the_shape_has_details)
{
  const double sigma = 0.005;
  const std::vector<Point> clean = half_rippled_sheet(120000);
  const Cloud cloud = cloud_of(with_noise(clean, sigma, 91), 0.);
  const double scale = cloud.frame.length_to_frame(sigma);
  const auto radii = [&](double spacing_of_samples, bool smooth_by_shape) {
    Noise_levels noise{std::vector<Noise>(64, Noise{scale, scale}), cloud.size()};
    noise.make_visible_above(0.);
    noise.of_range[63].radius_of_columns = scale;
    noise.of_range[62].is_visible = false;
    Adaptive_settings settings;
    settings.smooth_by_shape = smooth_by_shape;
    set_smoothing_radii<Tag>(noise, smoothing_probes<Tag>(cloud, settings), spacing_of_samples,
                             settings);
    return noise;
  };
  // The sums are over an eighth of the points, which are in a disk with a radius of 0.2.
  const Curve_ranges ranges{64, cloud.size()};
  std::vector<std::size_t> flat, rippled;
  for (std::size_t range = 0; range < 62; ++range)
  {
    double least = 1., most = 0.;
    for (std::size_t i = ranges.first_point(range); i < ranges.first_point(range + 1); ++i)
    {
      const double x = cloud.frame.from_frame(cloud.points[i]).x();
      least = (std::min)(least, x);
      most = (std::max)(most, x);
    }
    if (most < 0.3)
      flat.push_back(range);
    if (least > 0.7)
      rippled.push_back(range);
  }
  EXPECT_GT(flat.size(), 5u);
  EXPECT_GT(rippled.size(), 5u);

  const Noise_levels noise = radii(far_samples, true);
  for (std::size_t range : flat)
    EXPECT_NEAR(noise.of_range[range].smoothing_radius, 4. * scale, 0.4 * scale) << range;
  for (std::size_t range : rippled)
  {
    EXPECT_GE(noise.of_range[range].smoothing_radius, (3. - 1e-12) * scale) << range;
    EXPECT_LT(noise.of_range[range].smoothing_radius, 3.3 * scale) << range;
  }
  EXPECT_DOUBLE_EQ(noise.of_range[62].smoothing_radius, 4. * scale); // not smoothed
  EXPECT_DOUBLE_EQ(noise.of_range[63].smoothing_radius, 4. * scale); // must hold columns

  for (const Noise& here : radii(far_samples, false).of_range)
    EXPECT_DOUBLE_EQ(here.smoothing_radius, 4. * scale);

  // Samples nearer to each other than noise is large want balls of 1 sigma, in which the layer
  // looks like a volume. There, nothing was seen of the shape, and balls of flat parts stayed as
  // narrow.
  const Noise_levels near_samples = radii(scale / 2., true);
  const double usual = usual_smoothing_radius(scale, scale / 2.);
  EXPECT_LT(usual, 1.1 * scale);
  for (std::size_t range : flat)
    EXPECT_GT(near_samples.of_range[range].smoothing_radius, 2.3 * scale) << range;
  for (std::size_t range : rippled)
    EXPECT_GE(near_samples.of_range[range].smoothing_radius, (1. - 1e-12) * usual) << range;
}

// Balls as wide as for smooth shapes would take a third of the height of ripples away.
TEST(Smoothing_radius, keeps_details)
{
  const double sigma = 0.005;
  std::vector<Point> points;
  for (const Point& p : surfaces::square(120000, 92))
    points.emplace_back(p.x(), p.y(), height_of_ripples(p.x()));
  const Cloud cloud = cloud_of(with_noise(points, sigma, 93), 0.);
  const Neighbor_search& search = *cloud.search;
  const double scale = cloud.frame.length_to_frame(sigma);
  const auto part_lost = [&](bool smooth_by_shape) {
    Noise_levels noise{std::vector<Noise>(64, Noise{scale, scale}), cloud.size()};
    noise.make_visible_above(0.);
    Adaptive_settings settings;
    settings.smooth_by_shape = smooth_by_shape;
    set_smoothing_radii<Tag>(noise, smoothing_probes<Tag>(cloud, settings), far_samples, settings);
    std::vector<Point> smoothed = cloud.points;
    Uninitialized_vector<double> inverse_density(cloud.size(), 1. / (2. * CGAL_PI * 120000.));
    std::vector<std::uint8_t> is_bent(cloud.size(), 0);
    smooth_points<Tag>(smoothed, inverse_density, is_bent, search, noise, 60000, settings,
                       Progress(no_callback));
    double common = 0., all = 0.;
    for (const Point& q : smoothed)
    {
      const Point p = cloud.frame.from_frame(q);
      common += p.z() * height_of_ripples(p.x());
      all += std::pow(height_of_ripples(p.x()), 2);
    }
    return 1. - common / all;
  };
  EXPECT_NEAR(part_lost(false), 0.43, 0.05);
  EXPECT_LT(part_lost(true), 0.31);
}

// Two sheets 2 a apart have residuals of sigma^2 + a^2 around the plane between them: 3.25 sigma^2
// with a = 1.5 sigma. In the ball, whose weights count the middle more, it is 2.
TEST(Thin_parts, are_smoothed_less)
{
  const double sigma = 0.005, a = 1.5 * sigma;
  const auto part_taken_for_noise = [&](double height, double radius_of_columns, bool is_visible) {
    std::vector<Point> points = surfaces::square(60000, 94);
    for (std::size_t i = 0; i < points.size(); ++i)
      points[i] = points[i] + Vector(0., 0., i % 2 == 0 ? height : -height);
    const Cloud cloud = cloud_of(with_noise(points, sigma, 95), 0.);
    const double scale = cloud.frame.length_to_frame(sigma);
    Noise_levels noise{std::vector<Noise>(8, Noise{scale, scale, radius_of_columns}), cloud.size()};
    for (Noise& here : noise.of_range)
      here.is_visible = is_visible;
    spare_thin_parts<Tag>(noise, smoothing_probes<Tag>(cloud, default_settings), default_settings);
    for (const Noise& here : noise.of_range)
    {
      EXPECT_EQ(here.independent_level, here.level);
      EXPECT_NEAR(here.level, noise.of_range[0].level, 0.05 * scale);
    }
    return noise.of_range[0].level / scale;
  };
  EXPECT_EQ(part_taken_for_noise(0., 0., true), 1.); // one sheet
  EXPECT_NEAR(part_taken_for_noise(a, 0., true), std::sqrt(1.2 / 2.), 0.04);
  EXPECT_EQ(part_taken_for_noise(a, 0.1, true), 1.); // balls must hold columns
  EXPECT_EQ(part_taken_for_noise(a, 0., false), 1.); // not smoothed
}

// A bar 4 sigma thick became a round one: the mean distance from its axis, over half of its thickness,
// is the mean of sqrt(1 + u^2), u from 0 to 1, and that of its inscribed circle 1.
TEST(Thin_parts, keep_their_thickness)
{
  const double sigma = 0.01, half = 2. * sigma;
  CGAL::Random random(96);
  std::vector<Point> points;
  for (int i = 0; i < 20000; ++i)
  {
    const double x = random.uniform_real(0., 1.), y = random.uniform_real(-half, half);
    const double z = random.get_bool() ? half : -half;
    points.emplace_back(random.get_bool() ? Point(x, y, z) : Point(x, z, y));
  }
  const auto mean_distance_from_axis = [&](bool spare) {
    Adaptive_settings settings;
    settings.spare_thin_parts = spare;
    std::vector<Point> output;
    simplify_point_set<Tag>(with_noise(points, sigma, 97), std::back_inserter(output),
                            np::number_of_output_points(1000), settings);
    double sum = 0.;
    for (const Point& p : output)
      sum += std::sqrt(p.y() * p.y() + p.z() * p.z());
    return sum / 1000. / half;
  };
  const double exact = (std::sqrt(2.) + std::asinh(1.)) / 2.;
  EXPECT_LT(mean_distance_from_axis(false), exact - 0.12);
  EXPECT_NEAR(mean_distance_from_axis(true), exact, 0.08);
}

// 192 points are in a ball of 4 sigma, where 25 are enough.
TEST(Thinning, keeps_a_neighborhood_in_each_ball_where_points_are_smoothed)
{
  const Uninitialized_vector<double> inverse_density(30000, 0.04 * 0.04 / 48.);
  Noise_levels noise({{0.01, 0.01}, {0.02, 0.02}, {0.02, 0.02}}, 30000);
  noise.make_visible_above(0.0075); // half of 0.02, not half of 0.01
  smooth_as_usual(noise);
  const std::vector<std::size_t> kept = thin_points<Tag>(inverse_density, noise, 1000);
  const auto kept_before = [&](std::size_t i) {
    return std::lower_bound(kept.begin(), kept.end(), i) - kept.begin();
  };
  EXPECT_EQ(kept_before(10000), 10000);
  EXPECT_NEAR(static_cast<double>(kept_before(20000)), 10000. + 10000. * 25. / 192., 1.);
  EXPECT_NEAR(static_cast<double>(kept_before(30000)), 10000. + 20000. * 25. / 192., 1.);

  const Noise_levels left = noise.of_some(kept);
  for (std::size_t i = 0; i < kept.size(); i += 7)
    EXPECT_EQ(&left.at(i) - left.of_range.data(), &noise.at(kept[i]) - noise.of_range.data());
}

TEST(Thinning, keeps_two_points_for_each_sample)
{
  const Uninitialized_vector<double> inverse_density(30000, 1e-9);
  Noise_levels noise({{0., 0.}, {1., 1.}, {1., 1.}}, 30000);
  noise.make_visible_above(0.1);
  smooth_as_usual(noise);
  for (std::size_t samples : {5000u, 8000u, 15000u, 20000u})
  {
    const std::vector<std::size_t> kept = thin_points<Tag>(inverse_density, noise, samples);
    EXPECT_NEAR(static_cast<double>(kept.size()),
                (std::min)((std::max)(2. * static_cast<double>(samples), 10000.), 30000.), 1.);
    EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
  }
}

TEST(Thinning, keeps_enough_to_fit_surfaces_to)
{
  const Uninitialized_vector<double> inverse_density(1280, 1e-9);
  Noise_levels noise = uniform_noise(1., inverse_density.size());
  noise.make_visible_above(0.1);
  smooth_as_usual(noise);
  EXPECT_GE(thin_points<Tag>(inverse_density, noise, 1).size(), 57u);
  EXPECT_LE(thin_points<Tag>(inverse_density, noise, 1).size(), 59u);
}

TEST(Thinning, leaves_a_sparse_place_beside_a_dense_one)
{
  Uninitialized_vector<double> inverse_density(4095, 1e-6); // 16 ranges
  for (std::size_t i = 2000; i < 2030; ++i)
    inverse_density[i] = 1e-2;
  Noise_levels noise = uniform_noise(0.02, inverse_density.size());
  noise.make_visible_above(0.);
  smooth_as_usual(noise);
  const std::vector<std::size_t> kept = thin_points<Tag>(inverse_density, noise, 1);
  const auto begin = std::lower_bound(kept.begin(), kept.end(), 2000u);
  EXPECT_EQ(std::lower_bound(begin, kept.end(), 2030u) - begin, 30);
  EXPECT_NEAR(static_cast<double>(kept.size()), 256. + 3839. * 25. / 6400., 2.);
}

// Noise of 0.01 around a square, whose half at x < 0.5 has so many points, and the other half few
Cloud noisy_square(std::size_t dense, std::size_t sparse)
{
  std::vector<Point> points;
  for (const Point& p : surfaces::square(dense, 94))
    points.emplace_back(0.5 * p.x(), p.y(), 0.);
  for (const Point& p : surfaces::square(sparse, 95))
    points.emplace_back(0.5 + 0.5 * p.x(), p.y(), 0.);
  return cloud_of(with_noise(points, 0.01, 96), 0.);
}

// Of n points per area, a ball of 4 sigma around one at the height h holds n pi (16 sigma^2 - h^2 -
// sigma^2) in the mean: n pi 14.5 sigma^2 for the median of h^2.
TEST(Thinning, leaves_four_neighborhoods_in_balls_of_dense_noise)
{
  const Cloud cloud = noisy_square(400000, 60000); // 3600 and 550 points in a ball
  const double sigma = cloud.frame.length_to_frame(0.01);
  Noise_levels noise = uniform_noise(sigma, cloud.size());
  const auto parts = [&](double visible_error) {
    noise.make_visible_above(visible_error);
    return parts_against_noise<Tag>(cloud, noise, Adaptive_settings());
  };
  const std::vector<double> part = parts(0.);
  const Curve_ranges ranges{part.size(), cloud.size()};
  int dense = 0, sparse = 0;
  for (std::size_t range = 0; range < part.size(); ++range)
  {
    const Point p =
        cloud.frame.from_frame(cloud.points[ranges.first_point(range) + ranges.size(range) / 2]);
    if (p.x() > 0.15 && p.x() < 0.3 && p.y() > 0.2 && p.y() < 0.8)
    {
      EXPECT_NEAR(part[range], 4. * 289. / (800000. * CGAL_PI * 14.5e-4), 0.03);
      ++dense;
    }
    if (p.x() > 0.75)
    {
      EXPECT_EQ(part[range], 1.);
      ++sparse;
    }
  }
  EXPECT_GT(dense, 20);
  EXPECT_GT(sparse, 20);
  EXPECT_EQ(parts(sigma), std::vector<double>(part.size(), 1.)); // not visible

  const std::vector<std::size_t> kept = points_against_noise<Tag>({1., 0.25}, 1000, 1);
  EXPECT_EQ(kept.size(), 625u);
  EXPECT_EQ(kept[499], 499u);
  EXPECT_EQ(kept[624], 999u);
}

TEST(Thinning, ends_where_noise_is_not_too_dense)
{
  Cloud cloud = noisy_square(400000, 60000);
  const std::size_t size = cloud.size();
  const double sigma = cloud.frame.length_to_frame(0.01);
  const auto thin = [&](std::size_t number_of_samples) {
    Noise_levels noise = uniform_noise(sigma, cloud.size());
    return thin_dense_noise<Tag>(cloud, noise, {}, 0., number_of_samples, Adaptive_settings());
  };
  EXPECT_FALSE(thin(220000)); // two points for each
  EXPECT_EQ(cloud.size(), size);
  EXPECT_TRUE(thin(1000));
  EXPECT_EQ(cloud.search->size(), cloud.size());
  double sparse = 0., squares = 0.;
  for (const Point& q : cloud.points)
  {
    const Point p = cloud.frame.from_frame(q);
    sparse += p.x() > 0.7 ? 1. : 0.;
    squares += p.z() * p.z();
  }
  EXPECT_NEAR(sparse, 0.6 * 60000., 600.); // all are left
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(cloud.size())), 0.01, 0.0005);
  EXPECT_FALSE(thin(1000));
}

// A ball of 4 sigma holds 12,000 points. Fits took the nearest 289, which have the same height: the
// samples were 0.74 sigma off, and half of the noise was found.
TEST(Thinning, lets_fits_see_beyond_dense_noise)
{
  const double sigma = 0.03;
  const std::vector<Point> points = with_noise(surfaces::square(300000, 97), sigma, 98);
  CGAL::Curvature_aware_simplification_report report;
  double sum = 0.;
  for (const Point& p : simplified(
           points,
           CGAL::parameters::number_of_output_points(1000).simplification_report(std::ref(report))))
    sum += std::abs(p.z());
  EXPECT_LT(sum / 1000., 0.4 * sigma);
  EXPECT_NEAR(report.noise_level, sigma, 0.25 * sigma);
}

// A part that is 2000 times as dense as the rest was smoothed point by point, with 288 neighbors of
// each.
TEST(Thinning, smooths_few_points_of_a_dense_part)
{
  std::vector<Point> points = surfaces::square(3000, 76);
  for (const Point& p : surfaces::square(60000, 77))
    points.emplace_back(0.4 + 0.1 * p.x(), 0.4 + 0.1 * p.y(), 0.);
  points = with_noise(std::move(points), 0.005, 78);
  const Cloud cloud = cloud_of(points, 0.);
  const Smoothed result = smoothed(cloud.points, cloud.frame.length_to_frame(0.005), 500);
  std::size_t inside = 0;
  for (const Point& q : result.points)
  {
    const Point p = cloud.frame.from_frame(q);
    if (p.x() > 0.4 && p.x() < 0.5 && p.y() > 0.4 && p.y() < 0.5)
      ++inside;
  }
  EXPECT_LT(inside, 15000u);
  EXPECT_GT(result.points.size() - inside, 2900u);
}

// Balls of 4 sigma hold 2000 points, more than any fit takes. Of the 24 nearest, 0.38 sigma would
// be left.
TEST(Smoothing, leaves_little_noise_where_points_are_dense_against_it)
{
  const double sigma = 0.02;
  const Smoothed result = smoothed(with_noise(surfaces::square(100000, 72), sigma, 73), sigma, 200);
  double sum = 0.;
  for (const Point& p : result.points)
    sum += p.z() * p.z();
  EXPECT_LT(std::sqrt(sum / static_cast<double>(result.points.size())), 0.33 * sigma);
}

// 289 neighbors are in a ball of 2 sigma
TEST(Smoothing, takes_points_far_off_to_the_surface_as_well)
{
  const double sigma = 0.025;
  const std::vector<Point> points = with_noise(surfaces::square(40000, 101), sigma, 102);
  const auto left = [&](bool around_foot_points) {
    Adaptive_settings settings;
    settings.smooth_around_foot_points = around_foot_points;
    double sum = 0., number = 0.;
    for (const Point& p : smoothed(points, sigma, 200, settings).points)
      if (std::abs(p.x() - 0.5) < 0.4 && std::abs(p.y() - 0.5) < 0.4)
      {
        sum += p.z() * p.z();
        number += 1.;
      }
    return std::sqrt(sum / number) / sigma;
  };
  EXPECT_LT(left(true), 0.13);
  EXPECT_GT(left(false), 0.16);
}

TEST(Smoothing, takes_part_of_the_points_that_are_dense_against_the_noise)
{
  // 2010 points in a ball of 4 sigma, 80 times as many as a full neighborhood
  const std::vector<Point> points = with_noise(surfaces::square(100000, 72), 0.02, 73);
  const Smoothed few = smoothed(points, 0.02, 100);
  EXPECT_GT(few.points.size(), 1250u); // the layer is thick, which takes density away
  EXPECT_LT(few.points.size(), 10000u);
  // at least two for each sample
  const Smoothed many = smoothed(points, 0.02, 20000);
  EXPECT_NEAR(static_cast<double>(many.points.size()), 40000., 1.);
  EXPECT_EQ(smoothed(points, 0.02, 90000).points.size(), 100000u);
  // what is known of a point stays with it; it moves by 4 sigma at most
  ASSERT_EQ(few.is_bent.size(), few.points.size());
  for (std::size_t i = 0; i < few.points.size(); ++i)
    if (std::abs(few.points[i].x() - 0.5) > 0.08)
    {
      EXPECT_EQ(few.is_bent[i], few.points[i].x() > 0.5 ? 1 : 0);
    }
}

TEST(Smoothing, leaves_alone_what_noise_does_not_explain)
{
  // 10 sigma off, but less than the radius of its neighborhood: the fit knows the surface below
  std::vector<Point> points = with_noise(surfaces::square(20000, 74), 0.0005, 75);
  points[7] = Point(0.5, 0.5, 0.005);
  EXPECT_EQ(smoothed(points, 0.0005, 2000).points[7], points[7]);
  // 20 sigma off, and farther than its neighbors from each other: the fit knows little
  points = with_noise(surfaces::square(20000, 74), 0.005, 75);
  points[7] = Point(0.5, 0.5, 0.1);
  const Point moved = smoothed(points, 0.005, 2000).points[7];
  EXPECT_LT(CGAL::squared_distance(moved, points[7]), 0.005 * 0.005);
}

TEST(Smoothing, takes_what_residuals_show_beyond_the_noise_for_shape)
{
  // Heights of +-0.03 in turn, of which a quadric explains nothing: the variance of n residuals is
  // theirs, times n / (n - 6), and the point itself, at 5, has no say.
  Neighborhood neighborhood;
  const Point x(0., 0., 5.);
  neighborhood.neighbors.push_back({Vector(0., 0., 5.), 25., 1.});
  for (int i = 0; i < 12; ++i)
    neighborhood.neighbors.push_back({Vector(1., i, i % 2 == 0 ? 0.03 : -0.03), 1. + i * i, 0.5});
  EXPECT_NEAR(variance_of_residuals(neighborhood, Local_surface(), x), 2. * 0.0009, 1e-12);
  neighborhood.neighbors.resize(7); // six residuals, as many as there are coefficients, tell little
  EXPECT_NEAR(variance_of_residuals(neighborhood, Local_surface(), x), 6. * 0.0009, 1e-12);
  neighborhood.neighbors.resize(1);
  EXPECT_EQ(variance_of_residuals(neighborhood, Local_surface(), x), 0.);

  const std::vector<Point> points = surfaces::square(10, 76);
  const Neighbor_search search(points, Tag());
  const Surface_fit fit{search, Noise{3., 3.}};
  EXPECT_EQ(share_explained_by_noise(fit, 0.), 1.);
  EXPECT_EQ(share_explained_by_noise(fit, 22.5), 1.);
  EXPECT_EQ(share_explained_by_noise(fit, 90.), 0.25);
}

double distance_to_cube(const Point& p)
{
  const auto outside = [](double x) { return (std::max)({-x, x - 1., 0.}); };
  const auto inside = [](double x) { return (std::min)(x, 1. - x); };
  const double x = outside(p.x()), y = outside(p.y()), z = outside(p.z());
  const double distance = std::sqrt(x * x + y * y + z * z);
  return distance > 0. ? distance : (std::min)({inside(p.x()), inside(p.y()), inside(p.z())});
}

TEST(Smoothing, does_not_round_sharp_edges_more_than_noise_does)
{
  // 0.008 between points, and noise of a sixteenth of that
  const double sigma = 0.0005;
  const std::vector<Point> exact = cube(100000, 88);
  const std::vector<Point> points = with_noise(exact, sigma, 89);
  const auto error_in_sigma = [&](bool near_edges, double residuals_explained_by_noise) {
    Adaptive_settings settings;
    settings.residuals_explained_by_noise = residuals_explained_by_noise;
    const Smoothed result = smoothed(points, sigma, 10000, settings);
    EXPECT_EQ(result.points.size(), points.size());
    double sum = 0., number = 0.;
    for (std::size_t i = 0; i < result.points.size(); ++i)
      if (near_edges ? distance_to_edge(exact[i]) < 0.004 : distance_to_edge(exact[i]) > 0.05)
      {
        sum += std::pow(distance_to_cube(result.points[i]), 2);
        number += 1.;
      }
    return std::sqrt(sum / number) / sigma;
  };
  const double standard = Adaptive_settings().residuals_explained_by_noise;
  EXPECT_LT(error_in_sigma(true, standard), 1.05);
  EXPECT_GT(error_in_sigma(true, 1e300), 1.3);
  EXPECT_LT(error_in_sigma(false, standard), 0.55);
}

TEST(Smoothing, makes_narrow_fits_no_better_than_the_points_are)
{
  const std::vector<Point> points = surfaces::square(10, 76);
  const Neighbor_search search(points, Tag());
  // independent noise is as the fit says
  EXPECT_EQ(error_of_fit(Surface_fit{search, Noise{3., 3.}}, 1.5), 1.5);
  const Surface_fit fit{search, Noise{1., 3.}};
  EXPECT_NEAR(error_of_fit(fit, 1e9), 1., 1e-9);
  EXPECT_NEAR(error_of_fit(fit, 1.), std::pow(2., -0.25), 1e-12);
  EXPECT_NEAR(error_of_fit(fit, 1e-3), 1e-3, 1e-8);
}

TEST(Bias_of_noise, is_the_mean_curvature_times_the_variance)
{
  Local_surface surface; // 2 a^2 + b^2 + 7 a b over z = 0
  surface.c[3] = 2.;
  surface.c[4] = 7.;
  surface.c[5] = 1.;
  EXPECT_EQ(mean_curvature(surface), 3.);
  Noise noise{0.01, 0.02, 0., true, 0., 0.2};
  EXPECT_NEAR(bias_of_noise(noise, 2.), 0.08, 1e-15);
  // half of sigma at most
  EXPECT_NEAR(bias_of_noise(noise, -5.), -0.1, 1e-15);
  EXPECT_EQ(bias_of_noise(noise, 0.), 0.);
  noise.radius_of_columns = 0.1; // along the rays of a scanner
  EXPECT_EQ(bias_of_noise(noise, 2.), 0.);
  EXPECT_EQ(bias_of_noise(Noise{0.01, 0.02, 0., false, 0., 0.2}, 2.), 0.);
}

// sigma^2 H = 0.0064 inside
TEST(Bias_of_noise, is_taken_away)
{
  const double sigma = 0.08;
  const std::vector<Point> points = with_noise(surfaces::sphere(60000, 103), sigma, 104);
  const auto mean_height = [&](bool correct) {
    Adaptive_settings settings;
    settings.correct_bias_of_noise = correct;
    std::vector<Point> output;
    simplify_point_set<Tag>(points, std::back_inserter(output),
                            CGAL::parameters::number_of_output_points(500), settings);
    double sum = 0.;
    for (const Point& p : output)
      sum += std::sqrt((p - CGAL::ORIGIN).squared_length()) - 1.;
    return sum / 500.;
  };
  EXPECT_NEAR(mean_height(false), -0.0064, 0.001);
  EXPECT_NEAR(mean_height(true), 0., 0.0013); // the noise found is a little less
}

} // namespace
