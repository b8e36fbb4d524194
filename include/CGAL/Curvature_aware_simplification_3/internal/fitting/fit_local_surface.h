// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_FIT_LOCAL_SURFACE_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_FIT_LOCAL_SURFACE_H

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Surface_fit.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/fit_to_neighbors.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/lines_of_scan.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/point_of_curve.h>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The narrowest surface that can be trusted, around the foot point of x: through as few neighbors
// as possible, but twice as many as long as they are on one line, which may bend, or noise makes it
// unknown between two. If even the most are on one line, or what they reach beside it are no other
// lines of a scan, it is all there is: a curve, for which the narrowest do, and so they do for the
// next fit to it. `last` is the fit before, if any; `normal` is that of the sample, or the null
// vector of a point that starts one.
inline Local_surface fit_local_surface(const Surface_fit& fit, const Point& x, const Vector& normal,
                                       const Local_surface& last, int rounds,
                                       Neighborhood& neighborhood)
{
  const Center center = normal == NULL_VECTOR ? Center::has_no_say : Center::counts;
  const auto fit_curve = [&] {
    Local_surface surface = fit_to_neighbors(fit, x, normal, center, smallest_neighborhood,
                                             last.neighbors, rounds, neighborhood);
    surface.is_curve = true;
    surface.origin = point_of_curve(neighborhood, surface.origin);
    return surface;
  };
  if (last.is_curve)
    return fit_curve();
  // More than a third of all points do not tell what is between them (see fewest_points_to_fit):
  // those of a closed curve are as wide as a surface.
  const std::size_t largest =
      (std::min)({largest_neighborhood, fit.search.size(),
                  (std::max)(smallest_neighborhood, fit.search.size() / 3)});
  Vector guess = normal;
  bool is_line = false; // about which the surface turns
  std::optional<Line_of_points> line;
  for (std::size_t smallest = smallest_neighborhood;;)
  {
    const Local_surface surface =
        fit_to_neighbors(fit, x, guess, center, smallest, last.neighbors, rounds, neighborhood);
    if (!fit.settings.widen_between_lines)
      return surface;
    const std::size_t size = neighborhood.size();
    is_line = is_on_line(fit, surface) || (is_line && is_on_bent_line(neighborhood, surface));
    if (is_line && !line)
      line = line_of_points(neighborhood);
    if (!is_line && (size >= largest || !is_between_lines(fit, neighborhood, surface)))
      return !line || has_lines_beside(*line, surface.n, fit.search) ? surface : fit_curve();
    if (size >= largest)
      return fit_curve();
    smallest = (std::min)(2 * size - 1, largest); // the center may be one of them
    if (is_line)                                  // and the guess may have turned with another fit
      guess = NULL_VECTOR;
  }
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_FIT_LOCAL_SURFACE_H
