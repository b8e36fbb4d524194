// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FEATURES_THICK_AND_SPARSE_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FEATURES_THICK_AND_SPARSE_H

#include <CGAL/Curvature_aware_simplification_3/internal/features/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Uninitialized_vector.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/median_of_some.h>

#include <cstddef>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// What tells points in space from those of a surface: these are on thin layers, and near each
// other.

// kappa of a fold of 45 degrees between the normals, in the middle of a disk: lambda_0 = (1/4 - 16
// / (9 pi^2)) r^2 sin^2 (45 / 2 degrees). It is the flattest that counts as an edge; of 90 degrees,
// it is 0.08. Of points spread evenly in space, it is ten times as much: neither what is next to
// edges nor noise nor outliers are flat.
inline constexpr double largest_variation_of_flat_points = 0.02;

// kappa of points spread evenly in space: 0.19 on average for k = 16, and 99 % are above 0.07; that
// of a surface is, by Gaussian noise as large as the neighborhood, about 0.1 as well.
inline constexpr double least_variation_of_volumes = 0.07;

// kappa of points spread evenly in space is above that for two of five, for k = 16. On a layer of
// Gaussian noise of three quarters of the radius of a neighborhood, it is for one of eight.
inline constexpr double least_variation_of_round_volumes = 0.2;

// kappa of neighborhoods of twice the radius: it is mostly 0.03 to 0.15 for parts of a surface, and
// 0.18 to 0.26 in space.
inline constexpr double largest_variation_of_parts = 0.15;

// The same at the border of a volume is that of a half ball, 0.13.
inline constexpr double least_variation_at_borders_of_volumes = 0.12;

// From which 1/rho on points are sparse, by the median radius of all
struct Sparseness
{
  double of_outliers;     // 3 times the median radius: they may be outliers
  double of_sparse_parts; // twice: most of them are on sparse parts of a surface
};

inline Sparseness sparseness_of(const Uninitialized_vector<double>& inverse_density)
{
  constexpr std::size_t many = 10000; // all limits for far points follow from it: 0.5 % of rank
  const double median = median_of_some<Sequential_tag>(
      inverse_density.size(), [&](std::size_t i) { return inverse_density[i]; }, many);
  return {3. * 3. * median, 2. * 2. * median};
}

inline bool is_thick_and_sparse(const Features& features, std::size_t i, double variation,
                                double inverse_density)
{
  return features.surface_variation[i] > variation && features.inverse_density[i] > inverse_density;
}

// Whether so many points that look like outliers are more than a clean scan has. Of 15 of these, at
// most one in 2000 points had few votes; where one in 20 was an outlier, one in 130 at least had.
// Of few points, up to three are by chance: of 6000 clean squares, disks and ellipsoids of 100 to
// 999 points, one had three, none had more.
inline bool is_more_than_a_few(std::size_t suspects, std::size_t points)
{
  return suspects > 3 + points / 1000;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FEATURES_THICK_AND_SPARSE_H
