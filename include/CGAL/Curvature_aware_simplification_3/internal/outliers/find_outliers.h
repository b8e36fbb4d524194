// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_FIND_OUTLIERS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_FIND_OUTLIERS_H

#include <CGAL/Curvature_aware_simplification_3/internal/features/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/features/shared_features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/features/thick_and_sparse.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Searchable_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/outliers/Outlier_votes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/outliers/connected_surfaces.h>
#include <CGAL/Curvature_aware_simplification_3/internal/outliers/dense_outliers.h>
#include <CGAL/Curvature_aware_simplification_3/internal/outliers/isolated_clusters.h>
#include <CGAL/Curvature_aware_simplification_3/internal/outliers/noisy_layers.h>
#include <CGAL/Curvature_aware_simplification_3/internal/outliers/sparse_surfaces.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Adaptive_settings.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Flags.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Progress.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/index_selection.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Marks points that are far from others and thick, and if outliers `are_dense`, the roundest of
// those that are rather far, but for those that other points show to be on a surface.
// `number_with_few_votes` of the outliers are near it. Returns those that are in noisy layers.
template <typename ConcurrencyTag>
std::vector<std::size_t> mark_far_points(const Marked_points& points,
                                         std::size_t number_with_few_votes, bool are_dense,
                                         const Adaptive_settings& settings)
{
  const Features& features = points.features;
  const Sparseness& sparseness = points.sparseness;
  const std::vector<std::size_t> far_ones =
      indices_where<ConcurrencyTag>(points.size(), [&](std::size_t i) {
        return points.is_outlier[i] == 0 &&
               (is_thick_and_sparse(features, i, least_variation_of_volumes,
                                    sparseness.of_outliers) ||
                (are_dense && is_thick_and_sparse(features, i, least_variation_of_round_volumes,
                                                  sparseness.of_sparse_parts)));
      });
  set_flags<ConcurrencyTag>(points.is_outlier, far_ones, 1);
  if (!settings.keep_sparse_surfaces || far_ones.empty())
    return {};
  const bool are_likely = are_outliers_likely<ConcurrencyTag>(points.cloud, points.k(),
                                                              number_with_few_votes, far_ones);
  std::vector<std::size_t> in_layers;
  if (settings.keep_noisy_layers)
    in_layers = unmark_noisy_layers<ConcurrencyTag>(points, far_ones);
  unmark_sparse_surfaces<ConcurrencyTag>(points, needed_share_of_support(are_likely), far_ones);
  unmark_connected<ConcurrencyTag>(points, are_likely, far_ones);
  return in_layers;
}

// Whether what a second look finds may be outliers that hide from the first: of 5 shapes with 0.3
// to 5 % of them, 0.01 to 0.18 of those found before, and of a rotor with thin walls up to 0.4. Of
// sparse strips of a surface between denser ones, as of walls between roofs and the ground, it
// finds as many as the first look did: 0.6 to 1.4 of them.
inline bool are_few_against(std::size_t second, std::size_t first)
{
  return 3 * second <= first;
}

// Which points do not belong to a surface: 1 for outliers. Takes O(k + log n) for each outlier and
// for each point with few votes, and a pass over all points for each round of uncovering, of which
// there are few.
//
// 1. Outlier_votes::mark_few(): every point votes for its k nearest. A point on a surface gets
//    about k votes, at a corner of an open surface half of them, and the density of the input
//    cancels out: sparse regions vote for themselves. An outlier near a surface has neighbors there,
//    but is no neighbor of theirs: it gets less than a quarter of k. (Votes are the in-degrees of
//    the graph of k nearest neighbors; as a sign of outliers: Hautamaki et al. 2004.)
// 2. Outlier_votes::keep_lone_points(): where these are no more than a few, those in the plane of
//    their neighbors are lone points of a sparse border.
// 3. mark_far_points(): outliers far away vote for each other. They are those whose neighborhood is
//    as thick as wide and has more than 3 times the median radius, which noise alone does not give
//    it; where some may be denser, the roundest of those with 2 to 3 times are, too. Sparse parts
//    of a surface look like that as well, but they are layers in wider neighborhoods
//    (unmark_noisy_layers()), flat points are nearby (unmark_sparse_surfaces()), or they are
//    connected to denser parts (unmark_connected()).
// 4. Outlier_votes::take_back(): the votes of outliers do not count, which uncovers others; where
//    outliers are dense, those that lose a third of theirs.
// 5. isolated_clusters(): without single points between them, clusters are apart.
// 6. Outlier_votes::less_than_half(): where there are more than a few near the surface, others get
//    between a quarter of k and half of it, what a corner gets. A second look, once, asks for half,
//    unless it finds too many.
template <typename ConcurrencyTag>
Flags find_outliers(const Searchable_points& cloud, const Shared_features& shared,
                    const Adaptive_settings& settings, const Progress& progress)
{
  Flags is_outlier(cloud.size(), 0);
  const Marked_points points{cloud, shared.features, sparseness_of(shared.features.inverse_density),
                             is_outlier};
  const bool are_dense = are_far_points_dense<ConcurrencyTag>(points.features, points.sparseness);
  Outlier_votes<ConcurrencyTag> votes(points, shared, are_dense, settings);
  const std::vector<std::size_t> with_few_votes = votes.mark_few();
  const bool are_more_than_a_few = is_more_than_a_few(with_few_votes.size(), cloud.size());
  if (settings.keep_lone_points && !are_more_than_a_few)
    votes.keep_lone_points(with_few_votes);
  progress.report(0.2);
  votes.trust(mark_far_points<ConcurrencyTag>(points, with_few_votes.size(), are_dense, settings));
  progress.report(0.5);
  votes.take_back(flagged_indices<ConcurrencyTag>(is_outlier));
  progress.report(0.7);
  if (settings.find_clusters)
    votes.mark(isolated_clusters<ConcurrencyTag>(points));
  progress.report(0.9);
  if (are_more_than_a_few)
  {
    const std::vector<std::size_t> hidden = votes.less_than_half();
    if (are_few_against(hidden.size(), number_of_flagged<ConcurrencyTag>(is_outlier)))
      votes.mark(hidden);
  }
  return is_outlier;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_FIND_OUTLIERS_H
