// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_NOISE_AROUND_PLANES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_NOISE_AROUND_PLANES_H

#include <CGAL/Curvature_aware_simplification_3/internal/noise/Layer.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Noise_probes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Shown_noise.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/columns_of_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/limits_of_noise.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/parallel_axes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/tilts_of_planes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Adaptive_settings.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Flags.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The noise of each range that layers around planes show, which reach two thirds as far as those
// around quadrics: they see only one side of a part that is as thick as 1.6 spacings of the points,
// and less of details that these hardly show.
template <typename ConcurrencyTag>
std::vector<Shown_noise> noise_around_planes(const Noise_probes& probes,
                                             const Neighbor_search& search,
                                             const Adaptive_settings& settings)
{
  constexpr std::size_t k = 7; // a point and the ring around it
  // A plane turns along the noise as well: with 5, it shows up to a tenth too little of it.
  constexpr double wide_enough = 6.;
  // What is turned by less is in the surface, and not asked: noise turns planes by 0.25 to 0.45,
  // columns by 0.65 to 1.
  constexpr double tilt_along_columns = 0.4;

  const std::vector<std::size_t> ranges = all_ranges(probes);
  const auto layers = [&](std::size_t number) {
    return median_layers<ConcurrencyTag>(probes, ranges, search, number, Layer_around_plane());
  };
  const std::vector<Layer> narrow = layers(k), wide = layers(2 * k);
  const std::vector<double> tilts = median_tilts<ConcurrencyTag>(probes, ranges, search, k);
  std::vector<Vector> axes(ranges.size(), NULL_VECTOR);
  Flags in_columns(ranges.size(), 0);
  if (settings.find_columns)
  {
    std::vector<std::size_t> suspects; // elsewhere, planes are in the surface
    std::copy_if(ranges.begin(), ranges.end(), std::back_inserter(suspects),
                 [&](std::size_t range) {
                   return tilts[range] > tilt_along_columns || !narrow[range].is_broad();
                 });
    axes = parallel_axes<ConcurrencyTag>(probes, suspects, search);
    in_columns = find_columns<ConcurrencyTag>(probes, suspects, axes, search);
  }
  std::vector<Shown_noise> noise(ranges.size());
  std::vector<std::size_t> to_limit;
  for (std::size_t range : ranges)
  {
    Shown_noise& here = noise[range];
    here.axis = axes[range];
    here.is_in_columns = in_columns[range] != 0;
    const bool stands = settings.tell_standing_fits && tilts[range] > largest_tilt_of_planes;
    here.is_known = !here.is_in_columns && narrow[range].is_broad() && !stands;
    here.level = noise_of_layers(narrow[range], wide[range]);
    here.is_reliable =
        here.is_known && narrow[range].width >= wide_enough * narrow[range].thickness;
    if (settings.limit_noise_by_planes && !here.is_in_columns && !here.is_reliable)
      to_limit.push_back(range);
  }
  const std::vector<double> limits =
      limits_of_noise<ConcurrencyTag>(probes, to_limit, search, narrow, tilts);
  for (std::size_t range : to_limit)
    noise[range].limit = limits[range];
  return noise;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_NOISE_AROUND_PLANES_H
