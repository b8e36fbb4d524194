// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SIMPLIFY_ADAPTIVELY_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SIMPLIFY_ADAPTIVELY_H

#include <CGAL/Curvature_aware_simplification_3/internal/Cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Distinct_samples.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Stopwatch.h>
#include <CGAL/Curvature_aware_simplification_3/internal/denoise_samples.h>
#include <CGAL/Curvature_aware_simplification_3/internal/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/find_outliers.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise_level.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters.h>
#include <CGAL/Curvature_aware_simplification_3/internal/relax_on_surface.h>
#include <CGAL/Curvature_aware_simplification_3/internal/sampling_density.h>
#include <CGAL/Curvature_aware_simplification_3/internal/select_along_curve.h>
#include <CGAL/Curvature_aware_simplification_3/internal/select_points.h>

#include <CGAL/Curvature_aware_simplification_report.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The distinct points that lie on a surface, along the Hilbert curve
struct Surface_points
{
  std::vector<Point> points;
  std::vector<double> area; // that each stands for, by its k neighbors
};

inline Surface_points without_outliers(const Cloud& cloud, const Features& features,
                                       const std::vector<std::uint8_t>& is_outlier)
{
  Surface_points result;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (!is_outlier[i])
    {
      result.points.push_back(cloud.points[i]);
      result.area.push_back(CGAL_PI * features.inverse_density[i]);
    }
  return result;
}

// The samples, in the frame. All that the stages need is measured in the input: outliers, noise,
// density, curvature at the distance of the samples.
template <typename ConcurrencyTag>
Distinct_samples simplify_adaptively(const Cloud& cloud, const Neighbor_search& cloud_search,
                                     const Features& features, const Parameters& parameters,
                                     const Adaptive_settings& settings, const Progress& progress,
                                     Curvature_aware_simplification_report& report)
{
  Stopwatch stopwatch;
  const std::size_t number_of_samples = parameters.number_of_output_points;
  if (number_of_samples >= cloud.size()) // all points, and duplicates
    return distinct_samples(cloud, select_points<ConcurrencyTag>(cloud, features, parameters));

  const std::size_t k = neighborhood_size(parameters.number_of_neighbors, cloud.size()) - 1;
  std::vector<std::uint8_t> is_outlier(cloud.size(), 0);
  if (settings.find_outliers)
    is_outlier = find_outliers<ConcurrencyTag>(cloud, cloud_search, features, k);
  std::size_t outliers =
      static_cast<std::size_t>(std::count(is_outlier.begin(), is_outlier.end(), 1));
  if (cloud.size() - outliers < (std::max)(number_of_samples, cloud.size() / 2))
  { // what most points are is no outlier
    std::fill(is_outlier.begin(), is_outlier.end(), std::uint8_t(0));
    outliers = 0;
  }
  const Surface_points input = without_outliers(cloud, features, is_outlier);
  std::unique_ptr<Neighbor_search> own_search;
  if (outliers > 0)
    own_search.reset(new Neighbor_search(input.points, ConcurrencyTag()));
  const Neighbor_search& search = own_search ? *own_search : cloud_search;
  report.outliers_time = stopwatch.lap();

  const double noise =
      settings.measure_noise ? noise_level<ConcurrencyTag>(input.points, search) : 0.;
  report.noise_time = stopwatch.lap();

  const Sampling_density wanted = sampling_density<ConcurrencyTag>(
      input.points, search, input.area, number_of_samples, parameters.adaptivity, noise, settings,
      progress.part(0., 0.2));
  std::vector<double> weight(input.points.size());
  for (std::size_t i = 0; i < weight.size(); ++i)
    weight[i] = wanted.density[i] * wanted.area[i];
  const std::vector<std::size_t> selected =
      select_along_curve(weight, number_of_samples, parameters.random_seed);
  report.selection_time = stopwatch.lap();

  const Surface_fit fit{search, input.points.size(), noise, settings};
  std::vector<Surface_sample> samples(selected.size());
  for_each_index<ConcurrencyTag>(samples.size(), progress.part(0.2, 0.4),
                                 [&](std::size_t i)
                                 {
    const std::size_t j = selected[i];
    samples[i].spacing = lattice_spacing(wanted.density[j]);
    samples[i].place(fit, input.points[j], NULL_VECTOR);
  });
  relax_on_surface<ConcurrencyTag>(samples, fit, parameters.number_of_iterations,
                                   parameters.repulsion_weight, progress.part(0.4, 0.8));
  report.relaxation_time = stopwatch.lap();

  // The final fit. Where the narrowest has an error of sigma / 2, larger ones are worth their time
  // only if that is visible: beyond 1 % of the spacing.
  std::vector<Point> points(samples.size());
  const Progress final_progress = progress.part(0.8, 1.);
  if (settings.denoise && 0.5 * noise > 0.01 * wanted.mean_spacing)
    points = denoise_samples<ConcurrencyTag>(samples, fit, final_progress);
  else
    for_each_index<ConcurrencyTag>(samples.size(), final_progress,
                                   [&](std::size_t i)
                                   {
      Surface_sample& x = samples[i];
      x.place(fit, x.point, x.normal);
      points[i] = x.point;
    });
  report.projection_time = stopwatch.lap();

  report.number_of_outliers = outliers;
  report.noise_level = cloud.frame.length_from_frame(noise);
  report.output_spacing = cloud.frame.length_from_frame(wanted.mean_spacing);
  return {points, std::vector<std::size_t>(points.size(), 1)};
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SIMPLIFY_ADAPTIVELY_H
