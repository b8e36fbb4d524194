// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_NOISE_OF_SCAN_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_NOISE_OF_SCAN_H

#include <CGAL/Curvature_aware_simplification_3/internal/depth/Depth_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Searchable_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Noise_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/measure_noise.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Adaptive_settings.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/lattice_spacing.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <algorithm>
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

// The noise that rounding leaves, a third of what it caused (the standard deviation of what is
// rounded away is 0.29 steps): neighbors share it, so that those who measure noise do not see it.
// With 0.05 or 0.15 instead of 0.1, the mean error of single frames of a camera is 2 % larger;
// without, 14 %.
template <typename ConcurrencyTag>
void allow_for_rounding(Noise_levels& noise, const std::vector<Point>& points,
                        const std::vector<Depth_levels>& levels)
{
  constexpr double error_in_steps = 0.1;
  for_each_index<ConcurrencyTag>(0, noise.of_range.size(), [&](std::size_t range) {
    const std::size_t begin = noise.first_point[range], end = noise.first_point[range + 1];
    if (begin == end)
      return;
    const Point& p = points[begin + (end - begin) / 2];
    const double error = error_in_steps * step_at(p, levels);
    Noise& here = noise.of_range[range];
    here.level = (std::max)(here.level, error);
    here.independent_level = (std::max)(here.independent_level, error);
  });
}

// The noise of the points without outliers, and what rounding has left of depth, by place
template <typename ConcurrencyTag>
Noise_levels noise_of_scan(const Searchable_points& cloud,
                           const std::vector<Depth_levels>& depth_levels,
                           std::size_t number_of_probes, const Adaptive_settings& settings)
{
  const bool was_rounded = !depth_levels.empty();
  Noise_levels noise =
      settings.measure_noise
          ? measure_noise<ConcurrencyTag>(cloud, number_of_probes, was_rounded, settings)
          : uniform_noise(0., cloud.size());
  if (was_rounded)
    allow_for_rounding<ConcurrencyTag>(noise, cloud.points, depth_levels);
  if (!settings.noise_by_place)
    noise.make_uniform();
  return noise;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_NOISE_OF_SCAN_H
