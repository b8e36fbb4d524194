// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_MOVE_TO_CORNERS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_MOVE_TO_CORNERS_H

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Neighborhood.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/fit_local_surface.h>
#include <CGAL/Curvature_aware_simplification_3/internal/projection/move_to_targets.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/Sample_neighbors.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/Surface_sample.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Progress.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Where the samples end around x, in its tangent plane
struct Way_out
{
  // from the mean of its nearest neighbors to x, over their mean distance: about the null vector
  // amid samples; on a border, it has a length of 2 / pi = 0.64
  Vector direction = Vector(0., 0., 0.);
  double mean_distance = 0.;
};

inline Way_out way_out(const Surface_sample& x, const Neighbor_indices& neighbors,
                       const std::vector<Point>& points)
{
  const Neighbor_indices ring = first_of(neighbors, 8); // around a sample, and some more
  const Vector normal = x.normal();
  Vector sum(0., 0., 0.);
  double length = 0.;
  for (std::size_t i : ring)
  {
    const Vector d = x.point - points[i];
    const Vector t = d - (d * normal) * normal;
    sum = sum + t;
    length += std::sqrt(t.squared_length());
  }
  return length > 0. ? Way_out{sum / length, length / static_cast<double>(ring.size())} : Way_out();
}

// Whether the neighbors are in a part of a plane that is clearly less than a half, and their center
// is its corner: the mean of those in a half disk of radius R is 0.42 R off its center, in a third
// 0.55 R, in a quarter 0.6 R. Across the plane, noise may carry a point as far from the others.
inline bool is_corner(const Neighborhood& neighborhood, const Vector& normal)
{
  constexpr double least = 0.5;
  Vector sum(0., 0., 0.);
  for (const Neighborhood::Neighbor& neighbor : neighborhood.neighbors)
    sum = sum + neighbor.position;
  sum = sum - (sum * normal) * normal;
  const double limit = least * neighborhood.radius * static_cast<double>(neighborhood.size());
  return sum.squared_length() > limit * limit;
}

// The corner of an open surface next to a sample, if there is one: the last point of the input on
// the way out of the samples, if it is a corner of the input
inline std::optional<Target> nearest_corner(const Surface_sample& x,
                                            const Neighbor_indices& neighbors,
                                            const std::vector<Point>& points,
                                            const Surface_fit& fit)
{
  constexpr double at_border = 0.55; // somewhat less than on a straight one
  constexpr double reach = 1.; // in spacings: where samples are even, one is nearer to a corner
  // In spacings; on an even border it is 1.4. Where far more samples than even ones are asked for,
  // one is next to any corner, and the balls of all would each hold a large part of the input.
  constexpr double least_mean_distance = 0.5;
  // The mean of 64 random points in a half disk scatters: one in two hundred samples on the border
  // of a disk is taken for one next to a corner, and moves by half a spacing at most.
  constexpr std::size_t k = 65;

  const Way_out out = way_out(x, neighbors, points);
  if (!(out.direction.squared_length() > at_border * at_border &&
        out.mean_distance > least_mean_distance * x.spacing))
    return std::nullopt;
  Point last = x.point;
  double farthest = -std::numeric_limits<double>::infinity();
  fit.search.for_each_within(x.point, reach * x.spacing, [&](std::size_t, const Point& p, double) {
    const double way = (p - x.point) * out.direction;
    if (way > farthest)
    {
      farthest = way;
      last = p;
    }
  });
  static thread_local Neighborhood neighborhood;
  neighborhood.collect(fit.search, last, k);
  if (!is_corner(neighborhood, x.normal()))
    return std::nullopt;
  const Point corner =
      fit_local_surface(fit, last, x.normal(), x.surface, rounds_to_stay, neighborhood).origin;
  return Target{corner, std::sqrt(squared_distance(x.point, corner)) / x.spacing};
}

// Leaves a corner to the sample that is nearest to it. All samples are asked, since neighbors are
// those of before the samples moved, and two that are none came to be in the same corner.
template <typename ConcurrencyTag>
void leave_to_nearest(std::vector<std::optional<Target>>& targets, const std::vector<Point>& points)
{
  if (std::none_of(targets.begin(), targets.end(), [](const auto& target) { return target; }))
    return;
  const Neighbor_search search(points, ConcurrencyTag());
  for_each_index<ConcurrencyTag>(0, targets.size(), [&](std::size_t i) {
    if (targets[i])
      search.for_each_nearest(targets[i]->point, 1, [&](std::size_t nearest, const Point&, double) {
        if (nearest != i)
          targets[i].reset();
      });
  });
}

// Moves samples next to a corner of an open surface into it. They are pushed towards it, but stop
// at the border on one side of it, and whatever surface is reconstructed cuts off a corner without
// a sample. `neighbors` are those of about these places.
template <typename ConcurrencyTag>
void move_to_corners(std::vector<Surface_sample>& samples, const Sample_neighbors& neighbors,
                     const Surface_fitter& fitter, const Progress& progress)
{
  constexpr double one_for_each_corner = 1.; // in spacings

  const std::vector<Point> points = points_of<ConcurrencyTag>(samples);
  std::vector<std::optional<Target>> targets(samples.size());
  for_each_index<ConcurrencyTag>(samples.size(), progress, [&](std::size_t i) {
    targets[i] = nearest_corner(samples[i], neighbors.of(i), points, fitter.at(*samples[i].noise));
  });
  leave_to_nearest<ConcurrencyTag>(targets, points);
  move_to_targets<ConcurrencyTag>(samples, targets, neighbors, one_for_each_corner);
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_MOVE_TO_CORNERS_H
