// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_PLANES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_PLANES_H

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Neighborhood.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/principal_axes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Layer.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Noise_probes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Planes through few points that are tilted by more (the sine of the angle to the plane of many) do
// not lie in the surface. Noise turns planes through 5 and 7 points by 0.25 to 0.45, the other side
// of a thin part by 0.2 to 0.6. Planes through two columns of points, or through points on one line
// of a scan with noise, stand on the surface, at 0.65 to 1, and show no noise.
inline constexpr double largest_tilt_of_planes = 0.6;

// The sine of the angle between the planes through the `few` and the `many` points that are nearest
// to a place
inline double tilt_of_plane(const Neighbor_search& search, const Point& place, std::size_t few,
                            std::size_t many)
{
  Neighborhood neighborhood;
  neighborhood.collect(search, place, few);
  const Vector normal = plane_normal(neighborhood);
  neighborhood.collect(search, place, many);
  return sine_of_angle(normal, plane_normal(neighborhood));
}

// The median tilts of the planes through the `few` nearest points, of some ranges
template <typename ConcurrencyTag>
std::vector<double> median_tilts(const Noise_probes& probes, const std::vector<std::size_t>& ranges,
                                 std::size_t few)
{
  constexpr std::size_t many = 28; // between two rings and three
  const std::vector<double> tilts = at_probes<ConcurrencyTag>(probes, ranges, [&](std::size_t i) {
    return tilt_of_plane(probes.search, probes.points[i], few, many);
  });
  return medians_of_ranges<ConcurrencyTag>(
      probes, ranges, [&](const std::vector<std::size_t>& of_range) {
        return median_of(of_range, [&](std::size_t i) { return tilts[i]; });
      });
}

// A point and the ring around it
inline constexpr std::size_t points_of_ring = 7;

// What planes through few points show of each range
struct Planes
{
  std::vector<Layer> layer;
  std::vector<double> tilt;
};

template <typename ConcurrencyTag>
Planes planes_through(std::size_t few, const Noise_probes& probes,
                      const std::vector<std::size_t>& ranges)
{
  return {median_layers<ConcurrencyTag>(probes, ranges, few, Layer_around_plane()),
          median_tilts<ConcurrencyTag>(probes, ranges, few)};
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_PLANES_H
