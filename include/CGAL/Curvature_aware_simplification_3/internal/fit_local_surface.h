// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FIT_LOCAL_SURFACE_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FIT_LOCAL_SURFACE_H

#include <CGAL/Curvature_aware_simplification_3/internal/Adaptive_settings.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Noise_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fit_quadric.h>
#include <CGAL/Curvature_aware_simplification_3/internal/median.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// How local surfaces are fitted to the input
struct Surface_fit
{
  const Neighbor_search& search;
  std::size_t number_of_points; // of the search
  Noise noise = Noise();        // of the points near the place that is fitted
  Adaptive_settings settings = Adaptive_settings();

  Surface_fit with(const Noise& noise_there) const
  {
    return {search, number_of_points, noise_there, settings};
  }
  bool points_share_noise() const { return noise.level < noise.independent_level; }
};

// 18 neighbors, two rings around a point: three for each coefficient of a quadric
constexpr std::size_t smallest_neighborhood = 19;
// Four doublings above. Then noise is down to sigma / 6, and time grows faster than accuracy.
constexpr std::size_t largest_neighborhood = 16 * 18 + 1;
// In units of sigma. In a ball of that radius, the layer of noisy points looks flat; in a much smaller
// one it looks as thick as wide and has no normal.
constexpr double smallest_radius_in_noise = 7.;
// Welsch's weight exp(-e^2 / 2) with e in units of 2.5 standard deviations: 97 % of the efficiency
// of least squares for Gaussian noise, and nothing left of what is 8 standard deviations away
constexpr double residual_scale = 2.5;
// 2 standard deviations where a fit is widened: what it meets there may be another sheet, and nothing
// is left of that if it is 6 away
constexpr double residual_scale_of_wider = 2.;

inline double robust_weight(double residual, double spread, double scale = residual_scale)
{
  const double e = residual / (scale * spread);
  return std::exp(-0.5 * e * e);
}

// Standard deviation of the residuals, from their median: no outlier and no second sheet moves it
inline double residual_spread(const Neighborhood& neighborhood, const Local_surface& surface)
{
  static thread_local std::vector<double> residuals;
  residuals.clear();
  for (const Neighborhood::Neighbor& neighbor : neighborhood.neighbors)
    residuals.push_back(std::abs(surface.residual(neighbor.position)));
  const double n = static_cast<double>(residuals.size());
  // 1.4826: standard deviation over median of |x| for Gaussian x; the quadric used up 5 + 1
  return 1.4826 * median(residuals) * std::sqrt(n / (std::max)(n - 5., 1.));
}

// Collects the neighbors of x that a fit needs: `smallest` nearest, or all in the ball that noise asks
// for. `expected_neighbors` is about how many points are in that ball, or 0 if not known.
inline void collect_neighbors(const Surface_fit& fit, const Point& x, std::size_t smallest,
                              double wanted_radius, std::size_t expected_neighbors,
                              Neighborhood& neighborhood)
{
  neighborhood.neighbors.clear();
  smallest = (std::min)(smallest, fit.number_of_points);
  const std::size_t largest = (std::min)(largest_neighborhood, fit.number_of_points);
  if (expected_neighbors <= smallest)
  {
    neighborhood.collect(fit.search, x, smallest);
    if (neighborhood.radius >= wanted_radius || smallest == largest)
      return;
    // points on a surface grow with the square of the radius
    const double ratio = wanted_radius / (neighborhood.radius + 1e-300);
    expected_neighbors =
        static_cast<std::size_t>((std::min)(ratio * ratio * static_cast<double>(smallest), 1e9));
  }
  if (expected_neighbors < 2 * largest) // otherwise the ball holds more anyway
  {
    neighborhood.collect_within(fit.search, x, wanted_radius);
    if (neighborhood.size() < smallest)
      neighborhood.collect(fit.search, x, smallest);
    if (neighborhood.size() <= largest)
      return;
  }
  neighborhood.collect(fit.search, x, largest);
}

inline void collect_neighbors(const Surface_fit& fit, const Point& x,
                              std::size_t expected_neighbors, Neighborhood& neighborhood)
{
  collect_neighbors(fit, x, smallest_neighborhood, smallest_radius_in_noise * fit.noise.level,
                    expected_neighbors, neighborhood);
}

// Standard deviation of the height of a fit. `error` is what it would be for independent noise. Smoothed
// points share their noise: a fit narrower than the smoothing is as good as they are, e = sigma, a
// wider one as good as with independent noise. Both filters pass what is wider than they are and hold
// back the rest, so that the narrower one hardly matters; the transition 1/e^4 = 1/e_1^4 + 1/e_2^4 was
// measured on spheres.
inline double error_of_fit(const Surface_fit& fit, double error)
{
  if (!(fit.points_share_noise() && error > 0.))
    return error;
  const double ratio = error / fit.noise.level;
  return error / std::sqrt(std::sqrt(1. + ratio * ratio * ratio * ratio));
}

// The quadric as in fit_quadric.h, with the error for points that may share their noise. It fails as well
// where it passes far from the ball: few neighbors on one side had all the weight, and nothing is known
// of the center. Twice the radius is not far: so high is a plane in the ball over a center on its border if
// the guessed normal is off by 60 degrees.
inline bool fit_quadric(const Surface_fit& fit, const Neighborhood& neighborhood,
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

// Whether the ball is about as narrow as the noise allows
inline bool is_noisy(const Surface_fit& fit, const Neighborhood& neighborhood)
{
  return neighborhood.radius <= 2. * smallest_radius_in_noise * fit.noise.level;
}

// Rounds of reweighting: for a surface that a sample only moves on, the first leaves out outliers and
// other sheets well enough; for the place where it stays, a second one sees them in the light of the first.
constexpr int rounds_to_move = 1;
constexpr int rounds_to_stay = 2;

// The narrowest surface that can be trusted, around the foot point of x: a quadric by iteratively
// reweighted least squares, with `rounds` of reweighting as above. `normal` is a guess, or the null
// vector where there is none, and `expected_neighbors` how many neighbors may be needed, or 0. The
// neighbors are left in `neighborhood`.
inline Local_surface fit_local_surface(const Surface_fit& fit, const Point& x, const Vector& normal,
                                       std::size_t expected_neighbors, int rounds,
                                       Neighborhood& neighborhood)
{
  const bool has_guess = normal != NULL_VECTOR;

  Local_surface surface;
  surface.origin = x;
  if (has_guess)
    surface.n = normal;
  surface.complete_frame();
  collect_neighbors(fit, x, expected_neighbors, neighborhood);
  // A ball around a point off the surface holds more of the noise on its side: it is moved to the
  // foot point.
  for (int moves = 0;;)
  {
    if (!(neighborhood.radius > 0.))
      return surface;

    // a point that starts a sample has no say itself: it may be an outlier
    const auto weight_by_distance = [&]
    {
      neighborhood.weight_by_distance();
      if (!has_guess)
        for (Neighborhood::Neighbor& neighbor : neighborhood.neighbors)
          if (neighbor.squared_distance == 0.)
            neighbor.weight = 0.;
    };
    // First a plane. The ball may reach another sheet, which the next rounds then leave out: inner
    // neighbors decide, unless the ball is as narrow as the noise allows. Then all are needed to tell
    // the normal.
    weight_by_distance();
    if (!is_noisy(fit, neighborhood))
      for (Neighborhood::Neighbor& neighbor : neighborhood.neighbors)
        neighbor.weight = neighbor.weight * neighbor.weight * neighbor.weight;
    if (!has_guess && moves == 0)
    {
      surface.n = plane_normal(neighborhood);
      surface.complete_frame();
    }
    Local_surface fitted = surface;
    fitted.radius = neighborhood.radius;
    fitted.neighbors = expected_neighbors = neighborhood.size();
    if (!fit_plane(neighborhood, fitted))
      return surface;
    for (int round = 0; round < rounds; ++round)
    {
      fitted.spread = (std::max)(residual_spread(neighborhood, fitted), fit.noise.level);
      if (!(fitted.spread > 0.))
        break;
      weight_by_distance();
      for (Neighborhood::Neighbor& neighbor : neighborhood.neighbors)
        neighbor.weight *= robust_weight(fitted.residual(neighbor.position), fitted.spread);
      if (!fit_quadric(fit, neighborhood, fitted))
        break; // what was fitted before is the best there is
    }
    const double distance = std::abs(fitted.c[0]);
    // sigma / 2 in the narrowest balls for the noise: 1/14 of the radius. That part does for any ball.
    const double tolerance = 0.5 * neighborhood.radius / smallest_radius_in_noise;
    fitted.move_to_foot_point();
    if (!(distance > tolerance && moves < fit.settings.moves_to_foot_point))
      return fitted;
    ++moves;
    surface.origin = fitted.origin;
    surface.n = fitted.n;
    surface.complete_frame();
    collect_neighbors(fit, surface.origin, expected_neighbors, neighborhood);
  }
}

// The surface from a wider ball than `surface` was fitted to, taken from `wide`; false if that does not
// reduce its error. The narrower one tells by the height which points belong to the same sheet. Distances
// count in the tangent plane: in a ball, the noise of a neighbor would decide over its weight.
inline bool widen(const Surface_fit& fit, const Neighborhood& wide, double radius,
                  Neighborhood& neighborhood, Local_surface& surface)
{
  neighborhood.take_within(wide, surface.origin, radius);
  neighborhood.weight_by_distance(
      [&](const Neighborhood::Neighbor& neighbor)
      {
    const double h = neighbor.position * surface.n;
    return neighbor.squared_distance - h * h;
  });
  // A narrow fit to smoothed points follows their noise, and shows less of it than there is: with 1.5 to
  // 3 times what is left, the results are the same, and with less, points of the same sheet are lost.
  const double spread =
      fit.points_share_noise() ? (std::max)(surface.spread, 2. * fit.noise.level) : surface.spread;
  for (Neighborhood::Neighbor& neighbor : neighborhood.neighbors)
    neighbor.weight *=
        robust_weight(surface.residual(neighbor.position), spread, residual_scale_of_wider);
  Local_surface wider = surface;
  wider.radius = neighborhood.radius;
  wider.neighbors = neighborhood.size();
  if (!fit_quadric(fit, neighborhood, wider) || !(wider.error < surface.error))
    return false;
  wider.move_to_foot_point();
  surface = wider;
  return true;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FIT_LOCAL_SURFACE_H
