// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_COVARIANCE_SUMS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_COVARIANCE_SUMS_H

#include <CGAL/Curvature_aware_simplification_3/internal/tools/Computation_kernel.h>

#include <Eigen/Core>

#include <array>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The sums that the covariance matrix of weighted points consists of. Points are given relative to
// one near them: differences of neighbors are small, their coordinates are not.
struct Covariance_sums
{
  double weight = 0.;
  double x = 0., y = 0., z = 0.;
  double xx = 0., xy = 0., xz = 0., yy = 0., yz = 0., zz = 0.;

  void add(const Vector& v, double w = 1.)
  {
    const double wx = w * v.x(), wy = w * v.y(), wz = w * v.z();
    weight += w;
    x += wx;
    y += wy;
    z += wz;
    xx += wx * v.x();
    xy += wx * v.y();
    xz += wx * v.z();
    yy += wy * v.y();
    yz += wy * v.z();
    zz += wz * v.z();
  }

  Vector mean() const { return Vector(x / weight, y / weight, z / weight); }

  // the entries xx, xy, xz, yy, yz, zz, in the order of CGAL's diagonalization
  std::array<double, 6> covariance() const
  {
    return {(xx - x * x / weight) / weight, (xy - x * y / weight) / weight,
            (xz - x * z / weight) / weight, (yy - y * y / weight) / weight,
            (yz - y * z / weight) / weight, (zz - z * z / weight) / weight};
  }
};

// Of its entries xx, xy, xz, yy, yz, zz
inline Eigen::Matrix3d symmetric_matrix(const std::array<double, 6>& entries)
{
  Eigen::Matrix3d matrix;
  matrix << entries[0], entries[1], entries[2], //
      entries[1], entries[3], entries[4],       //
      entries[2], entries[4], entries[5];
  return matrix;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_COVARIANCE_SUMS_H
