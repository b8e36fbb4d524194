// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DENSITY_SURFACE_PIECES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DENSITY_SURFACE_PIECES_H

#include <CGAL/Curvature_aware_simplification_3/internal/features/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Covariance_sums.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Computation_kernel.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Curve_ranges.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Uninitialized_vector.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The points in a piece of the Hilbert curve: enough of them to compute the covariance of the
// points in a ball from a few pieces instead of hundreds of points
struct Surface_piece
{
  Point center;                     // the mean of the points
  std::array<double, 6> covariance; // as that of Covariance_sums
  double number;                    // of points
  double area;                      // of the surface that they stand for
};

// O(n)
template <typename ConcurrencyTag>
Uninitialized_vector<Surface_piece>
surface_pieces(const std::vector<Point>& points,
               const Uninitialized_vector<double>& inverse_density, std::size_t number_of_pieces)
{
  Uninitialized_vector<Surface_piece> pieces(number_of_pieces);
  const Curve_ranges ranges{number_of_pieces, points.size()};
  for_each_index<ConcurrencyTag>(0, number_of_pieces, [&](std::size_t i) {
    const std::size_t begin = ranges.first_point(i), end = ranges.first_point(i + 1);
    Covariance_sums sums;
    double area = 0.;
    for (std::size_t j = begin; j < end; ++j)
    {
      sums.add(points[j] - points[begin]);
      area += CGAL_PI * inverse_density[j];
    }
    pieces[i] = {points[begin] + sums.mean(), sums.covariance(), sums.weight, area};
  });
  return pieces;
}

template <typename ConcurrencyTag>
std::vector<Point> centers_of(const Uninitialized_vector<Surface_piece>& pieces)
{
  std::vector<Point> centers(pieces.size());
  for_each_index<ConcurrencyTag>(0, pieces.size(),
                                 [&](std::size_t i) { centers[i] = pieces[i].center; });
  return centers;
}

// How the points of some pieces around a place lie about their common plane
struct Deviation
{
  double squared_height; // over their plane: lambda_0 of the covariance
  double trace;          // lambda_0 + lambda_1 + lambda_2: r^2 / 2 for a disk of radius r
  double squared_offset; // of their mean from the place
  double number;         // of points
  double area;           // of the surface that they stand for
};

// Of the pieces in a ball together: with w points around c and the covariance C in each piece, the
// covariance around the mean m is sum w (C + (c - m) (c - m)^T) / sum w. A height below the
// rounding error of the coordinates, `coordinate_error`, is 0: a plane has no curvature. So the
// solver is the iterative one; the closed formula is off by the root of the precision for points on
// a line.
template <typename Ball>
Deviation deviation_from_plane(const Uninitialized_vector<Surface_piece>& pieces, const Ball& ball,
                               const Point& x, double coordinate_error)
{
  Covariance_sums centers;
  std::array<double, 6> inside = {}; // sum w C
  double area = 0.;
  for (std::size_t i : ball)
  {
    const Surface_piece& piece = pieces[i];
    centers.add(piece.center - x, piece.number);
    for (std::size_t entry = 0; entry < 6; ++entry)
      inside[entry] += piece.number * piece.covariance[entry];
    area += piece.area;
  }
  const double number = centers.weight;
  std::array<double, 6> c = centers.covariance();
  for (std::size_t entry = 0; entry < 6; ++entry)
    c[entry] += inside[entry] / number;
  const Eigen::Matrix3d covariance = symmetric_matrix(c);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance, Eigen::EigenvaluesOnly);
  const double squared_height = solver.eigenvalues()(0);
  const double trace = covariance.trace();
  const double rounding_error = rounding_error_of_eigenvalue(trace, coordinate_error);
  return {squared_height > rounding_error ? squared_height : 0., trace,
          centers.mean().squared_length(), number, area};
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DENSITY_SURFACE_PIECES_H
