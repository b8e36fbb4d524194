// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_CONNECTED_SURFACES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_CONNECTED_SURFACES_H

#include <CGAL/Curvature_aware_simplification_3/internal/features/thick_and_sparse.h>
#include <CGAL/Curvature_aware_simplification_3/internal/outliers/Marked_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/outliers/sparse_surfaces.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Flags.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/index_selection.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Of points that are taken for outliers because they are thick and sparse, thin parts that become
// sparse are connected to where they are denser: what has points of the surface for half of its
// neighbors, which have it for theirs, is part of it, though nothing around is flat.

// How many such neighbors a point needs. With a third of them, one outlier would follow the other
// where they are dense. A quarter lets all of a tube that becomes sparse follow, where half leaves
// up to 5 % of its points.
inline std::size_t needed_neighbors(std::size_t k, bool are_outliers_likely)
{
  return are_outliers_likely ? (k + 1) / 2 : (k + 3) / 4;
}

// Of the far ones that are marked, those of whose k nearest `needed` are of a surface and have them
// among their own. An outlier that is far as well, and was not marked since its neighborhood is
// flat by chance, is of none: others would follow it, one after the other. What is far and thick
// and not marked any more is. `neighbors` counts these for all points that are far and marked.
template <typename ConcurrencyTag>
std::vector<std::size_t> next_to_surface(const Marked_points& points, std::size_t needed,
                                         const std::vector<std::size_t>& far_ones,
                                         std::vector<std::atomic<std::uint32_t>>& neighbors)
{
  const auto is_of_surface = [&](std::size_t j) {
    return points.is_outlier[j] == 0 &&
           (points.features.inverse_density[j] <= points.sparseness.of_outliers ||
            points.features.surface_variation[j] > least_variation_of_volumes);
  };
  return those_where<ConcurrencyTag>(far_ones, [&](std::size_t i) {
    if (points.is_outlier[i] == 0)
      return false;
    std::uint32_t number = 0;
    for_each_mutual_neighbor(points, i, is_of_surface, [&](std::size_t) { ++number; });
    neighbors[i].store(number, std::memory_order_relaxed);
    return number >= needed;
  });
}

// Unmarks those of the far ones of whose k nearest so many at least are of a surface and have it
// among their own, those next to these, and so on. An outlier over a surface is no neighbor of its
// points, and those farther off have no others than outliers. But if outliers are likely, some may
// be too dense to be marked and connect others: those are left that look like space. O(k + log n)
// for each far one, and for each one unmarked.
template <typename ConcurrencyTag>
void unmark_connected(const Marked_points& points, bool are_outliers_likely,
                      const std::vector<std::size_t>& far_ones)
{
  Flags& is_outlier = points.is_outlier;
  const std::size_t needed = needed_neighbors(points.k(), are_outliers_likely);
  // of those that are far and marked; others are never asked, as if they had more than enough
  // already
  std::vector<std::atomic<std::uint32_t>> neighbors(points.size());
  for_each_index<ConcurrencyTag>(0, points.size(), [&](std::size_t i) {
    neighbors[i].store(static_cast<std::uint32_t>(needed), std::memory_order_relaxed);
  });
  std::vector<std::size_t> asked =
      next_to_surface<ConcurrencyTag>(points, needed, far_ones, neighbors);
  while (!asked.empty())
  {
    for_each_index<ConcurrencyTag>(0, asked.size(), [&](std::size_t a) {
      if (!are_outliers_likely ||
          variation_of_twice_the_radius(points.cloud, points.k(), asked[a]) <=
              largest_variation_of_parts)
        is_outlier[asked[a]] = 0;
    });
    // Each is asked in the round in which it gets the last neighbor it needs; in which order does
    // not matter.
    std::vector<std::vector<std::size_t>> reached(asked.size());
    for_each_index<ConcurrencyTag>(0, asked.size(), [&](std::size_t a) {
      if (is_outlier[asked[a]] == 0)
        for_each_mutual_neighbor(
            points, asked[a], [&](std::size_t j) { return is_outlier[j] != 0; },
            [&](std::size_t j) {
              if (neighbors[j].fetch_add(1, std::memory_order_relaxed) + 1 == needed)
                reached[a].push_back(j);
            });
    });
    asked.clear();
    for (const std::vector<std::size_t>& some : reached)
      asked.insert(asked.end(), some.begin(), some.end());
  }
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_CONNECTED_SURFACES_H
