// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_NOISE_OF_RANGE_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_NOISE_OF_RANGE_H

#include <CGAL/Curvature_aware_simplification_3/internal/noise/Layer.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Shown_noise.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Adaptive_settings.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

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

// What layers around quadrics, of more and more points, have told of a range
struct Noise_of_range
{
  static constexpr std::size_t smallest = 17, largest = 544; // points of a layer

  // noise.limit is an upper bound, from layers that are thick by their shape, as those of a twig
  // are: of these, no number of points is wide enough.
  Shown_noise noise;
  std::size_t enough = smallest; // points, to hold several columns

  // What layers tell whose inner half is on one line of a scan: there, the quadric can turn along
  // the noise of the line, meet the few points of the next, and show a part of the noise or none.
  std::optional<Shown_noise> doubtful;

  // What layers tell that may be on one line of a scan, whose noise is as large as the distance of
  // its points: the quadric or the plane then stands on the surface, and shows none of it. It
  // counts unless the thickness stays the same in larger layers.
  std::optional<Shown_noise> unconfirmed;

  void take(const Shown_noise& shown)
  {
    noise.level = shown.level;
    noise.is_reliable = shown.is_reliable;
  }

  // Points are in columns, of which balls of that radius, and only `number` points, hold several:
  // what fewer have told was of one.
  void expect_columns(double radius, std::size_t number)
  {
    noise.radius_of_columns = (std::max)(noise.radius_of_columns, radius);
    enough = (std::max)(enough, number);
    noise.limit = std::numeric_limits<double>::infinity();
    doubtful.reset();
    unconfirmed.reset();
  }

  // What layers of k / 2, k and 2 k points tell of the noise; returns whether it is known now. If
  // not, it is taken to be the thickness, until larger ones tell more.
  //
  // The narrower layer must be wide against the noise: in one as thick as wide, a fit turns along
  // the noise. And it must be broad. Where the narrowest is not, it may be two sheets. Where its
  // inner half is not broad, what it tells counts if larger ones, which see more of the shape, do
  // not tell much more.
  bool learn_from(std::size_t k, const Layer& inner, const Layer& narrow, const Layer& wide,
                  const Shown_noise& around_planes, const Adaptive_settings& settings)
  {
    // The width over the thickness. With 4, edges are lost in the neighborhoods of CAD parts with
    // noise (p99 up to 8 % larger); with less, noise that is wider than the spacing of the points
    // hides more of itself.
    constexpr double wide_enough = 3.3;
    // With 0.5, a third of the noise is missed on some lines 8 times as dense along as across.
    constexpr double nearly_all = 0.75;

    if (unconfirmed)
      return confirm(narrow, wide);
    const double noise_in_wide = settings.tell_two_sheets ? noise_in_thickness(wide) : 1.;
    const bool are_enough = k >= enough && narrow.is_broad();
    if (are_enough && narrow.width >= wide_enough * narrow.thickness)
    {
      const Shown_noise shown = shown_by(inner, narrow, wide, k > smallest ? noise_in_wide : 1.);
      if (inner.is_broad())
      {
        take(doubtful && doubtful->level >= nearly_all * shown.level ? *doubtful : shown);
        if (settings.tell_standing_fits && may_stand(narrow, wide, around_planes))
        {
          unconfirmed = noise;
          steady = is_steady(narrow, wide) ? 1 : 0;
        }
        return !unconfirmed;
      }
      doubtful = shown;
    }
    else if (settings.limit_noise_by_shape && are_enough && inner.is_broad() &&
             noise.radius_of_columns == 0. && are_thick_by_shape(narrow, wide))
      noise.limit = (std::min)(noise.limit, noise_of_layers(narrow, wide));
    noise.level = wide.thickness * noise_in_wide;
    return false;
  }

private:
  // Next to another sheet, the formula for the layer that holds it says 0.
  static Shown_noise shown_by(const Layer& inner, const Layer& narrow, const Layer& wide,
                              double noise_in_wide)
  {
    Shown_noise shown;
    shown.is_reliable = !holds_another_sheet(narrow, wide);
    if (shown.is_reliable)
      shown.level = noise_of_layers(narrow, wide) * noise_in_wide;
    else if (inner.is_broad())
      shown.level = noise_of_layers(inner, narrow);
    return shown;
  }

  // Whether the narrow layer may stand on the surface, or the planes that show less than it do: by
  // turning along the noise, those that lie in it hide a fifth
  bool may_stand(const Layer& narrow, const Layer& wide, const Shown_noise& around_planes) const
  {
    return jumps(narrow, wide) || (is_steady(narrow, wide) && around_planes.is_reliable &&
                                   around_planes.level < noise.level / 2.);
  }

  // Whether the thickness stays the same when layers grow decides what counts.
  bool confirm(const Layer& narrow, const Layer& wide)
  {
    constexpr int enough_doublings = 2; // over one, that of a thin part may stay the same by chance
    if (!is_steady(narrow, wide))
    {
      take(*unconfirmed);
      return true;
    }
    noise.level = noise_of_layers(narrow, wide);
    noise.is_reliable = noise.is_steady = ++steady == enough_doublings;
    return noise.is_steady;
  }

  int steady = 0; // doublings of a layer over which the thickness stayed the same
};

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_NOISE_OF_RANGE_H
