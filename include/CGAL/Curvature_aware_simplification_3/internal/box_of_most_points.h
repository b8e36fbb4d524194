// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_BOX_OF_MOST_POINTS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_BOX_OF_MOST_POINTS_H

#include <CGAL/Curvature_aware_simplification_3/internal/Computation_kernel.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Counter_based_random.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Halves first: the difference of the coordinates may overflow.
inline double half_of_longest_side(const Bbox_3& box)
{
  return (std::max)({box.xmax() / 2. - box.xmin() / 2., box.ymax() / 2. - box.ymin() / 2.,
                     box.zmax() / 2. - box.zmin() / 2.});
}

// Twice the box of the middle of each coordinate, without a `share` of the points at each end, of
// the points with the indices index(0), index(1), ..., index(number - 1). O(number)
template <typename Index>
Bbox_3 twice_the_middle_box(const std::vector<Point>& points, double share, std::size_t number,
                            const Index& index)
{
  double lower[3], upper[3];
  std::vector<double> values;
  for (int axis = 0; axis < 3; ++axis)
  {
    values.clear();
    for (std::size_t i = 0; i < number; ++i)
      values.push_back(points[index(i)][axis]);
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

[[noreturn]] inline void throw_point_too_far(const std::vector<Point>& points, const Bbox_3& most)
{
  // halves, since the difference of two coordinates may be more than the largest number
  const auto half_of_distance = [&](const Point& p)
  {
    double half = 0.;
    for (int axis = 0; axis < 3; ++axis)
      half = (std::max)(half,
                        std::abs(p[axis] / 2. - ((most.min)(axis) / 4. + (most.max)(axis) / 4.)));
    return half;
  };
  const auto farthest = std::max_element(points.begin(), points.end(),
                                         [&](const Point& p, const Point& q)
                                         { return half_of_distance(p) < half_of_distance(q); });
  const std::ptrdiff_t i = farthest - points.begin();
  throw std::invalid_argument("points: the point at index " + std::to_string(i) +
                              " is more than 1e140 times as far from most others as these are from "
                              "each other");
}

// Throws if `box`, that of all points, is so large against a box of the points in the middle that
// in its unit, the squares of their distances would underflow: what is so far away is no
// measurement, but stands for the lack of one.
inline void check_that_all_are_measurements(const std::vector<Point>& points, const Bbox_3& box,
                                            const Bbox_3& middle)
{
  constexpr double no_digits = 1e140;
  const double size = half_of_longest_side(middle);
  if (size > 0. && size <= half_of_longest_side(box) / no_digits)
    throw_point_too_far(points, middle);
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
  // Not every direction of a scanner comes back: nearly half of the points may be no measurements.
  constexpr double almost_half = 0.45;
  // Some points tell that there are none, and save the time for all. To be independent of the order
  // of the points, the answer must not depend on the choice of these: it is random, since the rows
  // of a scan could keep step with a regular one, and where twice as many are left out, one in
  // twenty is not among the rest (seven standard deviations). If there are no more than that, all
  // tell.
  constexpr std::size_t probes = 1000;
  constexpr double clearly_not_far = 10.;

  const Counter_based_random random(0, 0);
  const auto box_of_probes = [&](double share)
  {
    return twice_the_middle_box(points, share, (std::min)(probes, points.size()),
                                [&](std::size_t i) {
      return points.size() > probes ? random.bits(i) % points.size() : i;
    });
  };
  check_that_all_are_measurements(points, box, box_of_probes(almost_half));
  const double size = half_of_longest_side(box);
  if (half_of_longest_side(box_of_probes(2. * few)) * clearly_not_far > size)
    return box;
  const Bbox_3 most =
      twice_the_middle_box(points, few, points.size(), [](std::size_t i) { return i; });
  check_that_all_are_measurements(points, box, most);
  const double size_of_most = half_of_longest_side(most);
  return size_of_most > 0. && size_of_most < size / few_digits && is_difference_finite(box, most)
             ? most
             : box;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_BOX_OF_MOST_POINTS_H
