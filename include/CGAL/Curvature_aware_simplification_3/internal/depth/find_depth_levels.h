// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_FIND_DEPTH_LEVELS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_FIND_DEPTH_LEVELS_H

#include <CGAL/Curvature_aware_simplification_3/internal/depth/Depth_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/depth/Facet.h>
#include <CGAL/Curvature_aware_simplification_3/internal/depth/are_steps.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Searchable_points.h>

#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The levels that the depth of all points was rounded to, or none. With that, small neighborhoods
// are exactly flat and face the sensor, while the surface, as larger ones show it, does not.
template <typename ConcurrencyTag>
Depth_levels find_depth_levels(const Searchable_points& cloud, const std::vector<Facet>& facets,
                               double tolerance)
{
  // Where steps are as large as the spacing, few are wider than a facet.
  const std::vector<Vector> normals = common_normals(facets, tolerance, facets.size() / 16 + 1);
  if (normals.empty())
    return Depth_levels();
  const Depth_levels levels =
      levels_along<ConcurrencyTag>(normals.front(), tolerance, cloud.points);
  return are_many(levels) && are_most(levels.number_of_points, cloud.size()) &&
                 are_steps<ConcurrencyTag>(levels, facets, *cloud.search)
             ? levels
             : Depth_levels();
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_FIND_DEPTH_LEVELS_H
