// The promises of the manual for callbacks, reports and errors

#include "both_methods.h"

#include <CGAL/curvature_aware_random_simplify_point_set.h>
#include <CGAL/curvature_aware_simplify_point_set.h>
#include <CGAL/estimate_surface_variation.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace {

using namespace both_methods;

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
  std::vector<std::pair<Point, double>> variation;
  for (const Point& p : points)
    variation.emplace_back(p, 0.);
  CGAL::estimate_surface_variation<Tag>(
      variation, 16, CGAL::Second_of_pair_property_map<std::pair<Point, double>>(),
      np::point_map(CGAL::First_of_pair_property_map<std::pair<Point, double>>()).callback(check));
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

TEST_P(Both_methods, callback_may_throw_and_nothing_is_written)
{
  const std::vector<Point> points = surfaces::sphere(3000, 14);
  std::vector<std::pair<Point, double>> variation;
  for (const Point& p : points)
    variation.emplace_back(p, -1.);
  for (double end : {0., 0.5, 1.})
  {
    const auto fail = np::callback([&](double progress) {
      if (progress >= end)
        throw std::range_error("mine");
      return true;
    });
    CGAL::Curvature_aware_simplification_report report;
    report.number_of_input_points = 7;
    std::vector<Point> output;
    EXPECT_THROW(CGAL::curvature_aware_simplify_point_set<Tag>(
                     points, std::back_inserter(output),
                     fail.settings_of_the_paper(settings_of_the_paper)
                         .simplification_report(std::ref(report))),
                 std::range_error);
    EXPECT_THROW(CGAL::curvature_aware_random_simplify_point_set<Tag>(
                     points, std::back_inserter(output), fail),
                 std::range_error);
    EXPECT_TRUE(output.empty());
    EXPECT_EQ(report.number_of_input_points, 7u);
    EXPECT_THROW(CGAL::estimate_surface_variation<Tag>(
                     variation, 16, CGAL::Second_of_pair_property_map<std::pair<Point, double>>(),
                     fail.point_map(CGAL::First_of_pair_property_map<std::pair<Point, double>>())),
                 std::range_error);
    for (const auto& [p, kappa] : variation)
      ASSERT_EQ(kappa, -1.);
  }
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

} // namespace
