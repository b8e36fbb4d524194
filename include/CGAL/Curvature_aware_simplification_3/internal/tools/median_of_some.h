// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_MEDIAN_OF_SOME_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_MEDIAN_OF_SOME_H

#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/median.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The median of value(i) for i in [0, size), or, where they are more than 1000, of that many of
// them, evenly spread: for where it need not be exact. Half of the values are below it then, and
// 1.6 % more or less (the standard deviation, 0.5 / sqrt(1000)).
template <typename ConcurrencyTag, typename Value>
double median_of_some(std::size_t size, const Value& value, std::size_t most = 1000)
{
  const std::size_t number = (std::min)(most, size);
  std::vector<double> values(number);
  for_each_index<ConcurrencyTag>(0, number, [&](std::size_t i) {
    values[i] = value(static_cast<std::size_t>(std::uint64_t(i) * size / number));
  });
  return median(values);
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_MEDIAN_OF_SOME_H
