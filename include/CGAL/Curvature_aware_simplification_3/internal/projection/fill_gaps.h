// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_FILL_GAPS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_FILL_GAPS_H

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Surface_fit.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/Surface_sample.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Of the points of the input around a sample, the one that is farthest from all samples and from
// the points that are `taken` since these were listed; the place of the sample itself if all are
inline Point point_in_largest_gap(const Surface_sample& x, const Neighbor_search& samples,
                                  const std::set<Point>& taken, const Neighbor_search& input)
{
  std::vector<Point> around, taken_around;
  input.for_each_nearest(x.point, smallest_neighborhood, [&](std::size_t, const Point& p, double) {
    (taken.count(p) == 0 ? around : taken_around).push_back(p);
  });
  Point result = x.point;
  double largest = 0.;
  for (const Point& p : around)
  {
    double gap = squared_distance(p, samples.nearest(p));
    for (const Point& other : taken_around)
      gap = (std::min)(gap, squared_distance(p, other));
    if (gap > largest)
    {
      largest = gap;
      result = p;
    }
  }
  return result;
}

// Moves some of the samples, one after the other, to where samples are missed most around them
template <typename ConcurrencyTag>
void fill_gaps(std::vector<Surface_sample>& samples, const std::vector<std::size_t>& with,
               const Neighbor_search& input)
{
  if (with.empty())
    return;
  const Neighbor_search search(points_of<ConcurrencyTag>(samples), ConcurrencyTag());
  std::set<Point> taken;
  for (std::size_t i : with)
  {
    samples[i].point = point_in_largest_gap(samples[i], search, taken, input);
    taken.insert(samples[i].point);
  }
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_FILL_GAPS_H
