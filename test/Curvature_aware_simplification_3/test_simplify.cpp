// The promises of the manual for the public functions

#include "surfaces.h"

#include <CGAL/bounding_box.h>
#include <CGAL/curvature_aware_random_simplify_point_set.h>
#include <CGAL/curvature_aware_simplify_point_set.h>
#include <CGAL/estimate_surface_variation.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#endif

#include <boost/iterator/function_output_iterator.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace {

using surfaces::Kernel;
using surfaces::Point;
using surfaces::Vector;
using Tag = CGAL::Parallel_if_available_tag;
namespace np = CGAL::parameters;

// What must hold for the adaptive method, the default, and for that of the paper, runs with both.
bool settings_of_the_paper = false;

class Both_methods : public testing::TestWithParam<bool>
{
protected:
  void SetUp() override { settings_of_the_paper = GetParam(); }
};
INSTANTIATE_TEST_SUITE_P(, Both_methods, testing::Bool(),
                         [](const auto& info) { return info.param ? "paper" : "adaptive"; });

class Paper : public testing::Test
{
protected:
  void SetUp() override { settings_of_the_paper = true; }
};

template <typename ConcurrencyTag = Tag, typename NamedParameters = np::Default_named_parameters>
std::vector<Point> simplified(const std::vector<Point>& points,
                              const NamedParameters& parameters = np::default_values())
{
  std::vector<Point> output;
  CGAL::curvature_aware_simplify_point_set<ConcurrencyTag>(
      points, std::back_inserter(output), parameters.settings_of_the_paper(settings_of_the_paper));
  return output;
}

template <typename ConcurrencyTag = Tag, typename NamedParameters = np::Default_named_parameters>
std::vector<Point> subset(const std::vector<Point>& points,
                          const NamedParameters& parameters = np::default_values())
{
  std::vector<Point> output;
  CGAL::curvature_aware_random_simplify_point_set<ConcurrencyTag>(
      points, std::back_inserter(output), parameters);
  return output;
}

// the largest distance from a point of one set to the other set
double hausdorff_distance(const std::vector<Point>& a, const std::vector<Point>& b)
{
  double largest = 0.;
  for (const auto& [from, to] : {std::make_pair(&a, &b), std::make_pair(&b, &a)})
    for (const Point& p : *from)
    {
      double nearest = std::numeric_limits<double>::infinity();
      for (const Point& q : *to)
        nearest = std::min(nearest, CGAL::squared_distance(p, q));
      largest = std::max(largest, std::sqrt(nearest));
    }
  return largest;
}

std::vector<Point> transformed(const std::vector<Point>& points,
                               const std::function<Point(const Point&)>& map)
{
  std::vector<Point> result;
  std::transform(points.begin(), points.end(), std::back_inserter(result), map);
  return result;
}

TEST_P(Both_methods, count_is_exact_for_every_seed_count_and_percentage)
{
  const std::vector<Point> points = surfaces::torus(2000, 3., 1., 1);
  EXPECT_EQ(simplified(points).size(), 100u); // 5 % by default
  for (unsigned int seed = 0; seed < 20; ++seed)
    for (std::size_t n : {1u, 2u, 7u, 333u, 1999u, 2000u})
      EXPECT_EQ(simplified(points,
                           np::number_of_output_points(n).random_seed(seed).number_of_iterations(1))
                    .size(),
                n);
  EXPECT_EQ(simplified(points, np::select_percentage(29.)).size(), 580u);
  EXPECT_EQ(simplified(points, np::select_percentage(7)).size(), 140u);
  EXPECT_EQ(simplified(points, np::select_percentage(0.01)).size(), 1u); // rounded down, at least 1
  EXPECT_EQ(simplified(points, np::select_percentage(100)).size(), 2000u);
  EXPECT_EQ(simplified(points, np::select_percentage(static_cast<unsigned short>(7))).size(), 140u);
  EXPECT_EQ(simplified(points, np::select_percentage(50).number_of_output_points(3)).size(), 3u);
  EXPECT_EQ(simplified(points, np::select_percentage(0).number_of_output_points(3)).size(), 3u);
  EXPECT_EQ(subset(points).size(), 100u);
  EXPECT_EQ(subset(points, np::number_of_output_points(2000)), points);
}

TEST(Subset, holds_elements_of_the_input_in_their_order)
{
  const std::vector<Point> points = surfaces::torus(2000, 3., 1., 2);
  const std::vector<Point> output = subset(points, np::number_of_output_points(150));
  auto position = points.begin();
  for (const Point& p : output)
  {
    position = std::find(position, points.end(), p);
    ASSERT_NE(position, points.end());
    ++position;
  }
}

TEST_P(Both_methods, seed_decides_the_result)
{
  const std::vector<Point> points = surfaces::sphere(2000, 3);
  EXPECT_EQ(simplified(points), simplified(points, np::random_seed(0)));
  EXPECT_EQ(simplified(points, np::random_seed(5)), simplified(points, np::random_seed(5)));
  EXPECT_NE(simplified(points, np::random_seed(5)), simplified(points, np::random_seed(6)));
}

TEST_P(Both_methods, result_is_bitwise_the_same_for_every_tag_and_number_of_threads)
{
  std::vector<Point> points = surfaces::torus(30000, 3., 1., 4);
  for (std::size_t i = 0; i < 1000; ++i)
    points.push_back(points[7 * i]); // with duplicates
  const auto parameters = np::number_of_output_points(3000)
                              .random_seed(9)
                              .recompute_curvature(true)
                              .require_uniform_sampling(true);
  const std::vector<Point> sequential = simplified<CGAL::Sequential_tag>(points, parameters);
  EXPECT_EQ(sequential, simplified<CGAL::Parallel_if_available_tag>(points, parameters));
#ifdef CGAL_LINKED_WITH_TBB
  for (std::size_t threads : {1u, 2u, 3u, 8u})
  {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    EXPECT_EQ(sequential, simplified<CGAL::Parallel_tag>(points, parameters)) << threads;
  }
  EXPECT_EQ(subset<CGAL::Sequential_tag>(points), subset<CGAL::Parallel_tag>(points));
#endif
  // few outliers, which are hidden, and many with noise: they are removed, and points smoothed
  CGAL::Random random(3);
  for (double sigma : {0., 0.02})
  {
    std::vector<Point> scan;
    for (const Point& p : points)
      scan.push_back(p + sigma * Vector(surfaces::normal_deviate(random), 0., 0.));
    for (std::size_t i = 0; i < (sigma > 0. ? 3000u : 10u); ++i)
      scan.emplace_back(random.uniform_real(-9., 9.), random.uniform_real(-9., 9.),
                        random.uniform_real(-9., 9.));
    EXPECT_EQ(simplified<CGAL::Sequential_tag>(scan, parameters),
              simplified<CGAL::Parallel_if_available_tag>(scan, parameters));
  }
  // nor does it matter whether somebody watches
  EXPECT_EQ(sequential, simplified(points, parameters.callback([](double) { return true; })));
}

TEST_P(Both_methods, calls_at_the_same_time_do_not_disturb_each_other)
{
  // noisy ones and clean ones, so that threads leave different things in their buffers
  std::vector<std::vector<Point>> scans, expected, found(8);
  CGAL::Random random(5);
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    scans.push_back(surfaces::sphere(3000 + 500 * i, 60 + static_cast<unsigned int>(i)));
    if (i % 2 == 0)
      for (Point& p : scans.back())
        p = p + 0.02 * Vector(surfaces::normal_deviate(random), 0., 0.);
    expected.push_back(simplified(scans[i], np::select_percentage(10)));
  }
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < found.size(); ++i)
    threads.emplace_back([&, i] { found[i] = simplified(scans[i], np::select_percentage(10)); });
  for (std::thread& thread : threads)
    thread.join();
  EXPECT_EQ(found, expected);
#ifdef CGAL_LINKED_WITH_TBB
  found.assign(scans.size(), {});
  tbb::parallel_for(std::size_t(0), scans.size(), [&](std::size_t i) {
    found[i] = simplified(scans[i], np::select_percentage(10));
  });
  EXPECT_EQ(found, expected);
#endif
}

TEST_P(Both_methods, result_scales_and_moves_with_the_input)
{
  const std::vector<Point> points = surfaces::ellipsoid(5000, 2., 5);
  const auto parameters = np::number_of_output_points(500);
  const std::vector<Point> expected = simplified(points, parameters);

  for (double scale : {1e-300, 1e-6, 0.001, 3., 1e6, 1e300})
  {
    const std::vector<Point> output =
        simplified(transformed(points,
                               [=](const Point& p) {
                                 return Point(scale * p.x(), scale * p.y(), scale * p.z());
                               }),
                   parameters);
    const std::vector<Point> back = transformed(
        output, [=](const Point& p) { return Point(p.x() / scale, p.y() / scale, p.z() / scale); });
    EXPECT_LT(hausdorff_distance(expected, back), 1e-10) << scale;
  }
  for (const Vector& offset : {Vector(500000., 5400000., 300.), Vector(-1e3, 1e-3, 1e7)})
  {
    // rounding of the input to 1e-9 is all that the result may see
    const std::vector<Point> back = transformed(
        simplified(transformed(points, [=](const Point& p) { return p + offset; }), parameters),
        [=](const Point& p) { return p - offset; });
    EXPECT_LT(hausdorff_distance(expected, back), 1e-6) << offset;
  }
}

TEST_F(Paper, result_turns_with_the_input)
{
  const std::vector<Point> points = surfaces::ellipsoid(5000, 2., 5);
  const auto parameters = np::number_of_output_points(500);
  const auto turn = [](const Point& p) // about (1, 1, 1) by 120 degrees, then about z
  {
    const double c = std::cos(0.3), s = std::sin(0.3);
    return Point(c * p.y() - s * p.z(), s * p.y() + c * p.z(), p.x());
  };
  EXPECT_LT(hausdorff_distance(transformed(simplified(points, parameters), turn),
                               simplified(transformed(points, turn), parameters)),
            1e-9);
}

TEST_P(Both_methods, result_near_surfaces)
{
  // to the height that a step of one spacing along the tangent has above a surface of curvature 1
  CGAL::Curvature_aware_simplification_report report;
  const auto parameters = np::simplification_report(std::ref(report));
  const std::vector<Point> sphere = simplified(surfaces::sphere(20000, 6), parameters);
  for (const Point& p : sphere)
    EXPECT_NEAR(std::sqrt((p - CGAL::ORIGIN).squared_length()), 1.,
                report.output_spacing * report.output_spacing / 2.);
  const std::vector<Point> torus = simplified(surfaces::torus(20000, 3., 1., 6), parameters);
  for (const Point& p : torus)
    EXPECT_LT(surfaces::distance_to_torus(p, 3., 1.),
              report.output_spacing * report.output_spacing / 2.);
}

// Lipman et al. 2007 and Huang et al. 2009 as they stand, in double loops
std::vector<Point> locally_optimal_projection(const std::vector<Point>& P, std::vector<Point> X,
                                              double h, double mu, int iterations, bool weighted)
{
  const auto theta = [h](double r) { return r <= h ? std::exp(-r * r / (h / 4.) / (h / 4.)) : 0.; };
  const auto distance = [](const Point& a, const Point& b) {
    return std::sqrt(CGAL::squared_distance(a, b));
  };
  const auto densities = [&](const std::vector<Point>& points) {
    std::vector<double> result(points.size(), 1.);
    if (weighted)
      for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < points.size(); ++j)
          if (i != j)
            result[i] += theta(distance(points[i], points[j]));
    return result;
  };

  const std::vector<double> v = densities(P);
  for (int iteration = 0; iteration < iterations; ++iteration)
  {
    const std::vector<double> w = densities(X);
    std::vector<Point> moved;
    for (std::size_t i = 0; i < X.size(); ++i)
    {
      Vector attraction(0., 0., 0.), repulsion(0., 0., 0.);
      double attraction_weight = 0., repulsion_weight = 0.;
      for (std::size_t j = 0; j < P.size(); ++j)
      {
        const double r = distance(X[i], P[j]), alpha = theta(r) / (r + 1e-6 * h) / v[j];
        attraction = attraction + alpha * (P[j] - CGAL::ORIGIN);
        attraction_weight += alpha;
      }
      for (std::size_t j = 0; j < X.size(); ++j)
      {
        const double r = distance(X[i], X[j]);
        if (j == i || r == 0.)
          continue;
        const double beta = w[j] * theta(r) / r;
        repulsion = repulsion + beta * (X[i] - X[j]);
        repulsion_weight += beta;
      }
      moved.push_back(CGAL::ORIGIN + attraction / attraction_weight +
                      mu * repulsion / repulsion_weight);
    }
    X = moved;
  }
  return X;
}

TEST_F(Paper, special_case_is_the_classical_operator)
{
  const std::vector<Point> points = surfaces::torus(3000, 3., 1., 7);
  const double h = 1.2;
  for (bool weighted : {false, true})
  {
    const auto parameters =
        np::curvature_dependence(0.).adaptivity(0.).number_of_output_points(300);
    const std::vector<Point> output = simplified(
        points,
        parameters.neighbor_radius(h).number_of_iterations(5).require_uniform_sampling(weighted));
    const std::vector<Point> expected =
        locally_optimal_projection(points, subset(points, parameters), h, 0.45, 5, weighted);
    EXPECT_LT(hausdorff_distance(output, expected), 1e-9) << weighted;
  }
}

TEST_F(Paper, special_case_without_iterations_is_the_subset)
{
  const std::vector<Point> points = surfaces::torus(3000, 3., 1., 8);
  EXPECT_LT(hausdorff_distance(simplified(points, np::number_of_iterations(0)), subset(points)),
            1e-14);
}

TEST_F(Paper, selection_prefers_the_tight_side_as_the_weight_asks)
{
  // In a region, sum(F_i) points are expected. F follows from kappa, which is known by itself.
  const double c = 3.;
  const std::vector<Point> points = surfaces::ellipsoid(20000, c, 9);
  std::vector<std::pair<Point, double>> variation;
  for (const Point& p : points)
    variation.emplace_back(p, 0.);
  CGAL::estimate_surface_variation<Tag>(
      variation, 16, CGAL::Second_of_pair_property_map<std::pair<Point, double>>(),
      np::point_map(CGAL::First_of_pair_property_map<std::pair<Point, double>>()));
  const auto is_tip = [=](const Point& p) { return std::abs(p.z()) > 0.9 * c; };
  double mean_variation = 0., sum_at_tips = 0., tip_points = 0.;
  for (const auto& [p, kappa] : variation)
  {
    mean_variation += kappa / static_cast<double>(points.size());
    sum_at_tips += is_tip(p) ? kappa : 0.;
    tip_points += is_tip(p) ? 1. : 0.;
  }

  const double ratio = 0.05, alpha = 2. / 3.;
  for (double w : {0., 0.5, 1.})
  {
    // the density of the input is uniform: its term is 1 on average
    const double expected =
        ratio * ((1. - w) * tip_points +
                 w * ((1. - alpha) * tip_points + alpha * sum_at_tips / mean_variation));
    double selected = 0.;
    const unsigned int seeds = 40;
    for (unsigned int seed = 0; seed < seeds; ++seed)
      for (const Point& p : subset(points, np::curvature_weight(w).random_seed(seed)))
        selected += is_tip(p) ? 1. / seeds : 0.;
    EXPECT_NEAR(selected / expected, 1., 5. / std::sqrt(expected * seeds) + 0.02) << w;
  }
}

// output points in a region for one in the rest, both per input point: the ratio of densities when
// the input is uniform
double density_ratio(const std::vector<Point>& points, const std::vector<Point>& output,
                     const std::function<bool(const Point&)>& is_in)
{
  const double in = static_cast<double>(std::count_if(points.begin(), points.end(), is_in));
  const double out = static_cast<double>(points.size()) - in;
  const double output_in = static_cast<double>(std::count_if(output.begin(), output.end(), is_in));
  return output_in / in / ((static_cast<double>(output.size()) - output_in) / out);
}

TEST_F(Paper, relaxation_keeps_the_tight_side_dense)
{
  const std::vector<Point> ellipsoid = surfaces::ellipsoid(20000, 3., 10);
  const auto is_tip = [](const Point& p) { return std::abs(p.z()) > 2.7; };
  const std::vector<Point> torus = surfaces::torus(20000, 3., 1., 10);
  const auto is_inner = [](const Point& p) { return std::hypot(p.x(), p.y()) < 2.5; };

  const auto ratio = [](const std::vector<Point>& points, const auto& is_in,
                        const auto& parameters) {
    return density_ratio(points, simplified(points, parameters.number_of_output_points(2000)),
                         is_in);
  };
  const auto uniform = np::curvature_dependence(0.).curvature_weight(0.);
  EXPECT_NEAR(ratio(ellipsoid, is_tip, uniform), 1., 0.1);
  EXPECT_NEAR(ratio(torus, is_inner, uniform), 1., 0.1);
  // The selection decides, and ten iterations keep what it gave; of the inner side of the torus,
  // kappa is 1.6 times that of the outer.
  EXPECT_GT(ratio(ellipsoid, is_tip, np::random_seed(0)), 2.2);
  EXPECT_GT(ratio(torus, is_inner, np::random_seed(0)), 1.1);

  // In the long run, repulsion without curvature evens out, the more so the smaller d is.
  const auto after_40_iterations = [&](double d) {
    return ratio(ellipsoid, is_tip, np::number_of_iterations(40).curvature_dependence(d));
  };
  const double without = after_40_iterations(0.), half = after_40_iterations(0.5),
               standard = after_40_iterations(2.);
  EXPECT_GT(half, 1.03 * without);
  EXPECT_GT(standard, 1.02 * half);
}

TEST_F(Paper, relaxation_spreads_evenly)
{
  // nearest-neighbor distances vary by half (sqrt(4/pi - 1) = 0.52) in a random subset
  const auto variation = [](const std::vector<Point>& points) {
    double sum = 0., squares = 0.;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t j = 0; j < points.size(); ++j)
        if (j != i)
          nearest = std::min(nearest, CGAL::squared_distance(points[i], points[j]));
      sum += std::sqrt(nearest);
      squares += nearest;
    }
    const double n = static_cast<double>(points.size());
    return std::sqrt(squares / n - sum * sum / n / n) / (sum / n);
  };
  const std::vector<Point> points = surfaces::sphere(20000, 11);
  EXPECT_GT(variation(subset(points)), 0.45);
  EXPECT_LT(variation(simplified(points)), 0.25);
  EXPECT_LT(variation(simplified(points, np::curvature_dependence(0.))), 0.25);
}

TEST_P(Both_methods, callback_is_monotone_and_reaches_one)
{
  const std::vector<Point> points = surfaces::sphere(3000, 12);
  for (bool option : {false, true})
  {
    std::vector<double> progress;
    const std::function<bool(double)> record = [&](double p) {
      progress.push_back(p);
      return true;
    };
    simplified(points, np::callback(record).require_uniform_sampling(option));
    EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
    EXPECT_EQ(progress.front(), 0.);
    EXPECT_EQ(progress.back(), 1.);
    EXPECT_GT(progress.size(), 50u);

    progress.clear();
    subset(points, np::callback(record));
    EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
    EXPECT_EQ(progress.front(), 0.);
    EXPECT_EQ(progress.back(), 1.);
  }
}

TEST_P(Both_methods, callback_cancels_without_output)
{
  const std::vector<Point> points = surfaces::sphere(3000, 13);
  for (double end : {0., 0.3, 0.7, 0.99, 1.})
  {
    int calls_after_end = 0;
    const auto stop = np::callback([&](double progress) {
      calls_after_end += progress >= end ? 1 : 0;
      return progress < end;
    });
    EXPECT_TRUE(simplified(points, stop).empty()) << end;
    EXPECT_EQ(calls_after_end, 1) << end;
    EXPECT_TRUE(subset(points, stop).empty()) << end;
  }
  std::vector<std::pair<Point, double>> variation;
  for (const Point& p : points)
    variation.emplace_back(p, -1.);
  EXPECT_FALSE(CGAL::estimate_surface_variation<Tag>(
      variation, 16, CGAL::Second_of_pair_property_map<std::pair<Point, double>>(),
      np::point_map(CGAL::First_of_pair_property_map<std::pair<Point, double>>())
          .callback([](double progress) { return progress < 0.5; })));
  for (const auto& [p, kappa] : variation)
    EXPECT_EQ(kappa, -1.);
}

TEST_P(Both_methods, callback_is_called_on_the_calling_thread)
{
  const std::thread::id caller = std::this_thread::get_id();
  const auto check = [&](double) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    return true;
  };
  const std::vector<Point> points = surfaces::sphere(20000, 13);
  simplified(points, np::callback(check));
  subset(points, np::callback(check));
}

TEST_P(Both_methods, report_is_left_as_it_is_unless_the_call_succeeds)
{
  const std::vector<Point> points = surfaces::sphere(3000, 13);
  CGAL::Curvature_aware_simplification_report report;
  report.number_of_input_points = 7;
  report.noise_level = -1.;
  report.sorting_time = -1.;
  const auto expect_untouched = [&] {
    EXPECT_EQ(report.number_of_input_points, 7u);
    EXPECT_EQ(report.noise_level, -1.);
    EXPECT_EQ(report.sorting_time, -1.);
  };
  const auto reported = np::simplification_report(std::ref(report));
  for (double end : {0., 0.5, 1.})
  {
    simplified(points, reported.callback([&](double progress) { return progress < end; }));
    expect_untouched();
  }
  const std::vector<Point> none;
  EXPECT_THROW(simplified(none, reported), std::invalid_argument);
  expect_untouched();
  simplified(points, reported);
  EXPECT_EQ(report.number_of_input_points, 3000u);
  EXPECT_GE(report.noise_level, 0.);
}

TEST_P(Both_methods, callback_may_throw)
{
  const std::vector<Point> points = surfaces::sphere(3000, 14);
  EXPECT_THROW(
      simplified(points, np::callback([](double) -> bool { throw std::range_error("mine"); })),
      std::range_error);
}

TEST_F(Paper, report_tells_what_was_found)
{
  std::vector<Point> points = surfaces::sphere(10000, 15);
  points.insert(points.end(), points.begin(), points.begin() + 500);
  CGAL::Curvature_aware_simplification_report report;
  simplified(points, np::number_of_output_points(400).simplification_report(std::ref(report)));
  EXPECT_EQ(report.number_of_input_points, 10500u);
  EXPECT_EQ(report.number_of_distinct_points, 10000u);
  EXPECT_EQ(report.number_of_output_points, 400u);
  // a hexagonal lattice of 400 points on the area 4 pi
  EXPECT_NEAR(report.output_spacing / std::sqrt(4. * CGAL_PI / 400. * 2. / std::sqrt(3.)), 1.,
              0.05);
  EXPECT_DOUBLE_EQ(report.neighbor_radius, 2. * report.output_spacing);
  EXPECT_GT(report.maximum_surface_variation, 0.);
  EXPECT_LT(report.maximum_surface_variation, 0.01);
  EXPECT_GT(report.features_time, 0.);
  EXPECT_GT(report.relaxation_time, 0.);

  simplified(points, np::neighbor_radius(0.25).simplification_report(std::ref(report)));
  EXPECT_DOUBLE_EQ(report.neighbor_radius, 0.25);
}

// 1e305 is more than any number in the unit of the computation.
TEST_F(Paper, largest_radius_draws_to_the_center_as_all_do_that_hold_all_points)
{
  std::vector<Point> points = surfaces::sphere(1000, 15);
  for (Point& p : points)
    p = Point(1e-10 * p.x(), 1e-10 * p.y(), 1e-10 * p.z());
  CGAL::Curvature_aware_simplification_report report;
  const auto with_radius = [&](double radius) {
    return simplified(points,
                      np::number_of_output_points(50).neighbor_radius(radius).simplification_report(
                          std::ref(report)));
  };
  const std::vector<Point> output = with_radius(1e305);
  EXPECT_EQ(report.neighbor_radius, 1e305);
  EXPECT_EQ(output, with_radius(1e200));
  for (const Point& p : output)
    EXPECT_LT(CGAL::squared_distance(p, Point(CGAL::ORIGIN)), 1e-20);
}

// the message of the exception, or what was returned instead
template <typename Function>
std::string message_of(const Function& function)
{
  try
  {
    function();
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "no exception";
}

TEST(Errors, name_the_parameter_its_value_and_what_is_allowed)
{
  const std::vector<Point> points = surfaces::sphere(100, 16);
  std::vector<Point> untouched = {Point(1, 2, 3)};
  const auto message = [&](const auto& parameters) {
    return message_of([&] {
      CGAL::curvature_aware_simplify_point_set<Tag>(points, std::back_inserter(untouched),
                                                    parameters);
    });
  };
  const auto message_of_subset = [&](const auto& parameters) {
    std::vector<Point> selected;
    return message_of([&] {
      CGAL::curvature_aware_random_simplify_point_set<Tag>(points, std::back_inserter(selected),
                                                           parameters);
    });
  };
  const auto common_message = [&](const auto& parameters) {
    EXPECT_EQ(message_of_subset(parameters), message(parameters));
    return message(parameters);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();

  EXPECT_EQ(common_message(np::select_percentage(0)),
            "select_percentage is 0, but must be above 0 and at most 100");
  EXPECT_EQ(common_message(np::select_percentage(100.5)),
            "select_percentage is 100.5, but must be above 0 and at most 100");
  EXPECT_EQ(common_message(np::select_percentage(nan)),
            "select_percentage is nan, but must be above 0 and at most 100");
  EXPECT_EQ(common_message(np::number_of_output_points(0)),
            "number_of_output_points is 0, but must be an integer from 1 to the number of points, "
            "which is 100");
  EXPECT_EQ(
      common_message(np::number_of_output_points(101)),
      "number_of_output_points is 101, but must be an integer from 1 to the number of points, "
      "which is 100");
  EXPECT_EQ(common_message(np::number_of_output_points(-5)),
            "number_of_output_points is -5, but must be an integer from 1 to the number of points, "
            "which is 100");
  EXPECT_EQ(
      common_message(np::number_of_output_points(2.5)),
      "number_of_output_points is 2.5, but must be an integer from 1 to the number of points, "
      "which is 100");
  EXPECT_EQ(message(np::number_of_iterations(-1)),
            "number_of_iterations is -1, but must be an integer from 0 to 4294967295");
  EXPECT_EQ(common_message(np::number_of_neighbors(1)),
            "number_of_neighbors is 1, but must be an integer from 2 to 4294967295");
  EXPECT_EQ(message(np::neighbor_radius(-0.5)),
            "neighbor_radius is -0.5, but must be above 0 and finite");
  EXPECT_EQ(message(np::neighbor_radius(0.)),
            "neighbor_radius is 0, but must be above 0 and finite");
  EXPECT_EQ(message(np::neighbor_radius(nan)),
            "neighbor_radius is nan, but must be above 0 and finite");
  EXPECT_EQ(message(np::neighbor_radius(infinity)),
            "neighbor_radius is inf, but must be above 0 and finite");
  EXPECT_EQ(common_message(np::curvature_weight(1.5)),
            "curvature_weight is 1.5, but must be from 0 to 1");
  EXPECT_EQ(common_message(np::curvature_weight(-1)),
            "curvature_weight is -1, but must be from 0 to 1");
  EXPECT_EQ(message(np::curvature_dependence(-2.)),
            "curvature_dependence is -2, but must be at least 0 and finite");
  EXPECT_EQ(common_message(np::adaptivity(nan)), "adaptivity is nan, but must be from 0 to 1");
  EXPECT_EQ(message(np::repulsion_weight(0.5)),
            "repulsion_weight is 0.5, but must be at least 0 and below 0.5");
  EXPECT_EQ(common_message(np::number_of_neighbors(5000000000)),
            "number_of_neighbors is 5000000000, but must be an integer from 2 to 4294967295");
  EXPECT_EQ(message_of_subset(np::repulsion_weight(0.5)), "no exception"); // which it does not have
  EXPECT_EQ(untouched.size(), 1u);
}

TEST_P(Both_methods, errors_of_the_points)
{
  std::vector<Point> points, output;
  EXPECT_EQ(message_of([&] { output = simplified(points); }),
            "points is empty, but must hold at least one point");
  EXPECT_EQ(message_of([&] { output = subset(points); }),
            "points is empty, but must hold at least one point");
  std::vector<std::pair<Point, double>> none;
  const auto variation = [&](std::size_t k) {
    CGAL::estimate_surface_variation<Tag>(
        none, k, CGAL::Second_of_pair_property_map<std::pair<Point, double>>(),
        np::point_map(CGAL::First_of_pair_property_map<std::pair<Point, double>>()));
  };
  EXPECT_EQ(message_of([&] { variation(16); }),
            "points is empty, but must hold at least one point");

  points = surfaces::sphere(100, 17);
  for (double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
  {
    std::vector<Point> damaged = points;
    damaged[42] = Point(0., bad, 0.);
    damaged[77] = Point(0., 0., bad);
    EXPECT_EQ(message_of([&] { output = simplified(damaged); }),
              "points: the point at index 42 has a coordinate that is not finite");
  }
  none.emplace_back(Point(0, 0, 0), 0.);
  EXPECT_EQ(message_of([&] { variation(1); }),
            "k is 1, but must be an integer from 2 to 4294967295");
  EXPECT_NE(message_of([&] { variation(std::size_t(-1)); }), "no exception");

  EXPECT_NE(message_of([&] {
              simplified(points, np::number_of_output_points(std::int8_t(-3)));
            }).find("is -3, but"),
            std::string::npos);

  points[99] = Point(0., 0., -1e200); // a marker of an invalid measurement
  const std::string too_far = "points: the point at index 99 is more than 1e140 times as far from "
                              "many others as these are from each other";
  EXPECT_EQ(message_of([&] { output = simplified(points); }), too_far);
  EXPECT_EQ(message_of([&] { output = subset(points); }), too_far);
}

TEST(Report, is_filled_when_the_function_succeeds)
{
  CGAL::Curvature_aware_simplification_report report;
  const auto full = boost::make_function_output_iterator(
      [](const Point&) { throw std::length_error("no room is left"); });
  EXPECT_THROW(CGAL::curvature_aware_simplify_point_set<Tag>(
                   surfaces::sphere(1000, 3), full,
                   np::number_of_output_points(50).simplification_report(std::ref(report))),
               std::length_error);
  EXPECT_EQ(report.number_of_input_points, 0U);
}

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
TEST(Far_points, cost_the_others_no_digits)
{
  settings_of_the_paper = false;
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

TEST(Far_points, leave_the_literal_method_at_work)
{
  settings_of_the_paper = true;
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
TEST(Adaptive, result_does_not_depend_on_how_far_a_few_points_are)
{
  settings_of_the_paper = false;
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
TEST(Adaptive, does_not_move_samples_of_few_points_among_outliers)
{
  settings_of_the_paper = false;
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
// were at the place of another.
TEST(Adaptive, samples_of_a_curve_are_at_different_places)
{
  settings_of_the_paper = false;
  CGAL::Random random(28);
  std::vector<Point> circle;
  for (int i = 0; i < 5000; ++i)
  {
    const double t = random.uniform_real(0., 2. * CGAL_PI);
    circle.emplace_back(std::cos(t), std::sin(t), 0.);
  }
  for (std::size_t n : {1500u, 2500u, 4500u})
  {
    std::vector<Point> output = simplified(circle, np::number_of_output_points(n));
    std::vector<double> angles;
    for (const Point& p : output)
      angles.push_back(std::atan2(p.y(), p.x()));
    std::sort(angles.begin(), angles.end());
    std::size_t copies = 0;
    for (std::size_t i = 1; i < n; ++i)
      copies += angles[i] - angles[i - 1] < 1e-9 ? 1 : 0;
    EXPECT_LE(copies, 5u) << n; // of 4500, where all of the 19 points around have a sample
  }
}

TEST_P(Both_methods, input_is_left_as_it_was)
{
  const std::vector<Point> points = surfaces::torus(1000, 3., 1., 22);
  const std::vector<Point> copy = points;
  simplified(points);
  subset(points);
  EXPECT_EQ(points, copy);
}

} // namespace
