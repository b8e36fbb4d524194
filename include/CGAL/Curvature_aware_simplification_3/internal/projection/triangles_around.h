// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_TRIANGLES_AROUND_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_TRIANGLES_AROUND_H

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Local_surface.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/Surface_sample.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Computation_kernel.h>

#include <CGAL/Convex_hull_traits_adapter_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/property_map.h>

#include <boost/iterator/counting_iterator.hpp>

#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

using Triangle = Computation_kernel::Triangle_3;

// The triangles around a sample x of the Delaunay triangulation of it and its neighbors in its
// tangent plane: a mesh of the samples is about that. The inversion t -> t / |t|^2 maps circles
// through x to lines, and so the empty ones around triangles to the edges of the convex hull of the
// neighbors. Edges that x is outside of are those of no triangle: it is on a border. The hull takes
// less time than a triangulation, of which most is not around x. The unit is the spacing of x, and
// x the origin: squares of what is computed of triangles do not underflow.
template <typename Neighbors>
std::vector<Triangle> triangles_around(const Surface_sample& x, const Neighbors& neighbors,
                                       const std::vector<Point>& points)
{
  // Squared slope of the way to a neighbor, which is on another sheet if it is steeper: 63 degrees.
  // With 45 degrees, the results are the same, with 84, p99 is 1 % larger.
  constexpr double steepest = 4.;
  using Plane_kernel = Exact_predicates_inexact_constructions_kernel;
  using Point_in_plane = Plane_kernel::Point_2;
  using Traits =
      Convex_hull_traits_adapter_2<Plane_kernel, Pointer_property_map<Point_in_plane>::type>;

  Local_surface plane;
  plane.n = x.normal();
  plane.complete_frame();
  std::vector<Point_in_plane> inverted;
  std::vector<Vector> ring;
  for (std::size_t i : neighbors)
  {
    const Vector d = (points[i] - x.point) / x.spacing;
    const double a = d * plane.u, b = d * plane.v, h = d * plane.n;
    const double squared_length = a * a + b * b;
    if (!(squared_length > 0.) || h * h > steepest * squared_length)
      continue;
    inverted.emplace_back(a / squared_length, b / squared_length);
    ring.push_back(d);
  }

  std::vector<std::size_t> hull; // counterclockwise
  convex_hull_2(boost::make_counting_iterator(std::size_t(0)),
                boost::make_counting_iterator(ring.size()), std::back_inserter(hull),
                Traits(make_property_map(inverted)));
  std::vector<Triangle> triangles;
  for (std::size_t m = 0; m < hull.size(); ++m)
  {
    const std::size_t i = hull[m], j = hull[(m + 1) % hull.size()];
    if (left_turn(Point_in_plane(ORIGIN), inverted[i], inverted[j]))
      triangles.emplace_back(ORIGIN, ORIGIN + ring[i], ORIGIN + ring[j]);
  }
  return triangles;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_TRIANGLES_AROUND_H
