// CGAL::Point_set_3: the surface variation as a property of the points, and a simplified set

#include <CGAL/IO/read_points.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/curvature_aware_simplify_point_set.h>
#include <CGAL/estimate_surface_variation.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Simple_cartesian<double>;
using Point_set = CGAL::Point_set_3<Kernel::Point_3>;
using Concurrency_tag = CGAL::Parallel_if_available_tag;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("points_3/kitten.xyz");
  Point_set points;
  if (!CGAL::IO::read_points(filename, points.index_back_inserter(),
                             CGAL::parameters::point_map(points.point_push_map())))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  auto variation = points.add_property_map<double>("surface_variation", 0.).first;
  CGAL::estimate_surface_variation<Concurrency_tag>(points, 16, variation);
  std::cout << "The largest surface variation is "
            << *std::max_element(variation.begin(), variation.end()) << std::endl;

  Point_set output;
  CGAL::curvature_aware_simplify_point_set<Concurrency_tag>(
      points, output.point_back_inserter(),
      CGAL::parameters::select_percentage(20).adaptivity(0.5));
  std::cout << points.size() << " points simplified to " << output.size() << std::endl;
  return EXIT_SUCCESS;
}
