// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_IS_OFF_PLANE_OF_NEIGHBORS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_IS_OFF_PLANE_OF_NEIGHBORS_H

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Covariance_sums.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/principal_axes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/outliers/Marked_points.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Whether point i is off the plane of those of its k nearest points that are no outliers, by more
// than a part of the radius of the neighborhood: less is no outlier that matters. A border or an
// end of a surface is not, though it has few votes. With 0.1, 0.2, 0.3 and 0.4, of the points of a
// surface that are lost without this, 0.42, 0.22, 0.12 and 0.05 still are (5 % outliers), and up to
// 1.5 % more outliers are missed.
inline bool is_off_plane_of_neighbors(const Marked_points& points, std::size_t i)
{
  constexpr double far_off = 0.3;
  Covariance_sums sums;
  double squared_radius = 0.;
  points.cloud.search->for_each_nearest(
      points.point(i), points.k() + 1, [&](std::size_t j, const Point& p, double squared_distance) {
        squared_radius = (std::max)(squared_radius, squared_distance);
        if (j != i && points.is_outlier[j] == 0)
          sums.add(p - points.point(i));
      });
  return sums.weight < 3. || std::abs(sums.mean() * Principal_axes(sums).axis(0)) >=
                                 far_off * std::sqrt(squared_radius);
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_IS_OFF_PLANE_OF_NEIGHBORS_H
