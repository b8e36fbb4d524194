// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_AROUND_QUADRICS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_AROUND_QUADRICS_H

#include <CGAL/Curvature_aware_simplification_3/internal/Adaptive_settings.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Layer.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Noise_probes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Shown_noise.h>
#include <CGAL/Curvature_aware_simplification_3/internal/find_columns.h>
#include <CGAL/Curvature_aware_simplification_3/internal/median.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The part of the thickness that is noise where a layer is so thick that it may be two sheets, at
// heights of a and -a with noise sigma: s^2 = a^2 + sigma^2, and the excess kurtosis is -2 a^4 /
// s^4. It is about -0.45 for a single sheet, whose noise is cut off by the ball that layers are
// taken from, and -0.5 where two sheets begin to show as two.
inline double noise_in_thickness(const Layer& layer)
{
  constexpr double surely_two_sheets = -0.65;
  return layer.kurtosis < surely_two_sheets
             ? std::sqrt((std::max)(0., 1. - std::sqrt(-layer.kurtosis / 2.)))
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

// What layers around quadrics, of more and more points, have told of a range
struct Noise_of_range
{
  static constexpr std::size_t smallest = 17, largest = 544; // points of a layer

  Shown_noise noise;
  // Noise is no more than is told by layers that are thick by their shape, as those of a twig are:
  // of these, no number of points is wide enough.
  double limit = std::numeric_limits<double>::infinity();
  std::size_t enough = smallest; // points, to hold several columns

  // What layers tell whose inner half is on one line of a scan: there, the quadric can turn along
  // the noise of the line, meet the few points of the next, and show a part of the noise or none.
  std::optional<Shown_noise> doubtful;

  void take(const Shown_noise& shown)
  {
    noise.level = shown.level;
    noise.is_reliable = shown.is_reliable;
  }

  // Whether layers of k / 2, k and 2 k points tell the noise. If not, it is taken to be the
  // thickness, until larger ones tell more.
  //
  // The narrower layer must be wide against the noise: in one as thick as wide, a fit turns along
  // the noise. And it must be broad. Where the narrowest is not, it may be two sheets. Where its
  // inner half is not broad, what it tells counts if larger ones, which see more of the shape, do
  // not tell much more.
  bool is_told_by(std::size_t k, const Layer& inner, const Layer& narrow, const Layer& wide,
                  const Adaptive_settings& settings)
  {
    // The width over the thickness. With 4, edges are lost in the neighborhoods of CAD parts with
    // noise (p99 up to 8 % larger); with less, noise that is wider than the spacing of the points
    // hides more of itself.
    constexpr double wide_enough = 3.3;
    // With 0.5, a third of the noise is missed on some lines 8 times as dense along as across.
    constexpr double nearly_all = 0.75;

    const double level = noise_of_layers(narrow, wide);
    const double noise_in_wide = settings.tell_two_sheets ? noise_in_thickness(wide) : 1.;
    const bool are_enough = k >= enough && narrow.is_broad();
    if (are_enough && narrow.width >= wide_enough * narrow.thickness)
    {
      const Shown_noise shown{level * (k > smallest ? noise_in_wide : 1.), 0.,
                              !holds_another_sheet(narrow, wide)};
      if (inner.is_broad())
      {
        take(doubtful && doubtful->level >= nearly_all * shown.level ? *doubtful : shown);
        return true;
      }
      doubtful = shown;
    }
    else if (settings.limit_noise_by_shape && are_enough && inner.is_broad() &&
             are_thick_by_shape(narrow, wide))
      limit = (std::min)(limit, level);
    noise.level = wide.thickness * noise_in_wide;
    return false;
  }
};

// The noise of each range that layers around quadrics show.
//
// Where no k up to 544 tells it, the noise is all there is to see, and sigma is the thickness; but
// if that is more than the median, it may be that of a thin part, and the median counts. If the
// points end before for most ranges, they are too few to tell noise from shape, and are taken as
// they are.
template <typename ConcurrencyTag>
std::vector<Shown_noise>
noise_around_quadrics(const Noise_probes& probes, const Neighbor_search& search,
                      std::size_t number_of_points, const Adaptive_settings& settings)
{
  const auto layers = [&](const std::vector<std::size_t>& ranges, std::size_t k)
  { return median_layers<ConcurrencyTag>(probes, ranges, search, k, Layer_around_quadric()); };

  std::vector<std::size_t> unknown = all_ranges(probes);
  std::vector<Noise_of_range> of_range(unknown.size());
  std::size_t k = Noise_of_range::smallest;
  std::vector<Layer> inner = layers(unknown, k / 2), narrow = layers(unknown, k);
  for (; !unknown.empty() && k <= Noise_of_range::largest && 2 * k <= number_of_points; k *= 2)
  {
    std::vector<Layer> wide = layers(unknown, 2 * k);
    if (settings.find_columns)
    {
      const std::vector<double> columns =
          find_columns<ConcurrencyTag>(probes, unknown, search, k, narrow, wide);
      for (std::size_t range : unknown)
        if (columns[range] > 0.)
        {
          double& radius = of_range[range].noise.radius_of_columns;
          radius = (std::max)(radius, columns[range]);
          of_range[range].enough = 4 * k;
        }
    }
    unknown.erase(std::remove_if(unknown.begin(), unknown.end(),
                                 [&](std::size_t range) {
      return of_range[range].is_told_by(k, inner[range], narrow[range], wide[range], settings);
                  }),
                  unknown.end());
    inner.swap(narrow);
    narrow.swap(wide);
  }
  const bool are_too_few = k <= Noise_of_range::largest && 2 * unknown.size() >= of_range.size();
  std::vector<double> levels;
  for (const Noise_of_range& here : of_range)
    levels.push_back(here.noise.level);
  const double most = are_too_few ? 0. : median(levels);
  for (std::size_t range : unknown)
    if (of_range[range].doubtful)
      of_range[range].take(*of_range[range].doubtful);
    else
      of_range[range].limit = (std::min)(of_range[range].limit, most);
  std::vector<Shown_noise> noise;
  for (Noise_of_range& here : of_range)
  {
    here.noise.level = (std::min)(here.noise.level, here.limit);
    noise.push_back(here.noise);
  }
  return noise;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_AROUND_QUADRICS_H
