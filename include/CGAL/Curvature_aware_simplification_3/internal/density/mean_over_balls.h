// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DENSITY_MEAN_OVER_BALLS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DENSITY_MEAN_OVER_BALLS_H

#include <CGAL/Curvature_aware_simplification_3/internal/density/Surface_balls.h>
#include <CGAL/Curvature_aware_simplification_3/internal/density/surface_pieces.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Uninitialized_vector.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Of each range of the curve, the power mean of order p of the values in its ball: that of the
// range that a piece is of, by the area A of the piece, (sum A_j value_j^p / sum A_j)^(1/p). What
// is a step along the surface becomes a slope.
template <typename ConcurrencyTag>
std::vector<double> mean_over_balls(const std::vector<double>& value, double p,
                                    const Uninitialized_vector<Surface_piece>& pieces,
                                    std::size_t pieces_in_range, const Surface_balls& balls)
{
  const std::size_t n = value.size();
  std::vector<double> power(n), mean(n);
  for_each_index<ConcurrencyTag>(0, n, [&](std::size_t i) { power[i] = std::pow(value[i], p); });
  for_each_index<ConcurrencyTag>(0, n, [&](std::size_t i) {
    double sum = 0., area = 0.;
    for (std::size_t j : balls.of(i))
    {
      sum += pieces[j].area * power[j / pieces_in_range];
      area += pieces[j].area;
    }
    mean[i] = area > 0. ? std::pow(sum / area, 1. / p) : value[i];
  });
  return mean;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DENSITY_MEAN_OVER_BALLS_H
