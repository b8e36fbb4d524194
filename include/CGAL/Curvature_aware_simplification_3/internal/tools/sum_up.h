// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_SUM_UP_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_SUM_UP_H

#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Replaces each value, none of them negative, by the sum of all up to it, in two parallel rounds:
// blocks by themselves, and then with what comes before them. The sums do not fall:
// where one block ends, rounding may put its last sum above what the next one starts from.
template <typename ConcurrencyTag>
void sum_up(std::vector<double>& values)
{
  std::vector<double> before((values.size() + block_size - 1) / block_size + 1, 0.);
  for_each_index<ConcurrencyTag>(0, before.size() - 1, [&](std::size_t block) {
    const std::size_t end = (std::min)(values.size(), (block + 1) * block_size);
    for (std::size_t i = block * block_size; i < end; ++i)
      before[block + 1] += values[i];
  });
  for (std::size_t block = 1; block < before.size(); ++block)
    before[block] += before[block - 1];
  for_each_index<ConcurrencyTag>(0, before.size() - 1, [&](std::size_t block) {
    const std::size_t end = (std::min)(values.size(), (block + 1) * block_size);
    double sum = before[block];
    for (std::size_t i = block * block_size; i < end; ++i)
      values[i] = (std::min)(sum += values[i], before[block + 1]);
  });
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_SUM_UP_H
