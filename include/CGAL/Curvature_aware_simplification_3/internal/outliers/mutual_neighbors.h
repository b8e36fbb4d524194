// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_MUTUAL_NEIGHBORS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_MUTUAL_NEIGHBORS_H

#include <CGAL/Curvature_aware_simplification_3/internal/features/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Searchable_points.h>

#include <cstddef>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// function(j) for those j of the k nearest points of point i that count and have it within the
// radius of their own k nearest
template <typename Counts, typename Function>
void for_each_mutual_neighbor(const Searchable_points& cloud, const Features& features,
                              std::size_t i, const Counts& counts, const Function& function)
{
  cloud.search->for_each_nearest(cloud.points[i], features.number_of_neighbors + 1,
                                 [&](std::size_t j, const Point&, double squared_distance) {
                                   if (j != i && counts(j) &&
                                       squared_distance <= squared_radius(features, j))
                                     function(j);
                                 });
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_MUTUAL_NEIGHBORS_H
