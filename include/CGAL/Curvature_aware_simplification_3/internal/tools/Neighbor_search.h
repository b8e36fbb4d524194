// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_NEIGHBOR_SEARCH_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_NEIGHBOR_SEARCH_H

#include <CGAL/Curvature_aware_simplification_3/internal/tools/Computation_kernel.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/search_traits.h>

#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/assertions.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The nearest points, and the points in a ball, of a vector of points, which the search copies with
// their indices: in the order of the tree, they are at hand for what is done with neighbors, and
// take no more memory than indices and CGAL's cache of coordinates (72 bytes instead of 48 while it
// is built). Neighbors are handed to a functor and never stored: its arguments end with the call.
class Neighbor_search
{
public:
  // O(n log n)
  template <typename ConcurrencyTag>
  Neighbor_search(const std::vector<Point>& points, const ConcurrencyTag&)
    : m_tree(Half_of_box(points_in_leaf), Search_traits())
  {
    m_tree.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      m_tree.insert({points[i], i});
    m_tree.template build<ConcurrencyTag>();
  }

  // the number of points that are not hidden
  std::size_t size() const { return m_tree.size() - m_number_of_hidden; }

  // From now on, points with is_hidden[index] != 0 are no neighbors. As long as they are few, that
  // takes less time than a new tree.
  void hide(std::vector<std::uint8_t> is_hidden)
  {
    CGAL_precondition(is_hidden.size() == m_tree.size());
    m_is_hidden = std::move(is_hidden);
    m_number_of_hidden = m_tree.size() - static_cast<std::size_t>(
                                             std::count(m_is_hidden.begin(), m_is_hidden.end(), 0));
  }

  // function(index, point, squared distance) for the k nearest points, or all if they are fewer, in
  // no particular order. A point at the query itself counts as a neighbor.
  template <typename Function>
  void for_each_nearest(const Point& query, std::size_t k, const Function& function) const
  {
    // If there are hidden points among them, twice as many more are asked for, so that few rounds
    // do in the midst of many. These come in order, and the first k count.
    k = (std::min)(k, size());
    for (std::size_t wanted = k;;)
    {
      const K_neighbor_search search(m_tree, query, static_cast<unsigned int>(wanted), 0., true,
                                     Distance(m_tree.traits().point_property_map()), wanted > k);
      const std::size_t hidden = number_of_hidden(search);
      if (wanted < k + hidden && wanted < m_tree.size())
      {
        wanted = (std::min)(k + 2 * hidden, m_tree.size());
        continue;
      }
      std::size_t left = k;
      for (const auto& neighbor : search)
        if (left > 0 && (hidden == 0 || !is_hidden(neighbor.first)))
        {
          function(neighbor.first.second, neighbor.first.first, neighbor.second);
          --left;
        }
      return;
    }
  }

  // of the k-th nearest point, or the last if they are fewer
  double squared_distance_of_nearest(const Point& query, std::size_t k) const
  {
    double largest = 0.;
    for_each_nearest(query, k, [&](std::size_t, const Point&, double squared_distance) {
      largest = (std::max)(largest, squared_distance);
    });
    return largest;
  }

  // the nearest point; there is at least one
  Point nearest(const Point& query) const
  {
    Point result = query;
    for_each_nearest(query, 1, [&](std::size_t, const Point& p, double) { result = p; });
    return result;
  }

  // function(index, point, squared distance) for all points in the closed ball, in no particular
  // order. If there are more than `most`, it ends after one more: a ball may hold any number.
  template <typename Function>
  void for_each_within(const Point& center, double radius, const Function& function,
                       std::size_t most = (std::numeric_limits<std::size_t>::max)()) const
  {
    are_more_within(center, radius, most,
                    [&](std::size_t i, const Point& p, double squared_distance) {
                      function(i, p, squared_distance);
                      return true;
                    });
  }

  // Whether more than `most` points in the closed ball pass test(index, point, squared distance),
  // which is not asked any more once they do.
  template <typename Test>
  bool are_more_within(const Point& center, double radius, std::size_t most, const Test& test) const
  {
    std::size_t left = (std::min)(most, m_tree.size()) + 1;
    const auto visit = [&](const Point_with_index& p) {
      if (left > 0 && !is_hidden(p) && test(p.second, p.first, squared_distance(center, p.first)))
        --left;
    };
    // by reference, since CGAL assigns output iterators, and a lambda cannot be assigned
    m_tree.search(boost::make_function_output_iterator(std::cref(visit)),
                  Closed_ball{center, radius * radius, left});
    return left == 0;
  }

private:
  // With 24 instead of CGAL's 10, the tree is built in three quarters of the time, and searches
  // take as long or up to a tenth less; with 32 they are no faster.
  static constexpr unsigned int points_in_leaf = 24;

  using Tree = Kd_tree<Search_traits, Half_of_box>;
  using Distance = Distance_adapter<Point_with_index, Point_with_index_map, Distance_in_space>;
  using K_neighbor_search =
      Orthogonal_k_neighbor_search<Search_traits, Distance, Half_of_box, Tree>;

  bool is_hidden(const Point_with_index& p) const
  {
    return !m_is_hidden.empty() && m_is_hidden[p.second] != 0;
  }

  std::size_t number_of_hidden(const K_neighbor_search& search) const
  {
    if (m_is_hidden.empty())
      return 0;
    return static_cast<std::size_t>(
        std::count_if(search.begin(), search.end(),
                      [&](const auto& neighbor) { return is_hidden(neighbor.first); }));
  }

  Tree m_tree;
  std::vector<std::uint8_t> m_is_hidden; // by index; empty if none is
  std::size_t m_number_of_hidden = 0;
};

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_NEIGHBOR_SEARCH_H
