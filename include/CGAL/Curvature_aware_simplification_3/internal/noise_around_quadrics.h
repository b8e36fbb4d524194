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

// The noise of each range that layers around quadrics show. The narrower layer must be wide against
// the noise: in one as thick as wide, a fit turns along the noise. And it must be broad, as must
// its inner half: if that is on one line of a scan, the quadric can turn along the noise of the
// line, and meet the few points of the next.
//
// Where the narrowest is not, it may be two sheets. Where there is no such k up to 544, the noise
// is all there is to see, and sigma is the thickness; but if that is more than the median, it may
// be that of a thin part, and the median counts. If the points end before for most ranges, they are
// too few to tell noise from shape, and are taken as they are. Nowhere does noise count for more
// than is told by layers that are thick by their shape, as those of a twig are: of these, no k is
// wide enough.
template <typename ConcurrencyTag>
std::vector<Shown_noise>
noise_around_quadrics(const Noise_probes& probes, const Neighbor_search& search,
                      std::size_t number_of_points, const Adaptive_settings& settings)
{
  constexpr std::size_t smallest = 17, largest = 544;
  // The width over the thickness. With 4, edges are lost in the neighborhoods of CAD parts with
  // noise (p99 up to 8 % larger); with less, noise that is wider than the spacing of the points
  // hides more of itself.
  constexpr double wide_enough = 3.3;

  const auto layers = [&](const std::vector<std::size_t>& ranges, std::size_t k)
  { return median_layers<ConcurrencyTag>(probes, ranges, search, k, Layer_around_quadric()); };
  const auto noise_in = [&](const Layer& layer)
  { return settings.tell_two_sheets ? noise_in_thickness(layer) : 1.; };
  std::vector<std::size_t> unknown = all_ranges(probes);
  std::vector<Shown_noise> noise(unknown.size());
  std::vector<double> limit(unknown.size(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> enough(unknown.size(), smallest); // points to hold several columns
  std::size_t k = smallest;
  std::vector<Layer> inner = layers(unknown, k / 2), narrow = layers(unknown, k);
  for (; !unknown.empty() && k <= largest && 2 * k <= number_of_points; k *= 2)
  {
    std::vector<Layer> wide = layers(unknown, 2 * k);
    const std::vector<double> columns =
        settings.find_columns
            ? find_columns<ConcurrencyTag>(probes, unknown, search, k, narrow, wide)
            : std::vector<double>(noise.size(), 0.);
    std::vector<std::size_t> thick;
    for (std::size_t range : unknown)
    {
      Shown_noise& here = noise[range];
      if (columns[range] > 0.)
      {
        here.radius_of_columns = (std::max)(here.radius_of_columns, columns[range]);
        enough[range] = 4 * k;
      }
      const double level = noise_of_layers(narrow[range], wide[range]);
      const bool are_enough =
          k >= enough[range] && inner[range].is_broad() && narrow[range].is_broad();
      if (are_enough && narrow[range].width >= wide_enough * narrow[range].thickness)
      {
        here.level = level * (k > smallest ? noise_in(wide[range]) : 1.);
        here.is_reliable = !holds_another_sheet(narrow[range], wide[range]);
      }
      else
      {
        if (settings.limit_noise_by_shape && are_enough &&
            are_thick_by_shape(narrow[range], wide[range]))
          limit[range] = (std::min)(limit[range], level);
        // until a larger size tells more
        here.level = wide[range].thickness * noise_in(wide[range]);
        thick.push_back(range);
      }
    }
    unknown.swap(thick);
    inner.swap(narrow);
    narrow.swap(wide);
  }
  const bool are_too_few = k <= largest && 2 * unknown.size() >= noise.size();
  std::vector<double> levels;
  for (const Shown_noise& here : noise)
    levels.push_back(here.level);
  const double most = are_too_few ? 0. : median(levels);
  for (std::size_t range : unknown)
    limit[range] = (std::min)(limit[range], most);
  for (std::size_t range = 0; range < noise.size(); ++range)
    noise[range].level = (std::min)(noise[range].level, limit[range]);
  return noise;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_AROUND_QUADRICS_H
