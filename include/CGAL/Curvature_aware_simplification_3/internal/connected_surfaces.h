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
// dense. A quarter lets all of a tube that becomes sparse follow, where half leaves up to 4 % of its points.
inline double needed_share_of_neighbors(bool are_outliers_likely)
{
  return are_outliers_likely ? 1. / 2. : 1. / 4.;
}

// Those that may be connected to a surface by others: all, or if outliers are likely, those that do not look like space.
// Otherwise, outliers of which some are too dense to be marked would connect others.
template <typename ConcurrencyTag>
std::vector<std::size_t> possibly_connected(const Cloud& cloud, const Neighbor_search& search,
                                            std::size_t k, bool are_outliers_likely,
                                            const std::vector<std::size_t>& far_ones)
{
  return elements_at<ConcurrencyTag>(indices_where<ConcurrencyTag>(far_ones.size(),
                                                                   [&](std::size_t f)
                                                                   {
    return !are_outliers_likely || curvature_of_twice_the_radius(cloud, search, k, far_ones[f]) <=
                                       largest_curvature_of_parts;
                                     }),
                                     far_ones);
}

// Unmarks those of the far ones of whose k nearest such a share at least is not marked and has them among its own, those
// next to these, and so on. An outlier over a surface is no neighbor of its points, and those farther off have no
// others than outliers. O(k + log n) for each far one, and for each one unmarked.
template <typename ConcurrencyTag>
void unmark_connected(const Cloud& cloud, const Neighbor_search& search, const Features& features,
                      std::size_t k, double needed_share, const std::vector<std::size_t>& far_ones,
                      std::vector<std::uint8_t>& is_outlier)
{
  const double needed = needed_share * static_cast<double>(k);
  std::vector<std::atomic<std::uint32_t>> neighbors(cloud.size()); // that are not marked
  for_each_index<ConcurrencyTag>(0, far_ones.size(),
                                 [&](std::size_t f)
                                 {
    for_each_mutual_neighbor(
        cloud, search, features, k, far_ones[f], [&](std::size_t j) { return is_outlier[j] == 0; },
        [&](std::size_t) { neighbors[far_ones[f]].fetch_add(1, std::memory_order_relaxed); });
  });
  for (;;)
  {
    const std::vector<std::size_t> connected =
        elements_at<ConcurrencyTag>(indices_where<ConcurrencyTag>(far_ones.size(),
                                                                  [&](std::size_t f)
                                                                  {
      const std::size_t i = far_ones[f];
      return is_outlier[i] != 0 && neighbors[i].load(std::memory_order_relaxed) >= needed;
                                    }),
                                    far_ones);
    if (connected.empty())
      return;
    for_each_index<ConcurrencyTag>(0, connected.size(),
                                   [&](std::size_t c) { is_outlier[connected[c]] = 0; });
    for_each_index<ConcurrencyTag>(0, connected.size(),
                                   [&](std::size_t c)
                                   {
      for_each_mutual_neighbor(
          cloud, search, features, k, connected[c],
          [&](std::size_t j) { return is_outlier[j] != 0; },
          [&](std::size_t j) { neighbors[j].fetch_add(1, std::memory_order_relaxed); });
    });
  }
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_CONNECTED_SURFACES_H
