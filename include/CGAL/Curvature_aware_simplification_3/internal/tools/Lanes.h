// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_LANES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_LANES_H

#include <CGAL/Curvature_aware_simplification_3/internal/tools/Computation_kernel.h>

#include <Eigen/Core>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Two numbers in the two lanes of a vector register, which every processor has: loops over
// neighbors take two of these at once. With one after the other, a call takes 4 % longer, for
// repulsion and residuals where it is clean, and for the sums of fits where it is noisy.
using Lanes = Eigen::Array2d;

// A vector in each lane
struct Vector_lanes
{
  Lanes x, y, z;

  Vector_lanes(const Vector& p, const Vector& q) : x(p.x(), q.x()), y(p.y(), q.y()), z(p.z(), q.z())
  {}

  Lanes squared_length() const { return x * x + y * y + z * z; }
};

inline Lanes operator*(const Vector_lanes& v, const Vector& axis)
{
  return v.x * axis.x() + v.y * axis.y() + v.z * axis.z();
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_LANES_H
