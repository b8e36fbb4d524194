#ifndef CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_MEAN_SHIFT_CLUSTERING_H
#define CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_MEAN_SHIFT_CLUSTERING_H

#include <comparison/baselines/mean_shift.h>
#include <comparison/baselines/point_set_surface.h>
#include <comparison/baselines/principal_axes.h>
#include <comparison/baselines/search.h>
#include <comparison/types.h>

#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace comparison {

// Adaptive mean-shift clustering (Miao et al. 2009a).
//
// All points are shifted to their local modes, and clusters generated from these: a cluster of more
// than M points, or of a surface variation above T, is halved by the plane through the centroid of
// its modes across their longest axis, as Pauly et al. (2002) do it with the points, until no
// cluster exceeds M or T. Points of one mode stay together as long as M and T allow it. The
// centroid of each cluster, projected onto the surface, represents it.
//
// Where the points are spread evenly, their density has no distinct modes and the points hardly
// shift; there, clusters are those of the points themselves. The bandwidth is the distance to the
// M-th neighbor, so that a mode gathers about what a cluster may have.
class Mean_shift_clustering
{
public:
  using Cluster = std::vector<std::size_t>;

  Mean_shift_clustering(const Points& points, std::size_t maximum_size)
    : m_points(points),
      m_maximum_size(std::max<std::size_t>(maximum_size, 1)),
      m_surface(points, 24),
      m_modes(mean_shift_modes(points, m_maximum_size))
  {}

  std::vector<Cluster> clusters(double maximum_variation) const
  {
    std::vector<Cluster> done, open(1, Cluster(m_points.size()));
    std::iota(open.front().begin(), open.front().end(), std::size_t(0));
    while (!open.empty())
    {
      Cluster cluster = std::move(open.back());
      open.pop_back();
      if (cluster.size() == 1 ||
          (cluster.size() <= m_maximum_size &&
           principal_axes(cluster, m_points).variation() <= maximum_variation))
      {
        done.push_back(std::move(cluster));
        continue;
      }
      const auto middle = halve(cluster);
      open.emplace_back(cluster.begin(), middle);
      open.emplace_back(middle, cluster.end());
    }
    return done;
  }

  // the projected centroids
  Points representatives(const std::vector<Cluster>& clusters) const
  {
    Points result(clusters.size());
    CGAL::Curvature_aware_simplification_3::internal::for_each_index<Tag>(
        0, clusters.size(), [&](std::size_t i) {
          result[i] = m_surface.project(principal_axes(clusters[i], m_points).center);
        });
    return result;
  }

private:
  static Principal_axes principal_axes(const Cluster& cluster, const Points& positions)
  {
    Moments moments(positions[cluster.front()]);
    for (std::size_t i : cluster)
      moments.add(1., positions[i]);
    return moments.principal_axes();
  }

  // The two sides of the plane, neither of them empty. Points of one mode are halved by their own
  // positions, and if these coincide too, by their order.
  Cluster::iterator halve(Cluster& cluster) const
  {
    for (const Points* positions : {&m_modes, &m_points})
    {
      const Principal_axes axes = principal_axes(cluster, *positions);
      const auto middle = std::stable_partition(cluster.begin(), cluster.end(), [&](std::size_t i) {
        return ((*positions)[i] - axes.center) * axes.axes[2] < 0.;
      });
      if (middle != cluster.begin() && middle != cluster.end())
        return middle;
    }
    return cluster.begin() + static_cast<std::ptrdiff_t>(cluster.size() / 2);
  }

  const Points& m_points;
  std::size_t m_maximum_size; // M
  Point_set_surface m_surface;
  Points m_modes;
};

// (M, T) are the parameters that the caption of Fig. 7 names; it has (30, 0.01).
inline Points mean_shift_points(const Points& points, std::size_t maximum_size,
                                double maximum_variation)
{
  const Mean_shift_clustering clustering(points, maximum_size);
  return clustering.representatives(clustering.clusters(maximum_variation));
}

// The same with the T that gives the count nearest to n, for a given M. The count is monotone in T
// and jumps by what one halving sets free, mostly 1; T = 1/3, the largest variation there is,
// bounds it from below.
inline Points mean_shift_points_of_size(const Points& points, std::size_t n,
                                        std::size_t maximum_size)
{
  const Mean_shift_clustering clustering(points, maximum_size);
  return clustering.representatives(search_count(
      [&](double variation) { return clustering.clusters(variation); }, 1. / 3., 1e-12, n));
}

} // namespace comparison

#endif // CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_MEAN_SHIFT_CLUSTERING_H
