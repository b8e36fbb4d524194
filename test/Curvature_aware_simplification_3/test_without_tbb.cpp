// All public functions, built without TBB and with debug information, after macros as windows.h
// defines them. With PARALLEL defined it must not compile, and say why.

#include <CGAL/Hilbert_sort_median_3.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Simple_cartesian.h>

#include <Eigen/Dense>

#include <algorithm>
#include <functional>
#include <random>

#define far
#define near
#define small char
#define min(a, b) (((a) < (b)) ? (a) : (b))
#define max(a, b) (((a) > (b)) ? (a) : (b))

#include <CGAL/curvature_aware_random_simplify_point_set.h>
#include <CGAL/curvature_aware_simplify_point_set.h>
#include <CGAL/estimate_surface_variation.h>
#include <CGAL/property_map.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

#ifdef CGAL_LINKED_WITH_TBB
#error "this test must be built without TBB"
#endif

#ifdef PARALLEL
using Concurrency_tag = CGAL::Parallel_tag;
#else
using Concurrency_tag = CGAL::Parallel_if_available_tag;
#endif

int main()
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  std::vector<Point> points, output;
  for (int i = 0; i < 1000; ++i)
    points.emplace_back(i % 32, i / 32, 0);
  CGAL::curvature_aware_simplify_point_set<Concurrency_tag>(points, std::back_inserter(output));
  CGAL::curvature_aware_random_simplify_point_set<Concurrency_tag>(points,
                                                                   std::back_inserter(output));
  std::cout << output.size() << " points" << std::endl;

  using Point_and_value = std::pair<Point, double>;
  std::vector<Point_and_value> values;
  for (const Point& p : points)
    values.emplace_back(p, -1.);
  CGAL::estimate_surface_variation<Concurrency_tag>(
      values, 16, CGAL::Second_of_pair_property_map<Point_and_value>(),
      CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Point_and_value>()));
  return output.size() == 100 && values.front().second == 0. ? EXIT_SUCCESS : EXIT_FAILURE;
}
