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

// Where a scanner has met little, as on wires and branches and between far rings, a fit holds
// several parts and its surface is in the air between them. What tells so, where no noise is
// visible:

// A fit took more points than the smallest ones do, and not because of noise, until it was much
// wider than samples are apart. Then hardly any points are expected around, and no gap is seen.
inline bool is_wider_than_samples_show(const Surface_sample& x)
{
  // In spacings. With 2, errors are 1 to 3 % larger on scan lines and where density is uneven; with
  // visible noise, up to 2 %.
  constexpr double widest = 3.;
  return x.surface.neighbors >= 2 * smallest_neighborhood - 1 &&
         x.surface.radius > widest * x.spacing;
}

// A sample is farther from the nearest point of the input than that is from its neighbors: among
// random points on a surface, one place in 4,000 is twice as far as the fourth of them.
inline bool is_beyond_neighbors(const Point& nearest, double squared_distance,
                                const Neighbor_search& input)
{
  constexpr double ratio = 2.;
  constexpr std::size_t with_four_neighbors = 5;
  return squared_distance >
         ratio * ratio * input.squared_distance_of_nearest(nearest, with_four_neighbors);
}

// Moves samples whose surfaces are not known to the nearest points of the input. `known` has a
// point of the input for each, which may be the nearest.
template <typename ConcurrencyTag>
void stay_near_points(std::vector<Surface_sample>& samples, const std::vector<Point>& known,
                      const Neighbor_search& input)
{
  constexpr double far_off = 0.35; // in spacings
  for_each_index<ConcurrencyTag>(0, samples.size(), [&](std::size_t i) {
    Surface_sample& x = samples[i];
    const double limit = far_off * far_off * x.spacing * x.spacing;
    if (x.noise->is_visible || x.surface.is_curve || squared_distance(known[i], x.point) <= limit)
      return;
    const Point nearest = input.nearest(x.point);
    const double distance = squared_distance(nearest, x.point);
    if (distance > limit &&
        (is_wider_than_samples_show(x) || is_beyond_neighbors(nearest, distance, input)))
      x.point = nearest;
  });
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_STAY_NEAR_POINTS_H
