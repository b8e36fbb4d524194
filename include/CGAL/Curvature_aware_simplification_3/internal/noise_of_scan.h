// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_OF_SCAN_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_OF_SCAN_H

#include <CGAL/Curvature_aware_simplification_3/internal/Adaptive_settings.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Depth_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Noise_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Noise_probes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/measure_noise.h>
#include <CGAL/Curvature_aware_simplification_3/internal/undo_rounding.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

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

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_OF_SCAN_H
