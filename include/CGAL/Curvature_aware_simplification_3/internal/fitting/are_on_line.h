// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_ARE_ON_LINE_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_ARE_ON_LINE_H

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Neighborhood.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/principal_axes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Whether the few points next to a place are on a line, of a scan or of a column: the width of five
// random points across their line is half of their length, and a tenth for the vertices of long
// triangles.
inline bool are_on_line(const Neighbor_search& search, const Point& place, std::size_t few)
{
  static thread_local Neighborhood neighborhood;
  neighborhood.collect(search, place, few);
  const Eigen::Vector3d variances = principal_variances(covariance_sums(neighborhood));
  return std::sqrt(variances(1) / variances(2)) < least_breadth;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_ARE_ON_LINE_H
