// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_ISOLATED_CLUSTERS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_ISOLATED_CLUSTERS_H

#include <CGAL/Curvature_aware_simplification_3/internal/features/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/features/thick_and_sparse.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Covariance_sums.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/principal_axes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/outliers/Linked_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/outliers/Marked_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Flags.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Clusters of points that hang in the air, as they come with photographs and with reflections.
// Their points vote for each other, as those of a surface do, and they are dense: each of them is
// no outlier by itself. Nor are those of specks with less than k points, whose neighbors are a few
// other specks, and may be in a plane.

// As a whole, with these eigenvalues of its covariance matrix, and around each point: a part of a
// scan line with noise is not the first, a small ball, hollow, not the second.
inline bool is_thick(const Features& features, const std::vector<std::size_t>& cluster,
                     const Eigen::Vector3d& lambda)
{
  // A noisy surface of so many neighborhoods shows a shape in the output. The mean over a normally
  // distributed cluster is 0.18, over a ball of 150 to 400 points with noise of 0.8 spacings 0.15.
  constexpr std::size_t neighborhoods_of_shape = 8;
  constexpr double least_variation_of_large_clusters = 0.15;
  const std::size_t k = features.number_of_neighbors;
  double sum = 0.; // of the curvatures
  for (std::size_t i : cluster)
    sum += features.surface_variation[i];
  const double size = static_cast<double>(cluster.size());
  const double least_mean = cluster.size() > neighborhoods_of_shape * k
                                ? least_variation_of_large_clusters
                                : least_variation_of_volumes;
  const bool is_thick_everywhere =
      cluster.size() <= k || sum / size > least_mean; // few see other parts
  // The smallest eigenvalue of few points is smaller: of 10 Gaussian ones, 97 % have 0.042 of the
  // sum or more, and 0.027 is asked. With the part instead of its square, 64 % of the points in
  // specks of five were found, and not 79 %.
  const double part = (std::min)(1., size / static_cast<double>(k));
  const double least = least_variation_of_volumes * part * part;
  return is_thick_everywhere && lambda(0) > least * lambda.sum();
}

// Whether a cluster of that size is alone in this ball: three times the root mean square radius is
// about as far from a cluster as it is wide. Where points come in small groups, as if each were
// measured many times, these are nearer to each other. Counted is how many points are in the ball,
// not which: a cluster has hardly any that are so far out, and each of these lets one other in.
inline bool is_apart(const Marked_points& points, std::size_t size, const Point& center,
                     double radius)
{
  return !points.cloud.search->are_more_within(
      center, radius, size,
      [&](std::size_t j, const Point&, double) { return points.is_outlier[j] == 0; });
}

// Whether it is as thick as wide, and so many times its width from all else
inline bool is_isolated_volume(const Marked_points& points, const std::vector<std::size_t>& cluster,
                               double widths)
{
  if (cluster.empty())
    return false;
  Covariance_sums sums;
  for (std::size_t i : cluster)
    sums.add(points.point(i) - points.point(cluster.front()));
  const Eigen::Vector3d variances = principal_variances(sums);
  return is_thick(points.features, cluster, variances) &&
         is_apart(points, cluster.size(), points.point(cluster.front()) + sums.mean(),
                  3. * widths * std::sqrt(variances.sum()));
}

// Whether it is a few points that are far from others
inline bool is_speck(const Marked_points& points, const std::vector<std::size_t>& cluster)
{
  return cluster.size() <= points.k() &&
         points.features.inverse_density[cluster.front()] > points.sparseness.of_outliers;
}

// All their points. Components of the graph are searched from the places where the Hilbert curve
// jumps between points that are not flat; up to 32 k points of each are visited, which takes O(k +
// log n) each.
template <typename ConcurrencyTag>
std::vector<std::size_t> isolated_clusters(const Marked_points& points)
{
  const Linked_points<ConcurrencyTag> graph(points);
  const std::vector<std::size_t> first = graph.first_points();
  std::vector<std::vector<std::size_t>> clusters(first.size());
  Flags is_clear(first.size(), 0);
  for_each_index<ConcurrencyTag>(0, first.size(), [&](std::size_t c) {
    std::vector<std::size_t> cluster = graph.component_from(first[c]);
    if (!is_isolated_volume(points, cluster, 1.))
      return;
    is_clear[c] = !is_speck(points, cluster) || is_isolated_volume(points, cluster, 2.) ? 1 : 0;
    clusters[c].swap(cluster);
  });
  // Where a thin part becomes sparse, a few of its points may be apart by chance: on posts and a
  // chair, 3.2 to 5.6 of their radii in ten of eleven such places, and 8 in one. Of specks over a
  // square, 9 of 10 are farther than 7.5.
  std::size_t in_clear_specks = 0;
  for (std::size_t c = 0; c < clusters.size(); ++c)
    in_clear_specks += is_clear[c] != 0 && is_speck(points, clusters[c]) ? clusters[c].size() : 0;
  const bool are_specks = is_more_than_a_few(in_clear_specks, points.size());
  std::vector<std::size_t> result;
  for (std::size_t c = 0; c < clusters.size(); ++c)
    if (is_clear[c] != 0 || are_specks)
      result.insert(result.end(), clusters[c].begin(), clusters[c].end());
  // Of equally far points, either may be among the k nearest: then one may reach another that
  // does not reach it, and be in two components.
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_ISOLATED_CLUSTERS_H
