// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_COLUMNS_OF_POINTS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_COLUMNS_OF_POINTS_H

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Neighborhood.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/principal_axes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Noise_probes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Planes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/parallel_axes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Flags.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/index_selection.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The normal of the surface around a place that is in a column; none if so many points show none
inline Vector normal_around_column(const Neighbor_search& search, const Point& place)
{
  // Nine columns of 30 points. Of half as many, so many may be in one that they look like a curve.
  constexpr std::size_t many = 272;
  Neighborhood neighborhood;
  neighborhood.collect(search, place, many);
  const bool are_scan = 2 * many > search.size(); // and not a part of its surface
  // parts of a curve rise from the plane of many
  return are_scan || neighborhood.is_along_curve() ? NULL_VECTOR : plane_normal(neighborhood);
}

// So many points hold one column at least, if it is of few points.
inline constexpr std::size_t least_columns = 34;

// The column of a place
struct Column
{
  double points = 0.; // those in it, of the k nearest
  double radius = 0.; // of the ball of 2 k points

  // Two points are no column, but may be on the two sides of a thin part.
  bool is_one() const { return points >= 3.; }

  // Whether k points hold less than a dozen of such columns: of half as many, a fifth of the fits
  // of the smoothing stood on the surface.
  bool is_one_of_few(std::size_t k) const
  {
    return is_one() && 12. * points > static_cast<double>(k);
  }
};

// The column along an axis; without an axis, none of the points is known to be in it. They may
// scatter across it by a part of the radius of 68 points, of which 1 in 180 is so near to an axis
// by chance, if the surface is across it. With the points of a cone of 0.1 around the direction of
// the nearest instead, columns with a hundredth of that scatter were missed.
inline Column column_at(const Neighbor_search& search, const Point& place, const Vector& axis,
                        std::size_t k)
{
  constexpr double part = 0.075;
  const double squared_scatter =
      part * part * search.squared_distance_of_nearest(place, 2 * least_columns);
  std::size_t points = 0;
  if (axis != NULL_VECTOR)
    search.for_each_nearest(place, k, [&](std::size_t, const Point& p, double) {
      const double squared_distance = CGAL::cross_product(p - place, axis).squared_length();
      points += squared_distance <= squared_scatter ? 1 : 0;
    });
  return {static_cast<double>(points), std::sqrt(search.squared_distance_of_nearest(place, 2 * k))};
}

// The medians of these, of some ranges; those of others are left empty. At a probe, the axis is
// that of its own range, along which the scanner looked there.
template <typename ConcurrencyTag>
std::vector<Column> median_columns(const Noise_probes& probes,
                                   const std::vector<std::size_t>& ranges,
                                   const std::vector<Vector>& axes, std::size_t k)
{
  const std::vector<Column> columns = at_probes<ConcurrencyTag>(probes, ranges, [&](std::size_t i) {
    return column_at(probes.search, probes.points[i], axes[probes.range_around(i)], k);
  });
  return medians_of_ranges<ConcurrencyTag>(
      probes, ranges, [&](const std::vector<std::size_t>& of_range) {
        return Column{median_of(of_range, [&](std::size_t i) { return columns[i].points; }),
                      median_of(of_range, [&](std::size_t i) { return columns[i].radius; })};
      });
}

// Whether the points of some ranges are in columns, one above the other, as where a scanner at rest
// measured the same directions again and again.
//
// Those on a line of a scan are parallel as well, but are in the surface: their axis rises from it
// by a sine of 0.02 on rings of a cylinder, and with noise by up to 0.13 by chance. With 0.2, the
// mean error of frames was 4 % larger than with 0.1.
//
// Where the points are few, a range is so wide that it bends, and lines may rise from its normal by
// chance: they did in up to 0.4 of the ranges. Of frames, 0.5 to 0.9 rise, unless their points
// scatter so far that columns hardly show. So none is taken for columns if these are too few.
template <typename ConcurrencyTag>
Flags find_columns(const Noise_probes& probes, const std::vector<std::size_t>& ranges,
                   const std::vector<Vector>& axes)
{
  constexpr double steep = 0.15, least_share = 0.45;
  const std::vector<std::size_t> suspects = those_where<ConcurrencyTag>(
      ranges, [&](std::size_t range) { return axes[range] != NULL_VECTOR; });
  const std::vector<Column> columns =
      median_columns<ConcurrencyTag>(probes, suspects, axes, least_columns);
  const std::vector<Vector> normals =
      at_probes<ConcurrencyTag>(probes, suspects, [&](std::size_t i) {
        return normal_around_column(probes.search, probes.points[i]);
      });
  const std::vector<std::size_t> found =
      those_where<ConcurrencyTag>(suspects, [&](std::size_t range) {
        const Common_axis normal = common_axis(
            probes.of_range[range], [&](std::size_t i) { return &normals[i]; }, 1);
        const bool show_surface = normal.squared_cosine > 0.;
        return show_surface && std::abs(normal.axis * axes[range]) > steep &&
               columns[range].is_one();
      });
  Flags result(axes.size(), 0);
  if (static_cast<double>(found.size()) >= least_share * static_cast<double>(ranges.size()))
    for (std::size_t range : found)
      result[range] = 1;
  return result;
}

// Of each range: the axis along which the nearest points are, if these are parallel, and whether
// the points are in columns along it
struct Columns
{
  std::vector<Vector> axis;
  Flags exist;

  explicit Columns(std::size_t number_of_ranges)
    : axis(number_of_ranges, NULL_VECTOR), exist(number_of_ranges, 0)
  {}
};

// Only ranges whose planes through 7 points are no part of the surface are asked.
template <typename ConcurrencyTag>
Columns columns_of_ranges(const Noise_probes& probes, const Planes& planes_of_7)
{
  // Noise tilts planes by 0.25 to 0.45, columns by 0.65 to 1.
  constexpr double tilt_along_columns = 0.4;

  const std::vector<std::size_t> ranges = all_ranges(probes);
  const std::vector<std::size_t> suspects =
      those_where<ConcurrencyTag>(ranges, [&](std::size_t range) {
        return planes_of_7.tilt[range] > tilt_along_columns || !planes_of_7.layer[range].is_broad();
      });
  Columns columns(ranges.size());
  columns.axis = parallel_axes<ConcurrencyTag>(probes, suspects);
  columns.exist = find_columns<ConcurrencyTag>(probes, suspects, columns.axis);
  return columns;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_COLUMNS_OF_POINTS_H
