// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SIMPLIFY_POINT_SET_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SIMPLIFY_POINT_SET_H

#include <CGAL/Curvature_aware_simplification_3/internal/input/Cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/read_cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/paper/simplify_as_in_the_paper.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Adaptive_settings.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/read_parameters.h>
#include <CGAL/Curvature_aware_simplification_3/internal/simplify_adaptively.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Progress.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Stopwatch.h>
#include <CGAL/Curvature_aware_simplification_report.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// From the caller's range to the caller's output: reads, measures, simplifies by one of the two
// methods and writes. `settings` are those of the adaptive method, which only the benchmark
// changes.
template <typename ConcurrencyTag, typename PointRange, typename OutputIterator,
          typename NamedParameters>
OutputIterator simplify_point_set(const PointRange& points, OutputIterator output,
                                  const NamedParameters& np, const Adaptive_settings& settings)
{
  using Types = Input_types<PointRange, NamedParameters>;
  using Geom_traits = typename Types::Geom_traits;
  using FT = typename Geom_traits::FT;
  using Diagonalize_traits = typename Types::Diagonalize_traits;
  using Report = std::reference_wrapper<Curvature_aware_simplification_report>;
  using Given_report =
      typename internal_np::Lookup_named_param_def<internal_np::simplification_report_t,
                                                   NamedParameters, Report>::type;
  static_assert(std::is_convertible<Given_report, Curvature_aware_simplification_report&>::value,
                "simplification_report must be a reference: std::ref(report)");

  const Parameters parameters = internal::read_parameters(np, internal::number_of_elements(points));
  const Progress progress(parameters.callback);
  Curvature_aware_simplification_report report;
  Stopwatch stopwatch;

  try
  {
    progress.report(0.);
    Cloud cloud = internal::read_cloud<ConcurrencyTag>(points, np, progress.part(0., 0.1));
    const Progress after_sorting = progress.part(0.1, 1.);
    after_sorting.report(0.);
    report.sorting_time = stopwatch.lap();

    report.number_of_input_points = cloud.input_size();
    report.number_of_distinct_points = cloud.size();
    report.number_of_output_points = parameters.number_of_output_points;
    const Frame frame = cloud.frame;
    const Distinct_samples samples =
        parameters.settings_of_the_paper
            ? simplify_as_in_the_paper<ConcurrencyTag, Diagonalize_traits>(cloud, parameters,
                                                                           after_sorting, report)
            : simplify_adaptively<ConcurrencyTag, Diagonalize_traits>(
                  std::move(cloud), parameters, settings, after_sorting, report);

    progress.report(1.);
    for (std::size_t i = 0; i < samples.points.size(); ++i)
    {
      const Point p = frame.from_frame(samples.points[i], largest_coordinate<FT>());
      for (std::size_t copy = 0; copy < samples.copies[i]; ++copy)
        *output++ = typename Geom_traits::Point_3(static_cast<FT>(p.x()), static_cast<FT>(p.y()),
                                                  static_cast<FT>(p.z()));
    }
    Curvature_aware_simplification_report& given_report = parameters::choose_parameter(
        parameters::get_parameter(np, internal_np::simplification_report), std::ref(report));
    given_report = report;
  }
  catch (const Cancelled&)
  {}
  return output;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SIMPLIFY_POINT_SET_H
