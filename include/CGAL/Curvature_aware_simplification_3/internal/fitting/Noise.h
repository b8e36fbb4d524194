// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_NOISE_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_NOISE_H

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// In balls of so many sigma, a layer of noisy points looks flat: no fit that smooths them needs
// more.
inline constexpr double largest_smoothing_radius_in_noise = 4.;

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
  // Whether it was visible at the spacing of the samples before the smoothing: only then is it
  // worth time to reduce it.
  bool is_visible = false;
  double visible_error = 0.;    // the error of a fit above which it is visible
  double input_level = 0.;      // `level` before the smoothing
  double smoothing_radius = 0.; // of the ball in which a point is smoothed

  // Balls that hold several columns are as wide as they must be.
  bool may_be_narrowed() const { return is_visible && !(radius_of_columns > 0.); }
};

inline constexpr Noise no_noise = Noise();

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_NOISE_H
