// Points with colors and normals: the random simplification returns elements of the input, with all
// that they carry. The relaxed simplification returns new points, and takes the same property map.

#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/curvature_aware_random_simplify_point_set.h>
#include <CGAL/curvature_aware_simplify_point_set.h>
#include <CGAL/number_type_config.h>
#include <CGAL/property_map.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <tuple>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Color = std::array<unsigned char, 3>;
using Point_with_attributes = std::tuple<Point, Color, Vector>;
using Point_map = CGAL::Nth_of_tuple_property_map<0, Point_with_attributes>;
using Concurrency_tag = CGAL::Parallel_if_available_tag;

int main()
{
  // a torus, dyed along its tube
  std::vector<Point_with_attributes> points;
  CGAL::Random random(0);
  for (int i = 0; i < 20000; ++i)
  {
    const double u = random.get_double(0., 2. * CGAL_PI);
    const double v = random.get_double(0., 2. * CGAL_PI);
    const Vector normal(std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v));
    const Vector center(3. * std::cos(u), 3. * std::sin(u), 0.);
    const Color color = {static_cast<unsigned char>(127.5 + 127.5 * std::cos(v)), 0, 255};
    points.emplace_back(CGAL::ORIGIN + center + normal, color, normal);
  }

  const auto parameters =
      CGAL::parameters::point_map(Point_map()).number_of_output_points(1000).random_seed(1);

  std::vector<Point_with_attributes> subset;
  CGAL::curvature_aware_random_simplify_point_set<Concurrency_tag>(
      points, std::back_inserter(subset), parameters);
  std::cout << "of the subset, the first point is " << std::get<0>(subset.front())
            << " with normal " << std::get<2>(subset.front()) << std::endl;

  std::vector<Point> relaxed;
  CGAL::curvature_aware_simplify_point_set<Concurrency_tag>(points, std::back_inserter(relaxed),
                                                            parameters.adaptivity(1.));
  std::cout << "of the relaxed points, the first is " << relaxed.front() << std::endl;
  return EXIT_SUCCESS;
}
