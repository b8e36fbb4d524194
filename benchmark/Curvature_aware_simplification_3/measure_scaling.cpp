// Time and memory of one call with default parameters on points of a torus, and the ratio to the time
// of one normal estimation of the same points. One call in a process, because memory is counted from
// its largest size.
//
//   measure_scaling NUMBER_OF_POINTS NUMBER_OF_OUTPUT_POINTS [--ratio]

#include "surfaces.h"

#include <CGAL/Curvature_aware_simplification_report.h>
#include <CGAL/Real_timer.h>
#include <CGAL/curvature_aware_simplify_point_set.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

using Tag = CGAL::Parallel_if_available_tag;
using Point_with_normal = std::pair<surfaces::Point, surfaces::Kernel::Vector_3>;
namespace np = CGAL::parameters;

// a line of /proc/self/status in bytes, 0 where there is none
double memory(const std::string& key)
{
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.compare(0, key.size(), key) == 0)
      return 1024. * std::stod(line.substr(key.size()));
  return 0.;
}

double seconds_of_normal_estimation(const std::vector<surfaces::Point>& points)
{
  std::vector<Point_with_normal> points_with_normals;
  points_with_normals.reserve(points.size());
  for (const surfaces::Point& p : points)
    points_with_normals.emplace_back(p, CGAL::NULL_VECTOR);
  CGAL::Real_timer timer;
  timer.start();
  CGAL::pca_estimate_normals<Tag>(
      points_with_normals, 16,
      np::point_map(CGAL::First_of_pair_property_map<Point_with_normal>())
          .normal_map(CGAL::Second_of_pair_property_map<Point_with_normal>()));
  return timer.time();
}

int main(int argc, char* argv[])
{
  if (argc < 3)
  {
    std::cerr << "Usage: measure_scaling NUMBER_OF_POINTS NUMBER_OF_OUTPUT_POINTS [--ratio]"
              << std::endl;
    return EXIT_FAILURE;
  }
  const std::size_t size = std::stoul(argv[1]);
  const std::size_t n = std::stoul(argv[2]);
  const std::vector<surfaces::Point> points = surfaces::torus(size, 3., 1., 0);
  const double memory_before = memory("VmRSS:");

  CGAL::Curvature_aware_simplification_report report;
  std::vector<surfaces::Point> output;
  output.reserve(n);
  CGAL::Real_timer timer;
  timer.start();
  CGAL::curvature_aware_simplify_point_set<Tag>(
      points, std::back_inserter(output),
      np::number_of_output_points(n).simplification_report(std::ref(report)));
  const double seconds = timer.time();
  const double bytes = (memory("VmHWM:") - memory_before) / static_cast<double>(size);

  std::printf("%zu -> %zu points: %.3f s, %.0f bytes per input point; sorting %.3f, features %.3f, "
              "outliers %.3f, noise %.3f, selection %.3f, relaxation %.3f, projection %.3f s\n",
              size, output.size(), seconds, bytes, report.sorting_time, report.features_time,
              report.outliers_time, report.noise_time, report.selection_time,
              report.relaxation_time, report.projection_time);
  if (argc > 3)
    std::printf("%.2f times one normal estimation\n",
                seconds / seconds_of_normal_estimation(points));
  return EXIT_SUCCESS;
}
