// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_LEAVE_OUT_OUTLIERS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_LEAVE_OUT_OUTLIERS_H

#include <CGAL/Curvature_aware_simplification_3/internal/features/shared_features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Searchable_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/outliers/find_outliers.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Adaptive_settings.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Flags.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Progress.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Uninitialized_vector.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/index_selection.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Leaves out outliers: from the points, from the features, which is what `shared` keeps, and from
// the search, whose indices may not be those of the points any more. Returns how many were found,
// also if they are too many to be left out.
template <typename ConcurrencyTag>
std::size_t leave_out_outliers(Searchable_points& cloud, Shared_features& shared,
                               std::size_t number_of_samples, const Adaptive_settings& settings,
                               const Progress& progress)
{
  const std::size_t n = cloud.size();
  Flags is_outlier = find_outliers<ConcurrencyTag>(cloud, shared, settings, progress.part(0., 0.8));
  shared.votes = Uninitialized_vector<std::uint32_t>();
  shared.represented = std::vector<std::uint8_t>();
  const std::size_t number_found = number_of_flagged<ConcurrencyTag>(is_outlier);
  // What most points are is no outlier, and each sample needs a point to start from.
  if (number_found == 0 || n - number_found < (std::max)(number_of_samples, (n + 1) / 2))
    return number_found;

  std::vector<std::size_t> kept =
      indices_where<ConcurrencyTag>(n, [&](std::size_t i) { return is_outlier[i] == 0; });

  // To hide outliers saves a tree, an eighth of a call; but each search that meets one is done
  // again. Among 25 neighbors, one of a thousand is rarely met. With noise, when 3 % may be taken
  // for outliers and all points are smoothed, most searches meet one, which takes longer than a new
  // tree.
  const bool are_few = number_found <= n / 1000;
  if (are_few)
    cloud.search->hide(std::move(is_outlier));
  else
    cloud.search.reset(); // before the features are copied
  is_outlier = Flags();
  keep_elements<ConcurrencyTag>(kept, cloud.points);
  keep_elements<ConcurrencyTag>(kept, shared.features.surface_variation);
  keep_elements<ConcurrencyTag>(kept, shared.features.inverse_density);
  kept = std::vector<std::size_t>();
  if (!are_few)
    cloud.rebuild_search<ConcurrencyTag>();
  return number_found;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_LEAVE_OUT_OUTLIERS_H
