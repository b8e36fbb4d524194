// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_MEAN_OVER_RANGES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_MEAN_OVER_RANGES_H

#include <CGAL/Curvature_aware_simplification_3/internal/Curve_ranges.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/loops.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Of each range, the power mean of order p of the values of the ranges nearest to it, itself among them:
// (sum A_j value_j^p / sum A_j)^(1/p) with their areas A_j. What is a step along the surface becomes a slope.
template <typename ConcurrencyTag>
std::vector<double> mean_over_ranges(const std::vector<double>& value, double p,
                                     const std::vector<double>& area,
                                     const std::vector<Point>& centers, std::size_t number)
{
  const Neighbor_search search(centers, ConcurrencyTag());
  const std::size_t n = value.size();
  std::vector<double> weighted(n), mean(n);
  for_each_index<ConcurrencyTag>(
      0, n, [&](std::size_t i) { weighted[i] = area[i] * std::pow(value[i], p); });
  for_each_index<ConcurrencyTag>(0, n,
                                 [&](std::size_t i)
                                 {
    double sum = 0., sum_of_areas = 0.;
    search.for_each_nearest(centers[i], (std::min)(number, n),
                            [&](std::size_t j, const Point&, double)
                            {
      sum += weighted[j];
      sum_of_areas += area[j];
    });
    mean[i] = sum_of_areas > 0. ? std::pow(sum / sum_of_areas, 1. / p) : value[i];
  });
  return mean;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_MEAN_OVER_RANGES_H
