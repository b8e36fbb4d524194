// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_SEARCH_TRAITS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_SEARCH_TRAITS_H

#include <CGAL/Curvature_aware_simplification_3/internal/tools/Computation_kernel.h>

#include <CGAL/Euclidean_distance.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Splitters.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// What CGAL's Kd_tree and its searches are given by Neighbor_search: points with their indices, and
// parts that take less time than those they come with.
using Point_with_index = std::pair<Point, std::size_t>;
using Point_with_index_map = First_of_pair_property_map<Point_with_index>;
using Search_base_traits = Search_traits_3<Computation_kernel>;
using Search_traits =
    Search_traits_adapter<Point_with_index, Point_with_index_map, Search_base_traits>;

// Halves the bounding box of the points and not the cell that they are in, as Sliding_midpoint
// does: a surface leaves most of a cell empty, and a whole call takes 3 % less. No side is empty:
// where the two ends have no number between them, the lower one stays alone, and of equal points,
// each side gets half. CGAL would take one off at each level, and the stack of a search is as deep
// as the tree.
struct Half_of_box : Midpoint_of_max_spread<Search_traits>
{
  using Base = Midpoint_of_max_spread<Search_traits>;
  using Base::Base;

  void operator()(Base::Separator& separator, Base::Container& points, Base::Container& lower) const
  {
    const double low = points.max_tight_span_lower(), high = points.max_tight_span_upper();
    const double middle = (low + high) / 2.;
    separator =
        typename Base::Separator(points.max_tight_span_coord(), middle > low ? middle : high);
    points.split(lower, separator, true);
    if (low < high)
      return;
    const auto half = lower.begin() + (points.end() - lower.begin()) / 2;
    lower.set_range(lower.begin(), half);
    points.set_range(half, points.end());
  }
};

// CGAL's distance comes with a loop over any number of coordinates that may stop early. Three are
// computed at once in less time: a whole call takes 3 % less.
struct Distance_in_space : Euclidean_distance<Search_base_traits>
{
  template <typename CoordinateIterator>
  double interruptible_transformed_distance(const Point& query, CoordinateIterator begin,
                                            CoordinateIterator end, double) const
  {
    return this->transformed_distance_from_coordinates(query, begin, end);
  }
};

// A closed ball, a model of CGAL's FuzzyQueryItem. Fuzzy_sphere comes with loops over any number
// of coordinates that may stop early, and tells which cells are inside as a whole, where points
// need not be tested; but their distances are wanted anyway. A whole call with the settings of
// the paper takes 14 % less, one with noise 4 %.
struct Closed_ball
{
  Point center;
  double squared_radius;
  const std::size_t& left; // points that are asked for; without them, nothing is worth visiting

  bool contains(const Point_with_index& p) const
  {
    return squared_distance(center, p.first) <= squared_radius;
  }

  template <typename Box>
  bool inner_range_intersects(const Box& box) const
  {
    const auto outside = [&](int axis) {
      return (std::max)(
          {box.min_coord(axis) - center[axis], center[axis] - box.max_coord(axis), 0.});
    };
    return left > 0 &&
           Vector(outside(0), outside(1), outside(2)).squared_length() <= squared_radius;
  }

  template <typename Box>
  bool outer_range_contains(const Box&) const
  {
    return false; // not worth the question
  }
};

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_SEARCH_TRAITS_H
