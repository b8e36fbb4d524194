// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FIT_QUADRIC_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FIT_QUADRIC_H

#include <CGAL/Curvature_aware_simplification_3/internal/Local_surface.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Neighborhood.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The normal of the weighted least-squares plane
inline Vector plane_normal(const Neighborhood& neighborhood)
{
  double sum = 0.;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Neighborhood::Neighbor& neighbor : neighborhood.neighbors)
  {
    const Vector& p = neighbor.position;
    const Eigen::Vector3d q(p.x(), p.y(), p.z());
    sum += neighbor.weight;
    mean += neighbor.weight * q;
    covariance += neighbor.weight * q * q.transpose();
  }
  mean /= sum;
  covariance = covariance / sum - mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance);
  const Eigen::Vector3d n = solver.eigenvectors().col(0);
  const double length = n.norm();
  // the closed formula fails where all neighbors coincide: any direction is as good then
  return length > 0.5 ? Vector(n.x() / length, n.y() / length, n.z() / length) : Vector(0., 0., 1.);
}

// The quadric with the least squared heights of the weighted neighbors, in the frame of `surface`. Its
// `error` is what noise of standard deviation `noise` makes of c0. Returns false if it fails.
inline bool fit_quadric(const Neighborhood& neighborhood, double noise, Local_surface& surface)
{
  // in the unit of the radius, so that all entries of the matrix are of one size
  using Matrix = Eigen::Matrix<double, 6, 6>;
  using Column = Eigen::Matrix<double, 6, 1>;
  const double unit = neighborhood.radius;
  const double scale = 1. / unit;
  Matrix matrix = Matrix::Zero(); // sum of w b b' for the basis b
  Column right = Column::Zero();  // sum of w h b
  double sum = 0., sum_of_squares = 0.;
  for (const Neighborhood::Neighbor& neighbor : neighborhood.neighbors)
  {
    const double w = neighbor.weight;
    const double a = scale * (neighbor.position * surface.u);
    const double b = scale * (neighbor.position * surface.v);
    const double h = scale * (neighbor.position * surface.n);
    const Column basis = (Column() << 1., a, b, a * a, a * b, b * b).finished();
    const Column weighted = w * basis;
    matrix.noalias() += weighted * basis.transpose();
    right += h * weighted;
    sum += w;
    sum_of_squares += w * w;
  }
  if (!(sum > 0.))
    return false;

  // A penalty that only speaks where the neighbors are silent: points on a line know nothing of the
  // curvature across it. Against the 1/24 that a disk contributes to a^4, 1e-5 is nothing.
  for (int i = 1; i < 6; ++i)
    matrix(i, i) += (i < 3 ? 1e-9 : 1e-5) * sum;

  const Eigen::LDLT<Matrix> solver(matrix);
  const Column c = solver.solve(right);
  const double influence = noise > 0. ? solver.solve(Column::Unit(0))(0) : 0.;
  if (!c.allFinite() || !std::isfinite(influence))
    return false;
  for (int i = 0; i < 6; ++i)
    surface.c[i] = c(i) * (i == 0 ? unit : i < 3 ? 1. : scale);
  // var(c0) = sigma^2 (A^-1 B A^-1)_00 with A = sum w b b', B = sum w^2 b b', taken as A times the
  // mean weight
  surface.error = noise * std::sqrt((std::max)(influence, 0.) * sum_of_squares / sum);
  return true;
}

// The quadric over the least-squares plane of the weighted neighbors, around their center
inline bool fit_quadric_over_plane(const Neighborhood& neighborhood, double noise,
                                   Local_surface& surface)
{
  surface.origin = neighborhood.center;
  surface.n = plane_normal(neighborhood);
  surface.complete_frame();
  return fit_quadric(neighborhood, noise, surface);
}

// The plane with the least squared heights of the weighted neighbors
inline bool fit_plane(const Neighborhood& neighborhood, Local_surface& surface)
{
  const double scale = 1. / neighborhood.radius;
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const Neighborhood::Neighbor& neighbor : neighborhood.neighbors)
  {
    const Eigen::Vector3d basis(1., scale * (neighbor.position * surface.u),
                                scale * (neighbor.position * surface.v));
    const Eigen::Vector3d weighted = neighbor.weight * basis;
    matrix.noalias() += weighted * basis.transpose();
    right += (neighbor.position * surface.n) * weighted;
  }
  const double sum = matrix(0, 0);
  if (!(sum > 0.))
    return false;
  matrix(1, 1) += 1e-9 * sum; // as above
  matrix(2, 2) += 1e-9 * sum;
  const Eigen::Vector3d c = matrix.ldlt().solve(right);
  if (!c.allFinite())
    return false;
  std::fill(surface.c, surface.c + 6, 0.);
  surface.c[0] = c(0);
  surface.c[1] = scale * c(1);
  surface.c[2] = scale * c(2);
  return true;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FIT_QUADRIC_H
