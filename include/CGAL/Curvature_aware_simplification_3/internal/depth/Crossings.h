// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_CROSSINGS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_CROSSINGS_H

#include <CGAL/Curvature_aware_simplification_3/internal/depth/Depth_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/depth/Depth_view.h>
#include <CGAL/Curvature_aware_simplification_3/internal/depth/Facet.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Clean stairs have levels of their treads and of their fronts, and other parts with many parallel
// faces have levels of these, as if several cameras had seen them. But there, faces end at those of
// the other direction, while levels of cameras end anywhere: where two see the same, the levels of
// one are on both sides of those of the other.

// How many facets there are, levels of others around them, and one of these on both sides
struct Crossings
{
  std::size_t facets = 0, possible = 0, found = 0;

  Crossings& operator+=(const Crossings& other)
  {
    facets += other.facets;
    possible += other.possible;
    found += other.found;
    return *this;
  }

  // Of the possible ones, 0.35 to 0.9 were found in scans of two to six cameras, none on stairs and
  // folded sheets, and up to 0.06 on pyramids of steps, whose treads go around the corners. Of
  // faces, six of ten or more have others around; if less than one of four has, cameras see different
  // parts.
  bool are_of_cameras() const { return 6 * found >= possible || 4 * possible < facets; }
};

// Of a facet of one view. Levels of others count with four points in a ball with the radius of a
// step, two of them on either side.
inline Crossings crossings_at(const Facet& facet, std::size_t view,
                              const std::vector<Depth_levels>& levels,
                              const Views_of_points& view_of_point, const Neighbor_search& search)
{
  constexpr double radius_in_steps = 1.;
  constexpr std::size_t enough_on_side = 2;
  struct Part
  {
    std::size_t view, level, above, below;
  };
  const Depth_levels& own = levels[view];
  const double step = own.step_at(own.height(facet.point));
  std::vector<Part> parts;
  search.for_each_within(
      facet.point, radius_in_steps * step, [&](std::size_t i, const Point& p, double) {
        const std::size_t other = view_of_point[i];
        if (other == view || other == in_no_view)
          return;
        const std::size_t level = levels[other].level_of(levels[other].height(p));
        auto part = std::find_if(parts.begin(), parts.end(), [&](const Part& q) {
          return q.view == other && q.level == level;
        });
        if (part == parts.end())
          part = parts.insert(parts.end(), Part{other, level, 0, 0});
        const double height = (p - facet.point) * own.direction;
        if (height > 2. * own.tolerance)
          ++part->above;
        if (height < -2. * own.tolerance)
          ++part->below;
      });
  const auto is_any = [&](const auto& test) {
    return std::any_of(parts.begin(), parts.end(), test) ? std::size_t(1) : std::size_t(0);
  };
  return {1, is_any([&](const Part& p) { return p.above + p.below >= 2 * enough_on_side; }),
          is_any([&](const Part& p) {
            return p.above >= enough_on_side && p.below >= enough_on_side;
          })};
}

// Of some facets of one view that are on its levels
template <typename ConcurrencyTag>
Crossings crossings_of(std::size_t view, const std::vector<Facet>& facets,
                       const std::vector<Depth_levels>& levels,
                       const Views_of_points& view_of_point, const Neighbor_search& search)
{
  std::vector<Crossings> at(facets.size());
  for_each_index<ConcurrencyTag>(0, facets.size(), [&](std::size_t i) {
    at[i] = crossings_at(facets[i], view, levels, view_of_point, search);
  });
  Crossings sum;
  for (const Crossings& crossings : at)
    sum += crossings;
  return sum;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_CROSSINGS_H
