// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_LINKED_POINTS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_LINKED_POINTS_H

#include <CGAL/Curvature_aware_simplification_3/internal/features/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/features/thick_and_sparse.h>
#include <CGAL/Curvature_aware_simplification_3/internal/outliers/Marked_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Uninitialized_vector.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/index_selection.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The graph of points that may be in clusters that hang in the air. Two are linked if they are
// among the k nearest of each other and one reaches the other; points that are far from others
// reach no farther than specks are wide.
template <typename ConcurrencyTag>
class Linked_points
{
public:
  // Points that are far from others may have neighborhoods of several parts. Outliers are in no
  // component.
  explicit Linked_points(const Marked_points& points) : m_points(points)
  {
    const std::vector<std::size_t> far_ones =
        indices_where<ConcurrencyTag>(points.size(), [&](std::size_t i) { return is_far(i); });
    if (far_ones.empty())
      return;
    // Twice as far as its second nearest, which is in the same speck. Of specks of 8 points, with a
    // deviation as large as the spacing of the surface, a quarter more are found than with three
    // times as far: these lead from one to another.
    constexpr double reach = 2.;
    m_squared_reach.resize(points.size());
    for_each_index<ConcurrencyTag>(0, far_ones.size(), [&](std::size_t f) {
      const Point& p = points.point(far_ones[f]);
      m_squared_reach[far_ones[f]] =
          reach * reach * points.cloud.search->squared_distance_of_nearest(p, 3);
    });
  }

  // The points that may be the first of a component: from there it is searched.
  std::vector<std::size_t> first_points() const
  {
    return indices_where<ConcurrencyTag>(m_points.size(),
                                         [&](std::size_t i) { return may_be_first(i); });
  }

  // The component of point `first` in the graph of linked points; none if it has a point before
  // that one, a flat point, or too many.
  std::vector<std::size_t> component_from(std::size_t first) const
  {
    // 512 points: fused photographs leave clusters of some hundreds in the air.
    const std::size_t most = 32 * m_points.k();

    std::vector<std::size_t> component(1, first);
    std::unordered_set<std::size_t> is_in_component = {first};
    bool is_part_of_more = false;
    for (std::size_t visited = 0; visited < component.size() && !is_part_of_more; ++visited)
    {
      const std::size_t i = component[visited];
      for_each_mutual_neighbor(
          m_points, i,
          [&](std::size_t j) { return m_points.is_outlier[j] == 0 && is_within_reach(i, j); },
          [&](std::size_t j) {
            if (j < first || !may_be_in_cluster(j) || component.size() > most)
              is_part_of_more = true;
            else if (is_in_component.insert(j).second)
              component.push_back(j);
          });
    }
    return is_part_of_more ? std::vector<std::size_t>() : component;
  }

private:
  // A flat point is part of a surface. In the midst of few, k neighbors reach to other parts, and
  // may look flat.
  bool may_be_in_cluster(std::size_t i) const
  {
    return is_far(i) || (m_points.is_outlier[i] == 0 &&
                         m_points.features.surface_variation[i] > largest_variation_of_flat_points);
  }

  // The first point of a component is not linked to those before it on the curve. Of most
  // other points, one of the last few is.
  bool may_be_first(std::size_t i) const
  {
    if (!may_be_in_cluster(i))
      return false;
    for (std::size_t j = i; j > 0 && i - j < m_points.k(); --j)
      if (m_points.is_outlier[j - 1] == 0 &&
          squared_distance(m_points.point(j - 1), m_points.point(i)) <=
              (std::min)(squared_radius(m_points.features, j - 1),
                         squared_radius(m_points.features, i)) &&
          is_within_reach(i, j - 1))
        return false;
    return true;
  }

  // Whether the point is far from others, and no outlier by itself
  bool is_far(std::size_t i) const
  {
    return m_points.is_outlier[i] == 0 &&
           m_points.features.inverse_density[i] > m_points.sparseness.of_outliers;
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
    const double distance = squared_distance(m_points.point(i), m_points.point(j));
    return distance <= squared_reach(i) || distance <= squared_reach(j);
  }

  const Marked_points m_points;
  Uninitialized_vector<double> m_squared_reach; // of far points; empty if there are none
};

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_OUTLIERS_LINKED_POINTS_H
