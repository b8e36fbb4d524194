// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_INPUT_CLOUD_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_INPUT_CLOUD_H

#include <CGAL/Curvature_aware_simplification_3/internal/input/Frame.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Searchable_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/box_of_most_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/check_that_all_are_measurements.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/find_duplicates.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Computation_kernel.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Flags.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Progress.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Uninitialized_vector.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/index_selection.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Hilbert_sort_median_3.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The distinct points of the input, along a Hilbert curve, so that neighbors in space are neighbors
// in memory, and where they come from.
//
// Exact duplicates are merged. They tell nothing of the surface, but would fill the neighborhoods
// of k points and leave no room for those that do.
struct Cloud : Searchable_points
{
  Frame frame;
  // of each distinct point: its first position in the input
  Uninitialized_vector<std::size_t> input_index;
  std::vector<Duplicate> duplicates; // all other points of the input

  std::size_t input_size() const { return points.size() + duplicates.size(); }
};

// Only the points: where they come from is not asked any more.
inline Searchable_points without_positions(Cloud cloud)
{
  return static_cast<Searchable_points&&>(cloud);
}

// Of each input point: its distinct point. O(n), but by jumps through memory, so that only those
// ask who must know.
template <typename ConcurrencyTag>
std::vector<std::size_t> distinct_indices(const Cloud& cloud)
{
  std::vector<std::size_t> result(cloud.input_size());
  for_each_index<ConcurrencyTag>(0, cloud.size(),
                                 [&](std::size_t i) { result[cloud.input_index[i]] = i; });
  for_each_index<ConcurrencyTag>(0, cloud.duplicates.size(), [&](std::size_t d) {
    result[cloud.duplicates[d].index] = result[cloud.duplicates[d].first];
  });
  return result;
}

// Sorts points with their positions in the input: sorting positions alone would jump through memory
// with each comparison. Points that agree in the coordinate compared are told apart by the next
// ones, so that the order along the curve does not depend on that of the input. A model of CGAL's
// SpatialSortingTraits_3.
struct Sort_traits
{
  struct Point_3
  {
    Point point;
    std::size_t index;
  };

  template <int axis>
  struct Less
  {
    bool operator()(const Point_3& p, const Point_3& q) const
    {
      for (int i = axis; i < axis + 3; ++i)
        if (p.point[i % 3] != q.point[i % 3])
          return p.point[i % 3] < q.point[i % 3];
      return false;
    }
  };
  using Less_x_3 = Less<0>;
  using Less_y_3 = Less<1>;
  using Less_z_3 = Less<2>;

  Less_x_3 less_x_3_object() const { return Less_x_3(); }
  Less_y_3 less_y_3_object() const { return Less_y_3(); }
  Less_z_3 less_z_3_object() const { return Less_z_3(); }
};

// Without the duplicates, in the order of the input
template <typename ConcurrencyTag>
Uninitialized_vector<Sort_traits::Point_3> distinct_points(const std::vector<Point>& points,
                                                           const std::vector<Duplicate>& duplicates)
{
  const std::size_t n = points.size();
  Uninitialized_vector<Sort_traits::Point_3> distinct(n - duplicates.size());
  if (duplicates.empty())
  {
    for_each_index<ConcurrencyTag>(0, n, [&](std::size_t i) { distinct[i] = {points[i], i}; });
    return distinct;
  }
  Flags is_duplicate(n);
  for_each_index<ConcurrencyTag>(0, duplicates.size(),
                                 [&](std::size_t d) { is_duplicate[duplicates[d].index] = 1; });
  const std::vector<std::size_t> firsts =
      indices_where<ConcurrencyTag>(n, [&](std::size_t i) { return is_duplicate[i] == 0; });
  for_each_index<ConcurrencyTag>(0, distinct.size(), [&](std::size_t i) {
    distinct[i] = {points[firsts[i]], firsts[i]};
  });
  return distinct;
}

// Merges duplicates and sorts along a Hilbert curve. There is at least one point; coordinates are
// exact up to `relative_error` times the largest of them, a few far points aside. O(n log n)
template <typename ConcurrencyTag>
Cloud make_cloud(std::vector<Point> coordinates, double relative_error, const Progress& progress)
{
  const std::size_t n = coordinates.size();
  const Bbox_3 box = reduce_indices<ConcurrencyTag>(
      n, Bbox_3(), [&](std::size_t i) { return coordinates[i].bbox(); }, std::plus<Bbox_3>());
  const Bbox_3 most = box_of_most_points(coordinates, box);
  check_that_all_are_measurements(coordinates, box, most == box);
  const Frame frame(box, most);
  const double largest_coordinate =
      (std::max)({-most.xmin(), -most.ymin(), -most.zmin(), most.xmax(), most.ymax(), most.zmax()});
  for_each_index<ConcurrencyTag>(0, n, [&](std::size_t i) {
    const Point& p = coordinates[i];
    coordinates[i] = frame.to_frame(p.x(), p.y(), p.z());
  });

  std::vector<Duplicate> duplicates = find_duplicates<ConcurrencyTag>(coordinates);
  Uninitialized_vector<Sort_traits::Point_3> sorted =
      distinct_points<ConcurrencyTag>(coordinates, duplicates);
  coordinates = std::vector<Point>();
  // what CGAL::hilbert_sort() calls after it has shuffled the points, on one thread
  Hilbert_sort_median_3<Sort_traits, ConcurrencyTag>{Sort_traits()}(sorted.begin(), sorted.end());

  std::vector<Point> points(sorted.size());
  Uninitialized_vector<std::size_t> input_index(sorted.size());
  for_each_index<ConcurrencyTag>(0, sorted.size(), [&](std::size_t i) {
    points[i] = sorted[i].point;
    input_index[i] = sorted[i].index;
  });
  sorted = Uninitialized_vector<Sort_traits::Point_3>();
  progress.report(0.5);
  Cloud cloud{
      {std::move(points), nullptr, frame.length_to_frame(relative_error * largest_coordinate)},
      frame,
      std::move(input_index),
      std::move(duplicates)};
  cloud.rebuild_search<ConcurrencyTag>();
  return cloud;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_INPUT_CLOUD_H
