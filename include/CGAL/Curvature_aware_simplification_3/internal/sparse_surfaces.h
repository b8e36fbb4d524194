// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SPARSE_SURFACES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SPARSE_SURFACES_H

#include <CGAL/Curvature_aware_simplification_3/internal/Cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/loops.h>
#include <CGAL/Curvature_aware_simplification_3/internal/mutual_neighbors.h>
#include <CGAL/Curvature_aware_simplification_3/internal/prefix_sums.h>
#include <CGAL/Curvature_aware_simplification_3/internal/shared_features.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Those of the k nearest points of some points that are marked, in increasing order
template <typename ConcurrencyTag>
std::vector<std::size_t> marked_neighbors(const Cloud& cloud, const Neighbor_search& search,
                                          std::size_t k, const std::vector<std::size_t>& points,
                                          const std::vector<std::uint8_t>& is_marked)
{
  std::vector<std::atomic<std::uint8_t>> is_met(cloud.size());
  for_each_index<ConcurrencyTag>(0, points.size(),
                                 [&](std::size_t i)
                                 {
    search.for_each_nearest(cloud.points[points[i]], k + 1,
                            [&](std::size_t j, const Point&, double)
                            { is_met[j].store(1, std::memory_order_relaxed); });
  });
  return indices_where<ConcurrencyTag>(cloud.size(),
                                       [&](std::size_t j) {
    return is_marked[j] != 0 && is_met[j].load(std::memory_order_relaxed) != 0;
  });
}

// Of the points that are taken for outliers because they are thick and sparse, unmarks those of sparse parts of a
// surface. Where a scanner is far away, all of a surface is sparse, and thick at edges and where parts are hardly
// thicker than the points are apart; but a third of the mutual neighbors of such a point are flat and among flat
// ones, or were unmarked before. Of points spread evenly in space, one in a hundred is flat.
//
// Each round reaches one neighborhood farther, and asks only those that the last one may have changed. O(k + log n)
// for each marked point, and for each neighbor of one that is unmarked.
template <typename ConcurrencyTag>
void unmark_sparse_surfaces(const Cloud& cloud, const Neighbor_search& search,
                            const Features& features, std::size_t k,
                            std::vector<std::uint8_t>& is_outlier)
{
  // The flat parts of a surface are not far. In space, a few of 100,000 outliers meet a third by chance: without
  // an end, most others could follow.
  constexpr int most_rounds = 8;
  const std::size_t third = (std::max)(k / 3, std::size_t(1));
  // Flat ones that lead to a surface have so many flat neighbors. With a half, more of the thin parts are lost; with
  // a third, up to 11 outliers pass in 5 of 120 scans that have some, with this in 3.
  const std::size_t flat_around_flat = (std::max)(3 * k / 8, std::size_t(1));

  std::vector<std::size_t> candidates = indices_where<ConcurrencyTag>(
      cloud.size(), [&](std::size_t i) { return is_outlier[i] != 0; });
  if (candidates.empty())
    return;
  std::vector<std::uint8_t> is_on_surface(cloud.size()), is_unmarked(cloud.size());
  for_each_index<ConcurrencyTag>(0, cloud.size(),
                                 [&](std::size_t i)
                                 {
    is_on_surface[i] =
        is_outlier[i] == 0 && features.curvature[i] <= least_curvature_of_volumes ? 1 : 0;
  });
  const auto number_of_neighbors = [&](std::size_t i, const auto& counts)
  {
    std::size_t number = 0;
    for_each_mutual_neighbor(cloud, search, features, k, is_outlier, i,
                             [&](std::size_t j) { number += counts(j) ? 1 : 0; });
    return number;
  };
  const auto may_lead = [&](std::size_t j) { return is_on_surface[j] != 0; };
  const auto leads = [&](std::size_t j)
  {
    return is_unmarked[j] != 0 ||
           (is_on_surface[j] != 0 && number_of_neighbors(j, may_lead) >= flat_around_flat);
  };
  for (int round = 0; round < most_rounds && !candidates.empty(); ++round)
  {
    std::vector<std::uint8_t> is_led_to(candidates.size());
    for_each_index<ConcurrencyTag>(0, candidates.size(),
                                   [&](std::size_t c)
                                   {
      is_led_to[c] = number_of_neighbors(candidates[c], may_lead) >= third &&
                             number_of_neighbors(candidates[c], leads) >= third
                         ? 1
                         : 0;
    });
    const std::vector<std::size_t> unmarked = elements_at<ConcurrencyTag>(
        indices_where<ConcurrencyTag>(candidates.size(),
                                      [&](std::size_t c) { return is_led_to[c] != 0; }),
        candidates);
    for_each_index<ConcurrencyTag>(0, unmarked.size(),
                                   [&](std::size_t i)
                                   {
      is_outlier[unmarked[i]] = 0;
      is_on_surface[unmarked[i]] = 1;
      is_unmarked[unmarked[i]] = 1;
    });
    candidates = marked_neighbors<ConcurrencyTag>(cloud, search, k, unmarked, is_outlier);
  }
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SPARSE_SURFACES_H
