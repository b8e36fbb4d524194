// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SMOOTHING_THIN_POINTS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SMOOTHING_THIN_POINTS_H

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Surface_fit.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Noise_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Curve_ranges.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Uninitialized_vector.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/index_selection.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/sum_up.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The neighbors of a point by which it is smoothed: 24, four for each coefficient of a quadric, or
// all in a ball
inline constexpr std::size_t smoothing_neighborhood = 25;

// The part of the points that is enough to smooth all: those in the ball that smooths one are all
// averaged into it, so that more than a full neighborhood per ball tell the same again. All, where
// noise is not visible: there, points are not smoothed.
inline double part_to_smooth(const Noise& noise, double inverse_density)
{
  const double radius = noise.smoothing_radius;
  const double points_in_ball = radius * radius / inverse_density;
  constexpr double enough = static_cast<double>(smoothing_neighborhood);
  return noise.is_visible && points_in_ball > enough ? enough / points_in_ball : 1.;
}

// That of each point, from the mean 1/rho of ranges of the curve. With its own, points far from a
// surface, where noise is sparse, would be kept more often than those near it. A mean keeps all of
// a sparse place that shares a range with a dense one.
template <typename ConcurrencyTag>
std::vector<double> parts_to_smooth(const Uninitialized_vector<double>& inverse_density,
                                    const Noise_levels& noise)
{
  constexpr std::size_t points_in_range = 256; // with 64 and 1024, results are the same to 1 %
  const std::size_t n = inverse_density.size();
  const Curve_ranges ranges{n / points_in_range + 1, n};
  std::vector<double> parts(n);
  for_each_index<ConcurrencyTag>(0, ranges.number, [&](std::size_t range) {
    const std::size_t begin = ranges.first_point(range), end = ranges.first_point(range + 1);
    double sum = 0.;
    for (std::size_t i = begin; i < end; ++i)
      sum += inverse_density[i];
    for (std::size_t i = begin; i < end; ++i)
      parts[i] = part_to_smooth(noise.at(i), sum / static_cast<double>(end - begin));
  });
  return parts;
}

// The indices of some of the points, evenly along the curve, of which each counts for a part: one
// wherever the sum of the parts passes an integer. At least two for each sample remain, and enough
// to fit surfaces to, but for one by rounding, if there are so many: what is missing is taken from
// all places alike.
template <typename ConcurrencyTag>
std::vector<std::size_t> thin_to_parts(std::vector<double> part, std::size_t number_of_samples)
{
  const std::size_t n = part.size();
  const double all = static_cast<double>(n);
  const double enough = reduce_indices<ConcurrencyTag>(
      n, 0., [&](std::size_t i) { return part[i]; }, std::plus<double>());
  const double to_fit = static_cast<double>(fewest_points_to_fit + 1); // one may be lost
  const double wanted =
      (std::min)((std::max)(2. * static_cast<double>(number_of_samples), to_fit), all);
  std::vector<double> sum = std::move(part);
  if (enough < wanted)
  {
    const double more = (wanted - enough) / (all - enough);
    for_each_index<ConcurrencyTag>(0, n, [&](std::size_t i) { sum[i] += more * (1. - sum[i]); });
  }
  sum_up<ConcurrencyTag>(sum);
  return indices_where<ConcurrencyTag>(
      n, [&](std::size_t i) { return std::floor(sum[i]) > std::floor(i > 0 ? sum[i - 1] : 0.); });
}

// Those that are smoothed
template <typename ConcurrencyTag>
std::vector<std::size_t> thin_points(const Uninitialized_vector<double>& inverse_density,
                                     const Noise_levels& noise, std::size_t number_of_samples)
{
  return thin_to_parts<ConcurrencyTag>(parts_to_smooth<ConcurrencyTag>(inverse_density, noise),
                                       number_of_samples);
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SMOOTHING_THIN_POINTS_H
