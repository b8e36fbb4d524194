// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_LEVEL_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_LEVEL_H

#include <CGAL/Curvature_aware_simplification_3/internal/fit_quadric.h>
#include <CGAL/Curvature_aware_simplification_3/internal/loops.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Medians over some probes, evenly along the Hilbert curve, of what a quadric leaves of the heights
// of the k nearest points, and of their radius
template <typename ConcurrencyTag>
std::pair<double, double> median_residual(const std::vector<Point>& points,
                                          const Neighbor_search& search, std::size_t k)
{
  // 512 values give a median to about 3 % of the noise
  const std::size_t number_of_probes = (std::min)(std::size_t(512), points.size());
  std::vector<double> residual(number_of_probes, 0.), radius(number_of_probes, 0.);
  for_each_index<ConcurrencyTag>(0, number_of_probes,
                                 [&](std::size_t i)
                                 {
    Neighborhood neighborhood;
    Local_surface surface;
    const Point& probe = points[(2 * i + 1) * points.size() / (2 * number_of_probes)];
    neighborhood.collect(search, probe, k);
    radius[i] = neighborhood.radius;
    if (!(neighborhood.radius > 0.))
      return;
    if (!fit_quadric_over_plane(neighborhood, 0., surface))
      return;
    double sum = 0.;
    for (const Neighborhood::Neighbor& neighbor : neighborhood.neighbors)
    {
      const double e = surface.residual(neighbor.position);
      sum += e * e;
    }
    residual[i] = std::sqrt(sum / (std::max)(static_cast<double>(neighborhood.size()) - 6., 1.));
  });
  const auto median = [](std::vector<double>& values)
  {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  };
  return {median(residual), median(radius)};
}

// Standard deviation sigma of the distance of the points to the surface.
//
// The residual s of quadrics holds noise and shape. Noise is the same for all sizes of neighborhoods;
// what a quadric misses of the shape is cubic in the radius, so s_k^2 = sigma^2 + c k^3. Two sizes
// tell the two apart: sigma^2 = (8 s_k^2 - s_2k^2) / 7. The first must be wide against the noise,
// here r >= 4 s: where the points look as thick as wide, a fit turns along the noise. If there is no
// such k up to about 1000, the layer of noise is all there is to see, and its residual is the answer.
// If the points end before, they are too few to tell noise from shape, and are taken as they are.
template <typename ConcurrencyTag>
double noise_level(const std::vector<Point>& points, const Neighbor_search& search)
{
  std::size_t k = 17;
  double residual = 0.;
  for (;; k *= 2)
  {
    if (2 * k > points.size())
      return 0.; // too few to tell
    double radius;
    std::tie(residual, radius) = median_residual<ConcurrencyTag>(points, search, k);
    if (radius >= 4. * residual)
      break;
    if (k > 1000)
      return residual;
  }
  const double wider = median_residual<ConcurrencyTag>(points, search, 2 * k).first;
  return std::sqrt((std::max)(0., (8. * residual * residual - wider * wider) / 7.));
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_LEVEL_H
