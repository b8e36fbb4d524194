// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SMOOTHING_SMOOTH_SCAN_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SMOOTHING_SMOOTH_SCAN_H

#include <CGAL/Curvature_aware_simplification_3/internal/Scan.h>
#include <CGAL/Curvature_aware_simplification_3/internal/density/even_density.h>
#include <CGAL/Curvature_aware_simplification_3/internal/features/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Noise_probes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Adaptive_settings.h>
#include <CGAL/Curvature_aware_simplification_3/internal/smoothing/smooth_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/smoothing/smoothing_radii.h>
#include <CGAL/Curvature_aware_simplification_3/internal/smoothing/spare_thin_parts.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Flags.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Progress.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Uninitialized_vector.h>

#include <cstddef>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Takes visible noise away, and measures again what the smoothed points tell. `is_bent` is 1 for
// points of the scan at which there may be an edge, and k the number of neighbors for densities.
template <typename ConcurrencyTag>
void smooth_scan(Scan& scan, Flags& is_bent, std::size_t number_of_samples, std::size_t k,
                 const Adaptive_settings& settings, const Progress& progress)
{
  const Noise_probes probes = smoothing_probes<ConcurrencyTag>(scan, settings);
  if (settings.spare_thin_parts)
    spare_thin_parts<ConcurrencyTag>(scan.noise, probes, settings);
  set_smoothing_radii<ConcurrencyTag>(scan.noise, probes, scan.spacing(), settings);
  scan.noise = smooth_points<ConcurrencyTag>(scan.points, scan.inverse_density, is_bent,
                                             *scan.search, scan.noise, number_of_samples, settings,
                                             progress.part(0., 0.8));
  scan.inverse_density = Uninitialized_vector<double>(); // of the points as they were
  scan.rebuild_search<ConcurrencyTag>();
  progress.report(0.84);
  // Noise carries points apart: in a layer of half a spacing of the samples, the area of the
  // surface looked twice as large. Frames put them on top of each other, and it looked smaller.
  scan.inverse_density = inverse_densities<ConcurrencyTag>(scan, k, progress.part(0.84, 1.));
  scan.even_density =
      even_density<ConcurrencyTag>(scan.inverse_density, number_of_samples, settings.densest);
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SMOOTHING_SMOOTH_SCAN_H
