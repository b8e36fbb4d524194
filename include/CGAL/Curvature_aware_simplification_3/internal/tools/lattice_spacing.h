// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_LATTICE_SPACING_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_LATTICE_SPACING_H

#include <cmath>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The spacing of a hexagonal lattice with a density of points: s^2 = 2 / (sqrt(3) density)
inline double lattice_spacing(double density)
{
  return std::sqrt(2. / (std::sqrt(3.) * density));
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_LATTICE_SPACING_H
