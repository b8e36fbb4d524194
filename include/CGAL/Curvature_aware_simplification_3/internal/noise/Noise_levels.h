// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_NOISE_LEVELS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_NOISE_LEVELS_H

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Noise.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Curve_ranges.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/median.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The noise of all points. It grows with the distance from a scanner, and differs from scan to scan
// and from material to material: each range of the Hilbert curve has its own.
struct Noise_levels
{
  std::vector<Noise> of_range;
  std::vector<std::size_t> first_point; // of each range, and the number of points

  // of ranges of equally many points
  Noise_levels(std::vector<Noise> levels, std::size_t number_of_points)
    : of_range(std::move(levels))
  {
    const Curve_ranges ranges{of_range.size(), number_of_points};
    for (std::size_t range = 0; range <= of_range.size(); ++range)
      first_point.push_back(ranges.first_point(range));
  }

  const Noise& at(std::size_t i) const
  {
    const auto next = std::upper_bound(first_point.begin(), first_point.end(), i);
    return of_range[static_cast<std::size_t>(next - first_point.begin()) - 1];
  }

  // The same noise, of some of the points, whose indices are in order
  Noise_levels of_some(const std::vector<std::size_t>& points) const
  {
    Noise_levels result = *this;
    for (std::size_t& first : result.first_point)
      first = static_cast<std::size_t>(std::lower_bound(points.begin(), points.end(), first) -
                                       points.begin());
    return result;
  }

  double median() const
  {
    std::vector<double> levels;
    for (const Noise& noise : of_range)
      levels.push_back(noise.level);
    return internal::median(levels);
  }

  // The same noise everywhere
  void make_uniform()
  {
    const double level = median();
    for (Noise& noise : of_range)
      noise.level = noise.independent_level = level;
  }

  // Smoothing takes the points in a ball with a radius of 4 sigma. So that this ball holds several
  // columns, where there are any, noise counts as that part of their radius at least.
  void widen_to_columns()
  {
    for (Noise& noise : of_range)
    {
      noise.level =
          (std::max)(noise.level, noise.radius_of_columns / largest_smoothing_radius_in_noise);
      noise.independent_level = (std::max)(noise.independent_level, noise.level);
    }
  }

  // Whether it is anywhere, when balls are as wide as columns need
  bool is_visible_above(double error) const
  {
    Noise_levels widened = *this;
    widened.widen_to_columns();
    widened.make_visible_above(error);
    return widened.is_visible();
  }

  // The narrowest fits, to 19 points, err by 0.6 sigma: where noise is just visible, by 1.2 times
  // `error`.
  void make_visible_above(double error)
  {
    for (Noise& noise : of_range)
    {
      noise.is_visible = noise.level / 2. > error;
      noise.input_level = noise.level;
      noise.visible_error = error;
    }
  }

  bool is_visible() const
  {
    return std::any_of(of_range.begin(), of_range.end(),
                       [](const Noise& noise) { return noise.is_visible; });
  }
};

inline Noise_levels uniform_noise(double level, std::size_t number_of_points)
{
  return {{Noise{level, level}}, number_of_points};
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_NOISE_LEVELS_H
