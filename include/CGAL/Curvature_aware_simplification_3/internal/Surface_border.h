// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SURFACE_BORDER_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SURFACE_BORDER_H

#include <CGAL/Curvature_aware_simplification_3/internal/Local_surface.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Neighborhood.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL
{
namespace Curvature_aware_simplification_3
{
namespace internal
{

// Where the input ends around a sample: the half-plane a x + b y <= limit of the tangent plane.
// Repulsion pushes samples across a border; there they stop, and so the border is kept where it is,
// while averages would draw it inwards.
struct Surface_border
{
  bool exists = false;
  double x = 0., y = 0.; // outwards, of unit length
  double limit = 0.;

  void restrict(double& a, double& b) const
  {
    const double excess = a * x + b * y - limit;
    if (exists && excess > 0.)
    {
      a -= excess * x;
      b -= excess * y;
    }
  }
};

// The mean of the neighbors lies 0.29 R off the center of a half disk, and 0.1 R off that of a disk
// of 18 random points. Wrongly found borders do no harm: the input's extent is a limit everywhere.
inline Surface_border find_border(const Neighbor_search& search, std::size_t number_of_points,
                                  const Local_surface& surface)
{
  static thread_local Neighborhood neighborhood;
  neighborhood.collect(search, surface.origin, (std::min)(std::size_t(19), number_of_points));
  Surface_border border;
  if (!(neighborhood.radius > 0.))
    return border;
  neighborhood.weight_by_distance([](const Neighborhood::Neighbor& neighbor)
                                  { return neighbor.squared_distance; });
  double x = 0., y = 0., sum = 0.;
  for (const Neighborhood::Neighbor& neighbor : neighborhood.neighbors)
  {
    x += neighbor.weight * (neighbor.position * surface.u);
    y += neighbor.weight * (neighbor.position * surface.v);
    sum += neighbor.weight;
  }
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
    const double a = neighbor.position * surface.u, b = neighbor.position * surface.v;
    if (std::abs(a * border.y - b * border.x) < 0.5 * neighborhood.radius)
      border.limit = (std::max)(border.limit, a * border.x + b * border.y);
  }
  return border;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SURFACE_BORDER_H
