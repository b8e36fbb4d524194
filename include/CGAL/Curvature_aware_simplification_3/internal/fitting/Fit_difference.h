// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_FIT_DIFFERENCE_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_FIT_DIFFERENCE_H

#include <algorithm>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// By how much two fits around one place differ, or the sum of such differences over several places
struct Fit_difference
{
  double square = 0.;   // of the difference
  double expected = 0.; // of the square, if noise alone causes it; 0 if nothing is known

  // Another sheet, or a part that no quadric fits, has no more say than 50 places that differ by
  // their noise.
  void add(const Fit_difference& other)
  {
    constexpr double largest_square = 50.;
    square += (std::min)(other.square, largest_square * other.expected);
    expected += other.expected;
  }
};

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_FIT_DIFFERENCE_H
