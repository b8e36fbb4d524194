// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_INPUT_READ_CLOUD_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_INPUT_READ_CLOUD_H

#include <CGAL/Curvature_aware_simplification_3/internal/input/Cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Computation_kernel.h>

#include <CGAL/Default_diagonalize_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

template <typename ET>
class Lazy_exact_nt; // that of Exact_predicates_exact_constructions_kernel

namespace Curvature_aware_simplification_3 {
namespace internal {

// Calls with the caller's types are qualified: where these are from, functions may have the same
// names.

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

// The machine number nearest to the caller's number type: an exact one is read as a double.
template <typename FT>
using Machine_number = std::conditional_t<std::is_same<FT, float>::value, float, double>;

template <typename FT>
constexpr double largest_coordinate()
{
  return static_cast<double>((std::numeric_limits<Machine_number<FT>>::max)());
}

template <typename FT>
double coordinate_as_double(const FT& x)
{
  return CGAL::to_double(x);
}

// CGAL takes the middle of the interval that the number is known to be in, which may be 1e-5 of it
// wide, and depends on what was asked of the number before.
template <typename ET>
double coordinate_as_double(const Lazy_exact_nt<ET>& x)
{
  return x.approx().is_point() ? x.approx().inf() : CGAL::to_double(x.exact());
}

// Coordinates of the caller's points as doubles; throws at the first that is not finite.
template <typename PointRange, typename PointMap>
std::vector<Point> read_coordinates(const PointRange& points, const PointMap& point_map)
{
  using boost::get; // of pointers, which are property maps as well

  std::vector<Point> coordinates;
  coordinates.reserve(internal::number_of_elements(points));
  for (const auto& element : points)
  {
    const auto& p = get(point_map, element);
    coordinates.emplace_back(internal::coordinate_as_double(p.x()),
                             internal::coordinate_as_double(p.y()),
                             internal::coordinate_as_double(p.z()));
    const Point& q = coordinates.back();
    if (!(std::isfinite(q.x()) && std::isfinite(q.y()) && std::isfinite(q.z())))
      throw std::invalid_argument("points: the point at index " +
                                  std::to_string(coordinates.size() - 1) +
                                  " has a coordinate that is not finite");
  }
  return coordinates;
}

// Whether a number has no more digits than a float: 23 of the 52 bits behind its point. To convert
// it to float and back would tell as well, but g++ 12 leaves that out where it vectorizes.
inline bool has_digits_of_float(double x)
{
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  return bits % (std::uint64_t(1) << (52 - 23)) == 0;
}

// The relative error that coordinates have by rounding alone. Most files of scans have floats,
// whatever kernel they are read into.
inline double relative_rounding_error(const std::vector<Point>& coordinates)
{
  const bool are_floats = std::all_of(coordinates.begin(), coordinates.end(), [](const Point& p) {
    return has_digits_of_float(p.x()) && has_digits_of_float(p.y()) && has_digits_of_float(p.z());
  });
  return are_floats ? static_cast<double>(std::numeric_limits<float>::epsilon())
                    : std::numeric_limits<double>::epsilon();
}

// What the stages see of a point range
template <typename ConcurrencyTag, typename PointRange, typename NamedParameters>
Cloud read_cloud(const PointRange& points, const NamedParameters& np, const Progress& progress)
{
  using Types = Input_types<PointRange, NamedParameters>;
  std::vector<Point> coordinates =
      internal::read_coordinates(points, Types::NP_helper::get_const_point_map(points, np));
  const double relative_error = relative_rounding_error(coordinates);
  return make_cloud<ConcurrencyTag>(std::move(coordinates), relative_error, progress);
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_INPUT_READ_CLOUD_H
