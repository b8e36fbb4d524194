// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_LIMITS_OF_NOISE_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_LIMITS_OF_NOISE_H

#include <CGAL/Curvature_aware_simplification_3/internal/noise/Layer.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Noise_probes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Planes.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// What planes through few points tell of the noise even where shape adds to their thickness. Since
// they turn along the noise, a part of it is hidden, but no more than that as long as they are so
// wide against it. Both are what was measured with random points on a plane and noise of 0.3
// spacings for 7, of 0.2 for 5.
struct Plane_of_few_points
{
  std::size_t number;
  double width_over_thickness; // at least; in a volume, it is 2.5 for both numbers
  double shown_part;           // of the noise

  double limit(const Layer& layer, double tilt) const
  {
    return tilt <= largest_tilt_of_planes && layer.is_broad() &&
                   layer.width >= width_over_thickness * layer.thickness
               ? layer.thickness / shown_part
               : std::numeric_limits<double>::infinity();
  }
};

// How much noise there is at most in these ranges, as far as planes through 5 points, or through 7,
// which are known already, show it; infinity elsewhere, and where they do not. Fewer points see
// less of the other side of a thin part, but tell less of the noise.
template <typename ConcurrencyTag>
std::vector<double> limits_of_noise(const Noise_probes& probes,
                                    const std::vector<std::size_t>& ranges,
                                    const Planes& planes_of_7)
{
  constexpr Plane_of_few_points plane_of_5{5, 3.55, 0.84}, plane_of_7{points_of_ring, 3.3, 0.88};
  const Planes planes_of_5 = planes_through<ConcurrencyTag>(plane_of_5.number, probes, ranges);
  std::vector<double> limits(probes.of_range.size(), std::numeric_limits<double>::infinity());
  for (std::size_t range : ranges)
    limits[range] = (std::min)(plane_of_5.limit(planes_of_5.layer[range], planes_of_5.tilt[range]),
                               plane_of_7.limit(planes_of_7.layer[range], planes_of_7.tilt[range]));
  return limits;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_LIMITS_OF_NOISE_H
