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
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Flags.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/index_selection.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Several cameras have each rounded depth along an axis of their own, and each point is on a level
// of the camera that saw it. The levels of one do not show in the heights of all points, since
// those of the others are at any height: but in those of facets that face the camera.

// Of each point, the direction that the facet around it faces, if it is flat. O(log n) for each
template <typename ConcurrencyTag>
Flags directions_of_facets(const Searchable_points& cloud, const std::vector<Vector>& directions,
                           double tolerance)
{
  Flags result(cloud.size(), in_no_view);
  for_each_index<ConcurrencyTag>(0, cloud.size(), [&](std::size_t i) {
    const Facet facet = facet_around(*cloud.search, cloud.points[i]);
    for (std::size_t d = 0; d < directions.size() && is_flat(facet, tolerance); ++d)
      if (has_normal(facet, directions[d], tolerance))
        result[i] = static_cast<std::uint8_t>(d);
  });
  return result;
}

// The levels along some directions, of the points whose facets face these
template <typename ConcurrencyTag>
std::vector<Depth_levels> levels_of_facets(const Searchable_points& cloud,
                                           const std::vector<Vector>& directions, double tolerance)
{
  std::vector<Depth_levels> result;
  const Flags faced = directions_of_facets<ConcurrencyTag>(cloud, directions, tolerance);
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
Flags views_of_points(const std::vector<Point>& points, const std::vector<Depth_levels>& levels)
{
  Flags result(points.size(), in_no_view);
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
  constexpr std::size_t most = 64; // more than there will be, and indices of views are bytes
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
      add_camera(result, levels);
  }
  return result;
}

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
  const Flags view_of_point = views_of_points<ConcurrencyTag>(points, levels);
  const std::size_t others = indices_of<ConcurrencyTag>(in_no_view, view_of_point).size();
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

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_LEVELS_OF_CAMERAS_H
