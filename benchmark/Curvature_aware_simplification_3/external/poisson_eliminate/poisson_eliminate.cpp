// Calls CGAL::poisson_eliminate. Files are plain arrays of doubles; prints the seconds of the call.
//
//   run_poisson_eliminate INPUT OUTPUT COUNT RADIUS
//
// RADIUS is the maximum radius in output spacings, 0 for the default.

#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/compute_average_spacing.h>
#include <CGAL/poisson_eliminate.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

using Point = CGAL::Simple_cartesian<double>::Point_3;

int main(int argc, char* argv[])
{
  if (argc != 5)
    return EXIT_FAILURE;
  std::vector<Point> points, output;
  std::ifstream input(argv[1], std::ios::binary);
  double c[3];
  while (input.read(reinterpret_cast<char*>(c), sizeof(c)))
    points.emplace_back(c[0], c[1], c[2]);
  const std::size_t count = std::stoul(argv[3]);
  const double radius = std::stod(argv[4]);
  const double spacing = CGAL::compute_average_spacing<CGAL::Sequential_tag>(points, 6) *
                         std::sqrt(static_cast<double>(points.size()) / static_cast<double>(count));

  CGAL::Real_timer timer;
  timer.start();
  if (radius > 0.)
    CGAL::poisson_eliminate(points, count, std::back_inserter(output),
                            CGAL::parameters::maximum_radius(radius * spacing));
  else
    CGAL::poisson_eliminate(points, count, std::back_inserter(output));
  std::cout << timer.time() << std::endl;

  std::ofstream file(argv[2], std::ios::binary);
  for (const Point& p : output)
    for (int i = 0; i < 3; ++i)
    {
      const double x = p[i];
      file.write(reinterpret_cast<const char*>(&x), sizeof(x));
    }
  return file.good() ? EXIT_SUCCESS : EXIT_FAILURE;
}
