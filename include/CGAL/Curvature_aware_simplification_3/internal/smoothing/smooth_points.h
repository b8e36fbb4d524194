// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SMOOTHING_SMOOTH_POINTS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SMOOTHING_SMOOTH_POINTS_H

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Surface_fit.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Noise_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/smoothing/fit_smoothing_quadric.h>
#include <CGAL/Curvature_aware_simplification_3/internal/smoothing/thin_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Flags.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Progress.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Uninitialized_vector.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/index_selection.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// A point on the surface, and the variance of its distance to it
struct Smoothed_point
{
  Point point;
  double variance;
};

// How much of the way from a point to the foot point brings it nearer to the surface: 1 where the
// variance s^2 of the residuals is no more than noise by chance, f sigma^2; beyond, f sigma^2 /
// s^2, which is f times the gain of Lee's filter for images, so that there is no jump. On a sharp
// edge, a quadric is off by as much as they are, and the point itself by sigma only.
inline double share_explained_by_noise(const Surface_fit& fit, double residual_variance)
{
  const double explained =
      fit.settings.residuals_explained_by_noise * fit.noise.level * fit.noise.level;
  return residual_variance > explained ? explained / residual_variance : 1.;
}

// The quadric through the points in the ball that smooths one, around x or its foot point. Returns
// whether it tells more of x than x itself.
inline bool fit_to_smooth(const Surface_fit& fit, const Point& center, const Point& x,
                          double inverse_density, Neighborhood& neighborhood,
                          Local_surface& surface)
{
  const double radius = fit.noise.smoothing_radius;
  const double told_by_density = (std::min)(radius * radius / inverse_density, too_many_neighbors);
  std::size_t expected_neighbors = static_cast<std::size_t>(told_by_density);
  // Noise carries points apart, so that 1/rho is too large: the ball holds up to twice as many, and
  // to look for the nearest first would take a noisy call 5 % more time.
  if (2 * expected_neighbors > smoothing_neighborhood)
    expected_neighbors = (std::max)(expected_neighbors, smoothing_neighborhood + 1);
  collect_neighbors(fit, center, smoothing_neighborhood, radius, expected_neighbors, neighborhood);
  if (!(neighborhood.radius > 0.))
    return false;
  // Where noise is small against the distances of the points, weights fall as in other fits.
  if (!fit_smoothing_quadric((std::max)(neighborhood.radius / 2., radius), fit.noise.level,
                             neighborhood, surface))
    return false;
  // further than that, noise hardly carries a point: it is on another sheet, or the fit is wrong
  const double farthest = 4. * fit.noise.level;
  return std::sqrt(squared_distance(center, x)) + std::abs(surface.c[0]) <= farthest;
}

// x moved to the foot point on the quadric through its neighbors, as far as noise explains; x
// itself where its noise is not visible, or they tell nothing of it
inline Smoothed_point smooth_point(const Surface_fit& fit, const Point& x, double inverse_density)
{
  static thread_local Neighborhood neighborhood;
  const Smoothed_point unchanged{x, fit.noise.level * fit.noise.level};
  Local_surface surface;
  if (!fit.noise.is_visible || !fit_to_smooth(fit, x, x, inverse_density, neighborhood, surface))
    return unchanged;
  // A ball around a point off the surface holds more of the noise on its side, and so is the foot
  // point: the ball is moved there. In one of more than 6 sigma, there is all of the noise anyway.
  // With 4, samples are up to 7 % farther off where noise is along rays; with any size, light noise
  // takes 11 % more time for the same errors.
  constexpr double widest_to_move = 6.;
  if (fit.settings.smooth_around_foot_points &&
      neighborhood.radius <= widest_to_move * fit.noise.level)
  {
    surface.move_to_foot_point();
    const Point foot = surface.origin;
    if (!fit_to_smooth(fit, foot, x, inverse_density, neighborhood, surface))
      return unchanged;
  }
  const double share =
      share_explained_by_noise(fit, variance_of_residuals(neighborhood, surface, x));
  const double variance = share * surface.error * surface.error + (1. - share) * unchanged.variance;
  surface.move_to_foot_point();
  return {x + share * (surface.origin - x), variance};
}

// The noise that is left where points were smoothed and thinned: the mean of the variances of those
// that were kept, by range
template <typename ConcurrencyTag>
Noise_levels noise_left(const Noise_levels& noise, const std::vector<std::size_t>& kept_points,
                        const std::vector<double>& variance)
{
  Noise_levels left = noise.of_some(kept_points);
  for_each_index<ConcurrencyTag>(0, left.of_range.size(), [&](std::size_t range) {
    Noise& here = left.of_range[range];
    const std::size_t begin = left.first_point[range], end = left.first_point[range + 1];
    if (!here.is_visible || begin == end) // not smoothed, or none is left
      return;
    double sum = 0.;
    for (std::size_t i = begin; i < end; ++i)
      sum += variance[i];
    const double kept = static_cast<double>(end - begin);
    const double points =
        static_cast<double>(noise.first_point[range + 1] - noise.first_point[range]);
    here.independent_level = here.level * std::sqrt(kept / points);
    here.level = std::sqrt(sum / kept);
  });
  return left;
}

// Moves points with visible noise towards local surfaces, so that less of it is left and later fits
// can be narrower: in balls of 7 sigma, shape is lost. Thins points that are dense against the
// noise. Returns what is left of it.
template <typename ConcurrencyTag>
Noise_levels smooth_points(std::vector<Point>& points,
                           const Uninitialized_vector<double>& inverse_density, Flags& is_bent,
                           const Neighbor_search& search, const Noise_levels& noise,
                           std::size_t number_of_samples, const Adaptive_settings& settings,
                           const Progress& progress)
{
  const Surface_fitter fitter{search, settings};
  const std::vector<std::size_t> kept_points =
      thin_points<ConcurrencyTag>(inverse_density, noise, number_of_samples);
  std::vector<double> variance(kept_points.size());
  for_each_index<ConcurrencyTag>(kept_points.size(), progress, [&](std::size_t i) {
    const std::size_t j = kept_points[i];
    const Smoothed_point result =
        smooth_point(fitter.at(noise.at(j)), points[j], inverse_density[j]);
    points[j] = result.point; // the search has its own
    variance[i] = result.variance;
  });
  keep_elements<ConcurrencyTag>(kept_points, points);
  keep_elements<ConcurrencyTag>(kept_points, is_bent);
  return noise_left<ConcurrencyTag>(noise, kept_points, variance);
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SMOOTHING_SMOOTH_POINTS_H
