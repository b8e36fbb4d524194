// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FEATURES_SHARED_FEATURES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FEATURES_SHARED_FEATURES_H

#include <CGAL/Curvature_aware_simplification_3/internal/features/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/features/thick_and_sparse.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Searchable_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Flags.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Uninitialized_vector.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Features of which a point may have those of one nearby, its representative: where the
// neighborhood of a point is flat, those in its inner half see the same, and need not have their
// neighbors looked up.
struct Shared_features
{
  Features features;
  // For how many points this one votes, itself among them: those that share its features, but for
  // far ones, which got their own later. 0 if another one votes for it.
  std::vector<std::uint8_t> represented;
  // How many points have this one among their k nearest, the point itself not counted: a voter
  // counts once for each point that it represents. k on average.
  Uninitialized_vector<std::uint32_t> votes;
};

// O(n (log n + k)), but k-nearest-neighbor queries for a quarter of the points only, where these
// are dense against shape and noise
template <typename ConcurrencyTag, typename DiagonalizeTraits>
Shared_features compute_shared_features(const Searchable_points& cloud,
                                        std::size_t number_of_neighbors, const Progress& progress)
{
  // Of the squared radius. Points that are that near are in half of the neighborhood, and so get
  // the votes of a part of it at least. And an outlier over a surface that has such neighbors there
  // is so near that its 1/rho is less than twice as large as theirs.
  constexpr double inner_half = 0.5;
  // Points share within blocks of so many along the Hilbert curve only, one after the other, so
  // that the result does not depend on threads. Few neighborhoods meet the border of such a block.
  constexpr std::size_t sharing_block = 1024;
  constexpr std::uint8_t most = (std::numeric_limits<std::uint8_t>::max)();

  struct Neighbor
  {
    std::size_t index;
    double squared_distance;
  };

  const std::size_t n = cloud.size();
  const std::size_t size = neighborhood_size(number_of_neighbors, n);
  Shared_features shared{
      {Uninitialized_vector<double>(n), Uninitialized_vector<double>(n), size - 1},
      std::vector<std::uint8_t>(n, 0),
      Uninitialized_vector<std::uint32_t>(n)};
  std::vector<std::uint8_t>& represented = shared.represented;
  const auto assign = [&](std::size_t i, const Local_features& local) {
    shared.features.surface_variation[i] = local.surface_variation;
    shared.features.inverse_density[i] = local.inverse_density;
  };

  Flags is_done(n, 0);
  // sums of integers: the order does not matter
  Uninitialized_vector<std::atomic<std::uint32_t>> votes(n);
  for_each_index<ConcurrencyTag>(
      0, n, [&](std::size_t i) { votes[i].store(0, std::memory_order_relaxed); });
  for_each_index<ConcurrencyTag>(
      (n + sharing_block - 1) / sharing_block, progress, [&](std::size_t block) {
        std::vector<Neighbor> neighbors;
        const std::size_t begin = block * sharing_block, end = (std::min)(n, begin + sharing_block);
        for (std::size_t i = begin; i < end; ++i)
        {
          if (is_done[i] != 0)
            continue;
          neighbors.clear();
          const Local_features local = local_features<DiagonalizeTraits>(
              *cloud.search, cloud.points[i], size, cloud.coordinate_error,
              [&](std::size_t j, double squared_distance) {
                neighbors.push_back({j, squared_distance});
              });
          const bool is_flat = local.surface_variation <= largest_variation_of_flat_points;
          const double limit = inner_half * local.inverse_density * static_cast<double>(size - 1);
          assign(i, local);
          is_done[i] = 1;
          represented[i] = 1;
          for (const Neighbor& neighbor : neighbors)
          {
            const std::size_t j = neighbor.index;
            if (is_flat && neighbor.squared_distance <= limit && j >= begin && j < end &&
                is_done[j] == 0 && represented[i] < most)
            {
              assign(j, local);
              is_done[j] = 1;
              ++represented[i];
            }
          }
          for (const Neighbor& neighbor : neighbors)
            votes[neighbor.index].fetch_add(represented[i], std::memory_order_relaxed);
        }
      });

  // Far from all others, an outlier and its neighbors may happen to be flat: there, each speaks for
  // itself.
  const double sparse = sparseness_of(shared.features.inverse_density).of_outliers;
  for_each_index<ConcurrencyTag>(0, n, [&](std::size_t i) {
    if (represented[i] == 0 && shared.features.inverse_density[i] > sparse)
      assign(i, local_features<DiagonalizeTraits>(*cloud.search, cloud.points[i], size,
                                                  cloud.coordinate_error));
    // Not its own: where more points than have a vote are at one place, it may have none.
    shared.votes[i] = (std::max)(votes[i].load(std::memory_order_relaxed), std::uint32_t(1)) - 1;
  });
  return shared;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FEATURES_SHARED_FEATURES_H
