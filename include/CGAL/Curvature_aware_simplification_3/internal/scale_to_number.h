// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SCALE_TO_NUMBER_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SCALE_TO_NUMBER_H

#include <CGAL/Curvature_aware_simplification_3/internal/Curve_ranges.h>
#include <CGAL/Curvature_aware_simplification_3/internal/loops.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Scales a density so that its integral over the surface is `number`, but limits it: not more than
// one sample for two input points, since a denser result could show no more than they do, unless a
// uniform density asks for more: then up to `densest_in_sparse_regions` for each point. If all
// together are asked for more than that, all get more.
template <typename ConcurrencyTag>
void scale_to_number(std::vector<double>& density, double number, const Curve_ranges& ranges,
                     const std::vector<double>& range_area, double total_area,
                     double densest_in_sparse_regions)
{
  constexpr double densest = 0.5;

  const auto factor = [&]
  {
    return number / reduce_indices<ConcurrencyTag>(
                        ranges.number, 0.,
                        [&](std::size_t i) { return density[i] * range_area[i]; },
                        std::plus<double>());
  };
  // What the limit takes away goes to all others; a second and third round settle it.
  for (int round = 0; round < 3; ++round)
  {
    const double scale = factor();
    for_each_index<ConcurrencyTag>(0, ranges.number,
                                   [&](std::size_t i)
                                   {
      const double point_density = static_cast<double>(ranges.size(i)) / range_area[i];
      const double limit = std::clamp(number / total_area, densest * point_density,
                                      densest_in_sparse_regions * point_density);
      density[i] = (std::min)(scale * density[i], limit);
    });
  }
  const double scale = factor();
  for_each_index<ConcurrencyTag>(0, ranges.number, [&](std::size_t i) { density[i] *= scale; });
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SCALE_TO_NUMBER_H
