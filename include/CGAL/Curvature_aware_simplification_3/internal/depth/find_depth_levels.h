// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_FIND_DEPTH_LEVELS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_FIND_DEPTH_LEVELS_H

#include <CGAL/Curvature_aware_simplification_3/internal/depth/Depth_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/depth/is_between_sheets.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Neighborhood.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/are_on_line.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/principal_axes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Curve_ranges.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Flags.h>
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
  const Eigen::Vector3d lambda = eigenvalues(covariance_sums(neighborhood));
  Facet facet;
  facet.point = place;
  facet.normal = plane_normal(neighborhood);
  facet.thickness = std::sqrt((std::max)(lambda(0), 0.));
  facet.radius = neighborhood.radius;
  facet.spacing = facet.radius * std::sqrt(CGAL_PI / static_cast<double>(k));
  // On no line of a scan, nor on two: then, the few next to the place are on one.
  facet.is_broad = are_broad(radius_of_disk(lambda(1)), radius_of_disk(lambda(2))) &&
                   !are_on_line(search, place, few);
  return facet;
}

// The facets of points evenly along the Hilbert curve
template <typename ConcurrencyTag>
std::vector<Facet> some_facets(const std::vector<Point>& points, const Neighbor_search& search)
{
  constexpr std::size_t most = 256; // a sixteenth of them is one of the points to 1.5 %
  std::vector<Facet> facets((std::min)(most, points.size()));
  for_each_index<ConcurrencyTag>(0, facets.size(), [&](std::size_t i) {
    facets[i] = facet_around(search, points[middle_of_part(i, facets.size(), points.size())]);
  });
  return facets;
}

// The normal that many flat facets share, or the null vector. The mean of so many is more exact
// than one.
inline Vector common_normal(const std::vector<Facet>& facets, double tolerance)
{
  // Where steps are as large as the spacing, few are wider than a facet.
  const std::size_t many = facets.size() / 16 + 1;
  std::vector<Facet> flat;
  std::copy_if(facets.begin(), facets.end(), std::back_inserter(flat),
               [&](const Facet& f) { return f.is_broad && f.thickness <= tolerance; });

  std::size_t most = 0;
  Vector best = NULL_VECTOR;
  for (const Facet& candidate : flat)
  {
    std::size_t number = 0;
    Vector sum = NULL_VECTOR;
    for (const Facet& f : flat)
      if (f.radius * sine_of_angle(f.normal, candidate.normal) <= tolerance)
      {
        ++number;
        sum = sum + (f.normal * candidate.normal > 0. ? f.normal : -f.normal);
      }
    if (number > most)
    {
      most = number;
      best = sum / std::sqrt(sum.squared_length());
    }
  }
  return most >= many ? best : NULL_VECTOR;
}

// Whether the surface is oblique to the levels around a facet, so that these are steps of it and no
// faces
inline bool is_on_steps(const Facet& facet, const Depth_levels& levels,
                        const Neighbor_search& search)
{
  // The layers of a lattice of points are 1.13 spacings apart, as its 8 nearest points tell these,
  // and are no steps. Steps that are smaller still need not be undone: they are measured and
  // smoothed as noise. Of larger ones, too few levels are left to tell the surface between them.
  constexpr double smallest = 1.2, largest = 10.; // in spacings of the points
  constexpr double radius = 3.;                   // in steps: a ball of that radius holds several
  // The cosines of 80 degrees and of 10: no walls, whose points may be in rows, and no faces, of
  // which a ball holds one step.
  constexpr double wall = 0.17, face = 0.985;

  const std::size_t level = levels.level_of(levels.height(facet.point));
  if (level == levels.heights.size())
    return false;
  const double step = levels.step_at(levels.heights[level]);
  // squared distances may underflow, and a step be one of two jumps
  if (!(facet.spacing > 0. && step > 0.) || step < smallest * facet.spacing ||
      step > largest * facet.spacing)
    return false;
  // as many as in the ball, if the points are there as dense as here
  const double relative_radius = radius * step / facet.spacing;
  const double in_ball = CGAL_PI * relative_radius * relative_radius;
  static thread_local Neighborhood neighborhood;
  neighborhood.collect(search, facet.point, static_cast<std::size_t>(in_ball));
  const double cosine = std::abs(plane_normal(neighborhood) * levels.direction);
  return wall < cosine && cosine < face;
}

// The levels that the depth of the points was rounded to, or none. With that, small neighborhoods
// are exactly flat and face the sensor, while the surface, as larger ones show it, does not.
template <typename ConcurrencyTag>
Depth_levels find_depth_levels(const std::vector<Point>& points, const Neighbor_search& search,
                               double coordinate_error)
{
  // Errors of coordinates change the difference of two heights by up to 2 sqrt(3) of them, less
  // than 4. Levels are at least a spacing apart. Few smooth surfaces are that flat from one point
  // to the next, and those that are so are flat everywhere, and have no levels.
  constexpr double relative_tolerance = 0.02;

  const std::vector<Facet> facets = some_facets<ConcurrencyTag>(points, search);
  std::vector<double> spacings;
  for (const Facet& facet : facets)
    spacings.push_back(facet.spacing);
  const double tolerance = (std::max)(relative_tolerance * median(spacings), 4. * coordinate_error);
  const Vector direction = common_normal(facets, tolerance);
  if (direction == NULL_VECTOR)
    return Depth_levels();
  Depth_levels levels = levels_along<ConcurrencyTag>(direction, tolerance, points);
  if (levels.heights.empty())
    return levels;

  // Sheets that a ball holds several of, as fins or stacked disks, look oblique as well. Of the
  // facets on steps of 73 scans with rounded depth, also with noise, at most 8 % were between
  // sheets, of those on clean sheets 42 to 76 %.
  constexpr double most_between_sheets = 0.2;
  Flags on_steps(facets.size()), between_sheets(facets.size());
  for_each_index<ConcurrencyTag>(0, facets.size(), [&](std::size_t i) {
    on_steps[i] = is_on_steps(facets[i], levels, search) ? 1 : 0;
    between_sheets[i] =
        on_steps[i] != 0 && is_between_sheets(facets[i].point, facets[i].spacing, levels, search)
            ? 1
            : 0;
  });
  const auto number = [](const Flags& are) {
    return static_cast<double>(std::count(are.begin(), are.end(), 1));
  };
  const bool are_steps = 4. * number(on_steps) >= static_cast<double>(facets.size()) &&
                         number(between_sheets) <= most_between_sheets * number(on_steps);
  return are_steps ? levels : Depth_levels();
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_FIND_DEPTH_LEVELS_H
