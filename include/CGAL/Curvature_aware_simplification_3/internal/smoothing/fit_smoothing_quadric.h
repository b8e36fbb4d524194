// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SMOOTHING_FIT_SMOOTHING_QUADRIC_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SMOOTHING_FIT_SMOOTHING_QUADRIC_H

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Local_surface.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Neighborhood.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/fit_quadric.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Computation_kernel.h>

#include <algorithm>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The quadric through neighbors in a ball of that radius. Returns whether it tells more of its
// center than that itself, which is or was a noisy point: were the weights to fall within a few
// sigma, points with the same error would count most, and confirm it.
inline bool fit_smoothing_quadric(double radius, double sigma, Neighborhood& neighborhood,
                                  Local_surface& surface)
{
  neighborhood.weight_by_distance(2. * radius);
  return fit_quadric_over_plane(neighborhood, sigma, surface) && surface.error < sigma;
}

// The same, from neighbors that are in a larger ball, which may be around another center
inline bool fit_smoothing_quadric(const Neighborhood& wide, const Point& center, double radius,
                                  double sigma, Local_surface& surface)
{
  static thread_local Neighborhood neighborhood;
  neighborhood.take_within(wide, center, radius);
  return fit_smoothing_quadric(radius, sigma, neighborhood, surface);
}

// Variance of the heights of the neighbors over the surface that was fitted to them: noise, and
// shape that it missed. The point x that is smoothed does not count: it may be far off, and such
// are to be moved.
inline double variance_of_residuals(const Neighborhood& neighborhood, const Local_surface& surface,
                                    const Point& x)
{
  const Vector own_position = x - neighborhood.center;
  double sum = 0., sum_of_squares = 0., sum_of_residuals = 0.;
  for (const Neighborhood::Neighbor& neighbor : neighborhood.neighbors)
  {
    if (neighbor.position == own_position)
      continue;
    const double residual = surface.residual(neighbor.position);
    sum += neighbor.weight;
    sum_of_squares += neighbor.weight * neighbor.weight;
    sum_of_residuals += neighbor.weight * residual * residual;
  }
  if (!(sum > 0.))
    return 0.;
  // so many neighbors of equal weight would tell as much; the quadric used up 6
  const double n = sum * sum / sum_of_squares;
  return sum_of_residuals / sum * n / (std::max)(n - 6., 1.);
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SMOOTHING_FIT_SMOOTHING_QUADRIC_H
