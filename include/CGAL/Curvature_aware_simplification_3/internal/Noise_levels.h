// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_LEVELS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_LEVELS_H

#include <CGAL/Curvature_aware_simplification_3/internal/Curve_ranges.h>
#include <CGAL/Curvature_aware_simplification_3/internal/median.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The noise of the points of one place
struct Noise
{
  double level = 0.; // standard deviation sigma of their distance to the surface
  // That of independent noise with which a fit to many points would err as much: larger if they share their
  // noise, as smoothed points do
  double independent_level = 0.;
  // At the distance of the samples: only then is it worth time to reduce it.
  bool is_visible = false;
  double visible_error = 0.; // of a fit, above which it is visible there
};

// The noise of all points. It grows with the distance from a scanner, and differs from scan to scan and
// from material to material: each range of the Hilbert curve has its own.
struct Noise_levels
{
  std::vector<Noise> of_range;
  std::size_t number_of_points;

  Curve_ranges ranges() const { return {of_range.size(), number_of_points}; }
  const Noise& at(std::size_t i) const { return of_range[ranges().range_of(i)]; }

  double median() const
  {
    std::vector<double> levels;
    for (const Noise& noise : of_range)
      levels.push_back(noise.level);
    return internal::median(levels);
  }

  double least() const
  {
    return std::min_element(of_range.begin(), of_range.end(),
                            [](const Noise& a, const Noise& b) { return a.level < b.level; })
        ->level;
  }

  // The narrowest fits have an error of up to sigma / 2.
  void make_visible_above(double error)
  {
    for (Noise& noise : of_range)
    {
      noise.is_visible = noise.level / 2. > error;
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

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_LEVELS_H
