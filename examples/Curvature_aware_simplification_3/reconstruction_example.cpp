// From a raw scan to a mesh: points with noise and outliers are simplified, what was found in them
// is printed, and a triangle mesh of the simplified points is written.

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Curvature_aware_simplification_report.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/Random.h>
#include <CGAL/curvature_aware_simplify_point_set.h>
#include <CGAL/number_type_config.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <iterator>
#include <random>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangle = std::array<std::size_t, 3>;
using Concurrency_tag = CGAL::Parallel_if_available_tag;

// 40,000 points of a torus with noise, and 800 outliers
std::vector<Point> scan_of_torus()
{
  std::vector<Point> points;
  std::mt19937 engine(0);
  std::normal_distribution<double> noise(0., 0.02);
  CGAL::Random random(0);
  for (int i = 0; i < 40000; ++i)
  {
    const double u = random.get_double(0., 2. * CGAL_PI);
    const double v = random.get_double(0., 2. * CGAL_PI);
    const double tube = 1. + noise(engine), distance = 3. + tube * std::cos(v);
    points.emplace_back(distance * std::cos(u), distance * std::sin(u), tube * std::sin(v));
  }
  for (int i = 0; i < 800; ++i)
    points.emplace_back(random.get_double(-5., 5.), random.get_double(-5., 5.),
                        random.get_double(-2., 2.));
  return points;
}

int main(int argc, char* argv[])
{
  std::vector<Point> scan;
  if (argc < 2)
    scan = scan_of_torus();
  else if (!CGAL::IO::read_points(argv[1], std::back_inserter(scan)) || scan.empty())
  {
    std::cerr << "Cannot read " << argv[1] << std::endl;
    return EXIT_FAILURE;
  }

  std::vector<Point> points;
  CGAL::Curvature_aware_simplification_report report;
  CGAL::curvature_aware_simplify_point_set<Concurrency_tag>(
      scan, std::back_inserter(points),
      CGAL::parameters::select_percentage(5).simplification_report(std::ref(report)));
  std::cout << scan.size() << " points: " << report.number_of_outliers << " outliers, noise "
            << report.noise_level << std::endl;

  std::vector<Triangle> triangles;
  CGAL::advancing_front_surface_reconstruction(points.begin(), points.end(),
                                               std::back_inserter(triangles));
  std::cout << points.size() << " points simplified, " << triangles.size() << " triangles"
            << std::endl;
  return CGAL::IO::write_polygon_soup("mesh.off", points, triangles) ? EXIT_SUCCESS : EXIT_FAILURE;
}
