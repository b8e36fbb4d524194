// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_COLUMNS_OF_POINTS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_COLUMNS_OF_POINTS_H

#include <CGAL/Curvature_aware_simplification_3/internal/Covariance_sums.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Neighborhood.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Noise_probes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/principal_axes.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The direction from a place to its nearest point
inline Vector direction_to_nearest(const Neighbor_search& search, const Point& place)
{
  Vector direction = NULL_VECTOR;
  search.for_each_nearest(place, 2,
                          [&](std::size_t, const Point& p, double squared_distance)
                          {
    if (squared_distance > 0.) // not the place itself
      direction = (p - place) / std::sqrt(squared_distance);
  });
  return direction;
}

// The axis to which unit vectors u are nearest, whatever their signs: the eigenvector of the
// largest eigenvalue of the mean of u u^T, which is the mean squared cosine to it. The next one is
// the largest to any axis across. Vectors that are null count as far from all axes.
struct Common_axis
{
  Vector axis = NULL_VECTOR;
  double squared_cosine = 0.;
  double across = 0.;
};

template <typename Unit_vector>
Common_axis common_axis(const std::vector<std::size_t>& indices, const Unit_vector& unit_vector)
{
  Covariance_sums sums; // with their opposites, so that their mean is 0
  for (std::size_t i : indices)
  {
    sums.add(unit_vector(i), 1.);
    sums.add(-unit_vector(i), 1.);
  }
  const Eigen::Vector3d lambda = eigenvalues(sums);
  return {principal_axis(sums, 2), lambda(2), lambda(1)};
}

// The normal of the surface around a place that is in a column; none if so many points show none
inline Vector normal_around_column(const Neighbor_search& search, const Point& place)
{
  // Nine columns of 30 points. Of half as many, so many may be in one that they look like a curve.
  constexpr std::size_t many = 272;
  static thread_local Neighborhood neighborhood;
  neighborhood.collect(search, place, many);
  const bool are_scan = 2 * many > search.size(); // and not a part of its surface
  // parts of a curve rise from the plane of many
  return are_scan || neighborhood.is_along_curve() ? NULL_VECTOR : plane_normal(neighborhood);
}

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

inline Column column_at(const Neighbor_search& search, const Point& place, std::size_t k)
{
  constexpr double along = 0.1; // the sine of the angle to the direction of the nearest point
  const Vector direction = direction_to_nearest(search, place);
  std::size_t points = 0;
  search.for_each_nearest(place, k,
                          [&](std::size_t, const Point& p, double squared_distance)
                          {
    const Vector across = CGAL::cross_product(p - place, direction);
    points += across.squared_length() <= along * along * squared_distance ? 1 : 0;
  });
  return {static_cast<double>(points), std::sqrt(search.squared_distance_of_nearest(place, 2 * k))};
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
        median_of(probes.of_range[range], [&](std::size_t i) { return columns[i].points; }),
        median_of(probes.of_range[range], [&](std::size_t i) { return columns[i].radius; })};
  return medians;
}

// Whether points of some ranges are in columns, one above the other, as where a scanner at rest
// measured the same directions again and again.
//
// The nearest point of one in a column is in the same column, so that the directions to these are
// parallel: of a share f, while others have all directions, the mean squared cosine to that axis is
// larger by f than across. Seen was 0.5 and more in columns of ten points at random places, as long
// as their standard deviation is no more than their distance. If directions are random in a plane,
// as on a line of a scan with noise, it is more than 0.4 by chance in one of 3e4 ranges: for 64 of
// them, exp(-64 * 0.4^2).
//
// Those on a line of a scan are parallel as well, but are in the surface: their axis rises from it
// by a sine of 0.02 on rings of a cylinder, and with noise by up to 0.13 by chance. With 0.2 in the
// place of 0.1, the mean error of frames was 4 % larger.
template <typename ConcurrencyTag>
std::vector<std::uint8_t> find_columns(const Noise_probes& probes,
                                       const std::vector<std::size_t>& ranges,
                                       const Neighbor_search& search)
{
  constexpr double parallel = 0.4, steep = 0.15;
  constexpr std::size_t k = 34; // that hold one column at least, if it is of few points
  const std::vector<Vector> directions = at_probes<ConcurrencyTag>(
      probes, ranges, [&](const Point& place) { return direction_to_nearest(search, place); });
  std::vector<Common_axis> axes(probes.of_range.size());
  std::vector<std::size_t> suspects;
  for (std::size_t range : ranges)
  {
    axes[range] = common_axis(probes.of_range[range], [&](std::size_t i) { return directions[i]; });
    if (axes[range].squared_cosine - axes[range].across > parallel)
      suspects.push_back(range);
  }
  const std::vector<Column> columns = median_columns<ConcurrencyTag>(probes, suspects, search, k);
  const std::vector<Vector> normals = at_probes<ConcurrencyTag>(
      probes, suspects, [&](const Point& place) { return normal_around_column(search, place); });
  std::vector<std::uint8_t> are_found(probes.of_range.size(), 0);
  for (std::size_t range : suspects)
  {
    const Common_axis normal =
        common_axis(probes.of_range[range], [&](std::size_t i) { return normals[i]; });
    const bool show_surface = normal.squared_cosine > 0.;
    const bool rise = show_surface && std::abs(normal.axis * axes[range].axis) > steep;
    are_found[range] = rise && columns[range].is_one() ? 1 : 0;
  }
  return are_found;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_COLUMNS_OF_POINTS_H
