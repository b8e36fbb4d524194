// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SAMPLES_RELAX_ON_SURFACE_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SAMPLES_RELAX_ON_SURFACE_H

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/fit_to_neighbors.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/Sample_neighbors.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/Surface_sample.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/repel_samples.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Progress.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Fits a surface around each sample, and puts it there
template <typename ConcurrencyTag>
void place_on_surface(std::vector<Surface_sample>& samples, const Surface_fitter& fitter,
                      const Progress& progress)
{
  for_each_index<ConcurrencyTag>(samples.size(), progress, [&](std::size_t i) {
    Surface_sample& x = samples[i];
    x.place(fitter.at(*x.noise), x.point, NULL_VECTOR, rounds_to_move);
  });
}

// One iteration for one sample. The first term of eq. 8, which draws samples to the input, has
// become the surface that each sample moves on: it is exact to third order, where a mean is to
// first, and is fitted again when the sample leaves the part that it was fitted to.
inline void move_on_surface(Surface_sample& x, const Vector& repulsion,
                            const Surface_fitter& fitter)
{
  constexpr double trusted = 0.7; // of the radius of a fit: half of its area
  const Vector step = limited_step(repulsion, x.spacing);
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
  x.place(fitter.at(*x.noise), x.surface.point(part * a, part * b),
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
Sample_neighbors relax_on_surface(std::vector<Surface_sample>& samples,
                                  const Surface_fitter& fitter, std::size_t number_of_iterations,
                                  double repulsion_weight, const Progress& progress)
{
  // Means over all samples of how far they move, in spacings. Ten iterations come to 1 or a little
  // less: after the third, neighbors are searched for again. With 0.25, they would be a third time,
  // which makes no difference. Two samples that move as far as the mean come from 2 spacings to 1
  // unseen, but few move towards each other.
  constexpr double far_enough_to_search = 0.5;
  // After more iterations, most samples rest, and the mean tells nothing of the few that still
  // travel and meet others unseen: of 30 spheres, half had samples within 0.4 spacings of each
  // other after 70 iterations, with 0.04 the closest. Searched anew after 10, none had.
  constexpr std::size_t iterations_until_search = 10;
  // At the start, samples are where chance has put them, and the nearest decide: one ring and a
  // half is as good as more, and saves 2 % of a call.
  constexpr std::size_t first_neighbors = 12;
  // below which the distribution does not change any more: 1 % of what the first iteration moves
  constexpr double at_rest = 0.001;

  Sample_positions positions(samples, ConcurrencyTag());
  Sample_neighbors neighbors;
  neighbors.search(positions.points, first_neighbors, ConcurrencyTag());

  double moved_since_search = 0.;
  std::size_t last_search = 0; // before this iteration
  for (std::size_t iteration = 0; iteration < number_of_iterations; ++iteration)
  {
    if (moved_since_search > far_enough_to_search ||
        iteration - last_search == iterations_until_search)
    {
      neighbors.search(positions.points, Sample_neighbors::most, ConcurrencyTag());
      moved_since_search = 0.;
      last_search = iteration;
    }
    const double weight = repulsion_weight * length_of_steps(fitter.settings.length_of_first_steps,
                                                             iteration, number_of_iterations);
    const double mean_move = repel_samples<ConcurrencyTag>(
        samples, positions, neighbors, weight, fitter.settings,
        progress.step(iteration, number_of_iterations),
        [&](Surface_sample& x, const Vector& step) { move_on_surface(x, step, fitter); });
    if (mean_move < at_rest)
      break;
    moved_since_search += mean_move;
  }
  neighbors.sort(positions.points, ConcurrencyTag());
  return neighbors;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SAMPLES_RELAX_ON_SURFACE_H
