// The result is bit by bit the same for every tag, number of threads and order of the input, on
// inputs of which each needs other stages

#include "inputs.h"

#include <CGAL/curvature_aware_simplify_point_set.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <ostream>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace inputs;

using Report = CGAL::Curvature_aware_simplification_report;

struct Input
{
  std::string name;
  std::size_t count;
  std::function<std::vector<Point>()> points;
  std::function<bool(const Report&)> took_its_stage; // which the input is there for
};

std::ostream& operator<<(std::ostream& stream, const Input& input)
{
  return stream << input.name;
}

template <typename ConcurrencyTag>
std::vector<Point> result_of(const std::vector<Point>& points, std::size_t count, Report& report)
{
  std::vector<Point> output;
  CGAL::curvature_aware_simplify_point_set<ConcurrencyTag>(
      points, std::back_inserter(output),
      np::number_of_output_points(count).simplification_report(std::ref(report)));
  return output;
}

std::vector<Point> noisy_plate_with_outliers()
{
  std::vector<Point> points = with_noise(thin_plate(6.), 0.004, 1);
  add_outliers(points, 4000, 1.5, 2);
  return points;
}

// clusters of 30 points that hang in the air
std::vector<Point> cube_with_clusters()
{
  std::vector<Point> points = cube(10000, 3), centers;
  add_outliers(centers, 10, 3., 4);
  for (const Point& center : centers)
    for (const Point& p : with_noise(std::vector<Point>(30, center), 0.02, 5))
      points.push_back(p);
  return points;
}

// 100 times as many points at one end as at the other, and outliers
std::vector<Point> uneven_sphere_with_outliers()
{
  CGAL::Random random(6);
  std::vector<Point> points = surfaces::sphere(40000, 6);
  points.erase(std::remove_if(points.begin(), points.end(),
                              [&](const Point& p) {
                                return random.uniform_real(0., 1.) > std::pow(0.1, 1. + p.x());
                              }),
               points.end());
  add_outliers(points, 200, 2., 7);
  return points;
}

// lines of a scan, ten times as far apart as the points on them, with noise
std::vector<Point> lines()
{
  CGAL::Random random(8);
  std::vector<Point> points;
  for (int line = 0; line < 30; ++line)
    for (int i = 0; i < 300; ++i)
      points.emplace_back(10. * line, i, waves(10. * line, i) + surfaces::normal_deviate(random));
  return points;
}

// each of 2000 points 20 times, measured with an error that is small against their distance
std::vector<Point> copies_of_places()
{
  std::vector<Point> points;
  for (unsigned int i = 0; i < 20; ++i)
    for (const Point& p : with_noise(surfaces::sphere(2000, 9), 1e-4, 10 + i))
      points.push_back(p);
  return points;
}

const Input all_inputs[] = {
    {"sharp edges", 800, [] { return cube(10000, 11); },
     [](const Report& r) { return r.number_of_outliers == 0; }},
    {"noisy plate with outliers", 1500, noisy_plate_with_outliers,
     [](const Report& r) { return r.noise_level > 0.003 && r.number_of_outliers > 2000; }},
    {"clusters in the air", 800, cube_with_clusters,
     [](const Report& r) { return r.number_of_outliers >= 250; }},
    {"uneven density with outliers", 1000, uneven_sphere_with_outliers,
     [](const Report& r) { return r.number_of_outliers > 100; }},
    {"lines of a scan", 600, lines, [](const Report& r) { return r.noise_level > 0.5; }},
    {"depth in steps", 900, [] { return depth_frame(200, 3., waves); },
     [](const Report& r) { return r.depth_step > 2.9; }},
    {"depth in steps of three cameras", 900, [] { return seen_by_cameras(3., camera_of_strip); },
     [](const Report& r) { return r.depth_step > 2.9; }},
    {"frames of a scanner at rest", 500, [] { return frames_of_a_scanner_at_rest(50, 8, 0.5, 12); },
     [](const Report& r) { return r.noise_level > 0.3; }},
    {"copies of places", 300, copies_of_places,
     [](const Report& r) { return r.number_of_merged_points > 30000; }},
    {"dense noise", 30, [] { return with_noise(surfaces::sphere(30000, 13), 0.05, 14); },
     [](const Report& r) { return r.noise_level > 0.04; }},
    {"border and corners", 500,
     [] { return patch(8000, 15, [](double x, double y) { return 0.3 * x * y; }); },
     [](const Report& r) { return r.number_of_outliers == 0; }},
    {"nearly all points", 3500, [] { return cube(4000, 16); },
     [](const Report& r) { return r.number_of_outliers == 0; }},
};

class Invariances : public testing::TestWithParam<Input>
{};
INSTANTIATE_TEST_SUITE_P(, Invariances, testing::ValuesIn(all_inputs), [](const auto& info) {
  std::string name = info.param.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
});

TEST_P(Invariances, of_tags_threads_and_order)
{
  std::vector<Point> points = GetParam().points();
  const std::size_t count = GetParam().count;
  Report report;
  const std::vector<Point> expected = result_of<CGAL::Sequential_tag>(points, count, report);
  EXPECT_TRUE(GetParam().took_its_stage(report))
      << report.number_of_outliers << ' ' << report.noise_level << ' ' << report.depth_step << ' '
      << report.number_of_merged_points;
#ifdef CGAL_LINKED_WITH_TBB
  for (std::size_t threads : {1u, 2u, 3u, 8u})
  {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    EXPECT_EQ(result_of<CGAL::Parallel_tag>(points, count, report), expected) << threads;
  }
#endif
  std::mt19937 random(17);
  std::shuffle(points.begin(), points.end(), random);
  EXPECT_EQ(result_of<Tag>(points, count, report), expected);
}

} // namespace
