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
#include <utility>
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

// Computes them, for one block of points after the other
template <typename DiagonalizeTraits>
class Feature_sharing
{
public:
  // Points share within blocks of so many along the Hilbert curve only, one after the other, so
  // that the result does not depend on threads. Few neighborhoods meet the border of such a block.
  static constexpr std::size_t block = 1024;

  template <typename ConcurrencyTag>
  Feature_sharing(const Searchable_points& cloud, std::size_t number_of_neighbors,
                  const ConcurrencyTag&)
    : m_cloud(cloud),
      m_k(neighborhood_size(number_of_neighbors, cloud.size()) - 1),
      m_features{Uninitialized_vector<double>(cloud.size()),
                 Uninitialized_vector<double>(cloud.size()), m_k},
      m_represented(cloud.size(), 0),
      m_is_done(cloud.size(), 0),
      m_votes(cloud.size())
  {
    for_each_index<ConcurrencyTag>(
        0, cloud.size(), [&](std::size_t i) { m_votes[i].store(0, std::memory_order_relaxed); });
  }

  // Of the points of a block: the features of those that have none yet, which other ones share
  void compute(std::size_t begin, std::size_t end)
  {
    std::vector<Neighbor> neighbors;
    for (std::size_t i = begin; i < end; ++i)
    {
      if (m_is_done[i] != 0)
        continue;
      neighbors.clear();
      compute_own(i, [&](std::size_t j, double squared_distance) {
        neighbors.push_back({j, squared_distance});
      });
      m_is_done[i] = 1;
      m_represented[i] = 1;
      if (m_features.surface_variation[i] <= largest_variation_of_flat_points)
        share(i, neighbors, begin, end);
      for (const Neighbor& neighbor : neighbors)
        m_votes[neighbor.index].fetch_add(m_represented[i], std::memory_order_relaxed);
    }
  }

  // When all blocks are done. Far from all others, an outlier and its neighbors may happen to be
  // flat: there, each speaks for itself.
  template <typename ConcurrencyTag>
  Shared_features take(const ConcurrencyTag&)
  {
    const std::size_t n = m_cloud.size();
    const double sparse = sparseness_of(m_features.inverse_density).of_outliers;
    Uninitialized_vector<std::uint32_t> votes(n);
    for_each_index<ConcurrencyTag>(0, n, [&](std::size_t i) {
      if (m_represented[i] == 0 && m_features.inverse_density[i] > sparse)
        compute_own(i, No_visit());
      // Not its own: where more points than have a vote are at one place, it may have none.
      votes[i] = (std::max)(m_votes[i].load(std::memory_order_relaxed), std::uint32_t(1)) - 1;
    });
    return {std::move(m_features), std::move(m_represented), std::move(votes)};
  }

private:
  struct Neighbor
  {
    std::size_t index;
    double squared_distance;
  };

  template <typename Visit>
  void compute_own(std::size_t i, const Visit& visit)
  {
    assign(i, local_features<DiagonalizeTraits>(*m_cloud.search, m_cloud.points[i], m_k + 1,
                                                m_cloud.coordinate_error, visit));
  }

  void assign(std::size_t i, const Local_features& local)
  {
    m_features.surface_variation[i] = local.surface_variation;
    m_features.inverse_density[i] = local.inverse_density;
  }

  // The features of point i, with those of its block in the inner half of its neighborhood that
  // have none
  void share(std::size_t i, const std::vector<Neighbor>& neighbors, std::size_t begin,
             std::size_t end)
  {
    // Of the squared radius. Points that are that near are in half of the neighborhood, and so get
    // the votes of a part of it at least. And an outlier over a surface that has such neighbors
    // there is so near that its 1/rho is less than twice as large as theirs.
    constexpr double inner_half = 0.5;
    constexpr std::uint8_t most = (std::numeric_limits<std::uint8_t>::max)();
    const Local_features local{m_features.surface_variation[i], m_features.inverse_density[i]};
    const double limit = inner_half * local.inverse_density * static_cast<double>(m_k);
    for (const Neighbor& neighbor : neighbors)
    {
      const std::size_t j = neighbor.index;
      if (neighbor.squared_distance <= limit && j >= begin && j < end && m_is_done[j] == 0 &&
          m_represented[i] < most)
      {
        assign(j, local);
        m_is_done[j] = 1;
        ++m_represented[i];
      }
    }
  }

  const Searchable_points& m_cloud;
  std::size_t m_k;
  Features m_features;
  std::vector<std::uint8_t> m_represented;
  Flags m_is_done;
  // sums of integers: the order does not matter
  Uninitialized_vector<std::atomic<std::uint32_t>> m_votes;
};

// O(n (log n + k)), but k-nearest-neighbor queries for a quarter of the points only, where these
// are dense against shape and noise
template <typename ConcurrencyTag, typename DiagonalizeTraits>
Shared_features compute_shared_features(const Searchable_points& cloud,
                                        std::size_t number_of_neighbors, const Progress& progress)
{
  const std::size_t n = cloud.size();
  Feature_sharing<DiagonalizeTraits> sharing(cloud, number_of_neighbors, ConcurrencyTag());
  const std::size_t block = Feature_sharing<DiagonalizeTraits>::block;
  for_each_index<ConcurrencyTag>((n + block - 1) / block, progress, [&](std::size_t b) {
    sharing.compute(b * block, (std::min)(n, (b + 1) * block));
  });
  return sharing.take(ConcurrencyTag());
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FEATURES_SHARED_FEATURES_H
