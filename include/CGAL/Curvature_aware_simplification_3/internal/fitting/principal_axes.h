// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_PRINCIPAL_AXES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_PRINCIPAL_AXES_H

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Covariance_sums.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Neighborhood.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <cmath>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

inline Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen_solver(const Covariance_sums& sums,
                                                                   int options)
{
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(symmetric_matrix(sums.covariance()), options);
  return solver;
}

// The eigenvalues of the covariance matrix, in increasing order
inline Eigen::Vector3d eigenvalues(const Covariance_sums& sums)
{
  return eigen_solver(sums, Eigen::EigenvaluesOnly).eigenvalues();
}

// The direction in which weighted points are spread least (0) or most (2)
inline Vector principal_axis(const Covariance_sums& sums, int which)
{
  const Eigen::Vector3d axis =
      eigen_solver(sums, Eigen::ComputeEigenvectors).eigenvectors().col(which);
  const double length = axis.norm();
  // the closed formula fails where all neighbors coincide: any direction is as good then
  return length > 0.5 ? Vector(axis.x() / length, axis.y() / length, axis.z() / length)
                      : Vector(0., 0., 1.);
}

inline Covariance_sums covariance_sums(const Neighborhood& neighborhood)
{
  Covariance_sums sums;
  for (const Neighborhood::Neighbor& neighbor : neighborhood.neighbors)
    sums.add(neighbor.position, neighbor.weight);
  return sums;
}

// The normal of the weighted least-squares plane
inline Vector plane_normal(const Neighborhood& neighborhood)
{
  return principal_axis(covariance_sums(neighborhood), 0);
}

// Of two unit vectors
inline double sine_of_angle(const Vector& u, const Vector& v)
{
  return std::sqrt(CGAL::cross_product(u, v).squared_length());
}

// The direction of the weighted least-squares line
inline Vector line_direction(const Neighborhood& neighborhood)
{
  return principal_axis(covariance_sums(neighborhood), 2);
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_PRINCIPAL_AXES_H
