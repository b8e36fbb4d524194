// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_LEVELS_OF_CAMERAS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_LEVELS_OF_CAMERAS_H

#include <CGAL/Curvature_aware_simplification_3/internal/depth/Depth_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/depth/Depth_view.h>
#include <CGAL/Curvature_aware_simplification_3/internal/depth/Facet.h>
#include <CGAL/Curvature_aware_simplification_3/internal/depth/directions_of_cameras.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/principal_axes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Searchable_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/index_selection.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Several cameras have each rounded depth along an axis of their own, and each point is on a level
// of the camera that saw it. The levels of one do not show in the heights of all points, since
// those of the others are at any height: but in those of facets that face the camera.

// Of each point, the direction that the facet around it faces, if it is flat; of several directions
// within the tolerance, the one of most facets. O(log n) for each
template <typename ConcurrencyTag>
Views_of_points directions_of_facets(const Searchable_points& cloud,
                                     const std::vector<Vector>& directions, double tolerance)
{
  CGAL_assertion(directions.size() <= in_no_view);
  Views_of_points result(cloud.size(), in_no_view);
  for_each_index<ConcurrencyTag>(0, cloud.size(), [&](std::size_t i) {
    const Facet facet = facet_around(*cloud.search, cloud.points[i]);
    if (!is_flat(facet, tolerance))
      return;
    const auto faced =
        std::find_if(directions.begin(), directions.end(), [&](const Vector& direction) {
          return has_normal(facet, direction, tolerance);
        });
    if (faced != directions.end())
      result[i] = static_cast<std::uint8_t>(faced - directions.begin());
  });
  return result;
}

// The levels along some directions, of the points whose facets face these
template <typename ConcurrencyTag>
std::vector<Depth_levels> levels_of_facets(const Searchable_points& cloud,
                                           const std::vector<Vector>& directions, double tolerance)
{
  std::vector<Depth_levels> result;
  const Views_of_points faced = directions_of_facets<ConcurrencyTag>(cloud, directions, tolerance);
  for (std::size_t d = 0; d < directions.size(); ++d)
  {
    const Depth_levels levels = levels_along<ConcurrencyTag>(
        directions[d], tolerance,
        elements_at<ConcurrencyTag>(indices_of<ConcurrencyTag>(d, faced), cloud.points));
    if (levels.heights.size() >= fewest_levels_of_view)
      result.push_back(levels);
  }
  return result;
}

// The view of each point: that which has a level nearest to it. It is exactly on one of its own,
// and within the tolerance of one of another camera by chance.
template <typename ConcurrencyTag>
Views_of_points views_of_points(const std::vector<Point>& points,
                                const std::vector<Depth_levels>& levels)
{
  Views_of_points result(points.size(), in_no_view);
  for_each_index<ConcurrencyTag>(0, points.size(), [&](std::size_t i) {
    double least = (std::numeric_limits<double>::infinity)();
    for (std::size_t view = 0; view < levels.size(); ++view)
    {
      const double height = levels[view].height(points[i]);
      const std::size_t level = levels[view].level_of(height);
      if (level == levels[view].heights.size())
        continue;
      const double distance = std::abs(height - levels[view].heights[level]);
      if (distance < least)
      {
        least = distance;
        result[i] = static_cast<std::uint8_t>(view);
      }
    }
  });
  return result;
}

// Adds a level to those of its camera, or the first one of another camera
inline void add_camera(std::vector<Depth_levels>& cameras, const Depth_levels& more)
{
  constexpr double parallel = 0.01; // the sine, about what facets tell of a direction
  const auto same = std::find_if(cameras.begin(), cameras.end(), [&](const Depth_levels& levels) {
    return sine_of_angle(levels.direction, more.direction) <= parallel;
  });
  if (same == cameras.end())
  {
    cameras.push_back(more);
    return;
  }
  for (const double height : more.heights)
    same->heights.push_back(more.direction * same->direction > 0. ? height : -height);
  std::sort(same->heights.begin(), same->heights.end());
  same->number_of_points += more.number_of_points;
  same->gap_above = gaps_without_jumps(same->heights);
}

// The levels of all cameras: first of those of which parts are seen by few others. Without the
// points on these levels, others show.
template <typename ConcurrencyTag>
std::vector<Depth_levels> levels_of_cameras(const Searchable_points& cloud,
                                            const std::vector<Facet>& facets, double tolerance)
{
  constexpr std::size_t most = 64; // more than there will be; indices of views are bytes
  const std::vector<Vector> directions = directions_of_cameras(facets, tolerance, *cloud.search);
  if (directions.size() < 2) // one is found by the heights of all points
    return {};
  std::vector<Depth_levels> result = levels_of_facets<ConcurrencyTag>(cloud, directions, tolerance);
  for (std::size_t left = cloud.size(); !result.empty() && result.size() < most;)
  {
    Searchable_points rest;
    rest.points = elements_at<ConcurrencyTag>(
        indices_of<ConcurrencyTag>(in_no_view,
                                   views_of_points<ConcurrencyTag>(cloud.points, result)),
        cloud.points);
    if (are_most(cloud.size() - rest.size(), cloud.size()) || rest.size() >= left)
      break;
    left = rest.size();
    rest.rebuild_search<ConcurrencyTag>();
    const std::vector<Vector> more =
        directions_of_cameras(some_facets<ConcurrencyTag>(rest), tolerance, *rest.search);
    for (const Depth_levels& levels : levels_of_facets<ConcurrencyTag>(rest, more, tolerance))
      if (result.size() < most)
        add_camera(result, levels);
  }
  return result;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_LEVELS_OF_CAMERAS_H
