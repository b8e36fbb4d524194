// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_ARE_STEPS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_ARE_STEPS_H

#include <CGAL/Curvature_aware_simplification_3/internal/depth/Depth_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/depth/Facet.h>
#include <CGAL/Curvature_aware_simplification_3/internal/depth/is_between_sheets.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Neighborhood.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/principal_axes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Flags.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Whether the surface is oblique to the levels around a facet, so that these are steps of it and no
// faces
inline bool is_on_steps(const Facet& facet, const Depth_levels& levels,
                        const Neighbor_search& search)
{
  // The layers of a lattice of points are 1.13 spacings apart, as its 8 nearest points tell these,
  // and are no steps. Steps that are smaller still need not be undone: they are measured and
  // smoothed as noise. Of larger ones, too few levels are left to tell the surface between them.
  constexpr double smallest = 1.2, largest = 10.; // in spacings of the points
  constexpr double radius = 3.;                   // in steps: a ball of that radius holds several
  // The cosine of 80 degrees: no walls, whose points may be in rows. Nor are they faces, of which a
  // ball holds one step.
  constexpr double wall = 0.17;

  const std::size_t level = levels.level_of(levels.height(facet.point));
  if (level == levels.heights.size())
    return false;
  const double step = levels.step_at(levels.heights[level]);
  // squared distances may underflow, and a step be one of two jumps
  if (!(facet.spacing > 0. && step > 0.) || step < smallest * facet.spacing ||
      step > largest * facet.spacing)
    return false;
  // as many as in the ball, if the points are there as dense as here
  const double relative_radius = radius * step / facet.spacing;
  const double in_ball = CGAL_PI * relative_radius * relative_radius;
  Neighborhood neighborhood;
  neighborhood.collect(search, facet.point, static_cast<std::size_t>(in_ball));
  const double cosine = std::abs(plane_normal(neighborhood) * levels.direction);
  return wall < cosine && cosine < cosine_of_faces;
}

// Whether the levels are steps of the surface: a quarter of the facets at least are on steps.
// Others are on walls and faces, and where steps are too small or too large.
template <typename ConcurrencyTag>
bool are_steps(const Depth_levels& levels, const std::vector<Facet>& facets,
               const Neighbor_search& search)
{
  // Sheets that a ball holds several of, as fins or stacked disks, look oblique as well. Of the
  // facets on steps of 73 scans with rounded depth, also with noise, at most 8 % were between
  // sheets, of those on clean sheets 42 to 76 %.
  constexpr double most_between_sheets = 0.2;
  Flags on_steps(facets.size()), between_sheets(facets.size());
  for_each_index<ConcurrencyTag>(0, facets.size(), [&](std::size_t i) {
    on_steps[i] = is_on_steps(facets[i], levels, search) ? 1 : 0;
    between_sheets[i] =
        on_steps[i] != 0 && is_between_sheets(facets[i].point, facets[i].spacing, levels, search)
            ? 1
            : 0;
  });
  const auto number = [](const Flags& are) {
    return static_cast<double>(std::count(are.begin(), are.end(), 1));
  };
  return 4. * number(on_steps) >= static_cast<double>(facets.size()) &&
         number(between_sheets) <= most_between_sheets * number(on_steps);
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_ARE_STEPS_H
