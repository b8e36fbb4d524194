// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PAPER_DENSITY_WEIGHTS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PAPER_DENSITY_WEIGHTS_H

#include <CGAL/Curvature_aware_simplification_3/internal/paper/Theta.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The local density of each point (Huang et al. 2009, eq. 3): 1 + sum of theta over the others,
// which is the sum over all, since theta(0) = 1.
template <typename ConcurrencyTag>
std::vector<double> density_weights(const std::vector<Point>& points, const Neighbor_search& search,
                                    double radius, const Progress& progress)
{
  const Theta theta(radius);
  std::vector<double> weights(points.size());
  for_each_index<ConcurrencyTag>(points.size(), progress, [&](std::size_t i) {
    double sum = 0.;
    search.for_each_within(points[i], radius,
                           [&](std::size_t, const Point&, double squared_distance) {
                             sum += theta(squared_distance);
                           });
    weights[i] = sum;
  });
  return weights;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PAPER_DENSITY_WEIGHTS_H
