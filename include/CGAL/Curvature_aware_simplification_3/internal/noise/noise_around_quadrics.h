// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_NOISE_AROUND_QUADRICS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_NOISE_AROUND_QUADRICS_H

#include <CGAL/Curvature_aware_simplification_3/internal/noise/Layer.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Noise_of_range.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Noise_probes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/columns_of_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/noise_around_planes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Adaptive_settings.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/index_selection.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/median.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The noise that a fourth of the ranges exceed whose layers tell it: all but the unknown ones,
// which come in order. Nothing is known if these ranges are less than an eighth, which may be a
// part with less noise.
inline std::optional<double> upper_known_noise(const std::vector<Noise_of_range>& of_range,
                                               const std::vector<std::size_t>& unknown)
{
  std::vector<double> known;
  for (std::size_t range = 0; range < of_range.size(); ++range)
    if (!std::binary_search(unknown.begin(), unknown.end(), range))
      known.push_back(of_range[range].noise.level);
  if (8 * known.size() < of_range.size())
    return std::nullopt;
  const auto upper = known.begin() + static_cast<std::ptrdiff_t>(3 * known.size() / 4);
  std::nth_element(known.begin(), upper, known.end());
  return *upper;
}

// Limits the noise of ranges of which no layer tells it, to `most` and to what others have. A layer
// that is up to twice as thick as the noise of those is a thin part with that noise. What is
// thicker is not: it may be noise that is wider than any layer shows. With 1.6 and 2.5, errors are
// the same to 1 %.
inline void limit_unknown_noise(const std::vector<std::size_t>& unknown, double most,
                                std::vector<Noise_of_range>& of_range)
{
  constexpr double thin_part = 2.;
  const std::optional<double> upper = upper_known_noise(of_range, unknown);
  for (std::size_t range : unknown)
  {
    Noise_around_quadrics& noise = of_range[range].noise;
    noise.limit = (std::min)(noise.limit, most);
    if (upper && noise.level < thin_part * *upper)
      noise.limit = (std::min)(noise.limit, *upper);
  }
}

// What layers of growing numbers of points tell of each range, and the ranges of which they do not
template <typename ConcurrencyTag>
struct Growing_layers
{
  std::vector<Noise_of_range> of_range;
  std::vector<std::size_t> unknown;
  bool are_points_too_few; // the largest layers would have more

  Growing_layers(const Noise_probes& probes, const std::vector<Noise_around_planes>& around_planes,
                 const Columns& columns, const Adaptive_settings& settings)
    : of_range(probes.of_range.size()), unknown(all_ranges(probes))
  {
    const auto layers = [&](std::size_t k) {
      return median_layers<ConcurrencyTag>(probes, unknown, k, Layer_around_quadric());
    };
    std::size_t k = Noise_of_range::smallest;
    std::vector<Layer> inner = layers(k / 2), narrow = layers(k);
    for (; !unknown.empty() && k <= Noise_of_range::largest && 2 * k <= probes.search.size();
         k *= 2)
    {
      std::vector<Layer> wide = layers(2 * k);
      expect_columns(probes, columns, k);
      unknown.erase(std::remove_if(unknown.begin(), unknown.end(),
                                   [&](std::size_t range) {
                                     return of_range[range].learn_from(
                                         k, inner[range], narrow[range], wide[range],
                                         around_planes[range], settings);
                                   }),
                    unknown.end());
      inner.swap(narrow);
      narrow.swap(wide);
    }
    are_points_too_few = k <= Noise_of_range::largest;
  }

  // Takes what is there of the unknown ranges, if it is anything: it is known then.
  void take(std::optional<Noise_around_quadrics> Noise_of_range::*guess)
  {
    unknown.erase(std::remove_if(unknown.begin(), unknown.end(),
                                 [&](std::size_t range) {
                                   Noise_of_range& here = of_range[range];
                                   if (!(here.*guess))
                                     return false;
                                   here.take(*(here.*guess));
                                   return true;
                                 }),
                  unknown.end());
  }

private:
  // where k points hold too few columns, they show a plane along these and no noise
  void expect_columns(const Noise_probes& probes, const Columns& columns, std::size_t k)
  {
    const std::vector<std::size_t> in_columns = those_where<ConcurrencyTag>(
        unknown, [&](std::size_t range) { return columns.exist[range] != 0; });
    const std::vector<Column> around =
        median_columns<ConcurrencyTag>(probes, in_columns, columns.axis, k);
    for (std::size_t range : in_columns)
      if (around[range].is_one_of_few(k))
        of_range[range].expect_columns(around[range].radius, 2 * k);
  }
};

// The noise of each range that layers around quadrics show.
//
// Where no k up to 544 tells it, the noise is all there is to see, and sigma is the thickness; but
// that may be of a thin part, and so it is limited: by the median of all, and by what is known of
// others. If the points end before for most ranges, they are too few to tell noise from shape, and
// are taken as they are.
template <typename ConcurrencyTag>
std::vector<Noise_around_quadrics>
noise_around_quadrics(const Noise_probes& probes,
                      const std::vector<Noise_around_planes>& around_planes, const Columns& columns,
                      const Adaptive_settings& settings)
{
  Growing_layers<ConcurrencyTag> layers(probes, around_planes, columns, settings);
  layers.take(&Noise_of_range::unconfirmed); // where the points end before larger layers can tell
  const bool are_too_few =
      layers.are_points_too_few && 2 * layers.unknown.size() >= layers.of_range.size();
  std::vector<double> levels;
  for (const Noise_of_range& here : layers.of_range)
    levels.push_back(here.noise.level);
  const double most = are_too_few ? 0. : median(levels);
  layers.take(&Noise_of_range::doubtful);
  limit_unknown_noise(layers.unknown, most, layers.of_range);
  std::vector<Noise_around_quadrics> noise;
  for (const Noise_of_range& here : layers.of_range)
    noise.push_back(here.noise);
  return noise;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_NOISE_AROUND_QUADRICS_H
