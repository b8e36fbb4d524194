// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_CONNECTED_SURFACES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_CONNECTED_SURFACES_H

#include <CGAL/Curvature_aware_simplification_3/internal/Cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/loops.h>
#include <CGAL/Curvature_aware_simplification_3/internal/mutual_neighbors.h>
#include <CGAL/Curvature_aware_simplification_3/internal/prefix_sums.h>
#include <CGAL/Curvature_aware_simplification_3/internal/sparse_surfaces.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Of points that are taken for outliers because they are thick and sparse, thin parts that become sparse are connected to
// where they are denser: what has points of the surface for half of its neighbors, which have it for theirs, is part of
// it, though nothing around is flat.

// The share of the neighbors that such a point needs. A third would let one outlier follow the other where they are
// dense. A quarter lets all of a tube that becomes sparse follow, where half leaves up to 5 % of its points.
inline double needed_share_of_neighbors(bool are_outliers_likely)
{
  return are_outliers_likely ? 1. / 2. : 1. / 4.;
}

// Unmarks those of the far ones of whose k nearest such a share at least is not marked and has them among its own, those
// next to these, and so on. An outlier over a surface is no neighbor of its points, and those farther off have no
// others than outliers. But if outliers are likely, some may be too dense to be marked and connect others: those are left
// that look like space. O(k + log n) for each far one, and for each one unmarked.
template <typename ConcurrencyTag>
void unmark_connected(const Cloud& cloud, const Neighbor_search& search, const Features& features,
                      std::size_t k, bool are_outliers_likely,
                      const std::vector<std::size_t>& far_ones,
                      std::vector<std::uint8_t>& is_outlier)
{
  const double needed = needed_share_of_neighbors(are_outliers_likely) * static_cast<double>(k);

  std::vector<std::atomic<std::uint32_t>> neighbors(cloud.size()); // that are not marked
  std::vector<std::uint8_t> is_asked(far_ones.size());
  for_each_index<ConcurrencyTag>(0, far_ones.size(),
                                 [&](std::size_t f)
                                 {
    // those that are still marked, once they have enough neighbors
    is_asked[f] = is_outlier[far_ones[f]] == 0 ? 1 : 0;
    for_each_mutual_neighbor(
        cloud, search, features, k, far_ones[f], [&](std::size_t j) { return is_outlier[j] == 0; },
        [&](std::size_t) { neighbors[far_ones[f]].fetch_add(1, std::memory_order_relaxed); });
  });
  for (;;)
  {
    const std::vector<std::size_t> asked = indices_where<ConcurrencyTag>(far_ones.size(),
                                                                         [&](std::size_t f) {
      return is_asked[f] == 0 && neighbors[far_ones[f]].load(std::memory_order_relaxed) >= needed;
    });
    if (asked.empty())
      return;
    for_each_index<ConcurrencyTag>(0, asked.size(),
                                   [&](std::size_t a)
                                   {
      is_asked[asked[a]] = 1;
      const std::size_t i = far_ones[asked[a]];
      if (!are_outliers_likely ||
          curvature_of_twice_the_radius(cloud, search, k, i) <= largest_curvature_of_parts)
        is_outlier[i] = 0;
    });
    for_each_index<ConcurrencyTag>(0, asked.size(),
                                   [&](std::size_t a)
                                   {
      const std::size_t i = far_ones[asked[a]];
      if (is_outlier[i] == 0)
        for_each_mutual_neighbor(
            cloud, search, features, k, i, [&](std::size_t j) { return is_outlier[j] != 0; },
            [&](std::size_t j) { neighbors[j].fetch_add(1, std::memory_order_relaxed); });
    });
  }
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_CONNECTED_SURFACES_H
