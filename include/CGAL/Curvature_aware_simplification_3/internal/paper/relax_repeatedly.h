// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PAPER_RELAX_REPEATEDLY_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PAPER_RELAX_REPEATEDLY_H

#include <CGAL/Curvature_aware_simplification_3/internal/features/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Searchable_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/paper/Curvature_weights.h>
#include <CGAL/Curvature_aware_simplification_3/internal/paper/density_weights.h>
#include <CGAL/Curvature_aware_simplification_3/internal/paper/relax.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Parameters.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Progress.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The samples after all iterations of eq. 8 with support radius h, in the frame
template <typename ConcurrencyTag, typename DiagonalizeTraits>
std::vector<Point> relax_repeatedly(const std::vector<Point>& initial_samples,
                                    const Searchable_points& cloud, const Features& features,
                                    double h, const Parameters& parameters,
                                    const Progress& progress)
{
  const double scale =
      Curvature_weights::scale(largest_surface_variation<ConcurrencyTag>(features));
  const Curvature_weights curvature_weights(parameters.curvature_dependence);

  Attractors attractors{*cloud.search, std::vector<double>(cloud.size())};
  for_each_index<ConcurrencyTag>(0, cloud.size(), [&](std::size_t j) {
    attractors.weight[j] = curvature_weights.attraction(scale * features.surface_variation[j]);
  });
  if (parameters.require_uniform_sampling)
  {
    const std::vector<double> density =
        density_weights<ConcurrencyTag>(cloud.points, *cloud.search, h, progress.part(0., 0.2));
    for_each_index<ConcurrencyTag>(0, cloud.size(),
                                   [&](std::size_t j) { attractors.weight[j] /= density[j]; });
  }

  const std::size_t neighborhood = neighborhood_size(parameters.number_of_neighbors, cloud.size());
  const auto curvature_at = [&](const Point& x, const std::optional<std::size_t>& nearest) {
    double curvature = 0.;
    if (parameters.recompute_curvature) // paper, sec. 5.3
      curvature =
          local_features<DiagonalizeTraits>(*cloud.search, x, neighborhood, cloud.coordinate_error)
              .surface_variation;
    else if (nearest) // that of the nearest input point (paper, sec. 4.2)
      curvature = features.surface_variation[*nearest];
    else
      cloud.search->for_each_nearest(x, 1, [&](std::size_t j, const Point&, double) {
        curvature = features.surface_variation[j];
      });
    return (std::min)(scale * curvature, Curvature_weights::maximum_curvature);
  };

  std::vector<Point> samples = initial_samples;
  const Relaxation relaxation{h, parameters.repulsion_weight, parameters.require_uniform_sampling};
  const Progress iterations_progress =
      progress.part(parameters.require_uniform_sampling ? 0.2 : 0., 1.);
  for (std::size_t i = 0; i < parameters.number_of_iterations; ++i)
    samples =
        relax<ConcurrencyTag>(samples, attractors, curvature_weights, relaxation, curvature_at,
                              iterations_progress.step(i, parameters.number_of_iterations));
  return samples;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PAPER_RELAX_REPEATEDLY_H
