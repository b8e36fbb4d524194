// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_NOISY_LAYERS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_NOISY_LAYERS_H

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Covariance_sums.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/principal_axes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/outliers/Marked_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Curve_ranges.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Flags.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/index_selection.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Of points that are taken for outliers because they are thick and sparse, a surface whose noise is
// as large as the distances of its points, as a wall far behind what a camera looks at, is as thick
// as wide in the neighborhoods of all, and nothing there is flat. But in wider ones it is a layer.
// What fills a flat box around a surface is one as well; but that has the surface, which is denser,
// in its midst.

// A plane with a thickness: the standard deviation of the heights over it
struct Thick_plane
{
  Point center;
  Vector normal;
  double thickness;

  bool holds(const Point& p) const { return std::abs((p - center) * normal) <= 3. * thickness; }
};

// The layer that `number` points around a place are, if they are one, and most are sparse.
//
// kappa of a disk of them with noise sigma in spacings is sigma^2 / (number / 2 pi + sigma^2), with
// 16 k = 256 below the limit for up to 2 spacings, with 64 k for up to 4. That of a half ball, as
// at the border of a volume, is 0.13, and 0.09 or more for 256 points of one. On 13 shapes with 1
// to 40 % outliers, no place passes both tests, some each of them.
inline std::optional<Thick_plane> sparse_layer(const Marked_points& points, const Point& place,
                                               std::size_t number)
{
  constexpr double largest_variation = 0.09;
  // A surface among outliers is denser than they are, and outnumbers them; where far points are a
  // surface, those near it on other parts are few.
  constexpr double most = 0.75;
  if (2 * number > points.size()) // they are the scan, and not a part of it
    return std::nullopt;
  Covariance_sums sums;
  std::size_t sparse_ones = 0;
  points.cloud.search->for_each_nearest(place, number, [&](std::size_t j, const Point& p, double) {
    sums.add(p - place);
    if (points.features.inverse_density[j] > points.sparseness.of_sparse_parts)
      ++sparse_ones;
  });
  const Principal_axes axes(sums);
  const Eigen::Vector3d variances = axes.variances();
  if (static_cast<double>(sparse_ones) < most * static_cast<double>(number) ||
      !(variances(0) <= largest_variation * variances.sum()))
    return std::nullopt;
  return Thick_plane{place + sums.mean(), axes.axis(0), std::sqrt(variances(0))};
}

// Unmarks those of the far ones that are in such a layer, and returns them. One place tells for 16
// k of them along the Hilbert curve, about as many as it looks at. O(log n) for each far one.
template <typename ConcurrencyTag>
std::vector<std::size_t> unmark_noisy_layers(const Marked_points& points,
                                             const std::vector<std::size_t>& far_ones)
{
  const std::size_t n = far_ones.size(), k = points.k();
  const Curve_ranges ranges{n / (16 * k) + 1, n};
  Flags is_in_layer(n, 0);
  for_each_index<ConcurrencyTag>(0, ranges.number, [&](std::size_t range) {
    const std::size_t begin = ranges.first_point(range), end = ranges.first_point(range + 1);
    const Point& place = points.point(far_ones[begin + (end - begin) / 2]);
    std::optional<Thick_plane> layer = sparse_layer(points, place, 16 * k);
    if (!layer)
      layer = sparse_layer(points, place, 64 * k);
    for (std::size_t f = begin; layer && f < end; ++f)
      is_in_layer[f] = layer->holds(points.point(far_ones[f])) ? 1 : 0;
  });
  const std::vector<std::size_t> in_layers =
      elements_at<ConcurrencyTag>(flagged_indices<ConcurrencyTag>(is_in_layer), far_ones);
  set_flags<ConcurrencyTag>(points.is_outlier, in_layers, 0);
  return in_layers;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_NOISY_LAYERS_H
