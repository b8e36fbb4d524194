// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_LAYER_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_LAYER_H

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Neighborhood.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/fit_quadric.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/principal_axes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// How points look around a place: a layer with a thickness and an extent
struct Layer
{
  double thickness = 0.; // standard deviation of the heights
  double width = 0.;     // radius of a disk with the lesser of the two extents in its plane
  double length = 0.;    // and with the greater
  double kurtosis = 0.;  // of the heights, over that of a normal distribution
  double middle = 0.;    // share of the heights of less than half of their root mean square

  bool is_broad() const { return are_broad(width, length); }
};

// The thickness from a sum of squared residuals of n points over a fitted surface, such that of
// Gaussian noise, half of the fits show more and half less: the median of chi^2 with d degrees of
// freedom is about d (1 - 2 / (9 d))^3 (Wilson and Hilferty 1931).
inline double thickness(double sum_of_squares, std::size_t n, double number_of_coefficients)
{
  const double d = (std::max)(static_cast<double>(n) - number_of_coefficients, 1.);
  const double root = 1. - 2. / (9. * d);
  return std::sqrt(sum_of_squares / (d * root * root * root));
}

// The k nearest points, around the quadric fitted to them
struct Layer_around_quadric
{
  Layer operator()(const Neighbor_search& search, const Point& place, std::size_t k) const
  {
    static thread_local Neighborhood neighborhood;
    neighborhood.collect(search, place, k);
    Local_surface surface;
    if (!(neighborhood.radius > 0.) || !fit_quadric_over_plane(neighborhood, 0., surface))
      return Layer();
    double sum = 0., sum_of_fourth_powers = 0.;
    for (const Neighborhood::Neighbor& neighbor : neighborhood.neighbors)
    {
      // in the unit of the radius, so that the fourth power does not underflow
      const double e = surface.residual(neighbor.position) / neighborhood.radius;
      sum += e * e;
      sum_of_fourth_powers += e * e * e * e;
    }
    const Eigen::Vector3d variances = principal_variances(covariance_sums(neighborhood));
    const double n = static_cast<double>(neighborhood.size());
    const double kurtosis = sum > 0. ? n * (sum_of_fourth_powers / sum) / sum - 3. : 0.;
    const double half = neighborhood.radius * std::sqrt(sum / n) / 2.;
    const auto middle = std::count_if(neighborhood.neighbors.begin(), neighborhood.neighbors.end(),
                                      [&](const Neighborhood::Neighbor& neighbor) {
                                        return std::abs(surface.residual(neighbor.position)) < half;
                                      });
    return {neighborhood.radius * thickness(sum, neighborhood.size(), 6.),
            radius_of_disk(variances(1)), radius_of_disk(variances(2)), kurtosis,
            static_cast<double>(middle) / n};
  }
};

// The k nearest points, around their plane
struct Layer_around_plane
{
  Layer operator()(const Neighbor_search& search, const Point& place, std::size_t k) const
  {
    static thread_local Neighborhood neighborhood;
    neighborhood.collect(search, place, k);
    const Eigen::Vector3d variances = principal_variances(covariance_sums(neighborhood));
    const std::size_t n = neighborhood.size();
    return {thickness(variances(0) * static_cast<double>(n), n, 3.), radius_of_disk(variances(1)),
            radius_of_disk(variances(2)), 0., 1.};
  }
};

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_LAYER_H
