// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SMOOTHING_THIN_DENSE_NOISE_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SMOOTHING_THIN_DENSE_NOISE_H

#include <CGAL/Curvature_aware_simplification_3/internal/depth/Depth_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Surface_fit.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Searchable_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Noise_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Noise_probes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/noise_of_scan.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Adaptive_settings.h>
#include <CGAL/Curvature_aware_simplification_3/internal/smoothing/smoothing_radii.h>
#include <CGAL/Curvature_aware_simplification_3/internal/smoothing/thin_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Curve_ranges.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/index_selection.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// How many points are in a ball of 4 sigma, which smooths a point, around each probe
template <typename ConcurrencyTag>
std::vector<double> points_in_noise(const Noise_probes& probes, const Noise_levels& noise,
                                    std::size_t most)
{
  return at_visible_noise<ConcurrencyTag>(
      probes, noise, [&](const Point& place, const Noise& here) {
        double number = 0.;
        probes.search.for_each_within(
            place, largest_smoothing_radius_in_noise * here.level,
            [&](std::size_t, const Point&, double) { number += 1.; }, most);
        return number;
      });
}

// The part of the points that is enough against the noise around, in ranges of the curve of equally
// many points.
//
// Fits take the nearest 289 points. Where a ball of 4 sigma holds many more, these are in one that
// is narrower than the noise, and share most of their distance to the surface: of 640,000 points of
// a square with noise of 13 spacings, the output was 0.7 sigma off, and of a part of them 0.3. But
// what is left out averages no noise. With four times 289 in such a ball, the nearest are in one of
// 2 sigma; with twice as many, flat parts gain and thin ones lose. As long as it holds no more than
// six times 289, all are better than a part.
template <typename ConcurrencyTag>
std::vector<double> parts_against_noise(const Searchable_points& cloud, const Noise_levels& noise,
                                        const Adaptive_settings& settings)
{
  constexpr std::size_t enough = 4 * largest_neighborhood, too_many = 6 * largest_neighborhood;
  // Noise looks smaller where points are that dense, and is measured again with the part: more are
  // not counted.
  constexpr std::size_t most = 16 * enough;

  const Noise_probes probes = smoothing_probes<ConcurrencyTag>(cloud, settings);
  const std::vector<double> in_ball = points_in_noise<ConcurrencyTag>(probes, noise, most);
  std::vector<double> parts(probes.of_range.size());
  for_each_index<ConcurrencyTag>(0, parts.size(), [&](std::size_t range) {
    // The median over many places around: ranges may be shorter than noise is wide, and were those
    // far from the surface thinned less, noise would look larger.
    const double here =
        median_of(probes.of_range[range], [&](std::size_t i) { return in_ball[i]; });
    parts[range] = here > static_cast<double>(too_many) ? static_cast<double>(enough) / here : 1.;
  });
  return parts;
}

// Those points, evenly along the curve
template <typename ConcurrencyTag>
std::vector<std::size_t> points_against_noise(const std::vector<double>& part_of_range,
                                              std::size_t number_of_points,
                                              std::size_t number_of_samples)
{
  const Curve_ranges ranges{part_of_range.size(), number_of_points};
  std::vector<double> parts(number_of_points);
  for_each_index<ConcurrencyTag>(0, ranges.number, [&](std::size_t range) {
    for (std::size_t i = ranges.first_point(range); i < ranges.first_point(range + 1); ++i)
      parts[i] = part_of_range[range];
  });
  return thin_to_parts<ConcurrencyTag>(std::move(parts), number_of_samples);
}

// Leaves out points that are too dense against visible noise, evenly along the curve, and measures
// it again, until few would be left out. Returns whether any are.
template <typename ConcurrencyTag>
bool thin_dense_noise(Searchable_points& cloud, Noise_levels& noise,
                      const std::vector<Depth_levels>& depth_levels, double visible_error,
                      std::size_t number_of_samples, const Adaptive_settings& settings)
{
  constexpr double worth_it = 0.1; // of the points: for fewer, all would be measured again
  for (bool is_thinned = false;; is_thinned = true)
  {
    noise.make_visible_above(visible_error);
    if (!noise.is_visible())
      return is_thinned;
    const std::vector<double> parts = parts_against_noise<ConcurrencyTag>(cloud, noise, settings);
    const double enough =
        mean<ConcurrencyTag>(parts.size(), [&](std::size_t r) { return parts[r]; });
    const double to_select =
        2. * static_cast<double>(number_of_samples) / static_cast<double>(cloud.size());
    if ((std::max)(enough, to_select) > 1. - worth_it)
      return is_thinned;
    const std::vector<std::size_t> kept =
        points_against_noise<ConcurrencyTag>(parts, cloud.size(), number_of_samples);
    keep_elements<ConcurrencyTag>(kept, cloud.points);
    cloud.rebuild_search<ConcurrencyTag>();
    noise = noise_of_scan<ConcurrencyTag>(cloud, depth_levels, few_probes, settings);
  }
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SMOOTHING_THIN_DENSE_NOISE_H
