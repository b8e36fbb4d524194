// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_CURVE_RANGES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_CURVE_RANGES_H

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The points along the Hilbert curve in ranges of equally many, up to one: compact parts of the
// surface, each with measures of its own. There is at least one range.
struct Curve_ranges
{
  static constexpr std::size_t most = 0xffffffff; // ranges: products of two are below 2^64

  std::size_t number;
  std::size_t number_of_points;

  // point * number / number_of_points rounded down, where that product may have more than 64 bits
  std::size_t range_of(std::size_t point) const
  {
    if (std::uint64_t(number_of_points) >> 32 == 0)
      return static_cast<std::size_t>(std::uint64_t(point) * number / number_of_points);
    auto range = static_cast<std::size_t>(
        static_cast<double>(point) *
        (static_cast<double>(number) / static_cast<double>(number_of_points)));
    while (first_point(range) > point)
      --range;
    while (first_point(range + 1) <= point)
      ++range;
    return range;
  }

  // The least point of a range, range * number_of_points / number rounded up; that of the number of
  // ranges is the number of points.
  std::size_t first_point(std::size_t range) const
  {
    const std::size_t quotient = number_of_points / number, rest = number_of_points % number;
    return range * quotient +
           static_cast<std::size_t>((std::uint64_t(range) * rest + number - 1) / number);
  }

  std::size_t size(std::size_t range) const { return first_point(range + 1) - first_point(range); }
};

// The middle of the i-th of some equal parts of n places along the curve: for measures that a few
// of them tell
inline std::size_t middle_of_part(std::size_t i, std::size_t number_of_parts, std::size_t n)
{
  return static_cast<std::size_t>((2 * std::uint64_t(i) + 1) * n / (2 * number_of_parts));
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_CURVE_RANGES_H
