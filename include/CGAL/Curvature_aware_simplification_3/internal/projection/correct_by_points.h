// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_CORRECT_BY_POINTS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_CORRECT_BY_POINTS_H

#include <CGAL/Curvature_aware_simplification_3/internal/projection/fill_gaps.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/Sample_neighbors.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/Surface_sample.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/index_selection.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Whether the fit of a sample misses `nearest`, a point that is known to be on the surface but for
// noise: it mixes the sides of a part that is hardly thicker than the points are apart.
inline bool is_missed(const Surface_sample& x, const Point& nearest)
{
  // Of the radius of the fit, more than most points next to a fold of 90 degrees are off, 0.06.
  // With 0.05, samples on both sides of sharp edges move as well, and errors at 1 % of the points
  // are 2 % larger.
  constexpr double largest_error = 0.1;
  // Where samples are nearly as dense as the points, a fit is wider than they are apart, and they
  // show what it misses: there, of their spacing. With 0.1, they are 3 to 11 % farther off; with
  // 0.05, 99th percentiles are up to 3 % larger.
  constexpr double largest_error_in_spacings = 0.075;
  // Noise alone carries one point in 2000 that far. With 2.5, one in 80, single samples went to
  // them: errors with noise are 1 % larger. With 5, samples of sparse points are farther off.
  constexpr double largest_noise = 3.5;
  return std::abs(x.surface.residual(nearest - x.surface.origin)) >
         (std::max)(
             (std::min)(largest_error * x.surface.radius, largest_error_in_spacings * x.spacing),
             largest_noise * x.noise->level);
}

// The squared distance of a point to the nearest of these samples
inline double squared_distance_to_samples(const Point& p, const Neighbor_indices& neighbors,
                                          const std::vector<Surface_sample>& samples)
{
  double result = std::numeric_limits<double>::infinity();
  for (std::size_t j : neighbors)
    result = (std::min)(result, squared_distance(p, samples[j].point));
  return result;
}

// Moves samples whose fits miss the points that are nearest to them there, if no other sample is at
// such a point. Where several would move to it, the nearest of them does; the others fill gaps.
// There are hardly more points than samples where that happens, so that each that is used twice
// leaves one out.
template <typename ConcurrencyTag>
void correct_by_points(std::vector<Surface_sample>& samples, const std::vector<Point>& nearest,
                       const Sample_neighbors& neighbors, const Neighbor_search& input)
{
  constexpr double same_place = 0.1; // in spacings: two samples there show no more than one

  std::vector<std::size_t> missed = indices_where<ConcurrencyTag>(
      samples.size(), [&](std::size_t i) { return is_missed(samples[i], nearest[i]); });
  const auto distance_and_index = [&](std::size_t i) {
    return std::make_pair(squared_distance(samples[i].point, nearest[i]), i);
  };
  std::sort(missed.begin(), missed.end(), [&](std::size_t i, std::size_t j) {
    return distance_and_index(i) < distance_and_index(j);
  });
  std::set<Point> taken; // by samples that may be no neighbors
  std::vector<std::size_t> late;
  for (std::size_t i : missed)
  {
    const Point point = input.nearest(nearest[i]); // exactly, and not relative to the sample
    const double gap = same_place * samples[i].spacing;
    if (squared_distance_to_samples(point, neighbors.of(i), samples) > gap * gap &&
        taken.insert(point).second)
      samples[i].point = point;
    else
      late.push_back(i);
  }
  fill_gaps<ConcurrencyTag>(samples, late, input);
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_CORRECT_BY_POINTS_H
