// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SAMPLES_SELECT_SAMPLES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SAMPLES_SELECT_SAMPLES_H

#include <CGAL/Curvature_aware_simplification_3/internal/Scan.h>
#include <CGAL/Curvature_aware_simplification_3/internal/density/sampling_density.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Adaptive_settings.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Parameters.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/Surface_sample.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/select_along_curve.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Progress.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Uninitialized_vector.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/index_selection.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/lattice_spacing.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// So many samples, on points of the scan that are selected with the wanted
// density. They have no surface yet. The scan lets go of its points, whose memory the samples take:
// from here on, fits have those of the search.
template <typename ConcurrencyTag>
std::vector<Surface_sample>
select_samples(Scan& scan, std::size_t number_of_samples, const Parameters& parameters,
               const Adaptive_settings& settings, const Progress& progress)
{
  const Sampling_density wanted = sampling_density<ConcurrencyTag>(
      scan, number_of_samples, parameters.adaptivity, settings, progress);
  const std::vector<std::size_t> selected = select_along_curve<ConcurrencyTag>(
      wanted.ranges, wanted.weight, number_of_samples, parameters.random_seed);
  const std::vector<Point> selected_points = elements_at<ConcurrencyTag>(selected, scan.points);
  scan.points = std::vector<Point>();
  scan.inverse_density = Uninitialized_vector<double>();
  std::vector<Surface_sample> samples;
  samples.reserve(parameters.number_of_output_points); // some are inserted later, in this memory
  samples.resize(number_of_samples);
  for_each_index<ConcurrencyTag>(0, number_of_samples, [&](std::size_t i) {
    samples[i].point = selected_points[i];
    samples[i].spacing = lattice_spacing(wanted.density[wanted.ranges.range_of(selected[i])]);
    samples[i].noise = &scan.noise.at(selected[i]);
  });
  return samples;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SAMPLES_SELECT_SAMPLES_H
