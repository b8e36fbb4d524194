// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_FIT_FOLD_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_FIT_FOLD_H

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Local_surface.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Neighborhood.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/fit_quadric.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/two_planes.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Whether two planes explain the weighted neighbors, and better than a quadric, which has as many
// parameters. `tolerance` is how far from its plane a point may be.
inline bool fit_fold(const Neighborhood& neighborhood, double tolerance, Fold& fold)
{
  // Others may be on a third face, or where an edge is rounded.
  constexpr double explained = 0.8;
  // Of the squared residuals of the quadric. If both explain the points equally well, there is no
  // reason to see an edge; with noise, the quadric's residuals are hardly more than the noise.
  constexpr double better = 0.75;
  // cos 45 degrees, for the angle between the normals: flatter folds are bends of a mesh of
  // triangles, and a quadric follows them
  constexpr double flattest = 0.7071;

  Local_surface quadric;
  if (!fit_quadric_over_plane(neighborhood, 0., quadric))
    return false;
  double weight = 0., quadric_squares = 0.;
  for (const Neighborhood::Neighbor& neighbor : neighborhood.neighbors)
  {
    const double residual = quadric.residual(neighbor.position);
    weight += neighbor.weight;
    quadric_squares += neighbor.weight * residual * residual;
  }
  // Three standard residuals are within the tolerance, and so nearly all points: no need to look
  // for planes. That of a fold of 45 degrees in the middle of a disk is 0.025 radii, of 90 degrees
  // 0.06.
  if (9. * quadric_squares <= weight * tolerance * tolerance)
    return false;

  static thread_local std::vector<Vector> points;
  points.clear();
  for (const Neighborhood::Neighbor& neighbor : neighborhood.neighbors)
    points.push_back(neighbor.position);
  if (!two_planes(points, tolerance, fold) ||
      std::abs(fold.planes[0].normal * fold.planes[1].normal) > flattest)
    return false;
  const std::ptrdiff_t on_fold = std::count_if(
      points.begin(), points.end(), [&](const Vector& p) { return fold.distance(p) < tolerance; });
  double fold_squares = 0.;
  for (const Neighborhood::Neighbor& neighbor : neighborhood.neighbors)
  {
    const double residual = fold.distance(neighbor.position);
    fold_squares += neighbor.weight * residual * residual;
  }
  return static_cast<double>(on_fold) >= explained * static_cast<double>(points.size()) &&
         fold_squares < better * quadric_squares;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_FIT_FOLD_H
