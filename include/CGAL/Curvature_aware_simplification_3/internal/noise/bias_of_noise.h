// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_BIAS_OF_NOISE_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_BIAS_OF_NOISE_H

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Local_surface.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Noise.h>

#include <algorithm>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The mean curvature of a surface in the frame of its foot point, positive where the normal is on
// the inside of the bend: of f(a, b) = c3 a^2 + c4 a b + c5 b^2, it is c3 + c5.
inline double mean_curvature(const Local_surface& surface)
{
  return surface.c[3] + surface.c[5];
}

// How far fits to noisy points are off a bent surface along its normal, however many points there
// are.
//
// Noise in all directions carries points along the surface, too: those over a place belong to
// others around it. With that, their mean height is the mean of f over a normal distribution, where
// a^2 and b^2 have the mean sigma^2:
//   sigma^2 (c3 + c5),
// to the inside of the bend. Noise along the rays of a scanner makes that only where these are
// oblique, but it is not known which noise it is. Where points are in columns, it is: there, none.
inline double bias_of_noise(const Noise& noise, double mean_curvature)
{
  const double sigma = noise.input_level;
  if (!noise.is_visible || noise.radius_of_columns > 0.)
    return 0.;
  // With more, the surface bends within the noise, and its curvature is not known.
  const double most = 0.5 * sigma;
  return (std::clamp)(sigma * sigma * mean_curvature, -most, most);
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_BIAS_OF_NOISE_H
