// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FEW_VOTES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FEW_VOTES_H

#include <CGAL/Curvature_aware_simplification_3/internal/Cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Covariance_sums.h>
#include <CGAL/Curvature_aware_simplification_3/internal/loops.h>
#include <CGAL/Curvature_aware_simplification_3/internal/mutual_neighbors.h>
#include <CGAL/Curvature_aware_simplification_3/internal/prefix_sums.h>
#include <CGAL/Curvature_aware_simplification_3/internal/principal_axes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/shared_features.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Whether point i is off the plane of those of its k nearest points that are no outliers, by more than a part of the radius
// of the neighborhood: less is no outlier that matters. A border or an end of a surface is not, though it has few votes.
// With 0.1, 0.2, 0.3 and 0.4, of the points of a surface that are lost without this, 0.42, 0.22, 0.12 and 0.05 still are
// (5 % outliers), and up to 1.5 % more outliers are missed.
inline bool is_off_plane_of_neighbors(const Cloud& cloud, const Neighbor_search& search,
                                      std::size_t k, const std::vector<std::uint8_t>& is_outlier,
                                      std::size_t i)
{
  constexpr double far_off = 0.3;
  Covariance_sums sums;
  double squared_radius = 0.;
  search.for_each_nearest(cloud.points[i], k + 1,
                          [&](std::size_t j, const Point& p, double squared_distance)
                          {
    squared_radius = (std::max)(squared_radius, squared_distance);
    if (j != i && is_outlier[j] == 0)
      sums.add(p - cloud.points[i]);
  });
  return sums.weight < 3. ||
         std::abs(sums.mean() * principal_axis(sums, 0)) >= far_off * std::sqrt(squared_radius);
}

// Marks those that have less votes than needed_votes(i) and pass the test, and returns them. A vote that counts for
// several points makes the number uncertain: those with few are asked how many of their neighbors would vote for
// them, were these asked one by one.
template <typename ConcurrencyTag, typename NeededVotes, typename Test>
std::vector<std::size_t> mark_those_with_fewer_votes(
    const Cloud& cloud, const Neighbor_search& search, const Shared_features& shared, std::size_t k,
    const std::vector<std::atomic<std::uint32_t>>& votes, const NeededVotes& needed_votes,
    const Test& test, std::vector<std::uint8_t>& is_outlier)
{
  const std::vector<std::size_t> candidates = indices_where<ConcurrencyTag>(votes.size(),
                                                                            [&](std::size_t i) {
    return is_outlier[i] == 0 && votes[i].load(std::memory_order_relaxed) < needed_votes(i);
  });
  // all are counted before any is marked
  std::vector<std::uint8_t> is_confirmed(candidates.size());
  for_each_index<ConcurrencyTag>(0, candidates.size(),
                                 [&](std::size_t c)
                                 {
    std::size_t mutual_neighbors = 0;
    for_each_mutual_neighbor(
        cloud, search, shared.features, k, candidates[c],
        [&](std::size_t j) { return is_outlier[j] == 0; },
        [&](std::size_t) { ++mutual_neighbors; });
    is_confirmed[c] = mutual_neighbors < needed_votes(candidates[c]) && test(candidates[c]) ? 1 : 0;
  });
  const std::vector<std::size_t> found = elements_at<ConcurrencyTag>(
      indices_where<ConcurrencyTag>(candidates.size(),
                                    [&](std::size_t c) { return is_confirmed[c] != 0; }),
      candidates);
  for_each_index<ConcurrencyTag>(0, found.size(), [&](std::size_t f) { is_outlier[found[f]] = 1; });
  return found;
}

// Whether so many points with few votes are more than a clean scan has. Of 15 of these, at most one in 2000 points
// was taken for an outlier; where one in 20 was added, one in 130 at least had few votes. Of few points, up to three
// are by chance: of 6000 clean squares, disks and ellipsoids of 100 to 999 points, one had three, none had more.
inline bool is_more_than_a_few(std::size_t with_few_votes, std::size_t points)
{
  return with_few_votes > 3 + points / 1000;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FEW_VOTES_H
