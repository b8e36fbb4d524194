// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_CLEAN_SCAN_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_CLEAN_SCAN_H

#include <CGAL/Curvature_aware_simplification_3/internal/Adaptive_settings.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Depth_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Noise_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Progress.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Stopwatch.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Surface_fit.h>
#include <CGAL/Curvature_aware_simplification_3/internal/bent_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/find_outliers.h>
#include <CGAL/Curvature_aware_simplification_3/internal/lattice_spacing.h>
#include <CGAL/Curvature_aware_simplification_3/internal/measure_noise.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters.h>
#include <CGAL/Curvature_aware_simplification_3/internal/remove_outliers.h>
#include <CGAL/Curvature_aware_simplification_3/internal/shared_features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/smooth_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/smoothing_radii.h>
#include <CGAL/Curvature_aware_simplification_3/internal/undo_rounding.h>

#include <CGAL/Curvature_aware_simplification_report.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// What the stages that place samples see of the input: without outliers, and with less noise where
// it was visible
struct Clean_scan
{
  std::vector<Point> points; // along the Hilbert curve
  std::unique_ptr<Neighbor_search> search;
  std::vector<double> inverse_density; // 1 / rho of each point
  std::vector<std::uint8_t> is_bent;   // of each point: whether there may be an edge
  Noise_levels noise;                  // that is left
  double coordinate_error;             // of the points, from rounding in the input
  double spacing_of_samples;           // in the mean
  // Then some were not found, and the point nearest to a sample may be one.
  bool had_many_outliers;
};

// The noise of the points without outliers, and what rounding has left of depth, by place: at few
// places, and at many where it is visible
template <typename ConcurrencyTag>
Noise_levels noise_of_scan(const std::vector<Point>& points, const Neighbor_search& search,
                           const Depth_levels& depth_levels, double visible_error,
                           const Adaptive_settings& settings)
{
  // Points whose rounding was undone share what is left of it: a few hide it.
  Adaptive_settings measured = settings;
  measured.limit_noise_by_planes = settings.limit_noise_by_planes && depth_levels.heights.empty();
  const auto noise_at = [&](std::size_t number_of_probes)
  {
    Noise_levels noise =
        settings.measure_noise
            ? measure_noise<ConcurrencyTag>(points, search, number_of_probes, measured)
            : uniform_noise(0., points.size());
    if (!depth_levels.heights.empty())
      allow_for_rounding<ConcurrencyTag>(noise, points, depth_levels);
    if (!settings.noise_by_place)
      noise.make_uniform();
    return noise;
  };
  Noise_levels noise = noise_at(few_probes);
  const std::size_t many = many_probes(points.size(), settings.most_noise_probes);
  return many > few_probes && noise.is_visible_above(visible_error) ? noise_at(many) : noise;
}

// Measures what disturbs the input and takes it away, in this order: steps of the depth, outliers,
// noise. Takes what it is given, and lets go of each part when it is not needed any more: the
// search tree is as large as all else.
template <typename ConcurrencyTag, typename DiagonalizeTraits>
Clean_scan clean_scan(Cloud cloud, std::unique_ptr<Neighbor_search> search,
                      const Parameters& parameters, const Adaptive_settings& settings,
                      const Progress& progress, Curvature_aware_simplification_report& report)
{
  const std::size_t number_of_samples = parameters.number_of_output_points;
  const std::size_t distinct = cloud.size();
  const std::size_t k = neighborhood_size(parameters.number_of_neighbors, distinct) - 1;

  Stopwatch stopwatch;
  Depth_levels depth_levels;
  if (settings.undo_rounding)
    depth_levels = undo_rounding<ConcurrencyTag>(cloud, search);
  progress.report(0.1);
  report.depth_step = cloud.frame.length_from_frame(depth_levels.typical_step());
  report.sorting_time += stopwatch.lap();

  Shared_features shared = compute_shared_features<ConcurrencyTag, DiagonalizeTraits>(
      cloud, *search, parameters.number_of_neighbors, progress.part(0.1, 0.6));
  report.maximum_surface_variation = largest_surface_variation<ConcurrencyTag>(shared.features);
  report.features_time = stopwatch.lap();

  cloud.input_index = std::vector<std::size_t>(); // where points come from is not asked any more
  cloud.duplicates = std::vector<Duplicate>();
  std::size_t outliers_found = 0;
  if (settings.find_outliers)
    outliers_found = remove_outliers<ConcurrencyTag>(cloud, search, shared, k, number_of_samples,
                                                     settings, progress.part(0.6, 0.7));
  progress.report(0.7);
  report.number_of_outliers = distinct - cloud.size();
  report.outliers_time = stopwatch.lap();

  const double spacing_of_samples =
      lattice_spacing(static_cast<double>(number_of_samples) /
                      area_of_surface<ConcurrencyTag>(shared.features.inverse_density));
  // Wider fits are worth their time only where the error is visible: beyond 1 % of the spacing.
  const double visible_error = 0.01 * spacing_of_samples;
  Noise_levels noise =
      noise_of_scan<ConcurrencyTag>(cloud.points, *search, depth_levels, visible_error, settings);
  report.noise_level = cloud.frame.length_from_frame(noise.median());
  noise.widen_to_columns();
  noise.make_visible_above(visible_error);
  const bool are_enough_to_fit = cloud.size() >= fewest_points_to_fit;
  std::vector<std::uint8_t> is_bent = bent_points<ConcurrencyTag>(shared.features, k, noise);
  Clean_scan scan{std::move(cloud.points),
                  std::move(search),
                  std::move(shared.features.inverse_density),
                  std::move(is_bent),
                  std::move(noise),
                  cloud.coordinate_error,
                  spacing_of_samples,
                  is_more_than_a_few(outliers_found, distinct)};
  shared = Shared_features();
  progress.report(0.75);
  report.noise_time = stopwatch.lap();

  if (settings.smooth_points && scan.noise.is_visible() && are_enough_to_fit)
  {
    set_smoothing_radii<ConcurrencyTag>(scan.noise, scan.points, *scan.search, spacing_of_samples,
                                        settings);
    scan.noise = smooth_points<ConcurrencyTag>(scan.points, scan.inverse_density, scan.is_bent,
                                               *scan.search, scan.noise, number_of_samples,
                                               settings, progress.part(0.75, 0.95));
    scan.inverse_density = std::vector<double>(); // of the points as they were
    scan.search.reset(); // two trees at once would take the most memory of the call
    scan.search = std::make_unique<Neighbor_search>(scan.points, ConcurrencyTag());
    progress.report(0.96);
    // Noise carries points apart: in a layer of half a spacing of the samples, the area of the
    // surface looked twice as large. Frames put them on top of each other, and it looked smaller.
    scan.inverse_density =
        inverse_densities<ConcurrencyTag>(scan.points, *scan.search, k, progress.part(0.96, 1.));
    scan.spacing_of_samples =
        lattice_spacing(static_cast<double>(number_of_samples) /
                        area_of_surface<ConcurrencyTag>(scan.inverse_density));
  }
  report.smoothing_time = stopwatch.lap();
  return scan;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_CLEAN_SCAN_H
