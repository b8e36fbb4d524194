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
#include <CGAL/Curvature_aware_simplification_3/internal/input/Frame.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Searchable_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Noise_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Noise_probes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/bent_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/noise_of_scan.h>
#include <CGAL/Curvature_aware_simplification_3/internal/outliers/leave_out_outliers.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Adaptive_settings.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Parameters.h>
#include <CGAL/Curvature_aware_simplification_3/internal/smoothing/smooth_scan.h>
#include <CGAL/Curvature_aware_simplification_3/internal/smoothing/thin_dense_noise.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Flags.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Progress.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Stopwatch.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/index_selection.h>

#include <CGAL/Curvature_aware_simplification_report.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Points that are taken for those of a surface, and what is known of them
struct Surface_points : Searchable_points
{
  Features features;
  double even_density; // of samples that are spread evenly, see even_density()
  bool had_more_than_a_few_outliers;
};

// Takes away what would spoil the features: steps of the depth, and copies of places. Returns the
// levels that each camera rounded depth to.
template <typename ConcurrencyTag>
std::vector<Depth_levels>
restore_places(Searchable_points& cloud, const Frame& frame, std::size_t number_of_samples,
               const Adaptive_settings& settings, const Progress& progress,
               Curvature_aware_simplification_report& report)
{
  std::vector<Depth_levels> depth_levels;
  if (settings.undo_rounding)
    depth_levels = undo_rounding<ConcurrencyTag>(cloud, settings);
  progress.report(0.8);
  report.depth_step =
      frame.length_from_frame(typical_step<ConcurrencyTag>(cloud.points, depth_levels));
  if (settings.merge_copies)
    report.number_of_merged_points =
        merge_copies<ConcurrencyTag>(cloud, number_of_samples, progress.part(0.8, 1.));
  return depth_levels;
}

// The features, and the points that they do not show to be outliers
template <typename ConcurrencyTag, typename DiagonalizeTraits>
Surface_points without_outliers(Searchable_points cloud, const Parameters& parameters,
                                const Adaptive_settings& settings, const Progress& progress,
                                Curvature_aware_simplification_report& report)
{
  Stopwatch stopwatch;
  const std::size_t number_of_samples = parameters.number_of_output_points;
  const std::size_t places = cloud.size();
  Shared_features shared = compute_shared_features<ConcurrencyTag, DiagonalizeTraits>(
      cloud, parameters.number_of_neighbors, progress.part(0., 0.8));
  report.maximum_surface_variation = largest_surface_variation<ConcurrencyTag>(shared.features);
  report.features_time = stopwatch.lap();

  std::size_t found = 0;
  if (settings.find_outliers)
    found = leave_out_outliers<ConcurrencyTag>(cloud, shared, number_of_samples, settings,
                                               progress.part(0.8, 1.));
  progress.report(1.);
  report.number_of_outliers = places - cloud.size();
  const double density = even_density<ConcurrencyTag>(shared.features.inverse_density,
                                                      number_of_samples, settings.densest);
  report.outliers_time = stopwatch.lap();
  return {std::move(cloud), std::move(shared.features), density, is_more_than_a_few(found, places)};
}

// The noise: at few places, and at many where it is visible. Points that are too dense against it
// are left out before, and the features and the density of even samples are then those of what is
// left.
template <typename ConcurrencyTag, typename DiagonalizeTraits>
Noise_levels noise_of_enough_points(Surface_points& points,
                                    const std::vector<Depth_levels>& depth_levels,
                                    const Parameters& parameters, const Adaptive_settings& settings,
                                    const Progress& progress)
{
  const auto noise_at = [&](std::size_t number_of_places) {
    return noise_of_scan<ConcurrencyTag>(points, depth_levels, number_of_places, settings);
  };
  const std::size_t number_of_samples = parameters.number_of_output_points;
  Noise_levels noise = noise_at(few_probes);
  if (settings.thin_dense_noise &&
      thin_dense_noise<ConcurrencyTag>(points, noise, depth_levels,
                                       visible_error(points.even_density), number_of_samples,
                                       settings))
  {
    points.features = compute_features<ConcurrencyTag, DiagonalizeTraits>(
        points, parameters.number_of_neighbors, progress);
    points.even_density = even_density<ConcurrencyTag>(points.features.inverse_density,
                                                       number_of_samples, settings.densest);
  }
  const std::size_t many = many_probes(points.size(), settings.most_noise_probes);
  return many > few_probes && noise.is_visible_above(visible_error(points.even_density))
             ? noise_at(many)
             : noise;
}

// Without the features that no later stage needs; at which points there may be an edge is known
// when these are smoothed.
inline Scan scan_of(Surface_points points, Noise_levels noise)
{
  const double sparse = sparseness_of(points.features.inverse_density).of_outliers;
  return {static_cast<Searchable_points&&>(points),
          std::move(points.features.inverse_density),
          std::move(noise),
          points.even_density,
          std::vector<Point>(),
          sparse,
          points.had_more_than_a_few_outliers};
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
  const std::vector<Depth_levels> depth_levels = restore_places<ConcurrencyTag>(
      cloud, frame, number_of_samples, settings, progress.part(0., 0.1), report);
  report.sorting_time += stopwatch.lap();

  Surface_points points = without_outliers<ConcurrencyTag, DiagonalizeTraits>(
      std::move(cloud), parameters, settings, progress.part(0.1, 0.7), report);
  stopwatch.lap(); // reported there

  Noise_levels noise = noise_of_enough_points<ConcurrencyTag, DiagonalizeTraits>(
      points, depth_levels, parameters, settings, progress.part(0.7, 0.75));
  report.noise_level = frame.length_from_frame(noise.median());
  noise.widen_to_columns();
  noise.make_visible_above(visible_error(points.even_density));
  Flags is_bent = bent_points<ConcurrencyTag>(points.features, noise);
  const std::size_t k = points.features.number_of_neighbors;
  Scan scan = scan_of(std::move(points), std::move(noise));
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
