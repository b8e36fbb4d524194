// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NEAREST_LINE_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NEAREST_LINE_H

#include <CGAL/Curvature_aware_simplification_3/internal/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Neighborhood.h>
#include <CGAL/Curvature_aware_simplification_3/internal/principal_axes.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The line through the few points next to a place
struct Nearest_line
{
  Vector direction = NULL_VECTOR;
  double width = 0.; // of the points across it, over their length

  // Whether they are on it: a line of a scan, or a column of points one above the other. Of five
  // random points, the width is 0.5, and 0.1 for the vertices of long triangles; of three, it is
  // 0.27, and one in ten is on a line by chance.
  bool holds_them() const { return width < 0.05; }
};

inline Nearest_line nearest_line(const Neighbor_search& search, const Point& place, std::size_t few)
{
  static thread_local Neighborhood neighborhood;
  neighborhood.collect(search, place, few);
  const Eigen::Vector3d lambda = eigenvalues(covariance_sums(neighborhood));
  return {line_direction(neighborhood), std::sqrt((std::max)(lambda(1), 0.) / lambda(2))};
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NEAREST_LINE_H
