// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_COMPUTATION_KERNEL_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_COMPUTATION_KERNEL_H

#include <CGAL/Simple_cartesian.h>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// All stages compute in double coordinates, whatever the kernel of the caller's points.
using Computation_kernel = Simple_cartesian<double>;
using Point = Computation_kernel::Point_3;
using Vector = Computation_kernel::Vector_3;

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_COMPUTATION_KERNEL_H
