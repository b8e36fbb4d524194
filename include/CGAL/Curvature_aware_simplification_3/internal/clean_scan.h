// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_CLEAN_SCAN_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_CLEAN_SCAN_H

#include <CGAL/Curvature_aware_simplification_3/internal/Scan.h>
#include <CGAL/Curvature_aware_simplification_3/internal/copies/merge_copies.h>
#include <CGAL/Curvature_aware_simplification_3/internal/density/even_density.h>
#include <CGAL/Curvature_aware_simplification_3/internal/depth/Depth_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/depth/undo_rounding.h>
#include <CGAL/Curvature_aware_simplification_3/internal/features/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/features/shared_features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/features/thick_and_sparse.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Surface_fit.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Searchable_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Noise_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/bent_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/noise_of_scan.h>
#include <CGAL/Curvature_aware_simplification_3/internal/outliers/find_outliers.h>
#include <CGAL/Curvature_aware_simplification_3/internal/outliers/leave_out_outliers.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Adaptive_settings.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Parameters.h>
#include <CGAL/Curvature_aware_simplification_3/internal/smoothing/smooth_scan.h>
#include <CGAL/Curvature_aware_simplification_3/internal/smoothing/thin_dense_noise.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Flags.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Progress.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Stopwatch.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Uninitialized_vector.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/index_selection.h>

#include <CGAL/Curvature_aware_simplification_report.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The noise: at few places, and at many where it is visible. Points that are too dense against it
// are left out before, and the features and the density of even samples are then those of what is
// left.
template <typename ConcurrencyTag, typename DiagonalizeTraits>
Noise_levels noise_and_enough_points(Searchable_points& cloud, Features& features, double& density,
                                     const std::vector<Depth_levels>& depth_levels,
                                     const Parameters& parameters,
                                     const Adaptive_settings& settings, const Progress& progress)
{
  const auto noise_at = [&](std::size_t number_of_places) {
    return noise_of_scan<ConcurrencyTag>(cloud.points, *cloud.search, depth_levels,
                                         number_of_places, settings);
  };
  Noise_levels noise = noise_at(few_probes);
  if (settings.thin_dense_noise &&
      thin_dense_noise<ConcurrencyTag>(cloud, noise, depth_levels, visible_error(density),
                                       parameters.number_of_output_points, settings))
  {
    features = compute_features<ConcurrencyTag, DiagonalizeTraits>(
        cloud, parameters.number_of_neighbors, progress);
    density = even_density<ConcurrencyTag>(features.inverse_density,
                                           parameters.number_of_output_points, settings.densest);
  }
  const std::size_t many = many_probes(cloud.size(), settings.most_noise_probes);
  return many > few_probes && noise.is_visible_above(visible_error(density)) ? noise_at(many)
                                                                             : noise;
}

// Measures what disturbs the input and takes it away, in this order: steps of the depth, copies,
// outliers, noise. Takes what it is given, and lets go of each part when it is not needed any more:
// the search tree is as large as all else.
template <typename ConcurrencyTag, typename DiagonalizeTraits>
Scan clean_scan(Searchable_points cloud, const Frame& frame, const Parameters& parameters,
                const Adaptive_settings& settings, const Progress& progress,
                Curvature_aware_simplification_report& report)
{
  const std::size_t number_of_samples = parameters.number_of_output_points;

  Stopwatch stopwatch;
  std::vector<Depth_levels> depth_levels; // of each camera
  if (settings.undo_rounding)
    depth_levels = undo_rounding<ConcurrencyTag>(cloud, settings);
  progress.report(0.08);
  report.depth_step =
      frame.length_from_frame(typical_step<ConcurrencyTag>(cloud.points, depth_levels));
  if (settings.merge_copies)
    report.number_of_merged_points =
        merge_copies<ConcurrencyTag>(cloud, number_of_samples, progress.part(0.08, 0.1));
  report.sorting_time += stopwatch.lap();

  const std::size_t places = cloud.size();
  Shared_features shared = compute_shared_features<ConcurrencyTag, DiagonalizeTraits>(
      cloud, parameters.number_of_neighbors, progress.part(0.1, 0.6));
  report.maximum_surface_variation = largest_surface_variation<ConcurrencyTag>(shared.features);
  report.features_time = stopwatch.lap();

  std::size_t outliers_found = 0;
  if (settings.find_outliers)
    outliers_found = leave_out_outliers<ConcurrencyTag>(cloud, shared, number_of_samples, settings,
                                                        progress.part(0.6, 0.7));
  progress.report(0.7);
  report.number_of_outliers = places - cloud.size();
  report.outliers_time = stopwatch.lap();

  Features features = std::move(shared.features);
  shared = Shared_features();
  double density =
      even_density<ConcurrencyTag>(features.inverse_density, number_of_samples, settings.densest);
  Noise_levels noise = noise_and_enough_points<ConcurrencyTag, DiagonalizeTraits>(
      cloud, features, density, depth_levels, parameters, settings, progress.part(0.7, 0.75));
  report.noise_level = frame.length_from_frame(noise.median());
  noise.widen_to_columns();
  noise.make_visible_above(visible_error(density));
  Flags is_bent = bent_points<ConcurrencyTag>(features, noise);
  const double sparse = sparseness_of(features.inverse_density).of_outliers;
  const std::size_t k = features.number_of_neighbors;
  Scan scan{std::move(cloud),
            std::move(features.inverse_density),
            std::move(noise),
            density,
            std::vector<Point>(), // known when the points are smoothed
            sparse,
            is_more_than_a_few(outliers_found, places)};
  features = Features();
  progress.report(0.75);
  report.noise_time = stopwatch.lap();

  if (settings.smooth_points && scan.noise.is_visible() &&
      scan.points.size() >= fewest_points_to_fit)
    smooth_scan<ConcurrencyTag>(scan, is_bent, number_of_samples, k, settings,
                                progress.part(0.75, 1.));
  scan.bent_points =
      elements_at<ConcurrencyTag>(flagged_indices<ConcurrencyTag>(is_bent), scan.points);
  report.smoothing_time = stopwatch.lap();
  return scan;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_CLEAN_SCAN_H
