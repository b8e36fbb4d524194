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

#include <algorithm>
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

// An eigenvalue of the covariance matrix of a disk is a quarter of the square of its radius.
inline double radius_of_disk(double lambda)
{
  return 2. * std::sqrt((std::max)(lambda, 0.));
}

// The width of points on a line is less than this part of their length. Of lines of a scan, 5 to 50
// times as dense along as across, errors are the same with 0.05 to 0.2. But lines have a width of
// their own, and where they are as far apart as the samples, wider fits miss what is between them:
// with 0.2, the mean error of scanned shapes is 6 % larger there, with 0.05 1 %.
inline constexpr double least_breadth = 0.05;

// Whether points are as wide as a surface: those on one line of a scan, whose lines are farther
// apart than the points on them, tell neither a plane nor a quadric, and with noise along a ray of
// the scanner, they are in a plane across the surface. The width over the length is 0.6 for random
// points.
inline bool are_broad(double width, double length)
{
  constexpr double broad_enough = 1. / 3.;
  return width >= broad_enough * length;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_PRINCIPAL_AXES_H
