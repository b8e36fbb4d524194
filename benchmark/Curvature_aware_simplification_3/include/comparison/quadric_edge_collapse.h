#ifndef CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_QUADRIC_EDGE_COLLAPSE_H
#define CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_QUADRIC_EDGE_COLLAPSE_H

#include <comparison/types.h>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <cstddef>
#include <stdexcept>

namespace comparison {

// The mesh simplified by quadric error metrics (Garland and Heckbert 1997) to about n vertices: no
// peer, since it knows how the points are connected, but a bound for what is possible.
inline Mesh quadric_edge_collapse(const Mesh& mesh, std::size_t n)
{
  namespace simplification = CGAL::Surface_mesh_simplification;
  using Surface_mesh = CGAL::Surface_mesh<Point>;
  if (mesh.triangles.empty() ||
      !CGAL::Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(mesh.triangles))
    throw std::invalid_argument("there is no mesh to collapse");
  Surface_mesh surface;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(mesh.points, mesh.triangles, surface);

  // A closed mesh has about 3 edges for each vertex. CGAL's predicate that counts them changed its
  // name.
  const auto stop = [n](const auto&, const auto&, std::size_t, std::size_t number_of_edges) {
    return number_of_edges < 3 * n;
  };
  const simplification::GarlandHeckbert_plane_policies<Surface_mesh, Kernel> policies(surface);
  simplification::edge_collapse(
      surface, stop,
      CGAL::parameters::get_cost(policies.get_cost()).get_placement(policies.get_placement()));
  surface.collect_garbage();

  Mesh result;
  for (const auto& v : surface.vertices())
    result.points.push_back(surface.point(v));
  for (const auto& f : surface.faces())
  {
    Triangle triangle;
    std::size_t i = 0;
    for (const auto& v : surface.vertices_around_face(surface.halfedge(f)))
      triangle[i++] = static_cast<std::size_t>(v);
    result.triangles.push_back(triangle);
  }
  return result;
}

} // namespace comparison

#endif // CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_QUADRIC_EDGE_COLLAPSE_H
