// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_STAY_NEAR_POINTS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_STAY_NEAR_POINTS_H

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Surface_fit.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/Surface_sample.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Whether a fit took more points than the smallest ones do, and not because of noise, until it was
// much wider than samples are apart: as between the rings of a rotating scanner, beside wires and
// around far points. Then, its ball may hold several parts, and its surface be in the air between
// them, where hardly any points are expected and no gap is seen.
inline bool is_wider_than_samples_show(const Surface_sample& x)
{
  // In spacings. With 2, errors are 1 to 3 % larger on scan lines and where density is uneven; with
  // visible noise, up to 2 %.
  constexpr double widest = 3.;
  return !x.surface.is_curve && !x.noise->is_visible &&
         x.surface.neighbors >= 2 * smallest_neighborhood - 1 &&
         x.surface.radius > widest * x.spacing;
}

// Of samples on such fits, those that are not near a point of the input go to the nearest one.
template <typename ConcurrencyTag>
void stay_near_points(std::vector<Surface_sample>& samples, const Neighbor_search& input)
{
  constexpr double near_in_spacings = 0.35;
  for_each_index<ConcurrencyTag>(0, samples.size(), [&](std::size_t i) {
    Surface_sample& x = samples[i];
    if (!is_wider_than_samples_show(x))
      return;
    const Point nearest = input.nearest(x.point);
    const double limit = near_in_spacings * x.spacing;
    if (squared_distance(nearest, x.point) > limit * limit)
      x.point = nearest;
  });
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_STAY_NEAR_POINTS_H
