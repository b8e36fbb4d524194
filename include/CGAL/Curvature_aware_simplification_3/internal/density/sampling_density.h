// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DENSITY_SAMPLING_DENSITY_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DENSITY_SAMPLING_DENSITY_H

#include <CGAL/Curvature_aware_simplification_3/internal/Scan.h>
#include <CGAL/Curvature_aware_simplification_3/internal/density/scale_to_number.h>
#include <CGAL/Curvature_aware_simplification_3/internal/density/surface_curvature.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Adaptive_settings.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Curve_ranges.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Progress.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// How many samples per area are wanted, in ranges of the curve
struct Sampling_density
{
  Curve_ranges ranges;
  // Their integral over the surface is N.
  std::vector<double> density;
  // Of each point of a range: density times the area of the surface that it stands for, more on
  // borders.
  std::vector<double> weight;
};

// The density for which a piecewise linear surface through the samples has the least error.
//
// With n samples per area, such a surface is off by about c / n where the surface has curvature c.
// Among all n with the integral N, the integral of (c / n)^p is least for n ~ c^alpha with
// alpha = p / (p + 1): 1/2 for the mean error (p = 1), 1 for the largest one; 2/3, for p = 2, is
// between the two. With alpha = 0, the density is the same everywhere.
template <typename ConcurrencyTag>
Sampling_density sampling_density(const Scan& scan, std::size_t number_of_samples, double alpha,
                                  const Adaptive_settings& settings, const Progress& progress)
{
  const Surface_curvature surface =
      surface_curvature<ConcurrencyTag>(scan, number_of_samples, settings, progress);
  const Curve_ranges& ranges = surface.ranges;

  // Bounded from below by a part of the mean, with what noise may hide. Without that, the few
  // places of a noisy plane that look bent by chance are the only ones that are, and get half of
  // all samples. In the mean, areas count as far as they get samples, as in even_density():
  // otherwise, a few far points would decide.
  const auto area = [&](std::size_t i) {
    return (std::min)(surface.area[i],
                      settings.densest * static_cast<double>(ranges.size(i)) / scan.even_density);
  };
  const auto sum_over_ranges = [&](const auto& value) {
    return reduce_indices<ConcurrencyTag>(ranges.number, 0., value, std::plus<double>());
  };
  const double mean_power =
      sum_over_ranges([&](std::size_t i) {
        return area(i) * std::pow(surface.possible_curvature[i], order_of_mean);
      }) /
      sum_over_ranges(area);
  const double least =
      mean_power > 0. ? settings.least_curvature * std::pow(mean_power, 1. / order_of_mean) : 1.;
  std::vector<double> density(ranges.number), weight(ranges.number);
  for_each_index<ConcurrencyTag>(0, ranges.number, [&](std::size_t i) {
    const double curvature = surface.curvature[i];
    density[i] = std::pow(curvature * curvature + least * least, alpha / 2.);
  });
  scale_to_number<ConcurrencyTag>(density, static_cast<double>(number_of_samples), ranges,
                                  surface.area, settings.densest);
  for_each_index<ConcurrencyTag>(
      0, ranges.number, [&](std::size_t i) { weight[i] = density[i] * surface.area_of_point[i]; });
  return {ranges, std::move(density), std::move(weight)};
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DENSITY_SAMPLING_DENSITY_H
