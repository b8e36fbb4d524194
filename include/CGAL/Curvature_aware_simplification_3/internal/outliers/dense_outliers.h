// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_DENSE_OUTLIERS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_DENSE_OUTLIERS_H

#include <CGAL/Curvature_aware_simplification_3/internal/features/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/features/thick_and_sparse.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/index_selection.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/median_of_some.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Whether outliers fill a volume so densely that some of them have less than 3 times the median
// radius; if not, points that have less are of a surface.
//
// First sign: the median radius of far points hardly exceeds their limit. It is 1.6 to 2.3 times as
// much where 5 and 10 % of outliers fill the box around a shape, more where it is thin, and 1.1 to
// 1.4 times with 20 and 30 %. But so it is at the sparse end of a surface. Second sign: of the
// points that are rather far and thick, 0.18 to 0.33 are round in such volumes, and 0.17 at most on
// thin parts with noise. A few far points tell nothing: five of a lion head were as if dense.
template <typename ConcurrencyTag>
bool are_far_points_dense(const Features& features, const Sparseness& sparseness)
{
  constexpr double hardly_farther = 1.5;
  constexpr double round_enough = 1. / 6.;
  const std::size_t n = features.inverse_density.size();
  const std::vector<std::size_t> far_ones = indices_where<ConcurrencyTag>(n, [&](std::size_t i) {
    return is_thick_and_sparse(features, i, least_variation_of_volumes, sparseness.of_outliers);
  });
  if (!is_more_than_a_few(far_ones.size(), n))
    return false;
  const double median = median_of_some<ConcurrencyTag>(
      far_ones.size(), [&](std::size_t f) { return features.inverse_density[far_ones[f]]; });
  if (median >= hardly_farther * hardly_farther * sparseness.of_outliers)
    return false;
  const auto rather_far_ones = [&](double variation) {
    return static_cast<double>(number_where<ConcurrencyTag>(n, [&](std::size_t i) {
      return is_thick_and_sparse(features, i, variation, sparseness.of_sparse_parts);
    }));
  };
  return rather_far_ones(least_variation_of_round_volumes) >=
         round_enough * rather_far_ones(least_variation_of_volumes);
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_DENSE_OUTLIERS_H
