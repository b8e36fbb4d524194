// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FIT_QUADRIC_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FIT_QUADRIC_H

#include <CGAL/Curvature_aware_simplification_3/internal/Local_surface.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Neighborhood.h>
#include <CGAL/Curvature_aware_simplification_3/internal/principal_axes.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The length and the width of weighted neighbors: the roots of the eigenvalues of the covariance
// matrix of their places in the plane, from the moments m_ij = sum w a^i b^j in some unit
inline void set_extent(double m00, double m10, double m01, double m20, double m11, double m02,
                       double unit, Local_surface& surface)
{
  const double aa = m20 - m10 * m10 / m00, ab = m11 - m10 * m01 / m00, bb = m02 - m01 * m01 / m00;
  const double mean = (aa + bb) / 2., half = (aa - bb) / 2.;
  const double difference = std::sqrt(half * half + ab * ab);
  surface.length = unit * std::sqrt((std::max)(mean + difference, 0.) / m00);
  surface.width = unit * std::sqrt((std::max)(mean - difference, 0.) / m00);
}

// The quadric with the least squared heights of the weighted neighbors, in the frame of `surface`.
// Its `error` is what noise of standard deviation `noise` makes of c0; without noise, nobody asks
// for it, nor for the `amplification`. Returns false if it fails.
//
// With the basis f = (1, a, b, a^2, a b, b^2), the coefficients c solve (sum w f f^T) c = sum w h
// f. The matrix has 36 entries, but they are only 15 different moments m_ij = sum w a^i b^j.
inline bool fit_quadric(const Neighborhood& neighborhood, double noise, Local_surface& surface)
{
  // in the unit of the radius, so that all entries of the matrix are of one size
  using Matrix = Eigen::Matrix<double, 6, 6>;
  using Column = Eigen::Matrix<double, 6, 1>;
  const double unit = neighborhood.radius;
  const double scale = 1. / unit;
  double m00 = 0., m10 = 0., m01 = 0., m20 = 0., m11 = 0., m02 = 0., m30 = 0., m21 = 0., m12 = 0.,
         m03 = 0., m40 = 0., m31 = 0., m22 = 0., m13 = 0., m04 = 0.;
  double h00 = 0., h10 = 0., h01 = 0., h20 = 0., h11 = 0., h02 = 0.; // sum w h a^i b^j
  double sum_of_squares = 0.;
  for (const Neighborhood::Neighbor& neighbor : neighborhood.neighbors)
  {
    const double w = neighbor.weight;
    const double a = scale * (neighbor.position * surface.u);
    const double b = scale * (neighbor.position * surface.v);
    const double h = scale * (neighbor.position * surface.n);
    const double aa = a * a, ab = a * b, bb = b * b;
    const double wa = w * a, wb = w * b, waa = w * aa, wab = w * ab, wbb = w * bb;
    m00 += w;
    m10 += wa;
    m01 += wb;
    m20 += waa;
    m11 += wab;
    m02 += wbb;
    m30 += waa * a;
    m21 += waa * b;
    m12 += wbb * a;
    m03 += wbb * b;
    m40 += waa * aa;
    m31 += waa * ab;
    m22 += waa * bb;
    m13 += wab * bb;
    m04 += wbb * bb;
    h00 += w * h;
    h10 += wa * h;
    h01 += wb * h;
    h20 += waa * h;
    h11 += wab * h;
    h02 += wbb * h;
    sum_of_squares += w * w;
  }
  const double sum = m00;
  if (!(sum > 0.))
    return false;

  Matrix matrix;
  Column right;
  matrix << m00, m10, m01, m20, m11, m02, //
      m10, m20, m11, m30, m21, m12,       //
      m01, m11, m02, m21, m12, m03,       //
      m20, m30, m21, m40, m31, m22,       //
      m11, m21, m12, m31, m22, m13,       //
      m02, m12, m03, m22, m13, m04;
  right << h00, h10, h01, h20, h11, h02;
  // A penalty that only speaks where the neighbors are silent: points on a line know nothing of the
  // curvature across it. Against the 3/80 that a disk with the weights (1 - r^2)^2 contributes to
  // a^4, and the 1/8 to a^2, 1e-5 and 1e-9 are nothing.
  for (int i = 1; i < 6; ++i)
    matrix(i, i) += (i < 3 ? 1e-9 : 1e-5) * sum;

  const Eigen::LDLT<Matrix> solver(matrix);
  const Column c = solver.solve(right);
  const double influence = noise > 0. ? solver.solve(Column::Unit(0))(0) : 0.;
  if (!c.allFinite() || !std::isfinite(influence))
    return false;
  for (int i = 0; i < 6; ++i)
    surface.c[i] = c(i) * (i == 0 ? unit : i < 3 ? 1. : scale);
  set_extent(m00, m10, m01, m20, m11, m02, unit, surface);
  // var(c0) = sigma^2 (A^-1 B A^-1)_00 with A = sum w b b', B = sum w^2 b b', taken as A times the
  // mean weight: 8 to 11 % too small a deviation. The exact one takes 4 % more of a noisy call, for
  // the same errors of the mesh.
  surface.amplification = std::sqrt((std::max)(influence, 0.) * sum_of_squares / sum);
  surface.error = noise * surface.amplification;
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
  const double scale = 1. / neighborhood.radius; // with the moments, as above
  double m00 = 0., m10 = 0., m01 = 0., m20 = 0., m11 = 0., m02 = 0.;
  double h00 = 0., h10 = 0., h01 = 0.;
  for (const Neighborhood::Neighbor& neighbor : neighborhood.neighbors)
  {
    const double w = neighbor.weight;
    const double a = scale * (neighbor.position * surface.u);
    const double b = scale * (neighbor.position * surface.v);
    const double h = neighbor.position * surface.n;
    const double wa = w * a, wb = w * b;
    m00 += w;
    m10 += wa;
    m01 += wb;
    m20 += wa * a;
    m11 += wa * b;
    m02 += wb * b;
    h00 += w * h;
    h10 += wa * h;
    h01 += wb * h;
  }
  const double sum = m00;
  if (!(sum > 0.))
    return false;
  const double penalty = 1e-9 * sum; // as above
  Eigen::Matrix3d matrix;
  matrix << m00, m10, m01,     //
      m10, m20 + penalty, m11, //
      m01, m11, m02 + penalty;
  const Eigen::Vector3d right(h00, h10, h01);
  const Eigen::Vector3d c = matrix.ldlt().solve(right);
  if (!c.allFinite())
    return false;
  set_extent(m00, m10, m01, m20, m11, m02, neighborhood.radius, surface);
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
