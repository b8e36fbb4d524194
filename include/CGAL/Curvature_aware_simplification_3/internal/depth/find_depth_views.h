// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_FIND_DEPTH_VIEWS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_FIND_DEPTH_VIEWS_H

#include <CGAL/Curvature_aware_simplification_3/internal/depth/Crossings.h>
#include <CGAL/Curvature_aware_simplification_3/internal/depth/Depth_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/depth/Depth_view.h>
#include <CGAL/Curvature_aware_simplification_3/internal/depth/Facet.h>
#include <CGAL/Curvature_aware_simplification_3/internal/depth/add_steep_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/depth/are_steps.h>
#include <CGAL/Curvature_aware_simplification_3/internal/depth/levels_of_cameras.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Surface_fit.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Searchable_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/index_selection.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The views of several cameras that most of the points are in; none if their levels are not steps
// of a rounded depth
template <typename ConcurrencyTag>
std::vector<Depth_view> find_depth_views(const Searchable_points& cloud,
                                         const std::vector<Facet>& facets, double tolerance)
{
  std::vector<Depth_view> views;
  std::vector<Depth_levels> levels = levels_of_cameras<ConcurrencyTag>(cloud, facets, tolerance);
  if (levels.size() < 2)
    return views;
  add_steep_levels<ConcurrencyTag>(levels, cloud.points,
                                   tolerance_of_rounding(cloud.coordinate_error));
  const Views_of_points view_of_point = views_of_points<ConcurrencyTag>(cloud.points, levels);

  std::size_t in_views = 0;
  Crossings crossings;
  for (std::size_t view = 0; view < levels.size(); ++view)
  {
    Depth_view seen;
    seen.levels = levels[view];
    seen.indices = indices_of<ConcurrencyTag>(view, view_of_point);
    seen.points = elements_at<ConcurrencyTag>(seen.indices, cloud.points);
    if (seen.points.size() < fewest_points_to_fit)
      continue;
    seen.rebuild_search<ConcurrencyTag>();
    const std::vector<Facet> of_view = some_facets<ConcurrencyTag>(seen);
    if (!are_steps<ConcurrencyTag>(seen.levels, of_view, *seen.search))
      continue;
    crossings += crossings_of<ConcurrencyTag>(view, of_view, levels, view_of_point, *cloud.search);
    in_views += seen.points.size();
    views.push_back(std::move(seen));
  }
  if (views.size() < 2 || !are_most(in_views, cloud.size()) || !crossings.are_of_cameras())
    views.clear();
  return views;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_FIND_DEPTH_VIEWS_H
