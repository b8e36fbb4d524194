// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_FIT_TO_NEIGHBORS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_FIT_TO_NEIGHBORS_H

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Surface_fit.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/fit_quadric.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/principal_axes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/robust_weights.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Standard deviation of the height of a fit. `error` is what it would be for independent noise.
// Smoothed points share their noise: a fit narrower than the smoothing is as good as they are, e =
// sigma, a wider one as good as with independent noise. Both filters pass what is wider than they
// are and hold back the rest, so that the narrower one hardly matters; the transition 1/e^4 =
// 1/e_1^4 + 1/e_2^4 was measured on spheres.
inline double error_of_fit(const Surface_fit& fit, double error)
{
  if (!(fit.points_share_noise() && error > 0.))
    return error;
  const double ratio = error / fit.noise.level;
  return error / std::sqrt(std::sqrt(1. + ratio * ratio * ratio * ratio));
}

// The quadric as in fit_quadric.h, with the error for points that may share their noise. It fails
// as well where it passes far from the ball: few neighbors on one side had all the weight, and
// nothing is known of the center. Twice the radius is not far: so high is a plane in the ball over
// a center on its border if the guessed normal is off by 60 degrees.
inline bool fit_trusted_quadric(const Surface_fit& fit, const Neighborhood& neighborhood,
                                Local_surface& surface)
{
  Local_surface fitted = surface;
  if (!fit_quadric(neighborhood, fit.noise.independent_level, fitted) ||
      std::abs(fitted.c[0]) > 2. * neighborhood.radius)
    return false;
  surface = fitted;
  surface.error = error_of_fit(fit, surface.error);
  return true;
}

// What the point in the center of the first ball says of the surface: nothing where it starts a
// sample, since it may be an outlier
enum class Center
{
  counts,
  has_no_say
};

// Whether the ball is about as narrow as the noise allows
inline bool is_noisy(const Surface_fit& fit, const Neighborhood& neighborhood)
{
  return neighborhood.radius <= 2. * smallest_radius_in_noise * fit.noise.level;
}

// Weights by distance
inline void weight_for_quadric(Center center, Neighborhood& neighborhood)
{
  neighborhood.weight_by_distance();
  if (center == Center::has_no_say)
    for (Neighborhood::Neighbor& neighbor : neighborhood.neighbors)
      if (neighbor.squared_distance == 0.)
        neighbor.weight = 0.;
}

// The first fit is a plane. The ball may reach another sheet, which the next rounds then leave out:
// inner neighbors decide, with the cubes of their weights, which are about those of a ball that is
// narrower by sqrt(3). Not so where the ball is as narrow as the noise allows, or neighbors may
// be on one line, for which more were asked for: then all are needed to tell the normal.
inline void weight_for_plane(const Surface_fit& fit, Center center, std::size_t smallest,
                             Neighborhood& neighborhood)
{
  weight_for_quadric(center, neighborhood);
  if (!is_noisy(fit, neighborhood) && smallest == smallest_neighborhood)
    for (Neighborhood::Neighbor& neighbor : neighborhood.neighbors)
      neighbor.weight = neighbor.weight * neighbor.weight * neighbor.weight;
}

// Rounds of reweighting: the first leaves out outliers and other sheets well enough. A second one
// sees them in the light of the first, which makes no difference where points are exact; but where
// a sample stays among noisy ones, it would be 3 % farther from the surface without.
inline constexpr int rounds_to_move = 1;
inline constexpr int rounds_to_stay = 2;

// Takes a fit towards the quadric by iteratively reweighted least squares: neighbors with large
// residuals lose their weights. Where a round fails, what was fitted before is the best there is.
inline void reweight_and_fit(const Surface_fit& fit, Center center, int rounds,
                             Neighborhood& neighborhood, Local_surface& surface)
{
  static thread_local std::vector<double> residuals;
  for (int round = 0; round < rounds; ++round)
  {
    find_residuals(neighborhood, surface, residuals);
    surface.spread = (std::max)(spread_of(residuals), fit.noise.level);
    if (!(surface.spread > 0.))
      return;
    weight_for_quadric(center, neighborhood);
    reduce_weights(residuals, Robust_weight(surface.spread), neighborhood);
    if (!fit_trusted_quadric(fit, neighborhood, surface))
      return;
    if (!fit.noise.is_visible)
      return; // a second round would tell nothing new
  }
}

// The surface through at least `smallest` neighbors, around the foot point of x, with so many
// rounds of reweighting. `guess` is a normal, or the null vector where there is none, and
// `expected_neighbors` how many neighbors may be needed, or 0. The neighbors are left in
// `neighborhood`.
inline Local_surface fit_to_neighbors(const Surface_fit& fit, const Point& x, const Vector& guess,
                                      Center center, std::size_t smallest,
                                      std::size_t expected_neighbors, int rounds,
                                      Neighborhood& neighborhood)
{
  const bool has_guess = guess != NULL_VECTOR;
  const double wanted_radius = smallest_radius_in_noise * fit.noise.level;

  Local_surface surface;
  surface.origin = x;
  if (has_guess)
    surface.n = guess;
  surface.complete_frame();
  // A ball around a point off the surface holds more of the noise on its side: it is moved to the
  // foot point.
  for (int moves = 0;; ++moves)
  {
    collect_neighbors(fit, surface.origin, smallest, wanted_radius, expected_neighbors,
                      neighborhood);
    if (!(neighborhood.radius > 0.))
      return surface;
    expected_neighbors = neighborhood.size();

    weight_for_plane(fit, center, smallest, neighborhood);
    if (!has_guess && moves == 0)
    {
      surface.n = plane_normal(neighborhood);
      surface.complete_frame();
    }
    Local_surface fitted = surface;
    fitted.radius = neighborhood.radius;
    fitted.neighbors = neighborhood.size();
    if (!fit_plane(neighborhood, fitted))
      return surface;
    reweight_and_fit(fit, center, rounds, neighborhood, fitted);

    const double distance = std::abs(fitted.c[0]);
    // sigma / 2 in the narrowest balls for the noise: 1/14 of the radius. That part does for any
    // ball.
    const double tolerance = 0.5 * neighborhood.radius / smallest_radius_in_noise;
    fitted.move_to_foot_point();
    if (!(distance > tolerance && moves < fit.settings.moves_to_foot_point))
      return fitted;
    surface.origin = fitted.origin;
    surface.n = fitted.n;
    surface.complete_frame();
  }
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_FIT_TO_NEIGHBORS_H
