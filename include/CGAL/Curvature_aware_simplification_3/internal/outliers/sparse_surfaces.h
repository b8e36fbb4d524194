// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_SPARSE_SURFACES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_SPARSE_SURFACES_H

#include <CGAL/Curvature_aware_simplification_3/internal/features/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/features/thick_and_sparse.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Covariance_sums.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/principal_axes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Searchable_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/outliers/Marked_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Flags.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/index_selection.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/median_of_some.h>

#include <Eigen/Core>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Points that are taken for outliers because they are thick and sparse may be sparse parts of a
// surface. Where a scanner is far away, all of a surface is sparse, and thick at edges and where
// parts are hardly thicker than the points are apart. But not far from there it is flat. So flat
// points support these far ones, in neighborhoods of twice the radius.

// On a surface, twice the radius of the k nearest points holds so many. In space, one point in a
// hundred is as flat as points of surfaces are (kappa of 0.07 or less): among 4 k neighbors, a
// quarter never is so by chance; among k, a third is, for a few of 100,000 points.
inline std::size_t neighbors_within_twice_the_radius(std::size_t k)
{
  return 4 * k;
}

// kappa of so many points around one
inline double variation_of_twice_the_radius(const Searchable_points& cloud, std::size_t k,
                                            std::size_t i)
{
  Covariance_sums sums;
  cloud.search->for_each_nearest(
      cloud.points[i], neighbors_within_twice_the_radius(k) + 1,
      [&](std::size_t, const Point& p, double) { sums.add(p - cloud.points[i]); });
  const Eigen::Vector3d variances = principal_variances(sums);
  return variances(0) / variances.sum();
}

// The median of that over these
template <typename ConcurrencyTag>
double median_variation(const Searchable_points& cloud, std::size_t k,
                        const std::vector<std::size_t>& points)
{
  return median_of_some<ConcurrencyTag>(points.size(), [&](std::size_t i) {
    return variation_of_twice_the_radius(cloud, k, points[i]);
  });
}

// Whether something tells of outliers but the far points themselves. Where outliers fill the box
// around a surface, for each fifteen far ones at most, one near it has few votes. On 144 scans
// without outliers whose density falls 100 : 1 to 10,000 : 1, three of four had one for each
// hundred at most, and of an overview merged with a close-up one for each fifty. And in larger
// neighborhoods, parts of a surface are flatter than space is, and than 400 and more outliers that
// all are far.
template <typename ConcurrencyTag>
bool are_outliers_likely(const Searchable_points& cloud, std::size_t k,
                         std::size_t number_with_few_votes,
                         const std::vector<std::size_t>& far_ones)
{
  return number_with_few_votes > 3 + far_ones.size() / 30 || // up to three are by chance
         median_variation<ConcurrencyTag>(cloud, k, far_ones) > largest_variation_of_parts;
}

// The share of a neighborhood whose support such a point needs
inline double needed_share_of_support(bool are_outliers_likely)
{
  return are_outliers_likely ? 1. / 4. : 1. / 16.;
}

// Unmarks those of the far ones that have enough support of flat and sparse points, which are among
// other such points. They support others in the next round. O(n), and O(k + log n) for each point
// that supports.
template <typename ConcurrencyTag>
void unmark_sparse_surfaces(const Marked_points& points, double needed_share,
                            const std::vector<std::size_t>& far_ones)
{
  const Features& features = points.features;
  Flags& is_outlier = points.is_outlier;
  // Each reaches one neighborhood farther. Where outliers and a surface are equally sparse, there
  // has to be an end: one would follow the other. With four, some legs of animals are lost.
  constexpr int most_rounds = 8;
  const std::size_t many = neighbors_within_twice_the_radius(points.k());
  const auto share_of_many = [&](double share) {
    return (std::max)(static_cast<std::size_t>(share * static_cast<double>(many)), std::size_t(1));
  };
  const std::size_t flat_around_flat = share_of_many(1. / 4.);
  const std::size_t needed_support = share_of_many(needed_share);

  const auto is_flat_and_sparse = [&](std::size_t i) {
    return is_outlier[i] == 0 && features.surface_variation[i] <= least_variation_of_volumes &&
           features.inverse_density[i] > points.sparseness.of_sparse_parts;
  };
  std::vector<std::size_t> supporters =
      indices_where<ConcurrencyTag>(points.size(), is_flat_and_sparse);
  std::vector<std::atomic<std::uint32_t>> support(points.size());
  for (int round = 0; round < most_rounds && !supporters.empty(); ++round)
  {
    for_each_index<ConcurrencyTag>(0, supporters.size(), [&](std::size_t s) {
      std::vector<std::size_t> marked;
      std::size_t flat_and_sparse = 0; // with itself
      points.cloud.search->for_each_nearest(points.point(supporters[s]), many + 1,
                                            [&](std::size_t j, const Point&, double) {
                                              if (is_outlier[j] != 0)
                                                marked.push_back(j);
                                              else if (is_flat_and_sparse(j))
                                                ++flat_and_sparse;
                                            });
      if (round > 0 || flat_and_sparse > flat_around_flat)
        for (std::size_t j : marked)
          support[j].fetch_add(1, std::memory_order_relaxed);
    });
    supporters = those_where<ConcurrencyTag>(far_ones, [&](std::size_t i) {
      return is_outlier[i] != 0 && support[i].load(std::memory_order_relaxed) >= needed_support;
    });
    set_flags<ConcurrencyTag>(is_outlier, supporters, 0);
  }
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_SPARSE_SURFACES_H
