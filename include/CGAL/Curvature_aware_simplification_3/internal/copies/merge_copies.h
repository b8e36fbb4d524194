// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_COPIES_MERGE_COPIES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_COPIES_MERGE_COPIES_H

#include <CGAL/Curvature_aware_simplification_3/internal/copies/Copies_of_places.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Surface_fit.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Searchable_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Computation_kernel.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Counter_based_random.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Flags.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Progress.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/index_selection.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// What is made of a point
struct Merged_point
{
  bool is_left;
  Point point;
};

// Each point has a random rank. Of points within the distance r of copies of it, the one with the
// lowest rank is left, at the mean of those within r of it, so that their errors are averaged.
// Since ranks are random, some are left as well where each point is within r of the next, and such
// a chain does not become one point. Where a ball holds twice as many points as were looked for -
// it may reach into the next place - they are no copies but a dense part, and all are left as they
// are.
inline Merged_point merged_point(std::size_t i, const Searchable_points& cloud,
                                 const Copies_of_places& copies)
{
  const Counter_based_random ranks(0, 0);
  const std::uint64_t rank = ranks.bits(i);
  bool is_lowest = true;
  std::size_t number = 0;
  Vector sum(0., 0., 0.);
  const Point& place = cloud.points[i];
  cloud.search->for_each_within(
      place, copies.distance,
      [&](std::size_t j, const Point& p, double) {
        is_lowest = is_lowest && rank <= ranks.bits(j);
        sum = sum + (p - place);
        ++number;
      },
      2 * copies.most);
  if (number > 2 * copies.most)
    return {true, place};
  return {is_lowest, place + sum / static_cast<double>(number)};
}

// Leaves one point for all copies of a place, and returns by how many the points are fewer.
//
// Small parts that are far from each other look like copies: at least as many are left as there are
// samples, since each needs a point to start from, and enough to fit surfaces to.
template <typename ConcurrencyTag>
std::size_t merge_copies(Searchable_points& cloud, std::size_t number_of_samples,
                         const Progress& progress)
{
  const std::size_t n = cloud.size();
  const Copies_of_places copies = find_copies<ConcurrencyTag>(cloud, number_of_samples);
  if (!(copies.distance > 0.))
    return 0;
  Flags is_left(n);
  for_each_index<ConcurrencyTag>(n, progress, [&](std::size_t i) {
    is_left[i] = merged_point(i, cloud, copies).is_left ? 1 : 0;
  });
  const std::vector<std::size_t> left = flagged_indices<ConcurrencyTag>(is_left);
  if (left.size() < (std::max)(number_of_samples, fewest_points_to_fit))
    return 0;
  std::vector<Point> places(left.size()); // few: computed again, instead of kept for all points
  for_each_index<ConcurrencyTag>(0, left.size(), [&](std::size_t i) {
    places[i] = merged_point(left[i], cloud, copies).point;
  });
  cloud.points = std::move(places);
  cloud.rebuild_search<ConcurrencyTag>();
  return n - left.size();
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_COPIES_MERGE_COPIES_H
