// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PARAMETERS_CHECK_PARAMETERS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PARAMETERS_CHECK_PARAMETERS_H

#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// A parameter that is out of range: the message names it, its value and what is allowed.
template <typename Value>
[[noreturn]] void throw_invalid_parameter(const std::string& name, const Value& value,
                                          const std::string& allowed)
{
  std::ostringstream message; // with + since a small integer type may be that of characters
  message.precision(std::numeric_limits<double>::max_digits10);
  message << name << " is " << +value << ", but must be " << allowed;
  throw std::invalid_argument(message.str());
}

// In the range tests, a NaN fails every comparison, hence is never allowed.
inline double checked(const std::string& name, double value, bool is_allowed,
                      const std::string& allowed)
{
  if (!is_allowed)
    throw_invalid_parameter(name, value, allowed);
  return value;
}

[[noreturn]] inline void throw_empty_range()
{
  throw std::invalid_argument("points is empty, but must hold at least one point");
}

// Of neighbors, all of which are used if there are fewer, and of iterations
inline constexpr std::size_t largest_count = (std::numeric_limits<unsigned int>::max)();

// Compared before the conversion, so that a negative value is reported and not wrapped around.
template <typename Value>
std::size_t checked_count(const std::string& name, const Value& value, std::size_t minimum,
                          std::size_t maximum, const std::string& allowed)
{
  static_assert(std::is_arithmetic<Value>::value, "a count must be a number");
  const long double number = static_cast<long double>(value);
  if (!(number >= static_cast<long double>(minimum) &&
        number <= static_cast<long double>(maximum) && number == std::floor(number)))
    throw_invalid_parameter(name, value, allowed);
  return static_cast<std::size_t>(value);
}

inline std::string count_from(std::size_t minimum)
{
  return "an integer from " + std::to_string(minimum) + " to " + std::to_string(largest_count);
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PARAMETERS_CHECK_PARAMETERS_H
