// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DENSITY_SCALE_WITH_LIMITS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DENSITY_SCALE_WITH_LIMITS_H

#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <cstddef>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The scale t of values v_i, each of which may be L_i at most, with a given sum:
//   sum_i min(t v_i, L_i) = total.
// The sum is concave in t, so that the steps of Newton's method from t = 0 never pass the solution;
// they have arrived when a step leaves no more values at their limits. Infinite if the limits
// together are no more than the total.
template <typename ConcurrencyTag, typename Value, typename Limit>
double scale_with_limits(std::size_t size, double total, const Value& value, const Limit& limit)
{
  struct Sums
  {
    double limited, others; // the others at t = 1
  };
  const auto sum = [](const Sums& a, const Sums& b) {
    return Sums{a.limited + b.limited, a.others + b.others};
  };
  for (double scale = 0.;;)
  {
    const Sums sums = reduce_indices<ConcurrencyTag>(
        size, Sums{0., 0.},
        [&](std::size_t i) {
          return scale * value(i) < limit(i) ? Sums{0., value(i)} : Sums{limit(i), 0.};
        },
        sum);
    const double next = (total - sums.limited) / sums.others; // infinite if all are limited
    if (!(next > scale))
      return scale;
    scale = next;
  }
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DENSITY_SCALE_WITH_LIMITS_H
