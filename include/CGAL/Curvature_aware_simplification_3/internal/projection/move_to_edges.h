// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_MOVE_TO_EDGES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_MOVE_TO_EDGES_H

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Neighborhood.h>
#include <CGAL/Curvature_aware_simplification_3/internal/projection/fit_fold.h>
#include <CGAL/Curvature_aware_simplification_3/internal/projection/move_to_targets.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/Sample_neighbors.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/Surface_sample.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Progress.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// In spacings: a strip as wide on both sides of an edge holds 1.3 * 1.15 = 1.5 samples for each
// spacing of its length, more than the one that it needs. Samples farther away are the first row
// beside it.
inline constexpr double near_edge = 0.65;

// Whether the fold is more than a detail between the samples: most of the samples nearest to the
// one at `distance` spacings from the edge are on it, and some on each side.
inline bool is_seen_by_samples(const Fold& fold, const Point& center,
                               const Neighbor_indices& neighbors, const std::vector<Point>& points,
                               double spacing, double distance)
{
  const Neighbor_indices nearest = first_of(neighbors, 12); // one ring and a half
  // The others may be on a third face: three of 12. With four, errors of CAD parts are 13 % larger
  // at 1 % of the points, with two 3 % at 10 %. But one for the first row: where faces are a few
  // spacings wide, there are no samples to spare; with two, the error of such a part at 1 % is 25 %
  // larger.
  const double share = distance > near_edge ? 0.9 : 0.75;
  // in spacings: faces may bend with a radius of 3 spacings
  constexpr double tolerance = 0.15;

  std::size_t on_fold = 0, only_on[2] = {0, 0};
  for (std::size_t i : nearest)
  {
    const Vector p = points[i] - center;
    const bool on_first = std::abs(fold.planes[0].distance(p)) < tolerance * spacing;
    const bool on_second = std::abs(fold.planes[1].distance(p)) < tolerance * spacing;
    on_fold += on_first || on_second;
    only_on[0] += on_first && !on_second;
    only_on[1] += on_second && !on_first;
  }
  return static_cast<double>(on_fold) >= share * static_cast<double>(nearest.size()) &&
         only_on[0] > 0 && only_on[1] > 0;
}

// The nearest point of a sharp edge that the input around `center` shows, if there is one within
// `reach` spacings of a sample
inline std::optional<Target> edge_point(const Surface_sample& x, const Point& center, double reach,
                                        const Neighbor_indices& neighbors,
                                        const std::vector<Point>& points, const Surface_fit& fit)
{
  // 32 neighbors, of which planes have ten or more each; with noise, all within 46 sigma, so
  // that the tolerance of 3 sigma is small, but at most four times as many. Within 30 sigma and at
  // most 96, the error of CAD parts with noise is 4 % larger, its 99th percentile 8 %.
  constexpr double fewest = 33., most = 129.;
  constexpr double radius_in_noise = 46.;
  // of the radius of the ball: faces may bend with a radius of 17 of the ball's
  constexpr double flatness = 0.03;

  const double radius = radius_in_noise * fit.noise.level / x.surface.radius;
  const double wanted = static_cast<double>(x.surface.neighbors) * radius * radius;
  const std::size_t k = static_cast<std::size_t>((std::min)((std::max)(wanted, fewest), most));
  static thread_local Neighborhood neighborhood;
  neighborhood.collect(fit.search, center, k);
  neighborhood.weight_by_distance();
  Fold fold;
  if (!fit_fold(neighborhood, (std::max)(flatness * neighborhood.radius, 3. * fit.noise.level),
                fold))
    return std::nullopt;
  const Vector from_center = x.point - center;
  const Vector way = fold.way_to_edge(from_center);
  const double distance = std::sqrt(way.squared_length()) / x.spacing;
  // the planes are known in the ball only
  if (distance > reach ||
      (from_center + way).squared_length() > neighborhood.radius * neighborhood.radius ||
      !is_seen_by_samples(fold, center, neighbors, points, x.spacing, distance))
    return std::nullopt;
  return Target{x.point + way, distance};
}

// The nearest point of a sharp edge near a sample, if there is one. `bent` finds the points of the
// input at which there may be one.
inline std::optional<Target> nearest_edge_point(const Surface_sample& x,
                                                const Neighbor_indices& neighbors,
                                                const std::vector<Point>& points,
                                                const Surface_fit& fit, const Neighbor_search& bent)
{
  // In spacings: the first row on each side. Where an edge has a gap, a surface connects the faces
  // across it and cuts it off, unless the samples beside it fill it. With `near_edge`, the 99th
  // percentile of the error of CAD parts is 6 % larger.
  constexpr double reach = 1.;

  if (!(x.surface.radius > 0.))
    return std::nullopt;
  const Point center = bent.nearest(x.point);
  if (squared_distance(center, x.point) > reach * reach * x.spacing * x.spacing)
    return std::nullopt;
  const std::optional<Target> target = edge_point(x, center, reach, neighbors, points, fit);
  if (!target || target->distance <= near_edge)
    return target;
  // The planes around it are not those at its foot point, and are fitted again there. The largest
  // error is 5 % smaller.
  return edge_point(x, bent.nearest(target->point), reach, neighbors, points, fit);
}

// Moves samples next to a sharp edge onto it. Whatever surface is reconstructed, it cuts off an
// edge that no samples are on, and a quadric rounds it. `neighbors` are those of about these
// places, `bent` the points of the input at which there may be an edge.
template <typename ConcurrencyTag>
void move_to_edges(std::vector<Surface_sample>& samples, const Sample_neighbors& neighbors,
                   const Surface_fitter& fitter, const std::vector<Point>& bent,
                   const Progress& progress)
{
  // In spacings: of samples that would go to nearly the same place, only the nearest does. With
  // 0.15 to 0.45, errors at 10 % of the points are the same within 3 %.
  constexpr double too_close = 0.3;

  if (bent.empty())
    return;
  // a tree of their own: most inputs have few of them
  const Neighbor_search bent_search(bent, ConcurrencyTag());
  const std::vector<Point> points = points_of<ConcurrencyTag>(samples);
  std::vector<std::optional<Target>> targets(samples.size());
  for_each_index<ConcurrencyTag>(samples.size(), progress, [&](std::size_t i) {
    targets[i] = nearest_edge_point(samples[i], neighbors.of(i), points,
                                    fitter.at(*samples[i].noise), bent_search);
  });
  move_to_targets<ConcurrencyTag>(samples, targets, neighbors, too_close);
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_MOVE_TO_EDGES_H
