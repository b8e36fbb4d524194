// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_UNDO_ROUNDING_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_UNDO_ROUNDING_H

#include <CGAL/Curvature_aware_simplification_3/internal/depth/Depth_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/depth/find_depth_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/depth/find_depth_views.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Searchable_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Adaptive_settings.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// How far from p, in the plane of the levels, the surface leaves for the next level, which is `gap`
// above (or below, if it is negative). Of the points nearest to p + 1.5 gap d, p itself is 1.5
// |gap| away, and one of the next level is nearer if its distance in the plane is less than sqrt(2)
// |gap|. If there is none, or no next level, the distance is `unseen`.
inline double distance_to_next_level(const Point& p, double gap, double unseen,
                                     const Depth_levels& levels, const Neighbor_search& search)
{
  if (gap == 0.)
    return unseen;
  double distance = unseen;
  search.for_each_nearest(
      p + (1.5 * gap) * levels.direction, 1, [&](std::size_t, const Point& q, double) {
        const Vector v = q - p;
        const double height = v * levels.direction;
        if (std::abs(height) > levels.tolerance && (height > 0.) == (gap > 0.))
          distance =
              (std::min)(unseen, std::sqrt((std::max)(v.squared_length() - height * height, 0.)));
      });
  return distance;
}

// How much the depth of p was rounded down, as where the surface is a plane: between its borders
// with the levels below and above, depth grows by one gap, and is halfway between the levels at
// both. A border that is not seen is taken to be as far as the larger step lets see: where neither
// is, nothing is known, and it is 0.
inline double rounded_away(const Point& p, const Depth_levels& levels,
                           const Neighbor_search& search)
{
  const std::size_t level = levels.level_of(levels.height(p));
  if (level == levels.heights.size())
    return 0.; // an outlier
  const double below = levels.gap_below(level), above = levels.gap_above[level];
  if (!(below > 0. || above > 0.))
    return 0.;
  const double unseen = std::sqrt(2.) * (std::max)(below, above);
  const double to_below = distance_to_next_level(p, -below, unseen, levels, search);
  const double to_above = distance_to_next_level(p, above, unseen, levels, search);
  // Steps that are less than half as wide as high are taken for wider: their borders may overlap.
  const double width = (std::max)(to_below + to_above, (std::max)(below, above) / 2.);
  // Points of two levels at the same place in their plane do not meet halfway.
  constexpr double most = 0.49;
  const double part = (std::clamp)((to_below - to_above) / (2. * width), -most, most);
  return part * (part > 0. ? above : below);
}

// Moves points whose depth was rounded to steps to where they were before, as far as the borders of
// the steps tell. The search has copies of the points, which stay where they are.
template <typename ConcurrencyTag>
void move_between_levels(Searchable_points& seen, const Depth_levels& levels)
{
  for_each_index<ConcurrencyTag>(0, seen.size(), [&](std::size_t i) {
    Point& p = seen.points[i];
    p = p + rounded_away(p, levels, *seen.search) * levels.direction;
  });
}

// Undoes the rounding of depth, by several cameras or by one, if there was any. Without that, steps
// look like flat faces with sharp edges. Returns the levels of each camera. O(n log n)
template <typename ConcurrencyTag>
std::vector<Depth_levels> undo_rounding(Searchable_points& cloud, const Adaptive_settings& settings)
{
  const std::vector<Facet> facets = some_facets<ConcurrencyTag>(cloud);
  const double tolerance = thickness_of_flat_facets(facets, cloud.coordinate_error);
  std::vector<Depth_levels> result;
  std::vector<Depth_view> views;
  if (settings.tell_cameras)
    views = find_depth_views<ConcurrencyTag>(cloud, facets, tolerance);
  for (Depth_view& view : views)
  {
    move_between_levels<ConcurrencyTag>(view, view.levels);
    for_each_index<ConcurrencyTag>(0, view.points.size(), [&](std::size_t i) {
      cloud.points[view.indices[i]] = view.points[i];
    });
    result.push_back(view.levels);
  }
  if (result.empty())
  {
    const Depth_levels levels = find_depth_levels<ConcurrencyTag>(cloud, facets, tolerance);
    if (levels.heights.empty())
      return result;
    move_between_levels<ConcurrencyTag>(cloud, levels);
    result.push_back(levels);
  }
  cloud.rebuild_search<ConcurrencyTag>();
  return result;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_UNDO_ROUNDING_H
