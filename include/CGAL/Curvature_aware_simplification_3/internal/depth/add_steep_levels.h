// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_ADD_STEEP_LEVELS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_ADD_STEEP_LEVELS_H

#include <CGAL/Curvature_aware_simplification_3/internal/depth/Depth_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/depth/Depth_view.h>
#include <CGAL/Curvature_aware_simplification_3/internal/depth/levels_of_cameras.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Computation_kernel.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/index_selection.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Whether a height is on no level, but next to one by clearly less than a step, or than half of one
// where every other level is known
inline bool is_between_steps(const Depth_levels& levels, double height)
{
  const auto above = std::lower_bound(levels.heights.begin(), levels.heights.end(), height);
  constexpr double too_near = 0.4; // of a step
  const auto is_near = [&](double level) {
    const double distance = std::abs(height - level);
    return distance > levels.tolerance && distance < too_near * levels.step_at(level);
  };
  return (above != levels.heights.end() && is_near(*above)) ||
         (above != levels.heights.begin() && is_near(*std::prev(above)));
}

// Levels that no facet has shown, as where a surface is steep, are added: each camera has those of
// its points together with the points that are on no level, and not between its steps.
template <typename ConcurrencyTag>
void add_steep_levels(std::vector<Depth_levels>& levels, const std::vector<Point>& points,
                      double least_tolerance)
{
  // The others are at any height. One of twenty has another so near to it by chance, and eight in a
  // row hardly ever are. But where pixels are in rows, so are these.
  constexpr double by_chance = 0.05;
  const Views_of_points view_of_point = views_of_points<ConcurrencyTag>(points, levels);
  const std::size_t others = number_where<ConcurrencyTag>(
      points.size(), [&](std::size_t i) { return view_of_point[i] == in_no_view; });
  for (std::size_t view = 0; view < levels.size() && others > 0; ++view)
  {
    const Depth_levels known = levels[view];
    const std::vector<std::size_t> indices =
        indices_where<ConcurrencyTag>(points.size(), [&](std::size_t i) {
          return view_of_point[i] == view || (view_of_point[i] == in_no_view &&
                                              !is_between_steps(known, known.height(points[i])));
        });
    const double range = known.heights.back() - known.heights.front();
    const double chance = by_chance * range / static_cast<double>(others);
    levels[view] = levels_along<ConcurrencyTag>(
        known.direction, (std::clamp)(chance, least_tolerance, known.tolerance),
        elements_at<ConcurrencyTag>(indices, points));
    levels[view].tolerance = known.tolerance;
  }
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_ADD_STEEP_LEVELS_H
