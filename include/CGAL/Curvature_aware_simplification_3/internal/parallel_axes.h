// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PARALLEL_AXES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PARALLEL_AXES_H

#include <CGAL/Curvature_aware_simplification_3/internal/Covariance_sums.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Noise_probes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/principal_axes.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The directions from one of the points to its four nearest; null ones if these are fewer
inline std::array<Vector, 4> directions_to_nearest(const Neighbor_search& search,
                                                   const Point& place)
{
  std::array<Vector, 4> directions = {NULL_VECTOR, NULL_VECTOR, NULL_VECTOR, NULL_VECTOR};
  std::size_t number = 0;
  search.for_each_nearest(place, directions.size() + 1,
                          [&](std::size_t, const Point& p, double squared_distance)
                          {
    if (squared_distance > 0. && number < directions.size()) // not the place itself
      directions[number++] = (p - place) / std::sqrt(squared_distance);
  });
  return directions;
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

// Of the vectors unit_vectors(i), of all indices
template <typename Unit_vectors>
Common_axis common_axis(const std::vector<std::size_t>& indices, const Unit_vectors& unit_vectors)
{
  Covariance_sums sums; // with their opposites, so that their mean is 0
  for (std::size_t i : indices)
    for (const Vector& u : unit_vectors(i))
    {
      sums.add(u);
      sums.add(-u);
    }
  const Eigen::Vector3d lambda = eigenvalues(sums);
  return {principal_axis(sums, 2), lambda(2), lambda(1)};
}

// The axes along which points of some ranges are to their nearest; null where these are not
// parallel.
//
// The nearest points of one in a column are in the same column, so that the directions to these are
// parallel: of a share f, while others have all directions, the mean squared cosine to their axis
// is larger by f than across. Where points scatter across the column, the nearest is in any
// direction, but the next ones are along it. Four are still in a column of five, and are in one of
// ten whose points are as far apart as the columns: seen was 0.3 and more, with a scatter of a tenth
// of its standard deviation 0.2.
//
// If directions are random in a plane, as on a line of a scan with noise, it is more than 0.2 by
// chance in one of 3e4 ranges: for 256 of them, exp(-256 * 0.2^2). With 0.25, the mean error of
// frames that scatter is up to 1.2 times as large.
template <typename ConcurrencyTag>
std::vector<Vector> parallel_axes(const Noise_probes& probes,
                                  const std::vector<std::size_t>& ranges,
                                  const Neighbor_search& search)
{
  constexpr double parallel = 0.2;
  const auto directions = at_probes<ConcurrencyTag>(probes, ranges,
                                                    [&](std::size_t i) {
    return directions_to_nearest(search, probes.points[i]);
  });
  std::vector<Vector> axes(probes.of_range.size(), NULL_VECTOR);
  for (std::size_t range : ranges)
  {
    const Common_axis common =
        common_axis(probes.of_range[range], [&](std::size_t i) { return directions[i]; });
    if (common.squared_cosine - common.across > parallel)
      axes[range] = common.axis;
  }
  return axes;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PARALLEL_AXES_H
