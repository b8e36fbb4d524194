// Built without TBB. With PARALLEL defined it must not compile, and say why.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/curvature_aware_simplify_point_set.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <type_traits>
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
  std::cout << output.size() << " points" << std::endl;
  return output.size() == 50 ? EXIT_SUCCESS : EXIT_FAILURE;
}
