// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_RELAX_ON_SURFACE_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_RELAX_ON_SURFACE_H

#include <CGAL/Curvature_aware_simplification_3/internal/Progress.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Sample_neighbors.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Surface_sample.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fit_local_surface.h>
#include <CGAL/Curvature_aware_simplification_3/internal/loops.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Second term of eq. 8 in the tangent plane of the sample: the mean of (x - x_i) with the weights
// beta_i phi_2.
//
// Distances are measured in spacings, rho = |x - x_i| / s. theta = (1 - rho^2 / 4)^6 is close to
// exp(-1.5 rho^2), that of the paper for h = 3.3 spacings, and ends at two spacings, the second
// ring. phi_2 = s_i^2: where n phi_2 is the same everywhere, the forces balance, so the density n
// of the samples tends to what is wanted, 1 / s^2; it falls with the curvature as in eq. 3 and 4.
template <typename Neighbors>
Vector tangential_repulsion(const Surface_sample& x, const Neighbors& neighbors,
                            const std::vector<Point>& points, const std::vector<double>& spacings,
                            const Adaptive_settings& settings)
{
  const double inverse = 1. / (x.spacing * x.spacing);
  const double inverse_reach = 1. / (settings.reach_of_repulsion * settings.reach_of_repulsion);
  Vector sum(0., 0., 0.); // its part along the normal is taken off once, at the end
  double weight = 0.;
  for (std::size_t i : neighbors)
  {
    const Vector d = x.point - points[i];
    const double h = d * x.normal;
    const double squared_distance = d.squared_length() + (settings.weight_of_height - 1.) * h * h;
    const double rho2 = squared_distance * inverse;
    const double base = 1. - inverse_reach * rho2;
    if (!(base > 0. && rho2 > 0.)) // of a sample at the same place, no direction leads away
      continue;
    const double base3 = base * base * base;
    const double theta = base3 * base3;
    const double phi = spacings[i] * spacings[i] * inverse;
    const double beta = theta * phi / std::sqrt(rho2);
    sum = sum + beta * d;
    weight += beta;
  }
  sum = sum - (sum * x.normal) * x.normal;
  // In a lattice of spacing s, the weights add up to 6 (3/4)^6 = 1.07. Few and far neighbors push
  // less: divided by less, one at the end of the reach would push as six around do, and where noise
  // makes the spacings differ, samples would jump to and fro.
  weight = (std::max)(weight, settings.least_weight_of_neighbors);
  return weight > 0. ? sum / weight : Vector(0., 0., 0.);
}

// One iteration for one sample. The first term of eq. 8, which draws samples to the input, has
// become the surface that each sample moves on: it is exact to third order, where a mean is to
// first, and is fitted again when the sample leaves the part that it was fitted to.
inline void move_on_surface(Surface_sample& x, Vector step, const Surface_fit& fit)
{
  constexpr double trusted = 0.7; // of the radius of a fit: half of its area
  const double length = std::sqrt(step.squared_length());
  if (length > 0.5 * x.spacing) // further, and neighbors could pass each other
    step = step * (0.5 * x.spacing / length);
  double a = x.a + step * x.surface.u, b = x.b + step * x.surface.v;
  x.border.move_back(a, b);
  const double distance = std::sqrt(a * a + b * b);
  if (distance <= trusted * x.surface.radius)
  {
    x.move_to(a, b);
    return;
  }
  // beyond the fit, it is followed for half its radius at most
  const double part = (std::min)(1., 1.5 * x.surface.radius / distance);
  x.place(fit.with(x.noise), x.surface.point(part * a, part * b),
          x.surface.normal(part * a, part * b), rounds_to_move);
}

// How many times as long as the repulsion weight says the steps of an iteration are: `first` in the
// first one, which shrinks evenly to 1 in the tenth, or in the last if there are fewer. Further
// iterations then only carry on.
inline double length_of_steps(double first, std::size_t iteration, std::size_t number_of_iterations)
{
  const std::size_t last = (std::min)(number_of_iterations, std::size_t(10)) - 1;
  return iteration < last
             ? 1. + (first - 1.) * static_cast<double>(last - iteration) / static_cast<double>(last)
             : 1.;
}

// Iterations of eq. 8 until the samples rest, at most `number_of_iterations`. Returns the neighbors
// that they ended with, in the order of their distances.
template <typename ConcurrencyTag>
Sample_neighbors relax_on_surface(std::vector<Surface_sample>& samples, const Surface_fit& fit,
                                  std::size_t number_of_iterations, double repulsion_weight,
                                  const Progress& progress)
{
  // Means over all samples of how far they move, in spacings. Ten iterations come to 1 or a little
  // less: after the third, neighbors are searched for again. With 0.25, they would be a third time,
  // which makes no difference. Two samples that move as far as the mean come from 2 spacings to 1
  // unseen, but few move towards each other.
  constexpr double far_enough_to_search = 0.5;
  // After more iterations, most samples rest, and the mean tells nothing of the few that still
  // travel and meet others unseen: of 30 spheres, half had samples within 0.4 spacings of each other
  // after 70 iterations, with 0.04 the closest. Searched anew after 10, none had.
  constexpr std::size_t iterations_until_search = 10;
  // At the start, samples are where chance has put them, and the nearest decide: one ring and a
  // half is as good as more, and saves 2 % of a call.
  constexpr std::size_t first_neighbors = 12;
  // below which the distribution does not change any more: 1 % of what the first iteration moves
  constexpr double at_rest = 0.001;

  std::vector<Point> points(samples.size());
  std::vector<double> spacings(samples.size());
  for_each_index<ConcurrencyTag>(0, samples.size(),
                                 [&](std::size_t i)
                                 {
    points[i] = samples[i].point;
    spacings[i] = samples[i].spacing;
  });
  Sample_neighbors neighbors;
  neighbors.search(points, first_neighbors, ConcurrencyTag());

  double moved_since_search = 0.;
  std::size_t last_search = 0; // before this iteration
  std::vector<double> moved(samples.size());
  for (std::size_t iteration = 0; iteration < number_of_iterations; ++iteration)
  {
    if (moved_since_search > far_enough_to_search ||
        iteration - last_search == iterations_until_search)
    {
      neighbors.search(points, Sample_neighbors::most, ConcurrencyTag());
      moved_since_search = 0.;
      last_search = iteration;
    }
    const double iterations = static_cast<double>(number_of_iterations);
    const double weight = repulsion_weight * length_of_steps(fit.settings.length_of_first_steps,
                                                             iteration, number_of_iterations);
    const Progress iteration_progress =
        progress.part(static_cast<double>(iteration) / iterations,
                      static_cast<double>(iteration + 1) / iterations);
    // Samples that are neighbors on the Hilbert curve have different turns.
    const std::size_t turns = (std::min)(fit.settings.turns, samples.size());
    for (std::size_t turn = 0; turn < turns; ++turn)
    {
      const std::size_t number = (samples.size() - turn + turns - 1) / turns;
      const Progress turn_progress =
          iteration_progress.part(static_cast<double>(turn) / static_cast<double>(turns),
                                  static_cast<double>(turn + 1) / static_cast<double>(turns));
      for_each_index<ConcurrencyTag>(number, turn_progress,
                                     [&](std::size_t n)
                                     {
        const std::size_t i = turn + n * turns;
        Surface_sample& x = samples[i];
        const Vector repulsion =
            tangential_repulsion(x, neighbors.of(i), points, spacings, fit.settings);
        move_on_surface(x, weight * repulsion, fit);
        moved[i] = std::sqrt(squared_distance(x.point, points[i])) / x.spacing;
      });
      for_each_index<ConcurrencyTag>(0, number,
                                     [&](std::size_t n)
                                     {
        const std::size_t i = turn + n * turns;
        points[i] = samples[i].point;
      });
    }
    const double mean_move =
        mean<ConcurrencyTag>(moved.size(), [&](std::size_t i) { return moved[i]; });
    if (mean_move < at_rest)
      break;
    moved_since_search += mean_move;
  }
  neighbors.sort(points, ConcurrencyTag());
  return neighbors;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_RELAX_ON_SURFACE_H
