// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SIMPLIFY_ADAPTIVELY_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SIMPLIFY_ADAPTIVELY_H

#include <CGAL/Curvature_aware_simplification_3/internal/clean_scan.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Surface_fit.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Frame.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Searchable_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Adaptive_settings.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Parameters.h>
#include <CGAL/Curvature_aware_simplification_3/internal/projection/insert_samples.h>
#include <CGAL/Curvature_aware_simplification_3/internal/projection/project_samples.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/Distinct_samples.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/Surface_sample.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/relax_on_surface.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/select_along_curve.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/select_samples.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Curve_ranges.h>
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

// Points as they are, evenly along the Hilbert curve, where there are too few to fit a surface
template <typename ConcurrencyTag>
Distinct_samples select_without_moving(const std::vector<Point>& points,
                                       const Parameters& parameters)
{
  const std::size_t number = parameters.number_of_output_points;
  const std::vector<std::size_t> selected = select_along_curve<ConcurrencyTag>(
      Curve_ranges{1, points.size()}, {1.}, number, parameters.random_seed);
  return {elements_at<ConcurrencyTag>(selected, points), std::vector<std::size_t>(number, 1)};
}

// The samples, in the frame. All that the stages need is measured in the input: outliers, noise,
// density, curvature at the distance of the samples. Where to find the method of the paper:
//
//   kappa and rho (sec. 4.1, step 1)           clean_scan(), which also has what raw scans need
//   the selection by them (sec. 4.1)           select_samples(), by curvature at the spacing
//   attraction by points (eq. 8, first term)   place_on_surface(), a fit to them
//   repulsion by samples (eq. 8, second term)  relax_on_surface(), in the tangent plane
//
// and project_samples() for the last fit. Each stage has a folder, in the order of the data:
// input/, depth/, copies/, features/, outliers/, noise/, smoothing/, density/, samples/,
// projection/; they share fitting/ and tools/. The literal method is in paper/. The cloud is taken,
// since each stage lets go of what no later one needs.
template <typename ConcurrencyTag, typename DiagonalizeTraits>
Distinct_samples simplify_adaptively(Cloud cloud, const Parameters& parameters,
                                     const Adaptive_settings& settings, const Progress& progress,
                                     Curvature_aware_simplification_report& report)
{
  if (parameters.number_of_output_points >= cloud.size())
    return all_and_duplicates<ConcurrencyTag>(cloud, parameters.number_of_output_points,
                                              parameters.random_seed);
  if (cloud.size() < fewest_points_to_fit)
    return select_without_moving<ConcurrencyTag>(cloud.points, parameters);
  const Frame frame = cloud.frame;
  Searchable_points distinct = without_positions(std::move(cloud)); // whose end frees them
  Scan scan = clean_scan<ConcurrencyTag, DiagonalizeTraits>(
      std::move(distinct), frame, parameters, settings, progress.part(0., 0.4), report);
  report.output_spacing = frame.length_from_frame(scan.spacing());
  if (scan.points.size() < fewest_points_to_fit)
    return select_without_moving<ConcurrencyTag>(scan.points, parameters);

  Stopwatch stopwatch;
  const std::size_t number_to_insert = samples_to_insert(
      scan, parameters.number_of_output_points, parameters.adaptivity * settings.share_to_insert);
  std::vector<Surface_sample> samples =
      select_samples<ConcurrencyTag>(scan, parameters.number_of_output_points - number_to_insert,
                                     parameters, settings, progress.part(0.4, 0.5));
  report.selection_time = stopwatch.lap();

  const Surface_fitter fitter{*scan.search, settings, scan.sparse_inverse_density};
  place_on_surface<ConcurrencyTag>(samples, fitter, progress.part(0.5, 0.6));
  const Sample_neighbors neighbors =
      relax_on_surface<ConcurrencyTag>(samples, fitter, parameters.number_of_iterations,
                                       parameters.repulsion_weight, progress.part(0.6, 0.85));
  report.relaxation_time = stopwatch.lap();

  project_samples<ConcurrencyTag>(samples, neighbors, scan, fitter, parameters,
                                  progress.part(0.85, 1.));
  insert_samples<ConcurrencyTag>(samples, number_to_insert, neighbors, scan);
  std::vector<Point> points = points_of<ConcurrencyTag>(samples);
  report.projection_time = stopwatch.lap();
  return {std::move(points), std::vector<std::size_t>(samples.size(), 1)};
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SIMPLIFY_ADAPTIVELY_H
