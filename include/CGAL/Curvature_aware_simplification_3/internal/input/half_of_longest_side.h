// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_INPUT_HALF_OF_LONGEST_SIDE_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_INPUT_HALF_OF_LONGEST_SIDE_H

#include <CGAL/Bbox_3.h>

#include <algorithm>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Halves first: the difference of the coordinates may overflow.
inline double half_of_longest_side(const Bbox_3& box)
{
  return (std::max)({box.xmax() / 2. - box.xmin() / 2., box.ymax() / 2. - box.ymin() / 2.,
                     box.zmax() / 2. - box.zmin() / 2.});
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_INPUT_HALF_OF_LONGEST_SIDE_H
