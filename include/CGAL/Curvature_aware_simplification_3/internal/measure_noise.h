// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_MEASURE_NOISE_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_MEASURE_NOISE_H

#include <CGAL/Curvature_aware_simplification_3/internal/Adaptive_settings.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Noise_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Noise_probes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/find_columns.h>
#include <CGAL/Curvature_aware_simplification_3/internal/median.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Standard deviation sigma of the noise, from layers of k and of 2 k points. Their thickness s holds noise
// and shape. Noise is the same for all sizes, but what a quadric misses of the shape is not: on smooth
// surfaces it grows with the cube of the radius, on scanned ones, which have details of all sizes, about with
// its square (s_2k^2 is 2 to 7 times s_k^2 on clean shapes, 4 in the mean), and so does what a plane misses. So
// s_k^2 = sigma^2 + c k^2, and two sizes tell the two apart: sigma^2 = (4 s_k^2 - s_2k^2) / 3.
inline double noise_of_layers(const Layer& narrow, const Layer& wide)
{
  return std::sqrt((std::max)(
      0., (4. * narrow.thickness * narrow.thickness - wide.thickness * wide.thickness) / 3.));
}

// The part of the thickness that is noise where a layer is so thick that it may be two sheets, at heights of a
// and -a with noise sigma: s^2 = a^2 + sigma^2, and the excess kurtosis is -2 a^4 / s^4. It is about -0.45 for a single
// sheet, whose noise is cut off by the ball that layers are taken from, and -0.5 where two sheets begin to show as two.
inline double noise_in_thickness(const Layer& layer)
{
  constexpr double surely_two_sheets = -0.65;
  return layer.kurtosis < surely_two_sheets
             ? std::sqrt((std::max)(0., 1. - std::sqrt(-layer.kurtosis / 2.)))
             : 1.;
}

inline std::vector<std::size_t> all_ranges(const Noise_probes& probes)
{
  std::vector<std::size_t> ranges(probes.of_range.size());
  std::iota(ranges.begin(), ranges.end(), std::size_t(0));
  return ranges;
}

// The noise of each range that layers around quadrics show. The narrower layer must be broad, and wide against
// the noise: in one as thick as wide, a fit turns along the noise.
//
// Where the narrowest is not, it may be two sheets. Where there is no such k up to about 500, the noise is all there is
// to see, and sigma is the thickness; but if that is more than the median, it may be that of a thin part, and
// the median counts. If the points end before for most ranges, they are too few to tell noise from shape, and are
// taken as they are.
template <typename ConcurrencyTag>
std::vector<Noise> noise_around_quadrics(const Noise_probes& probes, const Neighbor_search& search,
                                         std::size_t number_of_points,
                                         const Adaptive_settings& settings)
{
  constexpr std::size_t smallest = 17, largest = 1000;
  // The width over the thickness. With 4, edges are lost in the neighborhoods of CAD parts with noise (p99 up
  // to 8 % larger); with less, noise that is wider than the spacing of the points hides more of itself.
  constexpr double wide_enough = 3.3;

  const auto layers = [&](const std::vector<std::size_t>& ranges, std::size_t k)
  { return median_layers<ConcurrencyTag>(probes, ranges, search, k, Layer_around_quadric()); };
  const auto noise_in = [&](const Layer& layer)
  { return settings.tell_two_sheets ? noise_in_thickness(layer) : 1.; };
  std::vector<std::size_t> unknown = all_ranges(probes);
  std::vector<Noise> noise(unknown.size());
  std::vector<std::size_t> enough(unknown.size(), smallest); // points to hold several columns
  std::size_t k = smallest;
  std::vector<Layer> narrow = layers(unknown, k);
  for (; !unknown.empty() && k <= largest && 2 * k <= number_of_points; k *= 2)
  {
    std::vector<Layer> wide = layers(unknown, 2 * k);
    const std::vector<std::uint8_t> are_columns =
        find_columns<ConcurrencyTag>(probes, unknown, search, k, narrow, wide, settings, noise);
    std::vector<std::size_t> thick;
    for (std::size_t range : unknown)
    {
      if (are_columns[range] != 0)
        enough[range] = 4 * k;
      if (k >= enough[range] && narrow[range].is_broad() &&
          narrow[range].width >= wide_enough * narrow[range].thickness)
        noise[range].level = noise_of_layers(narrow[range], wide[range]) *
                             (k > smallest ? noise_in(wide[range]) : 1.);
      else
      {
        // until a larger size tells more
        noise[range].level = wide[range].thickness * noise_in(wide[range]);
        thick.push_back(range);
      }
    }
    unknown.swap(thick);
    narrow.swap(wide);
  }
  const bool are_too_few = k <= largest && 2 * unknown.size() >= noise.size();
  std::vector<double> values;
  for (const Noise& here : noise)
    values.push_back(here.level);
  const double limit = are_too_few ? 0. : median(values);
  for (std::size_t range : unknown)
    noise[range].level = (std::min)(noise[range].level, limit);
  return noise;
}

// The same for layers around planes, which reach half as far: they see only one side of a part that is as thick
// as 1.6 spacings of the points, and less of details that these hardly show. Infinite where they are too
// narrow to tell.
template <typename ConcurrencyTag>
std::vector<Noise> noise_around_planes(const Noise_probes& probes, const Neighbor_search& search,
                                       const Adaptive_settings& settings)
{
  constexpr std::size_t k = 7; // a point and the ring around it
  // A plane turns along the noise as well: with 5, it shows up to a tenth too little of it.
  constexpr double wide_enough = 6.;

  const std::vector<std::size_t> ranges = all_ranges(probes);
  const auto layers = [&](std::size_t number)
  { return median_layers<ConcurrencyTag>(probes, ranges, search, number, Layer_around_plane()); };
  const std::vector<Layer> narrow = layers(k), wide = layers(2 * k);
  std::vector<Noise> noise(ranges.size());
  const std::vector<std::uint8_t> are_columns =
      find_columns<ConcurrencyTag>(probes, ranges, search, k, narrow, wide, settings, noise);
  for (std::size_t range : ranges)
    noise[range].level = are_columns[range] == 0 && narrow[range].is_broad() &&
                                 narrow[range].width >= wide_enough * narrow[range].thickness
                             ? noise_of_layers(narrow[range], wide[range])
                             : std::numeric_limits<double>::infinity();
  return noise;
}

// Standard deviation sigma of the distance of the points to the surface, by place. What a fit misses of the shape
// looks like noise and never makes it look less, so of two kinds of fits the one that shows less counts.
template <typename ConcurrencyTag>
Noise_levels measure_noise(const std::vector<Point>& points, const Neighbor_search& search,
                           const Adaptive_settings& settings = Adaptive_settings())
{
  const Noise_probes probes = noise_probes<ConcurrencyTag>(points);
  std::vector<Noise> noise =
      noise_around_quadrics<ConcurrencyTag>(probes, search, points.size(), settings);
  if (settings.noise_around_planes)
  {
    const std::vector<Noise> around_planes =
        noise_around_planes<ConcurrencyTag>(probes, search, settings);
    for (std::size_t range = 0; range < noise.size(); ++range)
    {
      Noise& here = noise[range];
      here.level = (std::min)(here.level, around_planes[range].level);
      here.radius_of_columns =
          (std::max)(here.radius_of_columns, around_planes[range].radius_of_columns);
    }
  }
  for (Noise& here : noise)
    here.independent_level = here.level;
  return {std::move(noise), points.size()};
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_MEASURE_NOISE_H
