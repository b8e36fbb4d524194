// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_INPUT_CHECK_THAT_ALL_ARE_MEASUREMENTS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_INPUT_CHECK_THAT_ALL_ARE_MEASUREMENTS_H

#include <CGAL/Curvature_aware_simplification_3/internal/input/half_of_longest_side.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Computation_kernel.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Counter_based_random.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/some_points.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Half of the largest difference of the coordinates: the difference itself may overflow.
inline double half_of_distance(const Point& p, const Point& q)
{
  return (std::max)({std::abs(p.x() / 2. - q.x() / 2.), std::abs(p.y() / 2. - q.y() / 2.),
                     std::abs(p.z() / 2. - q.z() / 2.)});
}

// The share of the points that are within twice `half` of p; 0 if all of these are equal
inline double share_within(const std::vector<Point>& points, const Point& p, double half)
{
  std::size_t number = 0;
  bool are_equal = true;
  for (const Point& q : points)
    if (half_of_distance(p, q) <= half)
    {
      ++number;
      are_equal = are_equal && p == q;
    }
  return are_equal ? 0. : static_cast<double>(number) / static_cast<double>(points.size());
}

[[noreturn]] inline void throw_point_too_far(const std::vector<Point>& points, const Point& from,
                                             const std::string& times)
{
  const auto farthest =
      std::max_element(points.begin(), points.end(), [&](const Point& p, const Point& q) {
        return half_of_distance(p, from) < half_of_distance(q, from);
      });
  throw std::invalid_argument("points: the point at index " +
                              std::to_string(farthest - points.begin()) + " is more than " + times +
                              " times as far from many others as these are from each other");
}

// What is far from a tenth of the points is no measurement, but stands for the lack of one. That
// may be most of the points, as not every direction of a scanner comes back. Throws if `box`, that
// of all points, is so large against the distances of a tenth of them that in its unit, the squares
// of these would underflow, or, where its center is the origin, that these points, enough for a
// surface, would be one by rounding.
inline void check_that_all_are_measurements(const std::vector<Point>& points, const Bbox_3& box,
                                            bool is_its_center_the_origin)
{
  // Of the box: the square of the one is a number with all its digits, and the other is a few units
  // in the last place.
  constexpr double too_small = 1e-140, equal = 1e-15;
  // A tenth of fewer points may be copies of one that differ by rounding.
  constexpr double share = 0.1, enough = 50.;
  // Of a thousand random points, less than 60 for a tenth of all is more than four standard
  // deviations off, and none of 150 is in that tenth once in 10^7 inputs. If there may be something
  // so far, all points tell.
  constexpr double share_of_some = 0.06;
  constexpr std::uint64_t candidates = 150;

  const std::vector<Point> some = some_points(points);
  const Counter_based_random random(0, 1);
  const double half = half_of_longest_side(box);
  const double share_for_a_surface = (std::max)(share, enough / static_cast<double>(points.size()));
  for (std::uint64_t i = 0; i < candidates; ++i)
  {
    const Point& p = points[random.bits(i) % points.size()];
    if (share_within(some, p, equal * half) < share_of_some)
      continue;
    if (share_within(some, p, too_small * half) >= share_of_some &&
        share_within(points, p, too_small * half) >= share)
      throw_point_too_far(points, p, "1e140");
    if (is_its_center_the_origin && share_within(points, p, equal * half) >= share_for_a_surface)
      throw_point_too_far(points, p, "1e15");
  }
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_INPUT_CHECK_THAT_ALL_ARE_MEASUREMENTS_H
