// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_FITS_OF_ALL_SIZES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_FITS_OF_ALL_SIZES_H

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Surface_fit.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/fit_local_surface.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/bias_of_noise.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/Surface_sample.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// 2 standard deviations where a fit is widened: what it meets there may be another sheet, and
// hardly anything is left of that if it is 6 away
inline constexpr double residual_scale_of_wider = 2.;

// The surface from a wider ball than `surface` was fitted to, taken from `wide`; false if that does
// not reduce its error. The narrower one tells by the height which points belong to the same sheet.
// Distances count in the tangent plane: in a ball, the noise of a neighbor would decide over its
// weight.
inline bool widen(const Surface_fit& fit, const Neighborhood& wide, double radius,
                  Neighborhood& neighborhood, Local_surface& surface)
{
  neighborhood.take_within(wide, surface.origin, radius);
  neighborhood.weight_by_distance(radius, [&](const Neighborhood::Neighbor& neighbor) {
    const double h = neighbor.position * surface.n;
    return neighbor.squared_distance - h * h;
  });
  // A narrow fit to smoothed points follows their noise, and shows less of it than there is: with
  // 1.5 to 3 times what is left, the results are the same, and with less, points of the same sheet
  // are lost.
  const double spread =
      fit.points_share_noise() ? (std::max)(surface.spread, 2. * fit.noise.level) : surface.spread;
  static thread_local std::vector<double> residuals;
  find_residuals(neighborhood, surface, residuals);
  reduce_weights(residuals, Robust_weight(spread, residual_scale_of_wider), neighborhood);
  Local_surface wider = surface;
  wider.radius = neighborhood.radius;
  wider.neighbors = neighborhood.size();
  if (!fit_trusted_quadric(fit, neighborhood, wider) || !(wider.error < surface.error))
    return false;
  wider.move_to_foot_point();
  surface = wider;
  return true;
}

// What the next wider fit changes
struct Widening
{
  double shift;     // of the sample along the normal
  double variance;  // of the shift, if noise alone causes it
  double curvature; // the change of the mean curvature, where it is known
};

// The narrowest fit, which is the surface of the sample, and what fits with 2, 4, ... times its
// neighbors change one after the other
struct Fits_of_all_sizes
{
  Point point;
  // The normal and the mean curvature of the first fit that knows it, or else the widest
  Vector normal;
  double curvature;
  std::vector<Widening> widenings;
};

inline Fits_of_all_sizes fits_of_all_sizes(const Surface_fit& fit, const Surface_sample& x)
{
  static thread_local Neighborhood neighborhood;
  Local_surface surface = x.surface;
  if (x.a != 0. || x.b != 0.) // back from a border
    surface = fit_local_surface(fit, x.point, x.normal(), surface, rounds_to_stay, neighborhood);
  Fits_of_all_sizes fits{surface.origin, surface.n, mean_curvature(surface), {}};
  if (!(surface.radius > 0.))
    return fits;
  // Balls of twice the area, and so on. All are in the largest, which is searched once, but for the
  // small way that the foot point goes.
  const std::size_t widest = fit.settings.points_of_widest_fit;
  const double ratio = static_cast<double>(widest) /
                       static_cast<double>((std::max)(surface.neighbors, std::size_t(1)));
  double largest_radius = surface.radius * std::sqrt(ratio);
  static thread_local Neighborhood wide;
  if (ratio > 1.)
  {
    // Next to where points are much denser, it may hold any number of them.
    const std::size_t most = 2 * widest;
    wide.collect_within(fit.search, surface.origin, largest_radius, most);
    if (wide.size() > most)
    {
      wide.collect(fit.search, surface.origin, most);
      largest_radius = wide.radius;
    }
  }
  static thread_local std::vector<Widening> widenings;
  widenings.clear();
  for (double radius = surface.radius; radius < largest_radius;)
  {
    radius = (std::min)(std::sqrt(2.) * radius, largest_radius);
    const Local_surface narrow = surface;
    if (!widen(fit, wide, radius, neighborhood, surface))
      break;
    const double curvature = mean_curvature(surface);
    double change = curvature - mean_curvature(narrow);
    // A fit that is narrower than the balls that smoothed the points bends with what these have
    // left: at that scale, nothing is known of the surface.
    if (narrow.radius < fit.noise.smoothing_radius)
    {
      fits.curvature = curvature;
      fits.normal = surface.n;
      change = 0.;
    }
    widenings.push_back({(surface.origin - narrow.origin) * surface.n,
                         narrow.error * narrow.error - surface.error * surface.error, change});
  }
  fits.widenings.assign(widenings.begin(), widenings.end()); // all samples have theirs at once
  return fits;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_FITS_OF_ALL_SIZES_H
