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

// Whether the neighbors are on one line of a scan, whose lines are much farther apart than the points on them.
// They tell the height at the center, but the surface turns about the line: without noise, as the line bends.
inline bool is_on_line(const Surface_fit& fit, const Local_surface& surface)
{
  // Of the length. On exact lines, 5 to 50 times as dense along as across, errors are the same with 0.05 to 0.2. But lines
  // have a width of their own, and where they are as far apart as the samples, wider fits miss what is between them: with
  // 0.2, the mean error of scanned shapes is 6 % larger there, with 0.05 1 %.
  constexpr double broad_enough = 0.05;

  // without what noise gives a line
  const double squared_width = surface.width * surface.width - fit.noise.level * fit.noise.level;
  return surface.radius > 0. &&
         squared_width < broad_enough * broad_enough * surface.length * surface.length;
}

// The narrowest surface that can be trusted, around the foot point of x: through as few neighbors as possible, but
// twice as many as long as they are on one line, or noise makes it unknown between two. If even the most are on one
// line, it is all there is: a curve, for which the narrowest do, and so they do for the next fit to it. `last` is the
// fit before, if any; the other arguments are those of fit_to_neighbors().
inline Local_surface fit_local_surface(const Surface_fit& fit, const Point& x, const Vector& normal,
                                       const Local_surface& last, int rounds,
                                       Neighborhood& neighborhood)
{
  const std::size_t largest = (std::min)(largest_neighborhood, fit.number_of_points);
  Vector guess = normal;
  bool is_curve = last.is_curve;
  for (std::size_t smallest = smallest_neighborhood;;)
  {
    Local_surface surface =
        fit_to_neighbors(fit, x, guess, smallest, last.neighbors, rounds, neighborhood);
    surface.is_curve = is_curve;
    if (!fit.settings.widen_between_lines || is_curve)
      return surface;
    const bool turns = is_on_line(fit, surface);
    if (!turns && (neighborhood.size() >= largest || !is_between_lines(fit, neighborhood, surface)))
      return surface;
    is_curve = neighborhood.size() >= largest;
    if (is_curve)
    {
      smallest = smallest_neighborhood;
      guess = normal;
    }
    else
    {
      smallest = (std::min)(2 * neighborhood.size() - 1, largest); // the center may be one of them
      if (turns) // and the guess may have turned with another fit
        guess = NULL_VECTOR;
    }
  }
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FIT_LOCAL_SURFACE_H
