// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_OUTLIER_VOTES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_OUTLIER_VOTES_H

#include <CGAL/Curvature_aware_simplification_3/internal/features/shared_features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/features/thick_and_sparse.h>
#include <CGAL/Curvature_aware_simplification_3/internal/outliers/Marked_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/outliers/is_off_plane_of_neighbors.h>
#include <CGAL/Curvature_aware_simplification_3/internal/outliers/sparse_surfaces.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Adaptive_settings.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Flags.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Uninitialized_vector.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/index_selection.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The votes of the points that are not marked as outliers, and what they tell of others. A vote
// counts for several points where these share their features.
template <typename ConcurrencyTag>
class Outlier_votes
{
public:
  // Others may set marks as well. Marked points do not count as voters when votes are asked for one
  // by one, but their votes remain until they are taken back.
  Outlier_votes(const Marked_points& points, const Shared_features& shared, bool are_outliers_dense,
                const Adaptive_settings& settings)
    : m_points(points),
      m_shared(shared),
      m_quarter((std::max)(points.k() / 4, std::size_t(1))),
      m_are_outliers_dense(are_outliers_dense),
      m_settings(settings),
      m_votes(points.size()),
      m_is_in_layer(points.size(), 0)
  {
    for_each_index<ConcurrencyTag>(0, points.size(), [&](std::size_t i) {
      m_votes[i].store(shared.votes[i] + 1, std::memory_order_relaxed);
    });
  }

  // Points of layers with so much noise that they look like space to their neighborhoods: they lose
  // votes, but need no more than others.
  void trust(const std::vector<std::size_t>& in_layers)
  {
    set_flags<ConcurrencyTag>(m_is_in_layer, in_layers, 1);
  }

  // Marks outliers, which take their votes back. This uncovers others with few votes, and so on.
  void mark(const std::vector<std::size_t>& found)
  {
    set_flags<ConcurrencyTag>(m_points.is_outlier, found, 1);
    take_back(found);
  }

  // Marks points with few votes, and returns them. Those that lost votes are in a volume if what is
  // around looks like that, too: a thin part among outliers does not.
  std::vector<std::size_t> mark_few()
  {
    const std::vector<std::size_t> found =
        with_less_votes([&](std::size_t i) { return few_votes(i); },
                        [&](std::size_t i) {
                          return votes(i) < m_quarter || !m_settings.keep_sparse_surfaces ||
                                 variation_of_twice_the_radius(m_points.cloud, m_points.k(), i) >
                                     least_variation_at_borders_of_volumes;
                        });
    set_flags<ConcurrencyTag>(m_points.is_outlier, found, 1);
    return found;
  }

  // Of points that were found for their few votes, unmarks those that have one at least and are in
  // the plane of their neighbors: lone points of sparse borders and corners are, while one of a few
  // outliers next to a surface hardly is. Their votes are no reason to mark them any more.
  void keep_lone_points(const std::vector<std::size_t>& found)
  {
    const std::vector<std::size_t> lone = those_where<ConcurrencyTag>(found, [&](std::size_t i) {
      return number_of_voters(i) > 0 && !is_off_plane_of_neighbors(m_points, i);
    });
    set_flags<ConcurrencyTag>(m_points.is_outlier, lone, 0);
    for_each_index<ConcurrencyTag>(0, lone.size(), [&](std::size_t l) {
      m_votes[lone[l]].store(static_cast<std::uint32_t>(m_points.k()) + 1,
                             std::memory_order_relaxed);
    });
  }

  // Those with less than half of k, which may be outliers as well. A border has little more than
  // half: asked again and again, border after border would go. Of points that are not sparse, only
  // those off the surface are returned: among sparse ones, it may be outliers that are in a plane.
  std::vector<std::size_t> less_than_half() const
  {
    return with_less_votes([&](std::size_t) { return m_points.k() / 2; },
                           [&](std::size_t i) {
                             return (m_is_in_layer[i] == 0 &&
                                     m_shared.features.inverse_density[i] >
                                         m_points.sparseness.of_sparse_parts) ||
                                    is_off_plane_of_neighbors(m_points, i);
                           });
  }

  // Points that were marked take their votes back, which uncovers others with few votes, until
  // there are no more.
  void take_back(std::vector<std::size_t> marked)
  {
    while (!marked.empty())
    {
      for_each_index<ConcurrencyTag>(0, marked.size(), [&](std::size_t f) {
        const std::uint32_t number = m_shared.represented[marked[f]];
        if (number > 0)
          m_points.cloud.search->for_each_nearest(m_points.point(marked[f]), m_points.k() + 1,
                                                  [&](std::size_t j, const Point&, double) {
                                                    if (j != marked[f])
                                                      m_votes[j].fetch_sub(
                                                          number, std::memory_order_relaxed);
                                                  });
      });
      marked = mark_few();
    }
  }

private:
  // Without its own. The counter may be 0: the point that represents it may have taken that back.
  std::size_t votes(std::size_t i) const
  {
    return (std::max)(m_votes[i].load(std::memory_order_relaxed), std::uint32_t(1)) - 1;
  }

  // of the neighbors of i, those not marked that would vote for it, were they asked one by one
  std::size_t number_of_voters(std::size_t i) const
  {
    std::size_t number = 0;
    for_each_mutual_neighbor(
        m_points, i, [&](std::size_t j) { return m_points.is_outlier[j] == 0; },
        [&](std::size_t) { ++number; });
    return number;
  }

  // A quarter of k: a corner of an open surface, the least that a surface has, gets a half. Where
  // outliers are dense, two thirds of those that a point had at first: with less, much of what is
  // around it are outliers. With half, a ninth of them remains, in groups that vote for each other.
  // A sparse region of a surface has no outliers to lose.
  std::size_t few_votes(std::size_t i) const
  {
    return m_are_outliers_dense && m_is_in_layer[i] == 0 &&
                   is_thick_and_sparse(m_shared.features, i, least_variation_of_volumes,
                                       m_points.sparseness.of_sparse_parts)
               ? (std::max)(m_quarter, 2 * std::size_t(m_shared.votes[i]) / 3)
               : m_quarter;
  }

  // Those not marked that have less votes than needed_votes(i) and pass the test. A vote that
  // counts for several points makes the number uncertain: those with few are asked how many of
  // their neighbors would vote for them, were these asked one by one.
  template <typename NeededVotes, typename Test>
  std::vector<std::size_t> with_less_votes(const NeededVotes& needed_votes, const Test& test) const
  {
    const std::vector<std::size_t> candidates =
        indices_where<ConcurrencyTag>(m_votes.size(), [&](std::size_t i) {
          return m_points.is_outlier[i] == 0 && votes(i) < needed_votes(i);
        });
    return those_where<ConcurrencyTag>(candidates, [&](std::size_t i) {
      return number_of_voters(i) < needed_votes(i) && test(i);
    });
  }

  const Marked_points m_points;
  const Shared_features& m_shared;
  std::size_t m_quarter; // of k, but 1 at least
  bool m_are_outliers_dense;
  const Adaptive_settings& m_settings;
  // Of each point, its own among them. Sums of integers: the order does not matter.
  Uninitialized_vector<std::atomic<std::uint32_t>> m_votes;
  Flags m_is_in_layer;
};

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_OUTLIER_VOTES_H
