// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SURFACE_PIECES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SURFACE_PIECES_H

#include <CGAL/Curvature_aware_simplification_3/internal/Curve_ranges.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/loops.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The points in pieces of the Hilbert curve. Of each piece, enough is kept to compute the covariance of
// the points in a ball from a few pieces instead of hundreds of points.
struct Surface_pieces
{
  std::vector<Point> center;            // the mean of the points
  std::vector<Eigen::Matrix3d> scatter; // sum of (p - center) (p - center)^T
  std::vector<double> number;           // of points
  std::vector<double> area;             // of the surface that they stand for
};

// for the operators of Eigen
inline Eigen::Vector3d eigen_vector(const Vector& v)
{
  return Eigen::Vector3d(v.x(), v.y(), v.z());
}

// O(n)
template <typename ConcurrencyTag>
Surface_pieces surface_pieces(const std::vector<Point>& points,
                              const std::vector<double>& inverse_density,
                              std::size_t number_of_pieces)
{
  Surface_pieces pieces{
      std::vector<Point>(number_of_pieces), std::vector<Eigen::Matrix3d>(number_of_pieces),
      std::vector<double>(number_of_pieces), std::vector<double>(number_of_pieces)};
  const Curve_ranges ranges{number_of_pieces, points.size()};
  for_each_index<ConcurrencyTag>(0, number_of_pieces,
                                 [&](std::size_t i)
                                 {
    const std::size_t begin = ranges.first_point(i), end = ranges.first_point(i + 1);
    const double number = static_cast<double>(end - begin);
    Vector sum(0., 0., 0.);
    double area = 0.;
    for (std::size_t j = begin; j < end; ++j)
    {
      sum = sum + (points[j] - points[begin]);
      area += CGAL_PI * inverse_density[j];
    }
    const Point center = points[begin] + sum / number;
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (std::size_t j = begin; j < end; ++j)
    {
      const Eigen::Vector3d d = eigen_vector(points[j] - center);
      scatter += d * d.transpose();
    }
    pieces.center[i] = center;
    pieces.scatter[i] = scatter;
    pieces.number[i] = number;
    pieces.area[i] = area;
  });
  return pieces;
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

// Of the pieces in a ball together: with w points around c in each piece, the covariance around the mean m is
// sum (scatter + w (c - m) (c - m)^T) / sum w. A height below the rounding error of the coordinates,
// `coordinate_error`, is 0: a plane has no curvature. So the solver is the iterative one; the closed
// formula is off by the root of the precision for points on a line.
template <typename Ball>
Deviation deviation_from_plane(const Surface_pieces& pieces, const Ball& ball, const Point& x,
                               double coordinate_error)
{
  double number = 0., area = 0.;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::size_t i : ball)
  {
    const Eigen::Vector3d d = eigen_vector(pieces.center[i] - x);
    const Eigen::Vector3d weighted = pieces.number[i] * d;
    number += pieces.number[i];
    area += pieces.area[i];
    mean += weighted;
    covariance += pieces.scatter[i] + weighted * d.transpose();
  }
  mean /= number;
  covariance = covariance / number - mean * mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance, Eigen::EigenvaluesOnly);
  const double squared_height = solver.eigenvalues()(0);
  const double trace = covariance.trace();
  const double rounding_error = rounding_error_of_eigenvalue(trace, coordinate_error);
  return {squared_height > rounding_error ? squared_height : 0., trace, mean.squaredNorm(), number,
          area};
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SURFACE_PIECES_H
