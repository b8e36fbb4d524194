// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_CORRECT_BY_POINTS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_CORRECT_BY_POINTS_H

#include <CGAL/Curvature_aware_simplification_3/internal/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Sample_neighbors.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Surface_fit.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Surface_sample.h>
#include <CGAL/Curvature_aware_simplification_3/internal/prefix_sums.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Whether the fit of a sample misses `nearest`, a point that is known to be on the surface but for
// noise: it mixes the sides of a part that is hardly thicker than the points are apart.
inline bool is_missed(const Surface_sample& x, const Point& nearest)
{
  // Of the radius of the fit, more than most points next to a fold of 90 degrees are off, 0.06.
  // With 0.05, samples on both sides of sharp edges move as well, and errors at 1 % of the points
  // are 2 % larger. Where samples are nearly as dense as the points, a fit is wider than they are
  // apart, and they show what it misses: there, of their spacing.
  constexpr double largest_error = 0.1;
  // Noise alone carries one point in 80 that far.
  constexpr double largest_noise = 2.5;
  return std::abs(x.surface.residual(nearest - x.surface.origin)) >
         (std::max)(largest_error * (std::min)(x.surface.radius, x.spacing),
                    largest_noise * x.noise.level);
}

// The squared distance of a point to the nearest of these samples
template <typename Neighbors>
double squared_distance_to_samples(const Point& p, const Neighbors& neighbors,
                                   const std::vector<Surface_sample>& samples)
{
  double result = std::numeric_limits<double>::infinity();
  for (std::size_t j : neighbors)
    result = (std::min)(result, squared_distance(p, samples[j].point));
  return result;
}

// Of the points of the input around a sample that are not `taken`, the one that is farthest from
// all samples; the place of the sample itself if there is none
inline Point point_in_largest_gap(const Surface_sample& x, const Neighbor_search& samples,
                                  const std::set<Point>& taken, const Surface_fit& fit)
{
  Point result = x.point;
  double largest = 0.;
  fit.search.for_each_nearest(x.point, (std::min)(smallest_neighborhood, fit.number_of_points),
                              [&](std::size_t, const Point& p, double)
                              {
    const double gap = squared_distance(p, samples.nearest(p));
    if (gap > largest && taken.count(p) == 0)
    {
      largest = gap;
      result = p;
    }
  });
  return result;
}

// Samples at the place of one before them. Of those that came to the same gap and went back to the
// same point, as many do on curves, no direction leads away from each other.
template <typename ConcurrencyTag>
std::vector<std::size_t> copies_of_others(const std::vector<Surface_sample>& samples)
{
  constexpr double same_place = 1e-6; // in spacings
  const std::vector<std::size_t> went_back = indices_where<ConcurrencyTag>(samples.size(),
                                                                           [&](std::size_t i) {
    return samples[i].went_back && !samples[i].noise.is_visible;
  });
  if (went_back.empty())
    return {};
  const Neighbor_search search(points_of<ConcurrencyTag>(samples), ConcurrencyTag());
  std::vector<std::uint8_t> is_copy(went_back.size(), 0);
  for_each_index<ConcurrencyTag>(0, went_back.size(),
                                 [&](std::size_t c)
                                 {
    const Surface_sample& x = samples[went_back[c]];
    search.for_each_within(x.point, same_place * x.spacing,
                           [&](std::size_t j, const Point&, double)
                           {
      if (j < went_back[c])
        is_copy[c] = 1;
    });
  });
  return elements_at<ConcurrencyTag>(indices_where<ConcurrencyTag>(went_back.size(),
                                                                   [&](std::size_t c)
                                                                   { return is_copy[c] != 0; }),
                                     went_back);
}

// Moves samples whose fits miss the points that are nearest to them there, if no other sample is at
// such a point. Where several would move to it, the nearest of them does; the others, one after the
// other, fill gaps. There are hardly more points than samples where that happens, so that each that
// is used twice leaves one out. Samples at the place of another fill gaps as well.
template <typename ConcurrencyTag>
void correct_by_points(std::vector<Surface_sample>& samples, const std::vector<Point>& nearest,
                       const Sample_neighbors& neighbors, const Surface_fit& fit)
{
  constexpr double same_place = 0.1; // in spacings: two samples there show no more than one

  const std::vector<std::size_t> copies = copies_of_others<ConcurrencyTag>(samples);
  std::vector<std::size_t> missed = indices_where<ConcurrencyTag>(samples.size(),
                                                                  [&](std::size_t i)
                                                                  {
    return is_missed(samples[i], nearest[i]) &&
           !std::binary_search(copies.begin(), copies.end(), i);
  });
  const auto distance_and_index = [&](std::size_t i)
  { return std::make_pair(squared_distance(samples[i].point, nearest[i]), i); };
  std::sort(missed.begin(), missed.end(),
            [&](std::size_t i, std::size_t j)
            { return distance_and_index(i) < distance_and_index(j); });
  std::set<Point> taken; // by samples that may be no neighbors
  std::vector<std::size_t> late = copies;
  for (std::size_t i : missed)
  {
    const Point point = fit.search.nearest(nearest[i]); // exactly, and not relative to the sample
    const double gap = same_place * samples[i].spacing;
    if (squared_distance_to_samples(point, neighbors.of(i), samples) > gap * gap &&
        taken.insert(point).second)
      samples[i].point = point;
    else
      late.push_back(i);
  }
  if (late.empty())
    return;
  const Neighbor_search search(points_of<ConcurrencyTag>(samples), ConcurrencyTag());
  for (std::size_t i : late)
  {
    samples[i].point = point_in_largest_gap(samples[i], search, taken, fit);
    taken.insert(samples[i].point);
  }
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_CORRECT_BY_POINTS_H
