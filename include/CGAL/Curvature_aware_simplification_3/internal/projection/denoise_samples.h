// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_DENOISE_SAMPLES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_DENOISE_SAMPLES_H

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Fit_difference.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/bias_of_noise.h>
#include <CGAL/Curvature_aware_simplification_3/internal/projection/fits_of_all_sizes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/Surface_sample.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Progress.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The part w of the step to a wider fit that has the least expected error, from the mean square q
// of such steps and the variance v that noise gives them; their sums do as well.
//
// Of nested least-squares fits z_0, z_1, ... the differences are uncorrelated with the wider one,
// and noise gives z_m+1 - z_m the variance v_m = var_m - var_m+1. What q_m has beyond that is
// shape, which the wider fit misses: s_m^2 = q_m - v_m. With a part w_m of the step, noise is down
// to var_m+1 + (1 - w_m)^2 v_m, and shape is off by b_m + w_m s_m, where b_m is what the steps
// before have missed, to the same side. The least sum of the first and the square of the second is
// at
//   w_m = (v_m - b_m s_m) / (v_m + s_m^2);
// with b_m = 0, this is a Wiener filter. With b_m = c s_m, where c is `missed_shape`, it is
//   w_m = (1 + c) v_m / q_m - c.
inline double part_of_step(const Fit_difference& steps, double missed_shape)
{
  if (steps.square <= steps.expected) // all of it is noise
    return 1.;
  return (std::max)((1. + missed_shape) * steps.expected / steps.square - missed_shape, 0.);
}

// Moves each sample as far towards wider fits as noise explains that these differ:
//   z = z_0 + sum_m w_m (z_m+1 - z_m).
// Then bias_of_noise() is taken away, which all these fits share, with the mean curvature combined
// with the same w_m.
// One difference tells little, so the mean square is over the sample and its 32 nearest, where
// shape is similar.
template <typename ConcurrencyTag>
void denoise_samples(std::vector<Surface_sample>& samples, const Surface_fitter& fitter,
                     const Progress& progress)
{
  constexpr std::size_t pool = 33; // squares: their mean is known to a fourth of itself

  std::vector<Fits_of_all_sizes> fits(samples.size());
  std::vector<Point> points(samples.size());
  for_each_index<ConcurrencyTag>(samples.size(), progress, [&](std::size_t i) {
    const Surface_sample& x = samples[i];
    fits[i] = x.noise->is_visible ? fits_of_all_sizes(fitter.at(*x.noise), x)
                                  : Fits_of_all_sizes{x.point, x.normal(), 0., {}};
    points[i] = fits[i].point;
  });

  const Neighbor_search search(points, ConcurrencyTag());
  for_each_index<ConcurrencyTag>(0, samples.size(), [&](std::size_t i) {
    const std::size_t steps = fits[i].widenings.size();
    std::vector<Fit_difference> differences(steps);
    search.for_each_nearest(points[i], pool, [&](std::size_t j, const Point&, double) {
      const std::vector<Widening>& other = fits[j].widenings;
      for (std::size_t m = 0; m < (std::min)(steps, other.size()); ++m)
        differences[m].add({other[m].shift * other[m].shift, other[m].variance});
    });
    double height = 0.; // above the narrowest fit
    double curvature = fits[i].curvature;
    for (std::size_t m = 0; m < steps; ++m)
    {
      const double part = part_of_step(differences[m], fitter.settings.missed_shape);
      height += part * fits[i].widenings[m].shift;
      curvature += part * fits[i].widenings[m].curvature;
    }
    if (fitter.settings.correct_bias_of_noise)
      height -= bias_of_noise(*samples[i].noise, curvature);
    samples[i].point = points[i] + height * fits[i].normal;
  });
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_DENOISE_SAMPLES_H
