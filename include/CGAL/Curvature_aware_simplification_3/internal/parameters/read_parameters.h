// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PARAMETERS_READ_PARAMETERS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PARAMETERS_READ_PARAMETERS_H

#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Parameters.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/check_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <type_traits>

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_NAMED_PARAMETERS
#error                                                                                             \
    "CGAL's own parameters_interface.h was found before that of Curvature_aware_simplification_3. \
Put this package's include directory in front of CGAL's; with CMake, link \
Curvature_aware_simplification_3::Curvature_aware_simplification_3."
#endif

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// How many of M points a percentage is: rounded down as in CGAL's other functions, but at least one
inline std::size_t percentage_of(double percentage, std::size_t number_of_points)
{
  // The product before the quotient: 100 * (29 / 100.) is below 29.
  const double count = static_cast<double>(number_of_points) * percentage / 100.;
  return (std::max)(std::size_t(1), static_cast<std::size_t>(count));
}

// The value of a named parameter as a double: CGAL::to_double() knows its number types, but not all
// that are built in
template <typename NamedParameters, typename Tag>
double number(const NamedParameters& np, const Tag& tag, double default_value)
{
  const auto value =
      parameters::choose_parameter(parameters::get_parameter(np, tag), default_value);
  if constexpr (std::is_arithmetic<std::remove_const_t<decltype(value)>>::value)
    return static_cast<double>(value);
  else
    return CGAL::to_double(value);
}

template <typename NamedParameters>
std::function<bool(double)> read_callback(const NamedParameters& np)
{
  using Callback = std::function<bool(double)>;
  using Given = typename internal_np::Lookup_named_param_def<internal_np::callback_t,
                                                             NamedParameters, Callback>::type;
  static_assert(std::is_convertible<Given, Callback>::value,
                "callback must take a double and return whether to go on, a bool");
  return parameters::choose_parameter(parameters::get_parameter(np, internal_np::callback),
                                      Callback());
}

// The named parameters of the selection: read and checked here, once
template <typename NamedParameters>
Selection_parameters read_selection_parameters(const NamedParameters& np,
                                               std::size_t number_of_points)
{
  if (number_of_points == 0)
    throw_empty_range();

  Selection_parameters result{};

  if (parameters::is_default_parameter<NamedParameters,
                                       internal_np::number_of_output_points_t>::value)
  {
    const double percentage = internal::number(np, internal_np::select_percentage, 5.);
    checked("select_percentage", percentage, percentage > 0. && percentage <= 100.,
            "above 0 and at most 100");
    result.number_of_output_points = percentage_of(percentage, number_of_points);
  }
  else
    result.number_of_output_points = checked_count(
        "number_of_output_points",
        parameters::choose_parameter(
            parameters::get_parameter(np, internal_np::number_of_output_points), std::size_t(1)),
        1, number_of_points,
        "an integer from 1 to the number of points, which is " + std::to_string(number_of_points));

  result.number_of_neighbors =
      checked_count("number_of_neighbors",
                    parameters::choose_parameter(
                        parameters::get_parameter(np, internal_np::number_of_neighbors), 16),
                    2, largest_count, count_from(2));

  const double curvature_weight = internal::number(np, internal_np::curvature_weight, 0.75);
  result.curvature_weight =
      checked("curvature_weight", curvature_weight,
              curvature_weight >= 0. && curvature_weight <= 1., "from 0 to 1");

  const double adaptivity = internal::number(np, internal_np::adaptivity, 2. / 3.);
  result.adaptivity =
      checked("adaptivity", adaptivity, adaptivity >= 0. && adaptivity <= 1., "from 0 to 1");

  const auto seed = parameters::choose_parameter(
      parameters::get_parameter(np, internal_np::random_seed), std::uint64_t(0));
  static_assert(std::is_integral<std::remove_const_t<decltype(seed)>>::value,
                "random_seed must be an integer");
  result.random_seed = static_cast<std::uint64_t>(seed);

  result.callback = internal::read_callback(np);
  return result;
}

// All named parameters but the property maps and traits, likewise
template <typename NamedParameters>
Parameters read_parameters(const NamedParameters& np, std::size_t number_of_points)
{
  Parameters result{};
  static_cast<Selection_parameters&>(result) =
      internal::read_selection_parameters(np, number_of_points);

  result.number_of_iterations =
      checked_count("number_of_iterations",
                    parameters::choose_parameter(
                        parameters::get_parameter(np, internal_np::number_of_iterations), 10),
                    0, largest_count, count_from(0));

  const double d = internal::number(np, internal_np::curvature_dependence, 2.);
  result.curvature_dependence =
      checked("curvature_dependence", d, d >= 0. && std::isfinite(d), "at least 0 and finite");

  const double mu = internal::number(np, internal_np::repulsion_weight, 0.45);
  result.repulsion_weight =
      checked("repulsion_weight", mu, mu >= 0. && mu < 0.5, "at least 0 and below 0.5");

  if (!parameters::is_default_parameter<NamedParameters, internal_np::neighbor_radius_t>::value)
  {
    const double h = internal::number(np, internal_np::neighbor_radius, 1.);
    result.neighbor_radius =
        checked("neighbor_radius", h, h > 0. && std::isfinite(h), "above 0 and finite");
  }

  result.recompute_curvature = parameters::choose_parameter(
      parameters::get_parameter(np, internal_np::recompute_curvature), false);
  result.require_uniform_sampling = parameters::choose_parameter(
      parameters::get_parameter(np, internal_np::require_uniform_sampling), false);
  result.settings_of_the_paper = parameters::choose_parameter(
      parameters::get_parameter(np, internal_np::settings_of_the_paper), false);
  return result;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PARAMETERS_READ_PARAMETERS_H
