// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FIND_COLUMNS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FIND_COLUMNS_H

#include <CGAL/Curvature_aware_simplification_3/internal/Layer.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Nearest_line.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Neighborhood.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Noise_probes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/principal_axes.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// As many as show the surface that columns of a few points rise from, as layers of k = 7 see them.
// A plane through fewer leans with the noise.
inline constexpr std::size_t points_around_column = 68;

// The k nearest points of a place, and the line through the few next to it
struct Column
{
  double radius = 0.; // of the ball of k points
  // of the line over their plane: the sine of the angle; 0 if the few are on no line, or the k on a
  // curve, whose parts rise from the plane of many
  double rise = 0.;
};

inline Column column_at(const Neighbor_search& search, const Point& place, std::size_t k)
{
  constexpr std::size_t few = 3; // of five frames, five points are often of two columns
  // of half as many, so many may be in the column of the place that they look like a curve
  constexpr std::size_t enough_for_curve = 4 * points_around_column;
  const Nearest_line line = nearest_line(search, place, few);
  static thread_local Neighborhood neighborhood;
  neighborhood.collect(search, place, k);
  const bool is_on_curve = k >= enough_for_curve && neighborhood.is_along_curve();
  const bool may_rise = line.holds_them() && !is_on_curve;
  return {neighborhood.radius,
          may_rise ? std::abs(line.direction * plane_normal(neighborhood)) : 0.};
}

// The medians of these, of some ranges; those of others are left empty
template <typename ConcurrencyTag>
std::vector<Column> median_columns(const Noise_probes& probes,
                                   const std::vector<std::size_t>& ranges,
                                   const Neighbor_search& search, std::size_t k)
{
  const std::vector<Column> columns = at_probes<ConcurrencyTag>(
      probes, ranges, [&](const Point& place) { return column_at(search, place, k); });
  std::vector<Column> medians(probes.of_range.size());
  for (std::size_t range : ranges)
    medians[range] = {
        median_of(probes.of_range[range], [&](std::size_t i) { return columns[i].radius; }),
        median_of(probes.of_range[range], [&](std::size_t i) { return columns[i].rise; })};
  return medians;
}

// Finds columns of points, one above the other, as where a scanner at rest measured the same
// directions again and again, where layers of k points hold hardly more than one: they show a plane
// along it, and no noise. The nearest points are then on a line that rises from the surface, as the
// points `around` show it. Returned is the radius of these, by range; 0 where there are no columns.
template <typename ConcurrencyTag>
std::vector<double> find_columns(const Noise_probes& probes, const std::vector<std::size_t>& ranges,
                                 const Neighbor_search& search, std::size_t around,
                                 const std::vector<Layer>& narrow, const std::vector<Layer>& wide)
{
  constexpr double steep = 0.3; // lines of a scan are in the surface
  // Layers that are exactly flat, but for rounding: by that of single precision, points 1e-4 of the
  // extent of the input apart are 6e-4 of their distance off.
  constexpr double flat = 1e-3;
  std::vector<double> radii(probes.of_range.size(), 0.);
  if (2 * around > search.size()) // they are the scan, and not a part of its surface
    return radii;
  std::vector<std::size_t> suspects; // elsewhere, k points are enough, and there is nothing to ask
  std::copy_if(ranges.begin(), ranges.end(), std::back_inserter(suspects),
               [&](std::size_t range)
               {
    return narrow[range].thickness < flat * narrow[range].width ||
           jumps(narrow[range], wide[range]);
  });
  const std::vector<Column> columns =
      median_columns<ConcurrencyTag>(probes, suspects, search, around);
  for (std::size_t range : suspects)
    if (columns[range].rise > steep)
      radii[range] = columns[range].radius;
  return radii;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FIND_COLUMNS_H
