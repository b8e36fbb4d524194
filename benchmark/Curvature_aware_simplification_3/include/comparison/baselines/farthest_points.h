#ifndef CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_FARTHEST_POINTS_H
#define CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_FARTHEST_POINTS_H

#include <comparison/types.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/centroid.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace comparison {

// A kd-tree whose nodes know the farthest of their points from all that were selected.
//
// A selected point changes only distances that are larger than its own distance to the point, so
// `select` descends only into nodes whose farthest point is farther than their box is near.
class Farthest_point_tree
{
public:
  explicit Farthest_point_tree(const Points& points)
    : m_points(points),
      m_order(points.size()),
      m_squared_distance(points.size(), std::numeric_limits<double>::infinity())
  {
    std::iota(m_order.begin(), m_order.end(), std::size_t(0));
    build(0, points.size());
  }

  // the point farthest from all selected ones, the first of the input among equals
  std::size_t farthest() const { return m_nodes.front().farthest; }

  void select(std::size_t i) { update(0, i); }

private:
  struct Node
  {
    CGAL::Bbox_3 box;
    std::size_t begin, end;   // in the order
    std::size_t second_child; // the first one follows the node; 0 for a leaf
    std::size_t farthest;
  };

  // A selected point counts as nearer than any other, so that it is not the farthest again even
  // when only duplicates are left.
  static constexpr double selected = -1.;
  static constexpr std::size_t leaf_size = 16; // few, as all are visited, but more than one per box

  // splits at the median of the longest side
  void build(std::size_t begin, std::size_t end)
  {
    const auto at = [&](std::size_t i) { return m_order.begin() + static_cast<std::ptrdiff_t>(i); };
    const std::size_t index = m_nodes.size();
    CGAL::Bbox_3 box;
    for (std::size_t i = begin; i < end; ++i)
      box += m_points[m_order[i]].bbox();
    m_nodes.push_back({box, begin, end, 0, *std::min_element(at(begin), at(end))});
    if (end - begin <= leaf_size)
      return;

    const std::array<double, 3> sides = {box.x_span(), box.y_span(), box.z_span()};
    const int axis = static_cast<int>(std::max_element(sides.begin(), sides.end()) - sides.begin());
    const std::size_t middle = begin + (end - begin) / 2;
    std::nth_element(at(begin), at(middle), at(end), [&](std::size_t i, std::size_t j) {
      return m_points[i][axis] < m_points[j][axis];
    });
    build(begin, middle);
    m_nodes[index].second_child = m_nodes.size();
    build(middle, end);
  }

  void update(std::size_t index, std::size_t i)
  {
    Node& node = m_nodes[index];
    if (squared_distance_to_box(m_points[i], node.box) > m_squared_distance[node.farthest])
      return;
    if (node.second_child != 0)
    {
      update(index + 1, i);
      update(node.second_child, i);
      node.farthest = farther(m_nodes[index + 1].farthest, m_nodes[node.second_child].farthest);
      return;
    }
    node.farthest = m_order[node.begin];
    for (std::size_t k = node.begin; k < node.end; ++k)
    {
      const std::size_t j = m_order[k];
      m_squared_distance[j] = j == i ? selected
                                     : std::min(m_squared_distance[j],
                                                CGAL::squared_distance(m_points[i], m_points[j]));
      node.farthest = farther(node.farthest, j);
    }
  }

  std::size_t farther(std::size_t i, std::size_t j) const
  {
    if (m_squared_distance[i] != m_squared_distance[j])
      return m_squared_distance[i] > m_squared_distance[j] ? i : j;
    return std::min(i, j);
  }

  static double squared_distance_to_box(const Point& p, const CGAL::Bbox_3& box)
  {
    double sum = 0.;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double outside = std::max({box.min(axis) - p[axis], 0., p[axis] - box.max(axis)});
      sum += outside * outside;
    }
    return sum;
  }

  const Points& m_points;
  std::vector<std::size_t> m_order;
  std::vector<double> m_squared_distance;
  std::vector<Node> m_nodes;
};

// Farthest point sampling (Eldar et al. 1997): each point is the one of the input that is farthest
// from those before it, and the first is the farthest from the centroid. min(n, M) points in the
// order of their selection, duplicates only when there are no others left.
inline Points farthest_points(const Points& points, std::size_t n)
{
  Points result;
  n = std::min(n, points.size());
  if (n == 0)
    return result;

  const Point centroid = CGAL::centroid(points.begin(), points.end(), CGAL::Dimension_tag<0>());
  const auto first =
      std::max_element(points.begin(), points.end(), [&](const Point& p, const Point& q) {
        return CGAL::squared_distance(p, centroid) < CGAL::squared_distance(q, centroid);
      });
  Farthest_point_tree tree(points);
  std::size_t next = static_cast<std::size_t>(first - points.begin());
  while (true)
  {
    result.push_back(points[next]);
    if (result.size() == n)
      return result;
    tree.select(next);
    next = tree.farthest();
  }
}

} // namespace comparison

#endif // CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_FARTHEST_POINTS_H
