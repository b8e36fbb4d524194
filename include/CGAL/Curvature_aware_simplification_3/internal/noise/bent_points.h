// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_BENT_POINTS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_BENT_POINTS_H

#include <CGAL/Curvature_aware_simplification_3/internal/features/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/features/thick_and_sparse.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Noise_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Flags.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <cstddef>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Which points are on a surface that bends so much that there may be an edge: 1 if so. Noise alone
// causes kappa = sigma^2 / (r^2 / 2) in a disk of radius r.
template <typename ConcurrencyTag>
Flags bent_points(const Features& features, const Noise_levels& noise)
{
  Flags is_bent(features.surface_variation.size());
  for_each_index<ConcurrencyTag>(0, is_bent.size(), [&](std::size_t i) {
    const double squared_size = squared_radius(features, i);
    const double sigma = noise.at(i).level;
    is_bent[i] = features.surface_variation[i] * squared_size >
                         largest_variation_of_flat_points * squared_size + 2. * sigma * sigma
                     ? 1
                     : 0;
  });
  return is_bent;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_BENT_POINTS_H
