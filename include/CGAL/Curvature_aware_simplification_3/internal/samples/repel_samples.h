// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SAMPLES_REPEL_SAMPLES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SAMPLES_REPEL_SAMPLES_H

#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Adaptive_settings.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/Sample_neighbors.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/Surface_sample.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Lanes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Progress.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Second term of eq. 8 in the tangent plane of the sample: the mean of (x - x_i) with the weights
// beta_i phi_2.
//
// Distances d = x - x_i are measured in spacings, and their part along the normal n counts w =
// `weight_of_height` times: rho^2 = (|d|^2 + (w - 1) (d n)^2) / s^2. theta = (1 - rho^2 / r^2)^6
// with the reach r = 2 is close to exp(-1.5 rho^2), that of the paper for h = 3.3 spacings, and
// ends at two spacings, the second ring; beta_i = theta / rho. phi_2 = s_i^2: where n phi_2 is the
// same everywhere, the forces balance, so the density n of the samples tends to what is wanted, 1 /
// s^2; it falls with the curvature as in eq. 3 and 4.
inline Vector tangential_repulsion(const Surface_sample& x, const Neighbor_indices& neighbors,
                                   const std::vector<Point>& points,
                                   const std::vector<double>& squared_spacings,
                                   const Adaptive_settings& settings)
{
  const Vector normal = x.normal();
  const double inverse = 1. / (x.spacing * x.spacing);
  const double inverse_reach = 1. / (settings.reach_of_repulsion * settings.reach_of_repulsion);
  Lanes sum_x = Lanes::Zero(), sum_y = Lanes::Zero(), sum_z = Lanes::Zero();
  Lanes weights = Lanes::Zero();
  for (auto neighbor = neighbors.begin(); neighbor != neighbors.end();)
  {
    const std::size_t i = *neighbor++;
    const bool is_pair = neighbor != neighbors.end(); // the last may be alone
    const std::size_t j = is_pair ? *neighbor++ : i;
    const Vector_lanes d(x.point - points[i], x.point - points[j]);
    const Lanes h = d * normal;
    const Lanes rho2 = inverse * (d.squared_length() + (settings.weight_of_height - 1.) * h * h);
    const Lanes base = ((1. - inverse_reach * rho2).max)(0.);
    const Lanes base3 = base * base * base;
    // of a sample at the same place, no direction leads away
    const Lanes phi = inverse * Lanes(rho2[0] > 0. ? squared_spacings[i] : 0.,
                                      is_pair && rho2[1] > 0. ? squared_spacings[j] : 0.);
    const Lanes beta =
        base3 * base3 * phi / (rho2.max)((std::numeric_limits<double>::min)()).sqrt();
    sum_x += beta * d.x;
    sum_y += beta * d.y;
    sum_z += beta * d.z;
    weights += beta;
  }
  Vector sum(sum_x.sum(), sum_y.sum(), sum_z.sum());
  sum = sum - (sum * normal) * normal; // in the plane: of the sum, instead of each term
  double weight = weights.sum();
  // In a lattice of spacing s, the weights add up to 6 (3/4)^6 = 1.07. Few and far neighbors push
  // less: divided by less, one at the end of the reach would push as six around do, and where noise
  // makes the spacings differ, samples would jump to and fro.
  weight = (std::max)(weight, settings.least_weight_of_neighbors);
  return weight > 0. ? sum / weight : Vector(0., 0., 0.);
}

// The step of a sample, but no longer than half of the spacing: further, and neighbors could pass
// each other.
inline Vector limited_step(const Vector& step, double spacing)
{
  const double length = std::sqrt(step.squared_length());
  return length > 0.5 * spacing ? step * (0.5 * spacing / length) : step;
}

// Where the samples are and how far apart they are to be, as their neighbors see them
struct Sample_positions
{
  std::vector<Point> points;
  std::vector<double> squared_spacings;

  template <typename ConcurrencyTag>
  Sample_positions(const std::vector<Surface_sample>& samples, const ConcurrencyTag&)
    : points(samples.size()), squared_spacings(samples.size())
  {
    for_each_index<ConcurrencyTag>(0, samples.size(), [&](std::size_t i) {
      points[i] = samples[i].point;
      squared_spacings[i] = samples[i].spacing * samples[i].spacing;
    });
  }
};

// Moves each sample once, in turns: move(sample, weight * repulsion). Returns the mean over all
// samples of how far they have moved, in spacings.
template <typename ConcurrencyTag, typename Move>
double repel_samples(std::vector<Surface_sample>& samples, Sample_positions& positions,
                     const Sample_neighbors& neighbors, double weight,
                     const Adaptive_settings& settings, const Progress& progress, const Move& move)
{
  std::vector<double> moved(samples.size());
  std::vector<Point> places; // of the samples of a turn: they move all at once
  // Samples that are neighbors on the Hilbert curve have different turns.
  const std::size_t turns = (std::min)(settings.turns, samples.size());
  for (std::size_t turn = 0; turn < turns; ++turn)
  {
    const std::size_t number = (samples.size() - turn + turns - 1) / turns;
    places.resize(number);
    for_each_index<ConcurrencyTag>(number, progress.step(turn, turns), [&](std::size_t n) {
      const std::size_t i = turn + n * turns;
      Surface_sample& x = samples[i];
      move(x, weight * tangential_repulsion(x, neighbors.of(i), positions.points,
                                            positions.squared_spacings, settings));
      moved[i] = std::sqrt(squared_distance(x.point, positions.points[i])) / x.spacing;
      places[n] = x.point;
    });
    for_each_index<ConcurrencyTag>(
        0, number, [&](std::size_t n) { positions.points[turn + n * turns] = places[n]; });
  }
  return mean<ConcurrencyTag>(moved.size(), [&](std::size_t i) { return moved[i]; });
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SAMPLES_REPEL_SAMPLES_H
