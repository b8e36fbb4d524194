// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_FLAGS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_FLAGS_H

#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// One for each point, 0 or 1. Not `bool`, whose vector packs neighbors into one word: different
// threads write them.
using Flags = std::vector<std::uint8_t>;

// Of points, which differ
template <typename ConcurrencyTag>
void set_flags(Flags& flags, const std::vector<std::size_t>& points, std::uint8_t value)
{
  for_each_index<ConcurrencyTag>(0, points.size(),
                                 [&](std::size_t i) { flags[points[i]] = value; });
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_FLAGS_H
