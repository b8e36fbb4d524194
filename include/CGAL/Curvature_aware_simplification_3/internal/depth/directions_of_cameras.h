// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_DIRECTIONS_OF_CAMERAS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_DIRECTIONS_OF_CAMERAS_H

#include <CGAL/Curvature_aware_simplification_3/internal/depth/Facet.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Neighborhood.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/principal_axes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Whether a third of the facets with that normal are oblique to the surface, as 256 points show it:
// of the facets on steps of 2 to 6 cameras, four of five are at least, of the faces of a part those
// next to its edges, of smooth parts that are flat from one point to the next one of a hundred.
inline bool are_oblique(const std::vector<Facet>& facets, const Vector& normal, double tolerance,
                        const Neighbor_search& search)
{
  constexpr std::size_t points_of_surface = 256;
  constexpr std::size_t most = 16; // are looked at
  Neighborhood neighborhood;
  std::size_t number = 0, oblique = 0;
  for (const Facet& facet : facets)
    if (number < most && is_flat(facet, tolerance) && has_normal(facet, normal, tolerance))
    {
      neighborhood.collect(search, facet.point, points_of_surface);
      ++number;
      if (std::abs(plane_normal(neighborhood) * normal) < cosine_of_faces)
        ++oblique;
    }
  return 3 * oblique > number;
}

// Directions that many facets face, but not the surface: cameras look along them. This saves to
// look at all points of most parts, which would take half of a call.
inline std::vector<Vector> directions_of_cameras(const std::vector<Facet>& facets, double tolerance,
                                                 const Neighbor_search& search)
{
  // Where cameras see the same, hardly a facet is flat.
  const std::size_t many = facets.size() / 64 + 1;
  std::vector<Vector> result = common_normals(facets, tolerance, many);
  result.erase(std::remove_if(result.begin(), result.end(),
                              [&](const Vector& normal) {
                                return !are_oblique(facets, normal, tolerance, search);
                              }),
               result.end());
  return result;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_DIRECTIONS_OF_CAMERAS_H
