// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_INPUT_FRAME_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_INPUT_FRAME_H

#include <CGAL/Curvature_aware_simplification_3/internal/tools/Computation_kernel.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The coordinate frame of the computation: most of the points are around the origin, and the
// diagonal of the bounding box has a length in [0.5, 1). So squares do not overflow, and underflow
// only for parts below 1e-154 of the whole, for any unit, and coordinates far from the origin, as
// in UTM, lose no digits in differences and products. The scale is a power of two, hence exact.
class Frame
{
public:
  // `most` is a box that holds most of the points
  Frame(const Bbox_3& box, const Bbox_3& most)
    : m_center((most.xmin() / 2. + most.xmax() / 2.), (most.ymin() / 2. + most.ymax() / 2.),
               (most.zmin() / 2. + most.zmax() / 2.))
  {
    // std::hypot, and quarters: the plain formulas overflow for coordinates above 1e154
    const double quarter_diagonal =
        std::hypot(box.xmax() / 4. - box.xmin() / 4., box.ymax() / 4. - box.ymin() / 4.,
                   box.zmax() / 4. - box.zmin() / 4.);
    std::frexp(quarter_diagonal, &m_exponent); // in [2^(e-1), 2^e), or both are 0
    m_exponent += 2;
    const int half = m_exponent / 2;
    m_to_frame[0] = std::ldexp(1., -half);
    m_to_frame[1] = std::ldexp(1., half - m_exponent);
  }

  Point to_frame(double x, double y, double z) const
  {
    return Point(length_to_frame(x - m_center.x()), length_to_frame(y - m_center.y()),
                 length_to_frame(z - m_center.z()));
  }

  // A sample may be a little outside of the box of the points, where the caller's number type may
  // have no numbers.
  Point from_frame(const Point& p, double largest = (std::numeric_limits<double>::max)()) const
  {
    const auto coordinate = [&](int axis) {
      return (std::clamp)(m_center[axis] + length_from_frame(p[axis]), -largest, largest);
    };
    return Point(coordinate(0), coordinate(1), coordinate(2));
  }

  double length_to_frame(double length) const { return length * m_to_frame[0] * m_to_frame[1]; }
  double length_from_frame(double length) const { return std::ldexp(length, m_exponent); }

private:
  Point m_center;
  int m_exponent;
  double m_to_frame[2]; // 2^-m_exponent, which itself may overflow, in two factors
};

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_INPUT_FRAME_H
