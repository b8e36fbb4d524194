// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_CLOUD_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_CLOUD_H

#include <CGAL/Curvature_aware_simplification_3/internal/Frame.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/loops.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_sort.h>
#endif

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The input as the stages see it: its distinct points, along a Hilbert curve, so that neighbors in
// space are neighbors in memory.
//
// Exact duplicates are merged. They tell nothing of the surface, but would fill the neighborhoods
// of k points and leave no room for those that do.
struct Cloud
{
  Frame frame;
  std::vector<Point> points;            // distinct, in the frame
  std::vector<std::size_t> input_index; // of each distinct point: its first position in the input
  std::vector<std::size_t> distinct_index; // of each input point: its distinct point
  double coordinate_error;                 // of the points, from rounding in the input

  std::size_t size() const { return points.size(); }
  std::size_t input_size() const { return distinct_index.size(); }
};

template <typename ConcurrencyTag, typename Iterator, typename Less>
void sort(Iterator begin, Iterator end, const Less& less)
{
#ifdef CGAL_LINKED_WITH_TBB
  if (std::is_convertible<ConcurrencyTag, Parallel_tag>::value)
  {
    tbb::parallel_sort(begin, end, less);
    return;
  }
#endif
  std::sort(begin, end, less);
}

// Merges duplicates and sorts along a Hilbert curve. There is at least one point; coordinates are
// exact up to `relative_error` times the largest of them. O(n log n)
template <typename ConcurrencyTag>
Cloud make_cloud(std::vector<Point> coordinates, double relative_error)
{
  const std::size_t n = coordinates.size();
  const Bbox_3 box = reduce_indices<ConcurrencyTag>(
      n, Bbox_3(), [&](std::size_t i) { return coordinates[i].bbox(); }, std::plus<Bbox_3>());
  const Frame frame(box);
  const double largest_coordinate =
      (std::max)({-box.xmin(), -box.ymin(), -box.zmin(), box.xmax(), box.ymax(), box.zmax()});
  for_each_index<ConcurrencyTag>(0, n,
                                 [&](std::size_t i)
                                 {
    const Point& p = coordinates[i];
    coordinates[i] = frame.to_frame(p.x(), p.y(), p.z());
  });

  // Equal points become neighbors in lexicographic order, the first of the input in front.
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t(0));
  sort<ConcurrencyTag>(order.begin(), order.end(),
                       [&](std::size_t i, std::size_t j)
                       {
    const Point &p = coordinates[i], &q = coordinates[j];
    return p < q || (p == q && i < j);
  });
  std::vector<std::size_t> first_equal(n);
  std::vector<std::size_t> input_index;
  for (std::size_t i : order)
  {
    if (input_index.empty() || coordinates[input_index.back()] != coordinates[i])
      input_index.push_back(i);
    first_equal[i] = input_index.back();
  }

  using Point_map = Pointer_property_map<Point>::const_type;
  using Sort_traits = Spatial_sort_traits_adapter_3<Computation_kernel, Point_map>;
  hilbert_sort<ConcurrencyTag>(input_index.begin(), input_index.end(),
                               Sort_traits(Point_map(coordinates.data())));

  std::vector<Point> points(input_index.size());
  std::vector<std::size_t>& distinct_index = order; // its memory is free again
  for_each_index<ConcurrencyTag>(0, points.size(),
                                 [&](std::size_t i)
                                 {
    points[i] = coordinates[input_index[i]];
    distinct_index[input_index[i]] = i;
  });
  for_each_index<ConcurrencyTag>(0, n,
                                 [&](std::size_t i)
                                 {
    if (first_equal[i] != i)
      distinct_index[i] = distinct_index[first_equal[i]];
  });
  return Cloud{frame, std::move(points), std::move(input_index), std::move(distinct_index),
               frame.length_to_frame(relative_error * largest_coordinate)};
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_CLOUD_H
