// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DENSITY_LATTICE_SPACING_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DENSITY_LATTICE_SPACING_H

#include <CGAL/Curvature_aware_simplification_3/internal/tools/Uninitialized_vector.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The spacing of a hexagonal lattice with a density of points: s^2 = 2 / (sqrt(3) density)
inline double lattice_spacing(double density)
{
  return std::sqrt(2. / (std::sqrt(3.) * density));
}

// The sum of the areas that the points stand for
template <typename ConcurrencyTag>
double area_of_surface(const Uninitialized_vector<double>& inverse_density)
{
  return reduce_indices<ConcurrencyTag>(
      inverse_density.size(), 0., [&](std::size_t i) { return CGAL_PI * inverse_density[i]; },
      std::plus<double>());
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DENSITY_LATTICE_SPACING_H
