// Points that were moved have no attributes. Here, each gets the color of the nearest point of the
// scan, and normals are estimated and oriented, as Poisson reconstruction wants them.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Point_set_3/IO.h>
#include <CGAL/Random.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/curvature_aware_simplify_point_set.h>
#include <CGAL/jet_estimate_normals.h>
#include <CGAL/mst_orient_normals.h>
#include <CGAL/point_generators_3.h>

#include <cstdlib>
#include <iostream>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Point_set = CGAL::Point_set_3<Point>;
using Color_map = Point_set::Property_map<unsigned char>;
using Search_traits = CGAL::Search_traits_adapter<Point_set::Index, Point_set::Point_map,
                                                  CGAL::Search_traits_3<Kernel>>;
using Neighbor_search = CGAL::Orthogonal_k_neighbor_search<Search_traits>;
using Concurrency_tag = CGAL::Parallel_if_available_tag;

// 40,000 points of a sphere, dyed by their height
void insert_sphere(Point_set& scan, Color_map& red)
{
  CGAL::Random random(0);
  CGAL::Random_points_on_sphere_3<Point> generator(1., random);
  for (int i = 0; i < 40000; ++i)
  {
    const Point p = *generator++;
    red[*scan.insert(p)] = static_cast<unsigned char>(127.5 + 127.5 * p.z());
  }
}

// of each point, what the nearest one of the scan has
void copy_colors(const Point_set& scan, const Color_map& from, const Point_set& points,
                 Color_map& to)
{
  const Point_set::Point_map place = scan.point_map();
  const Neighbor_search::Tree tree(scan.begin(), scan.end(), Neighbor_search::Splitter(),
                                   Search_traits(place));
  for (const Point_set::Index& i : points)
  {
    const Neighbor_search nearest(tree, points.point(i), 1, 0., true,
                                  Neighbor_search::Distance(place));
    to[i] = from[nearest.begin()->first];
  }
}

int main()
{
  Point_set scan;
  Color_map red = scan.add_property_map<unsigned char>("red", 0).first;
  insert_sphere(scan, red);

  Point_set points;
  CGAL::curvature_aware_simplify_point_set<Concurrency_tag>(scan, points.point_back_inserter());
  Color_map red_of_nearest = points.add_property_map<unsigned char>("red", 0).first;
  copy_colors(scan, red, points, red_of_nearest);

  const unsigned int neighbors = 12; // two rings
  points.add_normal_map();
  CGAL::jet_estimate_normals<Concurrency_tag>(points, neighbors);
  const auto not_oriented = CGAL::mst_orient_normals(points, neighbors);
  std::cout << points.size() << " points, of which " << points.end() - not_oriented
            << " have a normal without orientation" << std::endl;
  return CGAL::IO::write_point_set("simplified.ply", points) ? EXIT_SUCCESS : EXIT_FAILURE;
}
