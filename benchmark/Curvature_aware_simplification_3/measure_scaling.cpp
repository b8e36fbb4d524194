// Time and memory of one call with default parameters, and the ratio of the time to that of one
// normal estimation of the same points; see --help. The result is a JSON object.

#include "surfaces.h"

#include <comparison/memory.h>

#include <CGAL/Curvature_aware_simplification_report.h>
#include <CGAL/Real_timer.h>
#include <CGAL/curvature_aware_simplify_point_set.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>

#include <boost/program_options.hpp>
#include <nlohmann/json.hpp>
#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using Tag = CGAL::Parallel_if_available_tag;
using surfaces::Point;
using Points = std::vector<Point>;
using Point_with_normal = std::pair<Point, surfaces::Kernel::Vector_3>;
using nlohmann::json;
namespace np = CGAL::parameters;
namespace po = boost::program_options;

namespace {

Points torus(std::size_t n)
{
  return surfaces::torus(n, 3., 1., 0);
}

// What could cost more than a clean scan of the same size
Points make_input(const std::string& name, std::size_t size)
{
  if (name == "torus")
    return torus(size);
  CGAL::Random random(1);
  Points points;
  points.reserve(size);
  if (name == "duplicates") // each point ten times
    for (const Point& p : torus(size / 10))
      points.insert(points.end(), 10, p);
  else if (name == "line")
    for (std::size_t i = 0; i < size; ++i)
    {
      const double t = random.uniform_real(0., 1.);
      points.emplace_back(t, 2. * t, 3. * t);
    }
  else if (name == "clusters") // extent / spacing is 1e8 for a million points
    for (const Point& p : torus(size))
    {
      const double shift = points.size() % 2 == 0 ? 0. : 1e6;
      points.emplace_back(p.x() + shift, p.y() + shift, p.z() + shift);
    }
  else if (name == "outliers") // 10 %, in the inflated box
  {
    points = torus(size - size / 10);
    while (points.size() < size)
    {
      const double x = random.uniform_real(-4.4, 4.4), y = random.uniform_real(-4.4, 4.4);
      points.emplace_back(x, y, random.uniform_real(-1.1, 1.1));
    }
  }
  else if (name == "sheets") // ten squares, 0.6 spacings of the points apart
  {
    const double apart = 0.6 * std::sqrt(10. / static_cast<double>(size));
    while (points.size() < size)
    {
      const double x = random.uniform_real(0., 1.), y = random.uniform_real(0., 1.);
      points.emplace_back(x, y, apart * static_cast<double>(points.size() % 10));
    }
  }
  else if (name == "noise" || name == "layer") // Gaussian, of one and of ten spacings of the points
  {
    const double area = 12. * CGAL_PI * CGAL_PI;
    const double sigma = (name == "noise" ? 1. : 10.) * std::sqrt(area / static_cast<double>(size));
    for (const Point& p : torus(size))
    {
      const double x = surfaces::normal_deviate(random), y = surfaces::normal_deviate(random);
      points.emplace_back(p.x() + sigma * x, p.y() + sigma * y,
                          p.z() + sigma * surfaces::normal_deviate(random));
    }
  }
  else
    throw std::invalid_argument("There is no input " + name);
  return points;
}

double seconds_of_normal_estimation(const Points& points)
{
  std::vector<Point_with_normal> points_with_normals;
  points_with_normals.reserve(points.size());
  for (const Point& p : points)
    points_with_normals.emplace_back(p, CGAL::NULL_VECTOR);
  CGAL::Real_timer timer;
  timer.start();
  CGAL::pca_estimate_normals<Tag>(
      points_with_normals, 16,
      np::point_map(CGAL::First_of_pair_property_map<Point_with_normal>())
          .normal_map(CGAL::Second_of_pair_property_map<Point_with_normal>()));
  return timer.time();
}

double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

json stages(const CGAL::Curvature_aware_simplification_report& report)
{
  return {{"sorting", report.sorting_time},       {"features", report.features_time},
          {"outliers", report.outliers_time},     {"noise", report.noise_time},
          {"smoothing", report.smoothing_time},   {"selection", report.selection_time},
          {"relaxation", report.relaxation_time}, {"projection", report.projection_time}};
}

json measure(const Points& points, std::size_t n, unsigned int neighbors, std::size_t rounds,
             bool against_normals)
{
  CGAL::Curvature_aware_simplification_report report;
  std::vector<double> seconds, ratios;
  double memory = 0.;
  for (std::size_t round = 0; round < rounds; ++round)
  {
    Points output;
    output.reserve(n);
#ifdef __GLIBC__
    malloc_trim(0); // so that freed memory does not hide what the method needs
#endif
    comparison::reset_peak_memory();
    const double memory_before = comparison::status("VmRSS");
    CGAL::Real_timer timer;
    timer.start();
    CGAL::curvature_aware_simplify_point_set<Tag>(
        points, std::back_inserter(output),
        np::number_of_output_points(n).number_of_neighbors(neighbors).simplification_report(
            std::ref(report)));
    seconds.push_back(timer.time());
    memory = (std::max)(memory, comparison::status("VmHWM") - memory_before);
    if (against_normals)
      ratios.push_back(seconds.back() / seconds_of_normal_estimation(points));
  }
  json result = {{"seconds", median(seconds)},
                 {"bytes", memory / static_cast<double>(points.size())},
                 {"stages", stages(report)}};
  if (against_normals)
    result["ratio"] = median(ratios);
  return result;
}

} // namespace

int main(int argc, char* argv[])
try
{
  std::size_t size, n, rounds, threads;
  unsigned int neighbors;
  std::string input;
  po::options_description options("Options");
  options.add_options()("help", "this text");
  options.add_options()("input", po::value(&input)->default_value("torus"),
                        "torus, duplicates, line, clusters, outliers, noise, layer or sheets");
  options.add_options()("points", po::value(&size)->default_value(1000000), "of the input");
  options.add_options()("output-points", po::value(&n)->default_value(50000), "asked for");
  options.add_options()("neighbors", po::value(&neighbors)->default_value(16),
                        "number_of_neighbors");
  options.add_options()("threads", po::value(&threads)->default_value(0), "at most; 0: all");
  options.add_options()("rounds", po::value(&rounds)->default_value(3), "for the median");
  options.add_options()("ratio", "to the time of one normal estimation, too");
  po::variables_map values;
  po::store(po::parse_command_line(argc, argv, options), values);
  po::notify(values);
  if (values.count("help"))
  {
    std::cout << options;
    return EXIT_SUCCESS;
  }
#ifdef CGAL_LINKED_WITH_TBB
  using tbb::global_control;
  const global_control control(
      global_control::max_allowed_parallelism,
      threads > 0 ? threads
                  : global_control::active_value(global_control::max_allowed_parallelism));
#endif
  std::cout << measure(make_input(input, size), n, neighbors, (std::max)(rounds, std::size_t(1)),
                       values.count("ratio") > 0)
            << std::endl;
  return EXIT_SUCCESS;
}
catch (const std::exception& error)
{
  std::cerr << error.what() << std::endl;
  return EXIT_FAILURE;
}
