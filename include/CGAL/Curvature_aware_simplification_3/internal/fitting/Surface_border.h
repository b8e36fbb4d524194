// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_SURFACE_BORDER_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_SURFACE_BORDER_H

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Local_surface.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Neighborhood.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Where the input ends around a sample: the half-plane a x + b y <= limit of the tangent plane.
// Repulsion pushes samples across a border; there they stop, and so the border is kept where it is,
// while averages would draw it inwards.
struct Surface_border
{
  bool exists = false;
  double x = 0., y = 0.; // outwards, of unit length
  double limit = 0.;

  // moves (a, b) back to the border if it is beyond
  void move_back(double& a, double& b) const
  {
    const double excess = a * x + b * y - limit;
    if (!(exists && excess > 0.))
      return;
    a -= excess * x;
    b -= excess * y;
  }
};

// The mean of the neighbors lies 0.29 R off the center of a half disk, and 0.1 R off that of a disk
// of 18 random points. Wrongly found borders do no harm: the input's extent is a limit everywhere.
inline Surface_border find_border(const Neighborhood& neighborhood, const Local_surface& surface)
{
  Surface_border border;
  if (!(neighborhood.radius > 0.))
    return border;
  const Vector offset = neighborhood.center - surface.origin;
  const Weight_by_distance weight_by_distance(neighborhood.radius); // whatever the fit left out
  Vector weighted(0., 0., 0.);
  double sum = 0.;
  for (const Neighborhood::Neighbor& neighbor : neighborhood.neighbors)
  {
    const double weight = weight_by_distance(neighbor.squared_distance);
    weighted = weighted + weight * neighbor.position;
    sum += weight;
  }
  weighted = weighted + sum * offset;
  const double x = weighted * surface.u, y = weighted * surface.v;
  const double length = std::sqrt(x * x + y * y);
  if (!(length > 0.15 * sum * neighborhood.radius))
    return border;
  border.exists = true;
  border.x = -x / length;
  border.y = -y / length;
  // the extent of the neighbors in a strip around the outward direction
  border.limit = -neighborhood.radius;
  for (const Neighborhood::Neighbor& neighbor : neighborhood.neighbors)
  {
    const Vector position = neighbor.position + offset;
    const double a = position * surface.u, b = position * surface.v;
    if (std::abs(a * border.y - b * border.x) < 0.5 * neighborhood.radius)
      border.limit = (std::max)(border.limit, a * border.x + b * border.y);
  }
  // The last of random points is short of the end by the length that holds one point: 1 / (density
  // x width), for k points in half a disk and a strip as wide as R: pi R / 2 k
  border.limit += 0.5 * CGAL_PI * neighborhood.radius / static_cast<double>(neighborhood.size());
  return border;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_SURFACE_BORDER_H
