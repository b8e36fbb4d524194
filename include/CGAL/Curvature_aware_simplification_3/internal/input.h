// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_INPUT_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_INPUT_H

#include <CGAL/Curvature_aware_simplification_3/internal/Cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Neighbor_search.h>

#include <CGAL/Default_diagonalize_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Types that follow from the point range and the named parameters
template <typename PointRange, typename NamedParameters>
struct Input_types
{
  using NP_helper = Point_set_processing_3_np_helper<PointRange, NamedParameters>;
  using Geom_traits = typename NP_helper::Geom_traits;
  using Diagonalize_traits =
      typename internal_np::Lookup_named_param_def<internal_np::diagonalize_traits_t,
                                                   NamedParameters,
                                                   Default_diagonalize_traits<double, 3>>::type;
};

template <typename Range>
std::size_t number_of_elements(const Range& range)
{
  return static_cast<std::size_t>(std::distance(range.begin(), range.end()));
}

// The relative error that a coordinate has by the rounding of its number type alone. Exact number
// types hold what once was a double.
template <typename FT>
constexpr double relative_rounding_error()
{
  using Number = std::conditional_t<std::is_same<FT, float>::value, float, double>;
  return static_cast<double>(std::numeric_limits<Number>::epsilon());
}

// Coordinates of the caller's points as doubles; throws at the first that is not finite.
template <typename PointRange, typename PointMap>
std::vector<Point> read_coordinates(const PointRange& points, const PointMap& point_map)
{
  std::vector<Point> coordinates;
  coordinates.reserve(number_of_elements(points));
  for (const auto& element : points)
  {
    const auto& p = get(point_map, element);
    coordinates.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()),
                             CGAL::to_double(p.z()));
    const Point& q = coordinates.back();
    if (!(std::isfinite(q.x()) && std::isfinite(q.y()) && std::isfinite(q.z())))
      throw std::invalid_argument("points: the point at index " +
                                  std::to_string(coordinates.size() - 1) +
                                  " has a coordinate that is not finite");
  }
  return coordinates;
}

// What the stages see of a point range
template <typename ConcurrencyTag, typename PointRange, typename NamedParameters>
Cloud read_cloud(const PointRange& points, const NamedParameters& np)
{
  using Types = Input_types<PointRange, NamedParameters>;
  return make_cloud<ConcurrencyTag>(
      read_coordinates(points, Types::NP_helper::get_const_point_map(points, np)),
      relative_rounding_error<typename Types::Geom_traits::FT>());
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_INPUT_H
