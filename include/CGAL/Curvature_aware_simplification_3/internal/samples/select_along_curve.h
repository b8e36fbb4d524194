// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SAMPLES_SELECT_ALONG_CURVE_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SAMPLES_SELECT_ALONG_CURVE_H

#include <CGAL/Curvature_aware_simplification_3/internal/tools/Counter_based_random.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Curve_ranges.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/sum_up.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Exactly `number` of the points, in their order, with probabilities proportional to their weight,
// which is the `point_weight` of their range of the Hilbert curve: systematic sampling. The curve
// is cut into pieces of equal weight, and one point is taken of each. Independent draws (paper,
// sec. 4.1) have the same probabilities, but leave clusters and gaps, and must be trimmed to the
// count; here every compact piece of the surface gets its share up to one sample. No range is
// empty.
template <typename ConcurrencyTag>
std::vector<std::size_t> select_along_curve(const Curve_ranges& ranges,
                                            const std::vector<double>& point_weight,
                                            std::size_t number, std::uint64_t seed)
{
  CGAL_precondition(ranges.number <= ranges.number_of_points);
  std::vector<double> sum(ranges.number); // of the weights up to the end of the range
  for_each_index<ConcurrencyTag>(0, ranges.number, [&](std::size_t i) {
    sum[i] = point_weight[i] * static_cast<double>(ranges.size(i));
  });
  sum_up<ConcurrencyTag>(sum);
  const double piece = sum.back() / static_cast<double>(number);
  const double offset = Counter_based_random(seed, 0).uniform(0);

  std::vector<std::size_t> selected(number);
  for_each_index<ConcurrencyTag>(0, number, [&](std::size_t j) {
    const double wanted = (static_cast<double>(j) + offset) * piece;
    // rounding may ask for more than there is
    const std::size_t range = (std::min)(
        static_cast<std::size_t>(std::upper_bound(sum.begin(), sum.end(), wanted) - sum.begin()),
        ranges.number - 1);
    const double before = range == 0 ? 0. : sum[range - 1];
    const double last = static_cast<double>(ranges.size(range) - 1);
    // where nothing is wanted beyond `before`, the weight may be 0
    const double in_range =
        wanted > before ? (std::min)((wanted - before) / point_weight[range], last) : 0.;
    selected[j] = ranges.first_point(range) + static_cast<std::size_t>(in_range);
  });
  // a point heavier than a piece is taken once
  for (std::size_t j = 0; j < number; ++j)
  {
    if (j > 0)
      selected[j] = (std::max)(selected[j], selected[j - 1] + 1);
    selected[j] = (std::min)(selected[j], ranges.number_of_points - (number - j));
  }
  return selected;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SAMPLES_SELECT_ALONG_CURVE_H
