// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_FACET_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_FACET_H

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Neighborhood.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/are_on_line.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/principal_axes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Searchable_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Curve_ranges.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/median.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The cosine of 10 degrees: two planes with a smaller angle face the same direction.
inline constexpr double cosine_of_faces = 0.985;

// A few neighbors of a point, and their plane
struct Facet
{
  Point point = Point(0., 0., 0.);
  Vector normal = NULL_VECTOR;
  double thickness = 0.; // standard deviation of the heights
  double radius = 0.;
  double spacing = 0.; // of the points
  bool is_broad = false;
};

inline Facet facet_around(const Neighbor_search& search, const Point& place)
{
  constexpr std::size_t k = 8;   // a point and the ring around it
  constexpr std::size_t few = 5; // more than are on a line by chance
  static thread_local Neighborhood neighborhood;
  neighborhood.collect(search, place, k);
  const Principal_axes axes(covariance_sums(neighborhood));
  const Eigen::Vector3d variances = axes.variances();
  Facet facet;
  facet.point = place;
  facet.normal = axes.axis(0);
  facet.thickness = std::sqrt(variances(0));
  facet.radius = neighborhood.radius;
  facet.spacing = facet.radius * std::sqrt(CGAL_PI / static_cast<double>(k));
  // On no line of a scan, nor on two: then, the few next to the place are on one.
  facet.is_broad = are_broad(radius_of_disk(variances(1)), radius_of_disk(variances(2))) &&
                   !are_on_line(search, place, few);
  return facet;
}

// The facets of points evenly along the Hilbert curve
template <typename ConcurrencyTag>
std::vector<Facet> some_facets(const Searchable_points& cloud)
{
  constexpr std::size_t most = 256; // a sixteenth of them is one of the points to 1.5 %
  std::vector<Facet> facets((std::min)(most, cloud.size()));
  for_each_index<ConcurrencyTag>(0, facets.size(), [&](std::size_t i) {
    facets[i] =
        facet_around(*cloud.search, cloud.points[middle_of_part(i, facets.size(), cloud.size())]);
  });
  return facets;
}

// Errors of coordinates change the difference of two heights by up to 2 sqrt(3) of them, less than
// 4.
inline double tolerance_of_rounding(double coordinate_error)
{
  return 4. * coordinate_error;
}

// How thick facets of points in one plane are at most. Few smooth surfaces are that flat from one
// point to the next, and those that are so are flat everywhere.
inline double thickness_of_flat_facets(const std::vector<Facet>& facets, double coordinate_error)
{
  constexpr double relative = 0.02; // to the distance of the points
  std::vector<double> spacings;
  for (const Facet& facet : facets)
    spacings.push_back(facet.spacing);
  return (std::max)(relative * median(spacings), tolerance_of_rounding(coordinate_error));
}

inline bool is_flat(const Facet& facet, double tolerance)
{
  return facet.is_broad && facet.thickness <= tolerance;
}

inline bool has_normal(const Facet& facet, const Vector& normal, double tolerance)
{
  return facet.radius * sine_of_angle(facet.normal, normal) <= tolerance;
}

// The mean of the normals of the flattest half of some facets: of the others, some have points of
// two levels and are just flat enough.
inline Vector mean_normal(const std::vector<Facet>& facets)
{
  std::vector<double> thicknesses;
  for (const Facet& facet : facets)
    thicknesses.push_back(facet.thickness);
  const double half = median(thicknesses);
  Vector sum = NULL_VECTOR;
  for (const Facet& facet : facets)
    if (facet.thickness <= half)
      sum = sum + (sum * facet.normal < 0. ? -facet.normal : facet.normal);
  return sum / std::sqrt(sum.squared_length());
}

// The normals that `many` or more of the flat facets share, those of most facets first
inline std::vector<Vector> common_normals(const std::vector<Facet>& facets, double tolerance,
                                          std::size_t many)
{
  std::vector<Facet> flat;
  std::copy_if(facets.begin(), facets.end(), std::back_inserter(flat),
               [&](const Facet& f) { return is_flat(f, tolerance); });

  const auto number_with = [&](const Vector& normal) {
    return static_cast<std::size_t>(std::count_if(flat.begin(), flat.end(), [&](const Facet& f) {
      return has_normal(f, normal, tolerance);
    }));
  };
  std::vector<Vector> result;
  while (flat.size() >= many)
  {
    std::size_t most = 0;
    Vector normal = NULL_VECTOR;
    for (const Facet& candidate : flat)
    {
      const std::size_t number = number_with(candidate.normal);
      if (number > most)
      {
        most = number;
        normal = candidate.normal;
      }
    }
    if (most < many)
      break;
    const auto parallel = std::partition(flat.begin(), flat.end(), [&](const Facet& f) {
      return !has_normal(f, normal, tolerance);
    });
    result.push_back(mean_normal(std::vector<Facet>(parallel, flat.end())));
    flat.erase(parallel, flat.end());
  }
  return result;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_FACET_H
