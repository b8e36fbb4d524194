// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_PARALLEL_AXES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_PARALLEL_AXES_H

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Covariance_sums.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/principal_axes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Noise_probes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// As many as a column of five holds besides any one of its points
inline constexpr std::size_t directions_of_place = 4;

// The directions from one of the points to its nearest, from the nearest on; null where there are
// no more points
inline std::array<Vector, directions_of_place> directions_to_nearest(const Neighbor_search& search,
                                                                     const Point& place)
{
  std::array<Vector, directions_of_place> directions;
  directions.fill(NULL_VECTOR);
  std::vector<std::pair<double, Point>> nearest;
  search.for_each_nearest(place, directions.size() + 1,
                          [&](std::size_t, const Point& p, double squared_distance) {
                            if (squared_distance > 0.) // not the place itself
                              nearest.emplace_back(squared_distance, p);
                          });
  std::sort(nearest.begin(), nearest.end());
  for (std::size_t n = 0; n < (std::min)(nearest.size(), directions.size()); ++n)
    directions[n] = (nearest[n].second - place) / std::sqrt(nearest[n].first);
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

// Of `number` vectors of each index, of which unit_vectors(i) points to the first
template <typename UnitVectors>
Common_axis common_axis(const std::vector<std::size_t>& indices, const UnitVectors& unit_vectors,
                        std::size_t number)
{
  Covariance_sums sums; // with their opposites, so that their mean is 0
  for (std::size_t i : indices)
    for (std::size_t n = 0; n < number; ++n)
    {
      sums.add(unit_vectors(i)[n]);
      sums.add(-unit_vectors(i)[n]);
    }
  const Principal_axes axes(sums);
  const Eigen::Vector3d mean_squared_cosines = axes.variances();
  return {axes.axis(2), mean_squared_cosines(2), mean_squared_cosines(1)};
}

// The axes along which points of some ranges are to their nearest; null where these are not
// parallel.
//
// The nearest point of one in a column is in the same column, so that the directions to these are
// parallel: of a share f, while others have all directions, the mean squared cosine to their axis
// is larger by f than across. Where points scatter across the column, the nearest is in any
// direction, but the next ones are along it; of three frames, only two are. With the four nearest
// alone, oblique frames with noise of their distance are 2 times as far off if they are three; with
// the nearest alone, ten that scatter by a twentieth of the noise 9 times.
//
// If directions are random in a plane, as on a line of a scan with noise, the difference is more
// than 0.4 by chance in one of 3e4 ranges for 64 of them, exp(-64 * 0.4^2), and as rarely more than
// 0.2 for four times as many. With 0.25, the mean error of frames that scatter is up to 1.2 times
// as large.
template <typename ConcurrencyTag>
std::vector<Vector> parallel_axes(const Noise_probes& probes,
                                  const std::vector<std::size_t>& ranges)
{
  constexpr double parallel = 0.4; // of the difference times the root of the number at each place
  const auto directions = at_probes<ConcurrencyTag>(probes, ranges, [&](std::size_t i) {
    return directions_to_nearest(probes.search, probes.points[i]);
  });
  std::vector<Vector> axes(probes.of_range.size(), NULL_VECTOR);
  for (std::size_t range : ranges)
  {
    double clearest = parallel;
    for (std::size_t number : {std::size_t(1), directions_of_place})
    {
      const Common_axis common = common_axis(
          probes.of_range[range], [&](std::size_t i) { return directions[i].data(); }, number);
      const double clearness =
          std::sqrt(static_cast<double>(number)) * (common.squared_cosine - common.across);
      if (clearness <= clearest)
        continue;
      clearest = clearness;
      axes[range] = common.axis;
    }
  }
  return axes;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_PARALLEL_AXES_H
