// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FIT_LOCAL_SURFACE_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FIT_LOCAL_SURFACE_H

#include <CGAL/Curvature_aware_simplification_3/internal/Surface_fit.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fit_to_neighbors.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Whether the neighbors do not tell the height at the center, whatever is left out of them: noise would be larger
// there than at a point, and visibly so. The center is between two lines of a scan, whose lines are farther
// apart than the points on them; of 19 random points, less than 1 % are so badly placed.
inline bool is_between_lines(const Surface_fit& fit, Neighborhood& neighborhood,
                             const Local_surface& surface)
{
  const auto is_unknown = [&](const Local_surface& s)
  {
    return s.amplification > 1. &&
           s.amplification * fit.noise.independent_level > fit.noise.visible_error;
  };
  if (!is_unknown(surface))
    return false;
  neighborhood.weight_by_distance();
  Local_surface of_all = surface;
  return fit_quadric(neighborhood, fit.noise.independent_level, of_all) && is_unknown(of_all);
}

// The narrowest surface that can be trusted, around the foot point of x: through as few neighbors as possible, but
// twice as many as long as it is between lines. Without noise, that would miss more of the shape than it
// mends. The arguments are those of fit_to_neighbors().
inline Local_surface fit_local_surface(const Surface_fit& fit, const Point& x, const Vector& normal,
                                       std::size_t expected_neighbors, int rounds,
                                       Neighborhood& neighborhood)
{
  const std::size_t largest = (std::min)(largest_neighborhood, fit.number_of_points);
  for (std::size_t smallest = smallest_neighborhood;;)
  {
    const Local_surface surface =
        fit_to_neighbors(fit, x, normal, smallest, expected_neighbors, rounds, neighborhood);
    if (!fit.settings.widen_between_lines || neighborhood.size() >= largest ||
        !is_between_lines(fit, neighborhood, surface))
      return surface;
    smallest = (std::min)(2 * neighborhood.size() - 1, largest); // the center may be one of them
  }
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FIT_LOCAL_SURFACE_H
