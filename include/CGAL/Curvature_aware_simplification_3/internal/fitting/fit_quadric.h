// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_FIT_QUADRIC_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_FIT_QUADRIC_H

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Local_surface.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Neighborhood.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/principal_axes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Lanes.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The least-squares problem of heights h over a plane, sum w (c f - h)^2 -> min, with the first n
// functions of the basis f = (1, a, b, a^2, a b, b^2), in the unit of the radius, so that all
// entries are of one size: c solves A c = r with A = sum w f f^T and r = sum w h f.
template <int n>
struct Normal_equations
{
  Eigen::Matrix<double, n, n> matrix; // A
  Eigen::Matrix<double, n, 1> right;  // r
  double sum_of_squares;              // of the weights
};

// The normal equations for the weighted neighbors, in the frame of `surface`
template <int n>
Normal_equations<n> normal_equations(const Neighborhood& neighborhood, const Local_surface& surface)
{
  constexpr std::size_t size = n;
  Lanes matrix[size][size], right[size], squares = Lanes::Zero();
  for (int i = 0; i < n; ++i)
  {
    std::fill(matrix[i], matrix[i] + i + 1, Lanes::Zero());
    right[i] = Lanes::Zero();
  }
  const double scale = 1. / neighborhood.radius;
  const Vector u = scale * surface.u, v = scale * surface.v, normal = scale * surface.n;
  const std::vector<Neighborhood::Neighbor>& neighbors = neighborhood.neighbors;
  for (std::size_t k = 0; k < neighbors.size(); k += 2)
  {
    const bool is_pair = k + 1 < neighbors.size(); // the last may be alone
    const Neighborhood::Neighbor& p = neighbors[k];
    const Neighborhood::Neighbor& q = neighbors[is_pair ? k + 1 : k];
    const Lanes w(p.weight, is_pair ? q.weight : 0.);
    const Vector_lanes d(p.position, q.position);
    const Lanes a = d * u, b = d * v, h = d * normal;
    const Lanes f[6] = {Lanes::Ones(), a, b, a * a, a * b, b * b};
    for (int i = 0; i < n; ++i)
    {
      const Lanes weighted = w * f[i];
      for (int j = 0; j <= i; ++j)
        matrix[i][j] += weighted * f[j];
      right[i] += weighted * h;
    }
    squares += w * w;
  }
  Normal_equations<n> result;
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j <= i; ++j)
      result.matrix(i, j) = result.matrix(j, i) = matrix[i][j].sum();
    result.right(i) = right[i].sum();
  }
  result.sum_of_squares = squares.sum();
  return result;
}

// The length and the width of weighted neighbors: the roots of the eigenvalues of the covariance
// matrix of their places in the plane, from the matrix of normal equations in some unit
template <typename Matrix>
void set_extent(const Matrix& matrix, double unit, Local_surface& surface)
{
  const auto covariance = [&](int i, int j) {
    return matrix(i, j) - matrix(i, 0) * matrix(j, 0) / matrix(0, 0);
  };
  const double mean = (covariance(1, 1) + covariance(2, 2)) / 2.;
  const double half = (covariance(1, 1) - covariance(2, 2)) / 2.;
  const double off_diagonal = covariance(1, 2);
  const double difference = std::sqrt(half * half + off_diagonal * off_diagonal);
  surface.length = unit * std::sqrt((std::max)(mean + difference, 0.) / matrix(0, 0));
  surface.width = unit * std::sqrt((std::max)(mean - difference, 0.) / matrix(0, 0));
}

// The surface with the least squared heights of the weighted neighbors, in the frame of `surface`:
// a plane with n = 3 coefficients, a quadric with 6. Its `error` is what noise of standard
// deviation `noise` makes of c0. Returns false if it fails.
template <int n>
bool fit_coefficients(const Neighborhood& neighborhood, double noise, Local_surface& surface)
{
  Normal_equations<n> equations = normal_equations<n>(neighborhood, surface);
  Eigen::Matrix<double, n, n>& matrix = equations.matrix;
  const double sum = matrix(0, 0);
  if (!(sum > 0.))
    return false;
  const double unit = neighborhood.radius;
  set_extent(matrix, unit, surface);
  // A penalty that only speaks where the neighbors are silent: points on a line know nothing of the
  // curvature across it. Against the 3/80 that a disk with the weights (1 - r^2)^2 contributes to
  // a^4, and the 1/8 to a^2, 1e-5 and 1e-9 are nothing.
  for (int i = 1; i < n; ++i)
    matrix(i, i) += (i < 3 ? 1e-9 : 1e-5) * sum;

  const Eigen::LLT<Eigen::Matrix<double, n, n>> solver(matrix);
  if (solver.info() != Eigen::Success)
    return false;
  const Eigen::Matrix<double, n, 1> c = solver.solve(equations.right);
  // (A^-1)_00 = |L^-1 e_0|^2, since A = L L^T
  const double influence =
      solver.matrixL().solve(Eigen::Matrix<double, n, 1>::Unit(0)).eval().squaredNorm();
  if (!c.allFinite() || !std::isfinite(influence))
    return false;
  std::fill(surface.c, surface.c + 6, 0.);
  for (int i = 0; i < n; ++i)
    surface.c[i] = c(i) * (i == 0 ? unit : i < 3 ? 1. : 1. / unit);
  // var(c0) = sigma^2 (A^-1 B A^-1)_00 with B = sum w^2 f f^T, taken as A times the mean weight: 8
  // to 11 % too small a deviation. The exact one takes 4 % more of a noisy call, for the same
  // errors of the mesh.
  surface.amplification = std::sqrt(influence * equations.sum_of_squares / sum);
  surface.error = noise * surface.amplification;
  return true;
}

inline bool fit_plane(const Neighborhood& neighborhood, Local_surface& surface)
{
  return fit_coefficients<3>(neighborhood, 0., surface);
}

inline bool fit_quadric(const Neighborhood& neighborhood, double noise, Local_surface& surface)
{
  return fit_coefficients<6>(neighborhood, noise, surface);
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

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_FIT_QUADRIC_H
