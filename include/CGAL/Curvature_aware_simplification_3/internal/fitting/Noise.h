// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_NOISE_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_NOISE_H

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The noise of the points of one place, as the next stages take them: what is measured, at least
// what rounding has left of the depth and what columns need, and after the smoothing what is left
struct Noise
{
  double level = 0.; // standard deviation sigma of their distance to the surface
  // That of independent noise with which a fit to many points would err as much: larger if they
  // share their noise, as smoothed points do
  double independent_level = 0.;
  // Of balls that hold several columns of points, where points are one above the other; otherwise 0
  double radius_of_columns = 0.;
  // Before the smoothing, at the distance of the samples: only then is it worth time to reduce it.
  bool is_visible = false;
  double visible_error = 0.;    // of a fit, above which it is visible there
  double input_level = 0.;      // its standard deviation
  double smoothing_radius = 0.; // of the ball in which a point is smoothed
};

inline constexpr Noise no_noise = Noise();

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_NOISE_H
