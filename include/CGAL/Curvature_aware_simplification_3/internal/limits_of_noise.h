// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_LIMITS_OF_NOISE_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_LIMITS_OF_NOISE_H

#include <CGAL/Curvature_aware_simplification_3/internal/Layer.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Neighborhood.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Noise_probes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/principal_axes.h>

#include <algorithm>
#include <cmath>
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

  // `turn` is the sine of the angle to the plane of many points. Noise turns planes of so few by
  // 0.25 to 0.45, the other side of a thin part by 0.2 to 0.6. Planes through two columns of points
  // stand on the surface, at 0.65 to 0.9, and show no noise.
  double limit(const Layer& layer, double turn) const
  {
    constexpr double largest_turn = 0.6;
    return turn <= largest_turn && layer.is_broad() &&
                   layer.width >= width_over_thickness * layer.thickness
               ? layer.thickness / shown_part
               : std::numeric_limits<double>::infinity();
  }
};

// The sine of the angle between the planes through the `few` and the `many` points that are nearest
// to a place
inline double turn_of_plane(const Neighbor_search& search, const Point& place, std::size_t few,
                            std::size_t many)
{
  static thread_local Neighborhood neighborhood;
  neighborhood.collect(search, place, few);
  const Vector normal = plane_normal(neighborhood);
  neighborhood.collect(search, place, many);
  return std::sqrt(CGAL::cross_product(normal, plane_normal(neighborhood)).squared_length());
}

// How much noise there is at most in these ranges, as far as the nearest points show; infinity
// elsewhere, and where they do not. Fewer of them see less of the other side of a thin part, but
// tell less of the noise.
template <typename ConcurrencyTag>
std::vector<double> limits_of_noise(const Noise_probes& probes,
                                    const std::vector<std::size_t>& ranges,
                                    const Neighbor_search& search)
{
  constexpr std::size_t many = 28; // three rings
  std::vector<double> limits(probes.of_range.size(), std::numeric_limits<double>::infinity());
  for (const Plane_of_few_points plane :
       {Plane_of_few_points{5, 3.55, 0.84}, Plane_of_few_points{7, 3.3, 0.88}})
  {
    const std::vector<Layer> layers =
        median_layers<ConcurrencyTag>(probes, ranges, search, plane.number, Layer_around_plane());
    const std::vector<double> turns = at_probes<ConcurrencyTag>(probes, ranges,
                                                                [&](const Point& place) {
      return turn_of_plane(search, place, plane.number, many);
    });
    for (std::size_t range : ranges)
    {
      const double turn =
          median_of(probes.of_range[range], [&](std::size_t i) { return turns[i]; });
      limits[range] = (std::min)(limits[range], plane.limit(layers[range], turn));
    }
  }
  return limits;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_LIMITS_OF_NOISE_H
