// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_CURVE_RANGES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_CURVE_RANGES_H

#include <cstddef>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The points along the Hilbert curve in ranges of equally many, up to one: compact parts of the surface,
// each with measures of its own. There is at least one range.
struct Curve_ranges
{
  std::size_t number;
  std::size_t number_of_points;

  std::size_t range_of(std::size_t point) const { return point * number / number_of_points; }

  // the least point of a range; that of the number of ranges is the number of points
  std::size_t first_point(std::size_t range) const
  {
    return (range * number_of_points + number - 1) / number;
  }

  std::size_t size(std::size_t range) const { return first_point(range + 1) - first_point(range); }
};

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_CURVE_RANGES_H
