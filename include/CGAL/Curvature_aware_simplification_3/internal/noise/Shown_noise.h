// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_SHOWN_NOISE_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_SHOWN_NOISE_H

#include <CGAL/Curvature_aware_simplification_3/internal/noise/Layer.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Computation_kernel.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// What fits of one kind show of the noise of a range
struct Shown_noise
{
  bool is_known = true; // if not, these fits tell nothing
  double level = 0.;
  double radius_of_columns = 0.; // of balls that hold several of them, or 0
  Vector axis = NULL_VECTOR;     // along which the nearest points are, if these are parallel
  bool is_in_columns = false;    // as points are one above the other, along the axis
  bool is_steady = false;        // the same in layers of many sizes, as nothing but noise is
  bool is_reliable = true;       // if not, another kind of fits counts, whatever it tells
  double limit = std::numeric_limits<double>::infinity(); // the noise is no more than this
};

// Standard deviation sigma of the noise, from layers of k and of 2 k points. Their thickness s
// holds noise and shape. Noise is the same for all sizes, but what a quadric misses of the shape is
// not: on smooth surfaces it grows with the cube of the radius, on scanned ones, which have details
// of all sizes, about with its square (s_2k^2 is 2 to 7 times s_k^2 on clean shapes, 4 in the
// mean), and so does what a plane misses. So s_k^2 = sigma^2 + c k^2, and two sizes tell the two
// apart: sigma^2 = (4 s_k^2 - s_2k^2) / 3.
inline double noise_of_layers(const Layer& narrow, const Layer& wide)
{
  return std::sqrt((std::max)(
      0., (4. * narrow.thickness * narrow.thickness - wide.thickness * wide.thickness) / 3.));
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_SHOWN_NOISE_H
