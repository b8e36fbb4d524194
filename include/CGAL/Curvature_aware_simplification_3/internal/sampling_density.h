// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SAMPLING_DENSITY_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SAMPLING_DENSITY_H

#include <CGAL/Curvature_aware_simplification_3/internal/Adaptive_settings.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Progress.h>
#include <CGAL/Curvature_aware_simplification_3/internal/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/loops.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// How many samples per area are wanted at each input point
struct Sampling_density
{
  std::vector<double> density; // their integral over the surface is N
  std::vector<double> weight;  // density times the area of the surface that the point stands for,
                               // an estimate: their sum is about N
};

// The spacing of a hexagonal lattice with a density of points: s^2 = 2 / (sqrt(3) density)
inline double lattice_spacing(double density)
{
  return std::sqrt(2. / (std::sqrt(3.) * density));
}

// The sum of the areas that the points stand for
template <typename ConcurrencyTag>
double area_of_surface(const std::vector<double>& inverse_density)
{
  return reduce_indices<ConcurrencyTag>(
      inverse_density.size(), 0., [&](std::size_t i) { return CGAL_PI * inverse_density[i]; },
      std::plus<double>());
}

// lambda_0 of the k nearest points, the squared height over their plane, and their squared radius
struct Deviation
{
  double squared_height;
  double squared_radius;
};

// A height below the rounding error of the coordinates, `coordinate_error`, is 0: a plane has no
// curvature. So the solver is the iterative one; the closed formula is off by the root of the
// precision for points on a line.
inline Deviation deviation_from_plane(const Neighbor_search& search, const Point& x, std::size_t k,
                                      double coordinate_error)
{
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double squared_radius = 0.;
  search.for_each_nearest(x, k,
                          [&](std::size_t, const Point& p, double squared_distance)
                          {
    const Eigen::Vector3d q(p.x() - x.x(), p.y() - x.y(), p.z() - x.z());
    mean += q;
    covariance += q * q.transpose();
    squared_radius = (std::max)(squared_radius, squared_distance);
  });
  mean /= static_cast<double>(k);
  covariance = covariance / static_cast<double>(k) - mean * mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance, Eigen::EigenvaluesOnly);
  const double squared_height = solver.eigenvalues()(0);
  const double rounding_error = rounding_error_of_eigenvalue(covariance.trace(), coordinate_error);
  return {squared_height > rounding_error ? squared_height : 0., squared_radius};
}

// The density for which a piecewise linear surface through the samples has the least error.
//
// With n samples per area, such a surface is off by about c / n where the surface has curvature c.
// Among all n with the integral N, the integral of (c / n)^p is least for n ~ c^alpha with
// alpha = p / (p + 1): 1/2 for the mean error (p = 1), 1 for the largest one; 2/3, for p = 2, is
// between the two. With alpha = 0, the density is the same everywhere.
//
// What counts is the deviation from a plane at the distance of the samples. It is measured in balls
// with a radius R of 1.5 spacings: the curvature is sqrt(lambda_0) / R^2 up to a constant. From
// lambda_0, sigma^2 is taken off for the noise. Balls are no smaller than 3 sigma.
template <typename ConcurrencyTag>
Sampling_density sampling_density(const std::vector<Point>& points, const Neighbor_search& search,
                                  const std::vector<double>& inverse_density,
                                  std::size_t number_of_samples, double alpha, double noise,
                                  double coordinate_error, const Adaptive_settings& settings,
                                  const Progress& progress)
{
  // Not more than one sample for two input points, unless that many are asked for
  constexpr double densest = 0.5;
  // so many points tell lambda_0; where balls hold more, a part of the points is enough
  constexpr double enough = 24.;

  const std::size_t n = points.size();
  const double number = static_cast<double>(number_of_samples);
  const double total_area = area_of_surface<ConcurrencyTag>(inverse_density);
  const double spacing = lattice_spacing(number / total_area);
  const double radius = (std::max)(settings.curvature_radius * spacing, 3. * noise);

  const double mean_points_in_ball =
      CGAL_PI * radius * radius * static_cast<double>(n) / total_area;
  const std::size_t step =
      static_cast<std::size_t>((std::min)((std::max)(mean_points_in_ball / enough, 1.),
                                          (std::max)(static_cast<double>(n) / enough, 1.)));
  std::vector<Point> thinned;
  std::unique_ptr<Neighbor_search> own_search;
  if (step > 1)
  {
    for (std::size_t i = step / 2; i < n; i += step)
      thinned.push_back(points[i]);
    own_search.reset(new Neighbor_search(thinned, ConcurrencyTag()));
  }
  const Neighbor_search& thinned_search = own_search ? *own_search : search;
  const std::size_t number_of_thinned = own_search ? thinned.size() : n;

  // Ranges of the Hilbert curve, about one for each sample, represented by the point in its middle
  const std::size_t ranges = (std::min)(n, number_of_samples);
  const auto begin = [&](std::size_t i) { return i * n / ranges; };
  std::vector<double> curvature(ranges), area(ranges), range_area(ranges), range_density(ranges);
  for_each_index<ConcurrencyTag>(ranges, progress,
                                 [&](std::size_t i)
                                 {
    for (std::size_t j = begin(i); j < begin(i + 1); ++j)
      range_area[i] += CGAL_PI * inverse_density[j];
    const double size = static_cast<double>(begin(i + 1) - begin(i));
    const double points_in_ball =
        CGAL_PI * radius * radius * size / (range_area[i] * static_cast<double>(step));
    const std::size_t k = (std::min)(
        number_of_thinned,
        static_cast<std::size_t>((std::min)(4. * enough, (std::max)(16., points_in_ball))) + 1);
    const Deviation deviation = deviation_from_plane(
        thinned_search, points[(begin(i) + begin(i + 1)) / 2], k, coordinate_error);
    // beyond the noise, and two standard deviations of what k points say of it, so that noise alone is
    // taken for flat
    const double signal = deviation.squared_height -
                          noise * noise * (1. + 2. * std::sqrt(2. / static_cast<double>(k)));
    curvature[i] = deviation.squared_radius > 0.
                       ? std::sqrt((std::max)(signal, 0.)) / deviation.squared_radius
                       : 0.;
    area[i] = CGAL_PI * deviation.squared_radius /
              (std::max)((static_cast<double>(k) - 1.) * static_cast<double>(step), 1.);
  });

  // bounded from below by a part of the mean of order alpha, which few large values do not decide
  const double mean_power =
      reduce_indices<ConcurrencyTag>(
          ranges, 0., [&](std::size_t i) { return range_area[i] * std::pow(curvature[i], alpha); },
          std::plus<double>()) /
      total_area;
  const double least = alpha > 0. && mean_power > 0.
                           ? settings.least_curvature * std::pow(mean_power, 1. / alpha)
                           : 1.;
  for_each_index<ConcurrencyTag>(0, ranges,
                                 [&](std::size_t i) {
    range_density[i] = std::pow(curvature[i] * curvature[i] + least * least, alpha / 2.);
  });
  const auto total = [&]
  {
    return reduce_indices<ConcurrencyTag>(
        ranges, 0., [&](std::size_t i) { return range_density[i] * range_area[i]; },
        std::plus<double>());
  };
  // What the bound takes away goes to all others; a second and third round settle it.
  for (int round = 0; round < 3; ++round)
  {
    const double factor = number / total();
    for_each_index<ConcurrencyTag>(0, ranges,
                                   [&](std::size_t i)
                                   {
      const double point_density = static_cast<double>(begin(i + 1) - begin(i)) / range_area[i];
      range_density[i] = (std::min)(factor * range_density[i], densest * point_density);
    });
  }

  const double factor = number / total();
  Sampling_density result{std::vector<double>(n), std::vector<double>(n)};
  for_each_index<ConcurrencyTag>(0, ranges,
                                 [&](std::size_t i)
                                 {
    for (std::size_t j = begin(i); j < begin(i + 1); ++j)
    {
      result.density[j] = range_density[i] * factor;
      result.weight[j] = result.density[j] * area[i];
    }
  });
  return result;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SAMPLING_DENSITY_H
