// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SELECT_ALONG_CURVE_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SELECT_ALONG_CURVE_H

#include <CGAL/Curvature_aware_simplification_3/internal/counter_based_random.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Exactly `number` of the points, in their order, with probabilities proportional to `weight`:
// systematic sampling along the Hilbert curve. The curve is cut into pieces of equal weight, and
// one point is taken of each. Independent draws (paper, sec. 4.1) have the same probabilities, but
// leave clusters and gaps, and must be trimmed to the count; here every compact piece of the surface
// gets its share up to one sample.
inline std::vector<std::size_t> select_along_curve(const std::vector<double>& weight,
                                                   std::size_t number, std::uint64_t seed)
{
  double total = 0.;
  for (double w : weight)
    total += w;
  const double piece = total / static_cast<double>(number);
  const double offset = Counter_based_random(seed, 0).uniform(0);

  std::vector<std::size_t> selected;
  selected.reserve(number);
  double sum = 0.;
  for (std::size_t i = 0; i < weight.size() && selected.size() < number; ++i)
  {
    sum += weight[i];
    const std::size_t still_missing = number - selected.size();
    const std::size_t still_there = weight.size() - i;
    // the second condition: heavy points, and rounding, may leave too few for the rest
    if (sum > (static_cast<double>(selected.size()) + offset) * piece ||
        still_there <= still_missing)
      selected.push_back(i);
  }
  return selected;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SELECT_ALONG_CURVE_H
