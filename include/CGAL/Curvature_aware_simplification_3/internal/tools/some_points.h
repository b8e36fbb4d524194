// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_SOME_POINTS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_SOME_POINTS_H

#include <CGAL/Curvature_aware_simplification_3/internal/tools/Computation_kernel.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Counter_based_random.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// A thousand points, which tell what most of all are like in no time, or all, if they are no more.
// They are random, since the rows of a scan could keep step with a regular choice. So that the
// result does not depend on the order of the points, what they decide must be what any other
// thousand would.
inline std::vector<Point> some_points(const std::vector<Point>& points)
{
  constexpr std::size_t number = 1000;
  if (points.size() <= number)
    return points;
  const Counter_based_random random(0, 0);
  std::vector<Point> result(number);
  for (std::size_t i = 0; i < number; ++i)
    result[i] = points[random.bits(i) % points.size()];
  return result;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_SOME_POINTS_H
