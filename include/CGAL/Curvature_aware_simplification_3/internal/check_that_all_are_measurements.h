// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_CHECK_THAT_ALL_ARE_MEASUREMENTS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_CHECK_THAT_ALL_ARE_MEASUREMENTS_H

#include <CGAL/Curvature_aware_simplification_3/internal/Computation_kernel.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Counter_based_random.h>
#include <CGAL/Curvature_aware_simplification_3/internal/half_of_longest_side.h>
#include <CGAL/Curvature_aware_simplification_3/internal/some_points.h>

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
    if (std::abs(p.x() / 2. - q.x() / 2.) <= half && half_of_distance(p, q) <= half)
    {
      ++number;
      are_equal = are_equal && p == q;
    }
  return are_equal ? 0. : static_cast<double>(number) / static_cast<double>(points.size());
}

[[noreturn]] inline void throw_point_too_far(const std::vector<Point>& points, const Point& from)
{
  const auto farthest = std::max_element(points.begin(), points.end(),
                                         [&](const Point& p, const Point& q) {
    return half_of_distance(p, from) < half_of_distance(q, from);
  });
  throw std::invalid_argument("points: the point at index " +
                              std::to_string(farthest - points.begin()) +
                              " is more than 1e140 times as far from many others as these are from "
                              "each other");
}

// Throws if `box`, that of all points, is so large against the distances of a tenth of them that in
// its unit, the squares of these would underflow: what is so far away is no measurement, but stands
// for the lack of one. That may be most of the points, as not every direction of a scanner comes
// back.
inline void check_that_all_are_measurements(const std::vector<Point>& points, const Bbox_3& box)
{
  constexpr double no_digits = 1e140;
  constexpr double share = 0.1;
  // Of a thousand random points, less than 60 for a tenth of all is more than four standard
  // deviations off, and none of 150 is in that tenth once in 10^7 inputs. If there may be something
  // so far, all points tell.
  constexpr double share_of_some = 0.06;
  constexpr std::uint64_t candidates = 150;

  const std::vector<Point> some = some_points(points);
  const Counter_based_random random(0, 1);
  const double half = half_of_longest_side(box) / no_digits;
  for (std::uint64_t i = 0; i < candidates; ++i)
  {
    const Point& p = points[random.bits(i) % points.size()];
    if (share_within(some, p, half) >= share_of_some && share_within(points, p, half) >= share)
      throw_point_too_far(points, p);
  }
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_CHECK_THAT_ALL_ARE_MEASUREMENTS_H
