// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_POINT_OF_CURVE_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_POINT_OF_CURVE_H

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Neighborhood.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Parabola_sums.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/principal_axes.h>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The point beside x of the curve that neighbors are on: their position is a parabola over the way
// t along them, of which c0 is at x.
inline Point point_of_curve(const Neighborhood& neighborhood, const Point& x)
{
  if (!(neighborhood.radius > 0.))
    return x;
  const Vector along = line_direction(neighborhood);
  const Vector offset = neighborhood.center - x;
  Parabola_sums<3> sums;
  for (const Neighborhood::Neighbor& neighbor : neighborhood.neighbors)
  {
    const Vector p = (neighbor.position + offset) / neighborhood.radius;
    sums.add(p * along, {p.x(), p.y(), p.z()}, neighbor.weight);
  }
  const Parabola_sums<3>::Value c0 = sums.coefficients().row(0);
  const Vector step(c0.x(), c0.y(), c0.z());
  // not beyond the neighbors, where a few of them may tell no parabola
  return step.squared_length() <= 1. ? x + neighborhood.radius * step : x;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_POINT_OF_CURVE_H
