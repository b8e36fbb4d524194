// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_INPUT_BOX_OF_MOST_POINTS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_INPUT_BOX_OF_MOST_POINTS_H

#include <CGAL/Curvature_aware_simplification_3/internal/input/half_of_longest_side.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Computation_kernel.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/some_points.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Twice the box of the middle of each coordinate, without a `share` of the points at each end. O(n)
inline Bbox_3 twice_the_middle_box(const std::vector<Point>& points, double share)
{
  double lower[3], upper[3];
  std::vector<double> values(points.size());
  for (int axis = 0; axis < 3; ++axis)
  {
    for (std::size_t i = 0; i < points.size(); ++i)
      values[i] = points[i][axis];
    const auto outside = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
    std::nth_element(values.begin(), values.begin() + outside, values.end());
    const double low = values[static_cast<std::size_t>(outside)];
    std::nth_element(values.begin(), values.end() - 1 - outside, values.end());
    const double high = *(values.end() - 1 - outside);
    const double center = low / 2. + high / 2., half = high / 2. - low / 2.;
    lower[axis] = center - 2. * half;
    upper[axis] = center + 2. * half;
  }
  return Bbox_3(lower[0], lower[1], lower[2], upper[0], upper[1], upper[2]);
}

// Whether coordinates relative to the center of `most` are numbers for all in `box`
inline bool is_difference_finite(const Bbox_3& box, const Bbox_3& most)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double center = (most.min)(axis) / 2. + (most.max)(axis) / 2.;
    const double low = (box.min)(axis), high = (box.max)(axis);
    if (!std::isfinite(high - center) || !std::isfinite(center - low))
      return false;
  }
  return true;
}

// A box that holds most of the points, if that of all, `box`, is a hundred times as large: a few
// points that are so far away would otherwise decide over the precision of all. `box` in all other
// cases.
inline Bbox_3 box_of_most_points(const std::vector<Point>& points, const Bbox_3& box)
{
  // Two of the seven digits of a float, with which curvature is still known. Nearer points cost
  // less.
  constexpr double few_digits = 100.;
  // One in twenty on each side is what may be far; of most shapes, twice the rest holds all.
  constexpr double few = 0.05;
  // Some points tell that there are none, and save the time for all: where twice as many are left
  // out, one in twenty is not among the rest (seven standard deviations).
  constexpr double clearly_not_far = 10.;

  const double size = half_of_longest_side(box);
  const Bbox_3 most_of_some = twice_the_middle_box(some_points(points), 2. * few);
  if (half_of_longest_side(most_of_some) * clearly_not_far > size)
    return box;
  const Bbox_3 most = twice_the_middle_box(points, few);
  const double size_of_most = half_of_longest_side(most);
  return size_of_most > 0. && size_of_most < size / few_digits && is_difference_finite(box, most)
             ? most
             : box;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_INPUT_BOX_OF_MOST_POINTS_H
