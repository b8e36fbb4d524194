// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_MEASURE_NOISE_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_MEASURE_NOISE_H

#include <CGAL/Curvature_aware_simplification_3/internal/input/Searchable_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Noise_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Noise_of_range.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Noise_probes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Planes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/columns_of_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/noise_around_planes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/noise_around_quadrics.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Adaptive_settings.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The noise of a range that both kinds of fits show. What a fit misses of the shape looks like
// noise and never makes it look less, so the one that shows less counts, if it is reliable. Next to
// another sheet, quadrics are not: there, those of planes count, if they tell any, though these
// turn along the noise and show up to a fifth too little of it. Where these are not reliable, they
// still set a limit: where points are sparse, quadrics take both sides of a thin part that bends
// for one layer, and the thickness of the part for noise. Planes that stand on the surface, as
// those through points on one line of a scan, show none of its noise; but that of quadrics is
// steady then.
inline Noise noise_of_both(const Noise_around_quadrics& around_quadrics,
                           const Noise_around_planes& around_planes)
{
  Noise noise;
  noise.level = (std::min)(around_quadrics.level, around_quadrics.limit);
  if (around_quadrics.is_steady)
    noise.level = around_quadrics.level;
  else if (!around_quadrics.is_reliable && around_planes.is_known)
    noise.level = around_planes.level;
  else if (around_planes.is_reliable)
    noise.level = (std::min)(noise.level, around_planes.level);
  noise.level = (std::min)(noise.level, around_planes.limit);
  noise.independent_level = noise.level;
  noise.radius_of_columns = around_quadrics.radius_of_columns;
  return noise;
}

// Standard deviation sigma of the distance of the points to the surface, by place
template <typename ConcurrencyTag>
Noise_levels measure_noise(const Searchable_points& cloud, std::size_t number_of_probes,
                           bool points_share_errors, const Adaptive_settings& settings)
{
  const Noise_probes probes = noise_probes<ConcurrencyTag>(cloud, number_of_probes);
  Columns columns(probes.of_range.size());
  std::vector<Noise_around_planes> around_planes(probes.of_range.size()); // nothing known
  if (settings.noise_around_planes)
  {
    const Planes planes_of_7 =
        planes_through<ConcurrencyTag>(points_of_ring, probes, all_ranges(probes));
    if (settings.find_columns)
      columns = columns_of_ranges<ConcurrencyTag>(probes, planes_of_7);
    around_planes = noise_around_planes<ConcurrencyTag>(probes, planes_of_7, columns,
                                                        points_share_errors, settings);
  }
  const std::vector<Noise_around_quadrics> around_quadrics =
      noise_around_quadrics<ConcurrencyTag>(probes, around_planes, columns, settings);
  std::vector<Noise> noise;
  for (std::size_t range = 0; range < around_quadrics.size(); ++range)
    noise.push_back(noise_of_both(around_quadrics[range], around_planes[range]));
  return {std::move(noise), cloud.size()};
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_MEASURE_NOISE_H
