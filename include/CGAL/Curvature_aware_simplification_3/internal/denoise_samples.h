// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DENOISE_SAMPLES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DENOISE_SAMPLES_H

#include <CGAL/Curvature_aware_simplification_3/internal/Progress.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fit_local_surface.h>
#include <CGAL/Curvature_aware_simplification_3/internal/loops.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL
{
namespace Curvature_aware_simplification_3
{
namespace internal
{

// What a fit of one size says of a sample
struct Fit_of_size
{
  Point point;
  double variance;      // of its height, by noise
  double squared_error; // estimate of the squared bias that this size adds to the one before
};

// The fits around x with 1, 2, 4, ... times the neighbors of the narrowest
inline std::vector<Fit_of_size> fits_of_all_sizes(const Surface_fit& fit, const Point& x,
                                                  const Vector& normal)
{
  std::vector<Fit_of_size> fits;
  Local_surface surface = fit_local_surface(fit, x, normal);
  fits.push_back({surface.origin, surface.error * surface.error, 0.});
  if (!(surface.radius > 0.))
    return fits;
  Neighborhood neighborhood;
  neighborhood.collect(fit.search, surface.origin,
                       (std::min)(smallest_neighborhood, fit.number_of_points));
  // how many points the narrowest fit had: as many as its area holds at the density of the nearest
  const double ratio = surface.radius / neighborhood.radius;
  std::size_t k = (std::max)(
      smallest_neighborhood,
      static_cast<std::size_t>(static_cast<double>(smallest_neighborhood) * ratio * ratio));
  while (k < (std::min)(largest_neighborhood, fit.number_of_points))
  {
    k = (std::min)(2 * k, largest_neighborhood);
    const Local_surface narrow = surface;
    if (!widen(fit, k, surface))
      break;
    const double shift = (surface.origin - narrow.origin) * surface.n;
    const double expected = narrow.error * narrow.error - surface.error * surface.error;
    // an outlier among the shifts has no more say than 50 others
    fits.push_back({surface.origin, surface.error * surface.error,
                    (std::min)(shift * shift, 50. * expected) - expected});
  }
  return fits;
}

// Moves each sample to the fit of the size with the least risk, bias^2 + variance.
//
// The variance is known from sigma. The bias shows in how the heights of two sizes differ: for
// unbiased fits, E[(z_2k - z_k)^2] = var_k - var_2k, as for nested estimators; what exceeds it is
// bias. One difference tells little, so it is averaged over a sample and its 32 nearest (4 rings),
// where shape is similar. The bias grows with the square of the number of points, so from z_2k - z_k,
// the whole is 4/3 of it: its square is 16/9.
template <typename ConcurrencyTag>
std::vector<Point> denoise_samples(const std::vector<Point>& samples,
                                   const std::vector<Vector>& normals, const Surface_fit& fit,
                                   const Progress& progress)
{
  constexpr double bias_factor = 16. / 9.;
  constexpr std::size_t pool = 33;

  std::vector<std::vector<Fit_of_size>> fits(samples.size());
  for_each_index<ConcurrencyTag>(samples.size(), progress,
                                 [&](std::size_t i)
                                 { fits[i] = fits_of_all_sizes(fit, samples[i], normals[i]); });

  const Neighbor_search search(samples, ConcurrencyTag());
  std::vector<Point> result(samples.size());
  for_each_index<ConcurrencyTag>(
      0, samples.size(),
      [&](std::size_t i)
      {
        const std::size_t sizes = fits[i].size();
        std::vector<double> bias(sizes, 0.), variance(sizes, 0.), count(sizes, 0.);
        search.for_each_nearest(samples[i], (std::min)(pool, samples.size()),
                                [&](std::size_t j, const Point&, double)
                                {
                                  for (std::size_t m = 0; m < (std::min)(sizes, fits[j].size());
                                       ++m)
                                  {
                                    bias[m] += fits[j][m].squared_error;
                                    variance[m] += fits[j][m].variance;
                                    count[m] += 1.;
                                  }
                                });
        std::size_t best = 0;
        double least_risk = variance[0] / count[0];
        for (std::size_t m = 1; m < sizes; ++m)
        {
          const double risk = (bias_factor * (std::max)(bias[m], 0.) + variance[m]) / count[m];
          if (risk > least_risk)
            break;
          least_risk = risk;
          best = m;
        }
        result[i] = fits[i][best].point;
      });
  return result;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DENOISE_SAMPLES_H
