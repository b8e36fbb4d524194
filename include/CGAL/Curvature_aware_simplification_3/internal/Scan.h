// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SCAN_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SCAN_H

#include <CGAL/Curvature_aware_simplification_3/internal/input/Searchable_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Noise_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Uninitialized_vector.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/lattice_spacing.h>

#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// What the stages that place samples see of the input: without outliers, and with less noise where
// it was visible
struct Scan : Searchable_points
{
  Uninitialized_vector<double> inverse_density; // 1 / rho of each point
  Noise_levels noise;                           // that is left
  double even_density;            // of samples that are spread evenly, see even_density()
  std::vector<Point> bent_points; // at which there may be an edge
  double sparse_inverse_density;  // 1 / rho of points that are far from others, and more
  // Where there were, some were not found, and the point nearest to a sample may be one.
  bool had_more_than_a_few_outliers;

  // of samples that are spread evenly
  double spacing() const { return lattice_spacing(even_density); }
};

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SCAN_H
