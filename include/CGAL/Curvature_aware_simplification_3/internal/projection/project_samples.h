// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_PROJECT_SAMPLES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_PROJECT_SAMPLES_H

#include <CGAL/Curvature_aware_simplification_3/internal/Scan.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Surface_fit.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/fit_to_neighbors.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Parameters.h>
#include <CGAL/Curvature_aware_simplification_3/internal/projection/correct_by_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/projection/denoise_samples.h>
#include <CGAL/Curvature_aware_simplification_3/internal/projection/even_out_samples.h>
#include <CGAL/Curvature_aware_simplification_3/internal/projection/move_to_corners.h>
#include <CGAL/Curvature_aware_simplification_3/internal/projection/move_to_edges.h>
#include <CGAL/Curvature_aware_simplification_3/internal/projection/separate_copies.h>
#include <CGAL/Curvature_aware_simplification_3/internal/projection/stay_near_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/Sample_neighbors.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/Surface_sample.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Computation_kernel.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Progress.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Moves samples that have their places along the surface onto it: the step from a fit that is good
// enough to move on to what the points around say in all. `neighbors` are those of about these
// places.
template <typename ConcurrencyTag>
void project_samples(std::vector<Surface_sample>& samples, const Sample_neighbors& neighbors,
                     const Scan& scan, const Surface_fitter& fitter, const Parameters& parameters,
                     const Progress& progress)
{
  std::vector<Point> nearest(samples.size());
  for_each_index<ConcurrencyTag>(samples.size(), progress.part(0., 0.4), [&](std::size_t i) {
    Surface_sample& x = samples[i];
    nearest[i] = x.place(fitter.at(*x.noise), x.point, x.normal(), rounds_to_stay);
  });
  if (fitter.settings.denoise && scan.noise.is_visible())
    denoise_samples<ConcurrencyTag>(samples, fitter, progress.part(0.4, 0.75));
  if (fitter.settings.even_out && scan.noise.is_visible())
    even_out_samples<ConcurrencyTag>(samples, neighbors, fitter, parameters,
                                     progress.part(0.75, 0.8));
  if (fitter.settings.correct_by_points && !scan.had_more_than_a_few_outliers)
    correct_by_points<ConcurrencyTag>(samples, nearest, neighbors, *scan.search);
  if (fitter.settings.move_to_edges)
    move_to_edges<ConcurrencyTag>(samples, neighbors, fitter, scan.bent_points,
                                  progress.part(0.8, 0.93));
  if (fitter.settings.move_to_corners)
    move_to_corners<ConcurrencyTag>(samples, neighbors, fitter, progress.part(0.93, 1.));
  if (fitter.settings.stay_near_points)
    stay_near_points<ConcurrencyTag>(samples, nearest, *scan.search);
  separate_copies<ConcurrencyTag>(samples, neighbors, *scan.search);
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_PROJECT_SAMPLES_H
