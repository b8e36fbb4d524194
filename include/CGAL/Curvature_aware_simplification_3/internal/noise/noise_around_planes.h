// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_NOISE_AROUND_PLANES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_NOISE_AROUND_PLANES_H

#include <CGAL/Curvature_aware_simplification_3/internal/noise/Layer.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Noise_probes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Planes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/columns_of_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/layers_of_two_sizes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/limits_of_noise.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Adaptive_settings.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// What planes show of the noise of a range
struct Noise_around_planes
{
  bool is_known = false; // if not, they tell nothing but the limit
  bool is_reliable = false;
  double level = 0.;
  double limit = std::numeric_limits<double>::infinity(); // the noise is no more than this
};

// The noise of each range that layers around planes show, which reach two thirds as far as those
// around quadrics: they see only one side of a part that is as thick as 1.6 spacings of the points,
// and less of details that these hardly show. Where points share errors, as what is left of the
// rounding of depth, a few hide it and set no limit.
template <typename ConcurrencyTag>
std::vector<Noise_around_planes>
noise_around_planes(const Noise_probes& probes, const Planes& planes_of_7, const Columns& columns,
                    bool points_share_errors, const Adaptive_settings& settings)
{
  // A plane turns along the noise as well: with 5, it shows up to a tenth too little of it.
  constexpr double wide_enough = 6.;

  const std::vector<std::size_t> ranges = all_ranges(probes);
  const bool set_limits = settings.limit_noise_by_planes && !points_share_errors;
  const std::vector<Layer> wide =
      median_layers<ConcurrencyTag>(probes, ranges, 2 * points_of_ring, Layer_around_plane());
  std::vector<Noise_around_planes> noise(ranges.size());
  std::vector<std::size_t> to_limit;
  for (std::size_t range : ranges)
  {
    const Layer& narrow = planes_of_7.layer[range];
    const bool in_columns = columns.exist[range] != 0;
    const bool stands =
        settings.tell_standing_fits && planes_of_7.tilt[range] > largest_tilt_of_planes;
    Noise_around_planes& here = noise[range];
    here.is_known = !in_columns && narrow.is_broad() && !stands;
    here.level = noise_of_layers(narrow, wide[range]);
    here.is_reliable = here.is_known && narrow.width >= wide_enough * narrow.thickness;
    if (set_limits && !in_columns && !here.is_reliable)
      to_limit.push_back(range);
  }
  const std::vector<double> limits = limits_of_noise<ConcurrencyTag>(probes, to_limit, planes_of_7);
  for (std::size_t range : to_limit)
    noise[range].limit = limits[range];
  return noise;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_NOISE_AROUND_PLANES_H
