// The promises of the manual for the results of the public functions

#include "both_methods.h"

#include <CGAL/estimate_surface_variation.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#endif

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <thread>
#include <utility>
#include <vector>

namespace {

using namespace both_methods;

INSTANTIATE_TEST_SUITE_P(, Both_methods, testing::Bool(),
                         [](const auto& info) { return info.param ? "paper" : "adaptive"; });

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

TEST_F(Defaults, all_distinct_points_are_returned_as_they_are)
{
  std::vector<Point> points = surfaces::sphere(1000, 3);
  points.emplace_back(30., 0., 0.); // an outlier
  points.insert(points.end(), 500, points[7]);
  for (std::size_t n : {1001u, 1200u, 1501u})
  {
    CGAL::Curvature_aware_simplification_report report;
    std::vector<Point> output;
    CGAL::curvature_aware_simplify_point_set<Tag>(
        points, std::back_inserter(output),
        np::number_of_output_points(n).simplification_report(std::ref(report)));
    EXPECT_EQ(output.size(), n);
    EXPECT_LT(hausdorff_distance(output, points), 1e-13); // into the frame and back
    EXPECT_EQ(report.number_of_outliers, 0u);
    EXPECT_EQ(report.noise_level, 0.);
  }
}

TEST(Subset, makes_up_for_an_uneven_density_as_far_as_adaptivity_asks)
{
  std::vector<Point> points = surfaces::square(20000, 1); // and half as dense beside it
  for (const Point& p : surfaces::square(10000, 2))
    points.emplace_back(1. + p.x(), p.y(), p.z());
  const auto on_dense_side = [&](double adaptivity) {
    std::vector<Point> output;
    CGAL::curvature_aware_random_simplify_point_set<Tag>(
        points, std::back_inserter(output),
        np::number_of_output_points(3000).curvature_weight(0.).adaptivity(adaptivity));
    return static_cast<double>(
        std::count_if(output.begin(), output.end(), [](const Point& p) { return p.x() < 1.; }));
  };
  // within five standard deviations of drawing 3000 with the probabilities 1/2 and 2/3
  EXPECT_NEAR(on_dense_side(1.), 1500., 5. * std::sqrt(3000. / 4.));
  EXPECT_NEAR(on_dense_side(0.), 2000., 5. * std::sqrt(3000. * 2. / 9.));
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

TEST_P(Both_methods, input_is_left_as_it_was)
{
  const std::vector<Point> points = surfaces::torus(1000, 3., 1., 22);
  const std::vector<Point> copy = points;
  simplified(points);
  subset(points);
  EXPECT_EQ(points, copy);
}

} // namespace
