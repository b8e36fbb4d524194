// A progress bar, and a computation that is cancelled half-way: nothing is written then.

#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/curvature_aware_simplify_point_set.h>
#include <CGAL/point_generators_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Concurrency_tag = CGAL::Parallel_if_available_tag;

int main()
{
  std::vector<Point> points;
  CGAL::Random random(0);
  CGAL::Random_points_on_sphere_3<Point> generator(1., random);
  std::copy_n(generator, 50000, std::back_inserter(points));

  const auto show = [](double progress) {
    const std::size_t length = 40, done = static_cast<std::size_t>(progress * length);
    std::cout << "\r[" << std::string(done, '#') << std::string(length - done, ' ') << "]"
              << std::flush;
    return true;
  };
  std::vector<Point> output;
  CGAL::curvature_aware_simplify_point_set<Concurrency_tag>(points, std::back_inserter(output),
                                                            CGAL::parameters::callback(show));
  std::cout << "\n" << output.size() << " points" << std::endl;

  const auto show_and_cancel = [&show](double progress) {
    return show(progress) && progress < 0.5;
  };
  std::vector<Point> cancelled;
  CGAL::curvature_aware_simplify_point_set<Concurrency_tag>(
      points, std::back_inserter(cancelled), CGAL::parameters::callback(show_and_cancel));
  std::cout << "\n" << cancelled.size() << " points after cancelling" << std::endl;
  return EXIT_SUCCESS;
}
