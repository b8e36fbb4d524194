// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DENSITY_EVEN_DENSITY_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DENSITY_EVEN_DENSITY_H

#include <CGAL/Curvature_aware_simplification_3/internal/density/scale_with_limits.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Uninitialized_vector.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The density t of `number` samples that are spread evenly over the surface: with the areas A_i =
// pi / rho_i that the points stand for,
//   sum_i min(t A_i, L) = number.
//
// L is what scale_to_number() lets a point have, `densest`. Points far from all others, as outliers
// that were not found or the ground behind what was scanned, stand for large areas and get few
// samples: 24 of 50,000 points in a box 40 times as large as a sphere had more than 200 times its
// area, and noise that is seen at the spacing of the samples on the sphere is not at 16 times that.
// Where nearly as many samples as points are asked for, all get more, and L is twice the share of a
// point.
template <typename ConcurrencyTag>
double even_density(const Uninitialized_vector<double>& inverse_density, std::size_t number,
                    double densest)
{
  const std::size_t n = inverse_density.size();
  const double share = static_cast<double>(number) / static_cast<double>(n);
  const double limit = (std::max)(densest, 2. * share);
  return scale_with_limits<ConcurrencyTag>(
      n, static_cast<double>(number), [&](std::size_t i) { return CGAL_PI * inverse_density[i]; },
      [&](std::size_t) { return limit; });
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DENSITY_EVEN_DENSITY_H
