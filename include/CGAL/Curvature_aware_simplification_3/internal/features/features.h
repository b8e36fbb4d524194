// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FEATURES_FEATURES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FEATURES_FEATURES_H

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Covariance_sums.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Searchable_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Progress.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Uninitialized_vector.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// What the selection and the weights know of a point (paper, sec. 4.1, step 1)
struct Features
{
  // kappa, in [0, 1/3]: the curvature of the paper
  Uninitialized_vector<double> surface_variation;
  // 1 / rho = r^2 / k, r the distance to the k-th neighbor
  Uninitialized_vector<double> inverse_density;
  std::size_t number_of_neighbors = 0; // k, of all
};

// r^2 of point i, with its k-th neighbor inside: 1/rho is rounded
inline double squared_radius(const Features& features, std::size_t i)
{
  constexpr double rounding = 4. * std::numeric_limits<double>::epsilon();
  return (1. + rounding) * features.inverse_density[i] *
         static_cast<double>(features.number_of_neighbors);
}

struct Local_features
{
  double surface_variation;
  double inverse_density;
};

// What the smallest eigenvalue of a covariance matrix may be for points of a plane: a few units in
// the last place of the trace, by the computation, and the square of the error of the coordinates,
// by the input. (Eigen's closed formula may be off by the root of the precision where two are
// small.)
inline double rounding_error_of_eigenvalue(double trace, double coordinate_error)
{
  return 16. * std::numeric_limits<double>::epsilon() * trace + coordinate_error * coordinate_error;
}

// Surface variation of a covariance matrix: lambda_0 / (lambda_0 + lambda_1 + lambda_2), with
// lambda_0 the smallest eigenvalue (Pauly et al. 2002).
//
// What is below the rounding error of `coordinate_error` counts as 0. Otherwise a plane, whose
// lambda_0 is nothing but rounding error, would be given features when kappa is rescaled.
template <typename DiagonalizeTraits>
double surface_variation(const std::array<double, 6>& covariance, double coordinate_error)
{
  typename DiagonalizeTraits::Covariance_matrix matrix{};
  for (std::size_t i = 0; i < 6; ++i)
    matrix[i] = covariance[i];
  typename DiagonalizeTraits::Vector eigenvalues{};
  DiagonalizeTraits::diagonalize_selfadjoint_covariance_matrix(matrix, eigenvalues);

  const double trace = covariance[0] + covariance[3] + covariance[5];
  if (!(eigenvalues[0] > rounding_error_of_eigenvalue(trace, coordinate_error)))
    return 0.;
  return (std::min)(eigenvalues[0] / trace, 1. / 3.);
}

struct No_visit
{
  void operator()(std::size_t, double) const {}
};

// kappa and 1/rho at `query` from the `number_of_points` nearest points. When the query is itself a
// point of the search, it is the first of them and not counted among the k neighbors.
template <typename DiagonalizeTraits, typename Visit = No_visit>
Local_features local_features(const Neighbor_search& search, const Point& query,
                              std::size_t number_of_points, double coordinate_error,
                              const Visit& visit = Visit())
{
  double squared_radius = 0.;
  Covariance_sums sums;
  search.for_each_nearest(query, number_of_points,
                          [&](std::size_t j, const Point& p, double squared_distance) {
                            visit(j, squared_distance);
                            squared_radius = (std::max)(squared_radius, squared_distance);
                            sums.add(p - query);
                          });
  const double k = (std::max)(static_cast<double>(number_of_points) - 1., 1.);
  return {surface_variation<DiagonalizeTraits>(sums.covariance(), coordinate_error),
          squared_radius / k};
}

// The number of points of a neighborhood: the point itself and its k neighbors, or all there are,
// or as many as the queue of CGAL's search can count
inline std::size_t neighborhood_size(std::size_t number_of_neighbors, std::size_t number_of_points)
{
  constexpr std::size_t most = (std::numeric_limits<int>::max)() - 1;
  return (std::min)({number_of_neighbors, number_of_points - 1, most}) + 1;
}

// O(n (log n + k))
template <typename ConcurrencyTag, typename DiagonalizeTraits>
Features compute_features(const Searchable_points& cloud, std::size_t number_of_neighbors,
                          const Progress& progress)
{
  const std::size_t n = cloud.size();
  const std::size_t size = neighborhood_size(number_of_neighbors, n);
  Features features{Uninitialized_vector<double>(n), Uninitialized_vector<double>(n), size - 1};
  for_each_index<ConcurrencyTag>(n, progress, [&](std::size_t i) {
    const Local_features local = local_features<DiagonalizeTraits>(*cloud.search, cloud.points[i],
                                                                   size, cloud.coordinate_error);
    features.surface_variation[i] = local.surface_variation;
    features.inverse_density[i] = local.inverse_density;
  });
  return features;
}

// 1 / rho alone. O(n (log n + k))
template <typename ConcurrencyTag>
Uninitialized_vector<double> inverse_densities(const Searchable_points& cloud,
                                               std::size_t number_of_neighbors,
                                               const Progress& progress)
{
  const std::size_t size = neighborhood_size(number_of_neighbors, cloud.size());
  Uninitialized_vector<double> result(cloud.size());
  for_each_index<ConcurrencyTag>(cloud.size(), progress, [&](std::size_t i) {
    result[i] = cloud.search->squared_distance_of_nearest(cloud.points[i], size) /
                static_cast<double>(size - 1);
  });
  return result;
}

template <typename ConcurrencyTag>
double largest_surface_variation(const Features& features)
{
  return reduce_indices<ConcurrencyTag>(
      features.surface_variation.size(), 0.,
      [&](std::size_t i) { return features.surface_variation[i]; },
      [](double a, double b) { return (std::max)(a, b); });
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FEATURES_FEATURES_H
