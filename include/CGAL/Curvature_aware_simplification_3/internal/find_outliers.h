// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FIND_OUTLIERS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FIND_OUTLIERS_H

#include <CGAL/Curvature_aware_simplification_3/internal/Adaptive_settings.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/connected_surfaces.h>
#include <CGAL/Curvature_aware_simplification_3/internal/few_votes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/isolated_clusters.h>
#include <CGAL/Curvature_aware_simplification_3/internal/loops.h>
#include <CGAL/Curvature_aware_simplification_3/internal/prefix_sums.h>
#include <CGAL/Curvature_aware_simplification_3/internal/shared_features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/sparse_surfaces.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// kappa of points spread evenly in space is above that for two of five, for k = 16. On a layer of Gaussian noise of
// three quarters of the radius of a neighborhood, it is for one of eight.
inline constexpr double curvature_of_round_volumes = 0.2;

// Which points do not belong to a surface: 1 for outliers. Takes O(k + log n) for each outlier and
// for each point with few votes, and a pass over all points for each round of uncovering, of which
// there are few.
//
// Every point votes for its k nearest. A point on a surface gets about k votes, at a corner of an
// open surface half of them, and the density of the input cancels out: sparse regions vote for
// themselves. An outlier near a surface has neighbors there, but is no neighbor of theirs. Outliers
// far away vote for each other; they are those whose neighborhood is as thick as wide and has more
// than 3 times the median radius, which noise alone does not give it; of those with 2 to 3 times, the
// roundest are. Sparse parts of a surface look like that as well, but flat points are nearby, or they are
// connected to denser parts. The votes of outliers do not count, which uncovers others: in a volume, those that lose a third of theirs.
template <typename ConcurrencyTag>
std::vector<std::uint8_t> find_outliers(const Cloud& cloud, const Neighbor_search& search,
                                        const Shared_features& shared, std::size_t k,
                                        const Adaptive_settings& settings)
{
  const std::size_t n = cloud.size();
  const double sparse = far_inverse_density(shared.features.inverse_density);
  std::vector<std::uint8_t> is_outlier(n, 0);
  std::vector<std::atomic<std::uint32_t>> votes(n); // sums of integers: the order does not matter
  // A quarter of the votes: a corner of an open surface, the least that a surface has, gets a half.
  const std::size_t quarter = (std::max)(k / 4, std::size_t(1));
  const auto is_thick_and_sparse = [&](std::size_t i, double curvature, double inverse_density)
  {
    return shared.features.curvature[i] > curvature &&
           shared.features.inverse_density[i] > inverse_density;
  };
  constexpr double rather_far = 2. / 3.; // of the radius that is far
  const double rather_sparse = rather_far * rather_far * sparse;
  for_each_index<ConcurrencyTag>(
      0, n, [&](std::size_t i) { votes[i].store(shared.votes[i], std::memory_order_relaxed); });
  // In a volume, two thirds of those that a point had at first: with less, much of what is around it are
  // outliers. With half, a ninth of them remains, in groups that vote for each other. A sparse region of a
  // surface has no outliers to lose.
  const auto few_votes = [&](std::size_t i)
  {
    return is_thick_and_sparse(i, least_curvature_of_volumes, rather_sparse)
               ? (std::max)(quarter, 2 * std::size_t(shared.votes[i]) / 3)
               : quarter;
  };
  const auto mark = [&](const auto& needed_votes, const auto& test)
  {
    return mark_those_with_fewer_votes<ConcurrencyTag>(cloud, search, shared, k, votes,
                                                       needed_votes, test, is_outlier);
  };
  // Those that lost votes are in a volume if what is around looks like that, too: a thin part among outliers does not.
  const auto mark_few_votes = [&]
  {
    return mark(few_votes,
                [&](std::size_t i)
                {
      return votes[i].load(std::memory_order_relaxed) < quarter || !settings.keep_sparse_surfaces ||
             curvature_of_twice_the_radius(cloud, search, k, i) >
                 least_curvature_at_borders_of_volumes;
    });
  };
  // Outliers found take their votes back, until that uncovers no more.
  const auto take_votes_back = [&](std::vector<std::size_t> found)
  {
    while (!found.empty())
    {
      for_each_index<ConcurrencyTag>(0, found.size(),
                                     [&](std::size_t f)
                                     {
        const std::uint32_t number = shared.represented[found[f]];
        if (number > 0)
          search.for_each_nearest(cloud.points[found[f]], k + 1,
                                  [&](std::size_t j, const Point&, double)
                                  { votes[j].fetch_sub(number, std::memory_order_relaxed); });
      });
      found = mark_few_votes();
    }
  };
  const std::size_t number_with_few_votes = mark_few_votes().size();
  const std::vector<std::size_t> far_ones = indices_where<ConcurrencyTag>(n,
                                                                          [&](std::size_t i)
                                                                          {
    return is_outlier[i] == 0 &&
           (is_thick_and_sparse(i, least_curvature_of_volumes, sparse) ||
            is_thick_and_sparse(i, curvature_of_round_volumes, rather_sparse));
  });
  for_each_index<ConcurrencyTag>(0, far_ones.size(),
                                 [&](std::size_t f) { is_outlier[far_ones[f]] = 1; });
  if (settings.keep_sparse_surfaces && !far_ones.empty())
  {
    const bool are_likely =
        are_outliers_likely<ConcurrencyTag>(cloud, search, k, number_with_few_votes, far_ones);
    unmark_sparse_surfaces<ConcurrencyTag>(cloud, search, shared.features, k, rather_sparse,
                                           needed_share_of_votes(are_likely), far_ones, is_outlier);
    unmark_connected<ConcurrencyTag>(cloud, search, shared.features, k, are_likely, far_ones,
                                     is_outlier);
  }
  std::vector<std::size_t> found =
      indices_where<ConcurrencyTag>(n, [&](std::size_t i) { return is_outlier[i] != 0; });
  // Where there are more than a few near the surface, some hide between its corners' votes
  // and those of points farther off: a second look asks for half of the votes. Only once, because a
  // border has little more than half; asked again and again, border after border would go. Of points that
  // are not sparse, only those off the surface: among sparse ones, it may be outliers that are in a plane.
  const bool are_many = is_more_than_a_few(number_with_few_votes, n);
  take_votes_back(std::move(found));
  if (settings.find_clusters) // now, since without single points between them, clusters are apart
  {
    found = Isolated_clusters(cloud, search, shared.features, k, sparse, is_outlier)
                .points<ConcurrencyTag>();
    for (std::size_t i : found)
      is_outlier[i] = 1;
    take_votes_back(std::move(found));
  }
  if (are_many)
    take_votes_back(mark([&](std::size_t) { return k / 2; },
                         [&](std::size_t i)
                         {
      return shared.features.inverse_density[i] > rather_sparse ||
             is_off_plane_of_neighbors(cloud, search, k, is_outlier, i);
    }));
  return is_outlier;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FIND_OUTLIERS_H
