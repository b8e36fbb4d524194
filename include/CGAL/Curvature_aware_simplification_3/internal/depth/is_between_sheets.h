// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_IS_BETWEEN_SHEETS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_IS_BETWEEN_SHEETS_H

#include <CGAL/Curvature_aware_simplification_3/internal/depth/Depth_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Computation_kernel.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Whether points of one level are all around a place on it
inline bool is_amid_level(const Point& place, double spacing, double tolerance,
                          const Vector& direction, const Neighbor_search& search)
{
  // Two rings, most of them on the level, and about as dense as `spacing` says. The mean of half a
  // disk is 0.42 radii off its center, that of so many points in a whole one 0.14.
  constexpr std::size_t k = 19, fewest = 15;
  constexpr double largest_radius = 1.3, largest_offset = 0.35;

  double squared_radius = 0.;
  Vector sum = NULL_VECTOR;
  std::size_t number = 0;
  search.for_each_nearest(place, k, [&](std::size_t, const Point& p, double) {
    const Vector d = p - place;
    const double height = d * direction;
    if (std::abs(height) > tolerance)
      return;
    const Vector along = d - height * direction;
    squared_radius = (std::max)(squared_radius, along.squared_length());
    sum = sum + along;
    ++number;
  });
  const double usual = spacing * std::sqrt(static_cast<double>(k) / CGAL_PI);
  const double limit = largest_offset * static_cast<double>(number);
  return number >= fewest && squared_radius < largest_radius * largest_radius * usual * usual &&
         sum.squared_length() < limit * limit * squared_radius;
}

// Whether the levels next to that of p are over it and under it, as clean parallel sheets are.
// Depth has one value at each place, so that the level of a step has others beside it. `spacing` is
// that of the points around p.
inline bool is_between_sheets(const Point& p, double spacing, const Depth_levels& levels,
                              const Neighbor_search& search)
{
  const auto is_covered = [&](double gap) {
    // the place and the points are both within the tolerance
    return gap == 0. || is_amid_level(p + gap * levels.direction, spacing, 2. * levels.tolerance,
                                      levels.direction, search);
  };
  const std::size_t level = levels.level_of(levels.height(p));
  return is_covered(levels.gap_above[level]) && is_covered(-levels.gap_below(level));
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_IS_BETWEEN_SHEETS_H
