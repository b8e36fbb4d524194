// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_LAYERS_OF_TWO_SIZES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_LAYERS_OF_TWO_SIZES_H

#include <CGAL/Curvature_aware_simplification_3/internal/noise/Layer.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

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

// The excess kurtosis of the heights of a layer of two sheets at heights of a and -a with noise
// sigma is -2 a^4 / s^4, with s^2 = a^2 + sigma^2. It is about -0.45 for a single sheet, whose
// noise is cut off by the ball that layers are taken from, and -0.5 where two sheets begin to show
// as two.
//
// That of noise that is bounded, as rounding is, is as small: -1.2 if it is uniform. Then 0.29 of
// the heights are less than s / 2; of two sheets that are as far apart, so that there is a dip
// between them, 0.25 or less.
inline bool are_two_sheets(const Layer& layer)
{
  constexpr double surely_two = -0.65, maybe_bounded = -0.9, with_dip = 0.275;
  return layer.kurtosis < surely_two && (layer.kurtosis > maybe_bounded || layer.middle < with_dip);
}

// The part of the thickness s that is noise where a layer is so thick that it may be two sheets
inline double noise_in_thickness(const Layer& layer)
{
  return are_two_sheets(layer) ? std::sqrt((std::max)(0., 1. - std::sqrt(-layer.kurtosis / 2.)))
                               : 1.;
}

// Whether the thickness jumps when a layer grows from k to 2 k points: on clean shapes, it grows by
// a factor of 1.4 to 2.6. Then the k points may be too few, as in one column or on one line of a
// scan.
inline bool jumps(const Layer& narrow, const Layer& wide)
{
  constexpr double jump = 3.;
  return wide.thickness > jump * narrow.thickness;
}

// Whether the width of layers of k points over their thickness is no more in those of 2 k: then
// what makes these thicker is shape. In a volume it is so by chance, where the ratio is 2.25
// (medians differ by up to 0.25).
inline bool are_thick_by_shape(const Layer& narrow, const Layer& wide)
{
  constexpr double more_than_in_a_volume = 2.6;
  return narrow.width >= more_than_in_a_volume * narrow.thickness &&
         wide.width * narrow.thickness <= narrow.width * wide.thickness;
}

// Whether a wide layer holds another sheet, next to the one of the narrow layer: it is more than
// twice as thick, so that the two tell no noise, and more than a fifth as thick as wide, as no
// clean single sheet is.
inline bool holds_another_sheet(const Layer& narrow, const Layer& wide)
{
  return wide.thickness >= 2. * narrow.thickness && wide.width < 5. * wide.thickness;
}

// Whether the thickness stays the same when a layer grows, as that of a sheet with noise does, to
// 5 %, and none by shape, which grows by a factor of 1.4 at least
inline bool is_steady(const Layer& narrow, const Layer& wide)
{
  constexpr double same = 1.1;
  return wide.thickness < same * narrow.thickness && !are_two_sheets(wide);
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_LAYERS_OF_TWO_SIZES_H
