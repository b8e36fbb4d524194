// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_MARKED_POINTS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_MARKED_POINTS_H

#include <CGAL/Curvature_aware_simplification_3/internal/features/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/features/thick_and_sparse.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Searchable_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Flags.h>

#include <cstddef>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// What the stages that look for outliers see: the points, their features, from which 1/rho on they
// are far from others, and which of them are marked as outliers, 1 for those that are
struct Marked_points
{
  const Searchable_points& cloud;
  const Features& features;
  Sparseness sparseness;
  Flags& is_outlier;

  std::size_t size() const { return cloud.size(); }
  const Point& point(std::size_t i) const { return cloud.points[i]; }
  std::size_t k() const { return features.number_of_neighbors; }
};

// function(j) for those j of the k nearest points of point i that count and have it within the
// radius of their own k nearest
template <typename Counts, typename Function>
void for_each_mutual_neighbor(const Marked_points& points, std::size_t i, const Counts& counts,
                              const Function& function)
{
  points.cloud.search->for_each_nearest(
      points.point(i), points.k() + 1, [&](std::size_t j, const Point&, double squared_distance) {
        if (j != i && counts(j) && squared_distance <= squared_radius(points.features, j))
          function(j);
      });
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_MARKED_POINTS_H
