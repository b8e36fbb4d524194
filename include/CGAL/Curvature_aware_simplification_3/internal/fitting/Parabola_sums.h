// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_PARABOLA_SUMS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_PARABOLA_SUMS_H

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The sums of which a parabola is computed that is fitted to weighted values over t: with
// f = (1, t, t^2), sum w f f^T c = sum w f v^T
template <int dimension>
struct Parabola_sums
{
  using Value = Eigen::Matrix<double, 1, dimension>;
  using Coefficients = Eigen::Matrix<double, 3, dimension>;

  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Coefficients right = Coefficients::Zero();

  void add(double t, const Value& value, double weight)
  {
    const Eigen::Vector3d f(1., t, t * t);
    matrix += weight * f * f.transpose();
    right += weight * f * value;
  }

  Coefficients coefficients() const { return matrix.ldlt().solve(right); }
};

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_PARABOLA_SUMS_H
