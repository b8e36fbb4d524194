// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_NOISE_OF_SCAN_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_NOISE_OF_SCAN_H

#include <CGAL/Curvature_aware_simplification_3/internal/density/lattice_spacing.h>
#include <CGAL/Curvature_aware_simplification_3/internal/depth/Depth_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/depth/undo_rounding.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Noise_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Noise_probes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/measure_noise.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Adaptive_settings.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The error of samples that is visible: 1 % of their spacing if they are spread evenly. Only beyond
// that are wider fits worth their time.
inline double visible_error(double even_density)
{
  return 0.01 * lattice_spacing(even_density);
}

// The noise of the points without outliers, and what rounding has left of depth, by place
template <typename ConcurrencyTag>
Noise_levels noise_of_scan(const std::vector<Point>& points, const Neighbor_search& search,
                           const Depth_levels& depth_levels, std::size_t number_of_probes,
                           const Adaptive_settings& settings)
{
  // Points whose rounding was undone share what is left of it: a few hide it.
  Adaptive_settings measured = settings;
  measured.limit_noise_by_planes = settings.limit_noise_by_planes && depth_levels.heights.empty();
  Noise_levels noise =
      settings.measure_noise
          ? measure_noise<ConcurrencyTag>(points, search, number_of_probes, measured)
          : uniform_noise(0., points.size());
  if (!depth_levels.heights.empty())
    allow_for_rounding<ConcurrencyTag>(noise, points, depth_levels);
  if (!settings.noise_by_place)
    noise.make_uniform();
  return noise;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_NOISE_OF_SCAN_H
