// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_INSERT_SAMPLES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_INSERT_SAMPLES_H

#include <CGAL/Curvature_aware_simplification_3/internal/Scan.h>
#include <CGAL/Curvature_aware_simplification_3/internal/projection/fill_gaps.h>
#include <CGAL/Curvature_aware_simplification_3/internal/projection/triangles_around.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/Sample_neighbors.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/Surface_sample.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Computation_kernel.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Flags.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/sort.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// How many of the samples are not spread over the surface, but kept for tips and narrow ridges that
// none of the others happens to be on: there, a mesh of the samples misses most. They are found
// among points on surfaces that bend, which get twice their share at most. Where points are noisy
// or may be outliers, those farthest from the mesh are what is wrong with them.
inline std::size_t samples_to_insert(const Scan& scan, std::size_t number_of_samples, double share)
{
  if (scan.noise.is_visible() || scan.had_more_than_a_few_outliers)
    return 0;
  const std::size_t bent = scan.bent_points.size();
  const double share_of_bent = static_cast<double>(bent) / static_cast<double>(scan.points.size());
  return (std::min)(bent, static_cast<std::size_t>((std::min)(share, share_of_bent) *
                                                   static_cast<double>(number_of_samples)));
}

// A point of the input, and how far a mesh of the samples is from it
struct Missed_point
{
  Point point;
  // The samples that tell: the nearest alone would see less (p99 would be 2 % larger), six see no
  // more.
  std::array<std::size_t, 3> nearest; // the nearest first
  double distance;                    // from the mesh

  // Those that are missed most come first.
  bool operator<(const Missed_point& other) const
  {
    return std::tie(other.distance, point) < std::tie(distance, other.point);
  }
};

// There are three at least: 0.045 of the samples, which are inserted, are one or more.
inline std::array<std::size_t, 3> nearest_samples(const Point& p, const Neighbor_search& samples)
{
  CGAL_precondition(samples.size() >= 3);
  std::array<std::pair<double, std::size_t>, 3> nearest;
  std::size_t number = 0;
  samples.for_each_nearest(p, nearest.size(),
                           [&](std::size_t i, const Point&, double squared_distance) {
                             nearest[number++] = {squared_distance, i};
                           });
  std::sort(nearest.begin(), nearest.end());
  return {nearest[0].second, nearest[1].second, nearest[2].second};
}

// The distance from what is around a sample in a mesh, from the sample alone if there is nothing
inline double distance_from_triangles(const Point& p, const Surface_sample& x,
                                      const std::vector<Triangle>& triangles)
{
  const Point q = ORIGIN + (p - x.point) / x.spacing;
  double result = squared_distance(q, Point(ORIGIN));
  for (const Triangle& triangle : triangles)
    result = (std::min)(result, squared_distance(q, triangle));
  return x.spacing * std::sqrt(result);
}

// The bent points of the input, those that a mesh of the samples misses most first
template <typename ConcurrencyTag>
std::vector<Missed_point> missed_points(const std::vector<Surface_sample>& samples,
                                        const Sample_neighbors& neighbors,
                                        const std::vector<Point>& bent_points)
{
  const std::vector<Point> points = points_of<ConcurrencyTag>(samples);
  const Neighbor_search search(points, ConcurrencyTag());
  std::vector<Missed_point> missed(bent_points.size());
  for_each_index<ConcurrencyTag>(0, missed.size(), [&](std::size_t i) {
    missed[i] = {bent_points[i], nearest_samples(bent_points[i], search), 0.};
  });

  Flags is_asked(samples.size(), 0);
  for (const Missed_point& p : missed)
    for (std::size_t i : p.nearest)
      is_asked[i] = 1;
  std::vector<std::vector<Triangle>> triangles(samples.size());
  for_each_index<ConcurrencyTag>(0, samples.size(), [&](std::size_t i) {
    if (is_asked[i] != 0)
      triangles[i] = triangles_around(samples[i], neighbors.of(i), points);
  });

  for_each_index<ConcurrencyTag>(0, missed.size(), [&](std::size_t m) {
    Missed_point& p = missed[m];
    p.distance = std::numeric_limits<double>::infinity();
    for (std::size_t i : p.nearest)
      p.distance =
          (std::min)(p.distance, distance_from_triangles(p.point, samples[i], triangles[i]));
    if (!std::isfinite(p.distance)) // where the spacing underflows
      p.distance = 0.;
  });
  internal::sort<ConcurrencyTag>(missed);
  return missed;
}

// Adds `number` samples, no more than there are bent points, at those that a mesh of the samples
// misses most. One shows what is missed between the samples around it. Where there are more than
// such places, the others fill gaps.
template <typename ConcurrencyTag>
void insert_samples(std::vector<Surface_sample>& samples, std::size_t number,
                    const Sample_neighbors& neighbors, const Scan& scan)
{
  if (number == 0)
    return;
  const std::vector<Missed_point> missed =
      missed_points<ConcurrencyTag>(samples, neighbors, scan.bent_points);
  const std::size_t end = samples.size() + number;
  Flags has_one_beside(samples.size(), 0);
  for (auto p = missed.begin(); p != missed.end() && samples.size() < end; ++p)
  {
    if (has_one_beside[p->nearest[0]] != 0 || !(p->distance > 0.))
      continue;
    for (std::size_t i : p->nearest)
      has_one_beside[i] = 1;
    samples.push_back(samples[p->nearest[0]]);
    samples.back().point = p->point;
  }
  std::vector<std::size_t> others;
  for (auto p = missed.begin(); samples.size() < end; ++p)
  {
    others.push_back(samples.size());
    samples.push_back(samples[p->nearest[0]]);
  }
  fill_gaps<ConcurrencyTag>(samples, others, *scan.search);
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_INSERT_SAMPLES_H
