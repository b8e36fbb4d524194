// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DENSITY_SCALE_TO_NUMBER_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DENSITY_SCALE_TO_NUMBER_H

#include <CGAL/Curvature_aware_simplification_3/internal/density/scale_with_limits.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Curve_ranges.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Scales a density so that its integral over the surface is `number`, but to no more than `densest`
// samples for each input point: a denser result could show no more than the points do. If all
// together are asked for more than that, all get more.
//
// What the limit takes away goes to all others: see scale_with_limits().
template <typename ConcurrencyTag>
void scale_to_number(std::vector<double>& density, double number, const Curve_ranges& ranges,
                     const std::vector<double>& range_area, double densest)
{
  const auto limit = [&](std::size_t i) { return densest * static_cast<double>(ranges.size(i)); };
  const double scale = scale_with_limits<ConcurrencyTag>(
      ranges.number, number, [&](std::size_t i) { return density[i] * range_area[i]; }, limit);
  for_each_index<ConcurrencyTag>(0, ranges.number, [&](std::size_t i) {
    // an area may vanish where squares of coordinates underflow, and nothing limits its density
    if (range_area[i] > 0. || std::isfinite(scale))
      density[i] = (std::min)(limit(i) / range_area[i], scale * density[i]);
  });

  const double all = reduce_indices<ConcurrencyTag>(
      ranges.number, 0., [&](std::size_t i) { return density[i] * range_area[i]; },
      std::plus<double>());
  for_each_index<ConcurrencyTag>(0, ranges.number,
                                 [&](std::size_t i) { density[i] *= number / all; });
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DENSITY_SCALE_TO_NUMBER_H
