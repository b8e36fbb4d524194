// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SIMPLIFY_ADAPTIVELY_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SIMPLIFY_ADAPTIVELY_H

#include <CGAL/Curvature_aware_simplification_3/internal/Cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Distinct_samples.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Stopwatch.h>
#include <CGAL/Curvature_aware_simplification_3/internal/correct_by_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/denoise_samples.h>
#include <CGAL/Curvature_aware_simplification_3/internal/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/find_outliers.h>
#include <CGAL/Curvature_aware_simplification_3/internal/loops.h>
#include <CGAL/Curvature_aware_simplification_3/internal/measure_noise.h>
#include <CGAL/Curvature_aware_simplification_3/internal/move_to_corners.h>
#include <CGAL/Curvature_aware_simplification_3/internal/move_to_edges.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters.h>
#include <CGAL/Curvature_aware_simplification_3/internal/prefix_sums.h>
#include <CGAL/Curvature_aware_simplification_3/internal/relax_on_surface.h>
#include <CGAL/Curvature_aware_simplification_3/internal/remove_outliers.h>
#include <CGAL/Curvature_aware_simplification_3/internal/sampling_density.h>
#include <CGAL/Curvature_aware_simplification_3/internal/select_along_curve.h>
#include <CGAL/Curvature_aware_simplification_3/internal/select_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/shared_features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/smooth_points.h>
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

// The samples, in the frame. All that the stages need is measured in the input: outliers, noise,
// density, curvature at the distance of the samples. Takes what it is given, and lets go of each part
// when it is not needed any more: the search tree is as large as all else.
template <typename ConcurrencyTag, typename DiagonalizeTraits>
Distinct_samples simplify_adaptively(Cloud cloud, std::unique_ptr<Neighbor_search> search,
                                     const Parameters& parameters,
                                     const Adaptive_settings& settings, const Progress& progress,
                                     Curvature_aware_simplification_report& report)
{
  Stopwatch stopwatch;
  const std::size_t number_of_samples = parameters.number_of_output_points;
  const bool takes_all = number_of_samples >= cloud.size(); // and duplicates
  // A fit to more than a third of all points does not tell what is between them: samples of 19 to 45 points on a sphere
  // would be up to 0.7 to 0.4 of its radius off it, of 57 points 0.14.
  const bool are_too_few = cloud.size() < 3 * smallest_neighborhood;
  Depth_levels depth_levels;
  if (settings.undo_rounding && !takes_all && !are_too_few)
    depth_levels = undo_rounding<ConcurrencyTag>(cloud, search);
  report.depth_step = cloud.frame.length_from_frame(depth_levels.typical_step());
  report.sorting_time += stopwatch.lap();

  Shared_features shared = compute_shared_features<ConcurrencyTag, DiagonalizeTraits>(
      cloud, *search, parameters.number_of_neighbors, progress.part(0., 0.3));
  Features& features = shared.features;
  report.features_time = stopwatch.lap();
  report.maximum_surface_variation = largest_curvature<ConcurrencyTag>(features);

  if (takes_all)
    return distinct_samples<ConcurrencyTag>(
        cloud, select_points<ConcurrencyTag>(cloud, features, parameters));
  if (are_too_few)
  {
    const std::vector<std::size_t> selected = select_along_curve<ConcurrencyTag>(
        Curve_ranges{1, cloud.size()}, {1.}, number_of_samples, parameters.random_seed);
    return {elements_at<ConcurrencyTag>(selected, cloud.points),
            std::vector<std::size_t>(number_of_samples, 1)};
  }

  cloud.input_index = std::vector<std::size_t>(); // where points come from is not asked any more
  cloud.duplicates = std::vector<Duplicate>();
  std::vector<Point>& points = cloud.points;
  const std::size_t distinct = points.size();
  const std::size_t k = neighborhood_size(parameters.number_of_neighbors, distinct) - 1;
  if (settings.find_outliers)
    remove_outliers<ConcurrencyTag>(cloud, search, shared, k, number_of_samples, settings);
  report.number_of_outliers = distinct - points.size();
  // Then the point nearest to a sample may be one that was not found.
  const bool are_outliers_many = is_more_than_a_few(distinct - points.size(), distinct);
  report.outliers_time = stopwatch.lap();

  Noise_levels noise = settings.measure_noise
                           ? measure_noise<ConcurrencyTag>(points, *search, settings)
                           : uniform_noise(0., points.size());
  if (!depth_levels.heights.empty())
    allow_for_rounding<ConcurrencyTag>(noise, points, depth_levels);
  report.noise_level = cloud.frame.length_from_frame(noise.median());
  noise.widen_to_columns();
  if (!settings.noise_by_place)
    noise = uniform_noise(noise.median(), points.size());
  std::vector<std::uint8_t> is_bent = bent_points<ConcurrencyTag>(features, k, noise);
  features.curvature = std::vector<double>();
  report.noise_time = stopwatch.lap();

  const double mean_spacing =
      lattice_spacing(static_cast<double>(number_of_samples) /
                      area_of_surface<ConcurrencyTag>(features.inverse_density));
  // Wider fits are worth their time only where the error is visible: beyond 1 % of the spacing.
  noise.make_visible_above(0.01 * mean_spacing);

  if (settings.smooth_points && noise.is_visible())
  {
    noise = smooth_points<ConcurrencyTag>(points, features.inverse_density, is_bent, *search, noise,
                                          number_of_samples, mean_spacing, settings,
                                          progress.part(0.3, 0.4));
    search.reset();
    search = std::make_unique<Neighbor_search>(points, ConcurrencyTag());
  }
  report.smoothing_time = stopwatch.lap();

  const Surface_fit fit{*search, points.size(), Noise(), settings}; // each sample has its own noise
  std::vector<Surface_sample> samples(number_of_samples);
  std::vector<std::size_t> selected;
  {
    const Sampling_density wanted = sampling_density<ConcurrencyTag>(
        points, features.inverse_density, number_of_samples, parameters.adaptivity, noise,
        cloud.coordinate_error, settings, progress.part(0.4, 0.5));
    features = Features();
    selected = select_along_curve<ConcurrencyTag>(wanted.ranges, wanted.weight, number_of_samples,
                                                  parameters.random_seed);
    for_each_index<ConcurrencyTag>(0, samples.size(),
                                   [&](std::size_t i)
                                   {
      samples[i].spacing = lattice_spacing(wanted.density[wanted.ranges.range_of(selected[i])]);
      samples[i].noise = noise.at(selected[i]);
    });
  }
  report.selection_time = stopwatch.lap();

  for_each_index<ConcurrencyTag>(samples.size(), progress.part(0.5, 0.6),
                                 [&](std::size_t i)
                                 {
    samples[i].place(fit.with(samples[i].noise), points[selected[i]], NULL_VECTOR, rounds_to_move);
  });
  const Sample_neighbors neighbors =
      relax_on_surface<ConcurrencyTag>(samples, fit, parameters.number_of_iterations,
                                       parameters.repulsion_weight, progress.part(0.6, 0.85));
  report.relaxation_time = stopwatch.lap();

  std::vector<Point> nearest(samples.size());
  for_each_index<ConcurrencyTag>(samples.size(), progress.part(0.85, 0.91),
                                 [&](std::size_t i)
                                 {
    Surface_sample& x = samples[i];
    nearest[i] = x.place(fit.with(x.noise), x.point, x.normal, rounds_to_stay);
  });
  if (settings.correct_by_points && !are_outliers_many)
    correct_by_points<ConcurrencyTag>(samples, nearest, neighbors, fit);
  if (settings.denoise && noise.is_visible())
    denoise_samples<ConcurrencyTag>(samples, fit, progress.part(0.91, 0.97));
  if (settings.move_to_edges)
  {
    const std::vector<Point> bent =
        elements_at<ConcurrencyTag>(indices_where<ConcurrencyTag>(points.size(), [&](std::size_t i)
                                                                  { return is_bent[i] != 0; }),
                                    points);
    move_to_edges<ConcurrencyTag>(samples, neighbors, fit, bent, progress.part(0.97, 0.99));
  }
  if (settings.move_to_corners)
    move_to_corners<ConcurrencyTag>(samples, neighbors, fit, progress.part(0.99, 1.));
  std::vector<Point> result = points_of<ConcurrencyTag>(samples);
  report.projection_time = stopwatch.lap();

  report.output_spacing = cloud.frame.length_from_frame(mean_spacing);
  return {std::move(result), std::vector<std::size_t>(number_of_samples, 1)};
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SIMPLIFY_ADAPTIVELY_H
