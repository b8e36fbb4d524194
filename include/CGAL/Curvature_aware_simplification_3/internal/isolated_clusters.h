// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_ISOLATED_CLUSTERS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_ISOLATED_CLUSTERS_H

#include <CGAL/Curvature_aware_simplification_3/internal/Covariance_sums.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Flags.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Searchable_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Uninitialized_vector.h>
#include <CGAL/Curvature_aware_simplification_3/internal/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/index_selection.h>
#include <CGAL/Curvature_aware_simplification_3/internal/loops.h>
#include <CGAL/Curvature_aware_simplification_3/internal/mutual_neighbors.h>
#include <CGAL/Curvature_aware_simplification_3/internal/principal_axes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/thick_and_sparse.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Clusters of points that hang in the air, as they come with photographs and with reflections.
// Their points vote for each other, as those of a surface do, and they are dense: each of them is
// no outlier by itself. Nor are those of specks with less than k points, whose neighbors are a few
// other specks, and may be in a plane.
template <typename ConcurrencyTag>
class Isolated_clusters
{
public:
  // Points with more than `sparse` 1/rho are so far from others that their neighborhoods may be of
  // several parts.
  Isolated_clusters(const Searchable_points& cloud, const Features& features, double sparse,
                    const Flags& is_outlier)
    : m_cloud(cloud),
      m_features(features),
      m_k(features.number_of_neighbors),
      m_sparse(sparse),
      m_is_outlier(is_outlier)
  {
    const std::vector<std::size_t> far_ones =
        indices_where<ConcurrencyTag>(cloud.size(), [&](std::size_t i) { return is_far(i); });
    if (far_ones.empty())
      return;
    // Twice as far as its second nearest, which is in the same speck. Of specks of 8 points, with a
    // deviation as large as the spacing of the surface, a quarter more are found than with three
    // times as far: these lead from one to another.
    constexpr double reach = 2.;
    m_squared_reach.resize(cloud.size());
    for_each_index<ConcurrencyTag>(0, far_ones.size(), [&](std::size_t f) {
      const Point& p = cloud.points[far_ones[f]];
      m_squared_reach[far_ones[f]] =
          reach * reach * cloud.search->squared_distance_of_nearest(p, 3);
    });
  }

  // All their points. Components are searched from the places where the Hilbert curve jumps between
  // points that are not flat; up to 8 k points of each are visited, which takes O(k + log n) each.
  std::vector<std::size_t> points() const
  {
    const std::vector<std::size_t> first = indices_where<ConcurrencyTag>(
        m_cloud.size(), [&](std::size_t i) { return may_be_first(i); });
    std::vector<std::vector<std::size_t>> clusters(first.size());
    Flags is_clear(first.size(), 0);
    for_each_index<ConcurrencyTag>(0, first.size(), [&](std::size_t c) {
      std::vector<std::size_t> cluster = component_from(first[c]);
      if (!is_isolated_volume(cluster, 1.))
        return;
      is_clear[c] = !is_speck(cluster) || is_isolated_volume(cluster, 2.) ? 1 : 0;
      clusters[c].swap(cluster);
    });
    // Where a thin part becomes sparse, a few of its points may be apart by chance: on posts and a
    // chair, 3.2 to 5.6 of their radii in ten of eleven such places, and 8 in one. Of specks over a
    // square, 9 of 10 are farther than 7.5.
    std::size_t in_clear_specks = 0;
    for (std::size_t c = 0; c < clusters.size(); ++c)
      in_clear_specks += is_clear[c] != 0 && is_speck(clusters[c]) ? clusters[c].size() : 0;
    const bool are_specks = is_more_than_a_few(in_clear_specks, m_cloud.size());
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

private:
  // A flat point is part of a surface. In the midst of few, k neighbors reach to other parts, and
  // may look flat.
  bool may_be_in_cluster(std::size_t i) const
  {
    return is_far(i) || (m_is_outlier[i] == 0 &&
                         m_features.surface_variation[i] > largest_variation_of_flat_points);
  }

  // The first point of a component is not linked to those before it on the curve. Of most
  // other points, one of the last few is.
  bool may_be_first(std::size_t i) const
  {
    if (!may_be_in_cluster(i))
      return false;
    for (std::size_t j = i; j > 0 && i - j < m_k; --j)
      if (m_is_outlier[j - 1] == 0 &&
          squared_distance(m_cloud.points[j - 1], m_cloud.points[i]) <=
              (std::min)(squared_radius(m_features, j - 1), squared_radius(m_features, i)) &&
          is_within_reach(i, j - 1))
        return false;
    return true;
  }

  // Whether the point is far from others, and no outlier by itself
  bool is_far(std::size_t i) const
  {
    return m_is_outlier[i] == 0 && m_features.inverse_density[i] > m_sparse;
  }

  // How far a point reaches that is far from others; any other reaches all
  double squared_reach(std::size_t i) const
  {
    return is_far(i) ? m_squared_reach[i] : std::numeric_limits<double>::infinity();
  }

  // Whether one of two points reaches the other: then they are linked, if they are among the k
  // nearest of each other as well.
  bool is_within_reach(std::size_t i, std::size_t j) const
  {
    const double distance = squared_distance(m_cloud.points[i], m_cloud.points[j]);
    return distance <= squared_reach(i) || distance <= squared_reach(j);
  }

  // The component of point `first` in the graph of linked points; none if it has a point before
  // that one, a flat point, or too many.
  std::vector<std::size_t> component_from(std::size_t first) const
  {
    // A noisy surface of so many neighborhoods shows a shape in the output; clusters are rarely as
    // large.
    const std::size_t most = 8 * m_k;

    std::vector<std::size_t> component(1, first);
    std::unordered_set<std::size_t> is_in_component = {first};
    bool is_part_of_more = false;
    for (std::size_t visited = 0; visited < component.size() && !is_part_of_more; ++visited)
    {
      const std::size_t i = component[visited];
      for_each_mutual_neighbor(
          m_cloud, m_features, i,
          [&](std::size_t j) { return m_is_outlier[j] == 0 && is_within_reach(i, j); },
          [&](std::size_t j) {
            if (j < first || !may_be_in_cluster(j) || component.size() > most)
              is_part_of_more = true;
            else if (is_in_component.insert(j).second)
              component.push_back(j);
          });
    }
    return is_part_of_more ? std::vector<std::size_t>() : component;
  }

  // Whether it is a few points that are far from others
  bool is_speck(const std::vector<std::size_t>& cluster) const
  {
    return cluster.size() <= m_k && m_features.inverse_density[cluster.front()] > m_sparse;
  }

  // Whether it is as thick as wide, and so many times its width from all else
  bool is_isolated_volume(const std::vector<std::size_t>& cluster, double widths) const
  {
    if (cluster.empty())
      return false;
    Covariance_sums sums;
    for (std::size_t i : cluster)
      sums.add(m_cloud.points[i] - m_cloud.points[cluster.front()]);
    const Eigen::Vector3d lambda = eigenvalues(sums);
    return is_thick(cluster, lambda) &&
           is_apart(cluster, m_cloud.points[cluster.front()] + sums.mean(),
                    3. * widths * std::sqrt((std::max)(lambda.sum(), 0.)));
  }

  // As a whole, with these eigenvalues of its covariance matrix, and around each point: a part of a
  // scan line with noise is not the first, a small ball, hollow, not the second.
  bool is_thick(const std::vector<std::size_t>& cluster, const Eigen::Vector3d& lambda) const
  {
    double sum = 0.; // of the curvatures
    for (std::size_t i : cluster)
      sum += m_features.surface_variation[i];
    const double size = static_cast<double>(cluster.size());
    const bool is_thick_everywhere =
        cluster.size() <= m_k || sum / size > least_variation_of_volumes; // few see other parts
    // The smallest eigenvalue of few points is smaller: of 10 Gaussian ones, 97 % have 0.042 of the
    // sum or more, and 0.027 is asked. With the part instead of its square, 64 % of the points in
    // specks of five were found, and not 79 %.
    const double part = (std::min)(1., size / static_cast<double>(m_k));
    const double least = least_variation_of_volumes * part * part;
    return is_thick_everywhere && lambda(0) > least * lambda.sum();
  }

  // Whether nothing else is in this ball: three times the root mean square radius is about as far
  // from a cluster as it is wide. Where points come in small groups, as if each were measured many
  // times, these are nearer to each other. Counted is how many points are in the ball, not which: a
  // cluster has hardly any that are so far out, and each of these lets one other in.
  bool is_apart(const std::vector<std::size_t>& cluster, const Point& center, double radius) const
  {
    return !m_cloud.search->are_more_within(
        center, radius, cluster.size(),
        [&](std::size_t j, const Point&, double) { return m_is_outlier[j] == 0; });
  }

  const Searchable_points& m_cloud;
  const Features& m_features;
  std::size_t m_k;
  double m_sparse;
  const Flags& m_is_outlier;
  Uninitialized_vector<double> m_squared_reach; // of far points; empty if there are none
};

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_ISOLATED_CLUSTERS_H
