// Simplifies a point set to 5 % of its points with the defaults.

#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/curvature_aware_simplify_point_set.h>
#include <CGAL/point_generators_3.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Concurrency_tag = CGAL::Parallel_if_available_tag;

int main()
{
  std::vector<Point> points;
  CGAL::Random random(0);
  CGAL::Random_points_on_sphere_3<Point> generator(1., random);
  std::copy_n(generator, 20000, std::back_inserter(points));

  std::vector<Point> output;
  CGAL::curvature_aware_simplify_point_set<Concurrency_tag>(points, std::back_inserter(output));

  std::cout << points.size() << " points simplified to " << output.size() << std::endl;
  return EXIT_SUCCESS;
}
