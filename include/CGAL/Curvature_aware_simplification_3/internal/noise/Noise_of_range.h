// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_NOISE_OF_RANGE_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_NOISE_OF_RANGE_H

#include <CGAL/Curvature_aware_simplification_3/internal/noise/Layer.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/layers_of_two_sizes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/noise_around_planes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Adaptive_settings.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// What quadrics show of the noise of a range
struct Noise_around_quadrics
{
  double level = 0.;
  bool is_reliable = true; // if not, that of planes counts, if it is known
  bool is_steady = false;  // the same in layers of many sizes, as nothing but noise is
  double limit = std::numeric_limits<double>::infinity(); // the noise is no more than this
  double radius_of_columns = 0.; // of balls that hold several of them, or 0
};

// What layers around quadrics, of more and more points, have told of a range
struct Noise_of_range
{
  static constexpr std::size_t smallest = 17, largest = 544; // points of a layer

  // noise.limit is an upper bound, from layers that are thick by their shape, as those of a twig
  // are: of these, no number of points is wide enough.
  Noise_around_quadrics noise;
  std::size_t enough = smallest; // points, to hold several columns

  // What layers tell whose inner half is on one line of a scan: there, the quadric can turn along
  // the noise of the line, meet the few points of the next, and show a part of the noise or none.
  std::optional<Noise_around_quadrics> doubtful;

  // What layers tell that may be on one line of a scan, whose noise is as large as the distance of
  // its points: the quadric or the plane then stands on the surface, and shows none of it. It
  // counts unless the thickness stays the same in larger layers.
  std::optional<Noise_around_quadrics> unconfirmed;

  void take(const Noise_around_quadrics& shown)
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
                  const Noise_around_planes& around_planes, const Adaptive_settings& settings)
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
      const Noise_around_quadrics shown =
          shown_by(inner, narrow, wide, k > smallest ? noise_in_wide : 1.);
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
  static Noise_around_quadrics shown_by(const Layer& inner, const Layer& narrow, const Layer& wide,
                                        double noise_in_wide)
  {
    Noise_around_quadrics shown;
    shown.is_reliable = !holds_another_sheet(narrow, wide);
    if (shown.is_reliable)
      shown.level = noise_of_layers(narrow, wide) * noise_in_wide;
    else if (inner.is_broad())
      shown.level = noise_of_layers(inner, narrow);
    return shown;
  }

  // Whether the narrow layer may stand on the surface, or the planes that show less than it do: by
  // turning along the noise, those that lie in it hide a fifth
  bool may_stand(const Layer& narrow, const Layer& wide,
                 const Noise_around_planes& around_planes) const
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
