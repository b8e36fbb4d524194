// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PAPER_SIMPLIFY_AS_IN_THE_PAPER_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PAPER_SIMPLIFY_AS_IN_THE_PAPER_H

#include <CGAL/Curvature_aware_simplification_3/internal/features/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/paper/relax_repeatedly.h>
#include <CGAL/Curvature_aware_simplification_3/internal/paper/sample_spacing.h>
#include <CGAL/Curvature_aware_simplification_3/internal/paper/select_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Parameters.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/Distinct_samples.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Stopwatch.h>

#include <CGAL/Curvature_aware_simplification_report.h>

#include <algorithm>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The selection of sec. 4.1 and the relaxation of eq. 8, literally: the samples in the frame
template <typename ConcurrencyTag, typename DiagonalizeTraits>
Distinct_samples simplify_as_in_the_paper(const Cloud& cloud, const Parameters& parameters,
                                          const Progress& progress,
                                          Curvature_aware_simplification_report& report)
{
  Stopwatch stopwatch;
  const Features features = compute_features<ConcurrencyTag, DiagonalizeTraits>(
      cloud, parameters.number_of_neighbors, progress.part(0., 0.5));
  report.features_time = stopwatch.lap();
  report.maximum_surface_variation = largest_surface_variation<ConcurrencyTag>(features);

  Distinct_samples samples = distinct_samples<ConcurrencyTag>(
      cloud, select_points<ConcurrencyTag>(cloud, features, parameters));
  report.selection_time = stopwatch.lap();

  const double spacing = sample_spacing<ConcurrencyTag>(samples.points);
  // Of a radius that is far larger than all distances, squares must be numbers; theta is 1.
  constexpr double largest_radius = 1e100;
  const double h =
      parameters.neighbor_radius
          ? (std::min)(cloud.frame.length_to_frame(*parameters.neighbor_radius), largest_radius)
          : radius_in_spacings * spacing;
  // A ball smaller than the rounding error of the coordinates holds nothing but its center.
  if (h > cloud.coordinate_error)
    samples.points = relax_repeatedly<ConcurrencyTag, DiagonalizeTraits>(
        samples.points, cloud, features, h, parameters, progress.part(0.5, 1.));
  report.relaxation_time = stopwatch.lap();
  report.output_spacing = cloud.frame.length_from_frame(spacing);
  report.neighbor_radius = parameters.neighbor_radius.value_or(cloud.frame.length_from_frame(h));
  return samples;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PAPER_SIMPLIFY_AS_IN_THE_PAPER_H
