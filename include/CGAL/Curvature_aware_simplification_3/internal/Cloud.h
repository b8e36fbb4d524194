// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_CLOUD_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_CLOUD_H

#include <CGAL/Curvature_aware_simplification_3/internal/Frame.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/loops.h>
#include <CGAL/Curvature_aware_simplification_3/internal/scan.h>

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

  // Points are sorted together with their positions in the input: sorting positions alone would jump
  // through memory with each comparison. Equal points become neighbors in lexicographic order, the first
  // of the input in front.
  using Point_and_index = std::pair<Point, std::size_t>;
  std::vector<Point_and_index> sorted(n);
  for_each_index<ConcurrencyTag>(0, n,
                                 [&](std::size_t i) {
    sorted[i] = {frame.to_frame(coordinates[i].x(), coordinates[i].y(), coordinates[i].z()), i};
  });
  coordinates = std::vector<Point>();
  sort<ConcurrencyTag>(sorted.begin(), sorted.end(), std::less<Point_and_index>());
  const std::vector<std::size_t> first_of_equals = indices_where<ConcurrencyTag>(
      n, [&](std::size_t i) { return i == 0 || sorted[i].first != sorted[i - 1].first; });
  const std::size_t distinct = first_of_equals.size();
  std::vector<std::size_t> first_equal(n);
  for_each_index<ConcurrencyTag>(0, distinct,
                                 [&](std::size_t i)
                                 {
    const std::size_t end = i + 1 < distinct ? first_of_equals[i + 1] : n;
    for (std::size_t j = first_of_equals[i]; j < end; ++j)
      first_equal[sorted[j].second] = sorted[first_of_equals[i]].second;
  });
  if (distinct < n)
    sorted = elements_at<ConcurrencyTag>(first_of_equals, sorted);

  using Sort_traits = Spatial_sort_traits_adapter_3<Computation_kernel,
                                                    First_of_pair_property_map<Point_and_index>>;
  hilbert_sort<ConcurrencyTag>(sorted.begin(), sorted.end(), Sort_traits());

  std::vector<Point> points(distinct);
  std::vector<std::size_t> input_index(distinct);
  std::vector<std::size_t> distinct_index(n);
  for_each_index<ConcurrencyTag>(0, distinct,
                                 [&](std::size_t i)
                                 {
    points[i] = sorted[i].first;
    input_index[i] = sorted[i].second;
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
