// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SAMPLING_DENSITY_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SAMPLING_DENSITY_H

#include <CGAL/Curvature_aware_simplification_3/internal/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Progress.h>
#include <CGAL/Curvature_aware_simplification_3/internal/loops.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL
{
namespace Curvature_aware_simplification_3
{
namespace internal
{

// How many samples per area are wanted at each input point
struct Sampling_density
{
  std::vector<double> density; // their integral over the surface is N
  std::vector<double> area;    // of the surface, that an input point stands for
  double mean_spacing;
};

// The spacing of a hexagonal lattice with a density of points: s^2 = 2 / (sqrt(3) density)
inline double lattice_spacing(double density)
{
  return std::sqrt(2. / (std::sqrt(3.) * density));
}

// lambda_0 of the k nearest points, the squared height over their plane, and their squared radius
struct Deviation
{
  double squared_height;
  double squared_radius;
};

inline Deviation deviation_from_plane(const Neighbor_search& search, const Point& x, std::size_t k)
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
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance, Eigen::EigenvaluesOnly);
  return {(std::max)(solver.eigenvalues()(0), 0.), squared_radius};
}

// The density for which a piecewise linear surface through the samples has the least squared error.
//
// With n samples per area, such a surface is off by about c / n where the surface has curvature c.
// Among all n with the integral N, the integral of (c / n)^p is least for n ~ c^(p / (p + 1)):
// c^(1/2) for the mean error, c for the largest. Here p = 2, as between the two.
//
// What counts is the deviation from a plane at the distance of the samples. It is measured in balls
// with the radius of 1.5 spacings, at 2 N places: the curvature is sqrt(lambda_0) / R^2 up to a
// constant. Balls of that size also see the other side of a part that is thinner, and make it
// dense. From lambda_0, sigma^2 is taken off for the noise, and two standard deviations of its
// estimate from k points, so that noise alone is taken for flat. Balls are no smaller than 3 sigma.
template <typename ConcurrencyTag>
Sampling_density sampling_density(const std::vector<Point>& points, const Neighbor_search& search,
                                  const std::vector<double>& area_of_point,
                                  std::size_t number_of_samples, double noise,
                                  const Progress& progress)
{
  constexpr double exponent = 2. / 3.;
  // Curvature is bounded from below by half of its mean: flat parts keep 0.5^(2/3) = 0.63 of the
  // mean density, hence 1.26 times the spacing. Thin flat parts need a spacing below their
  // thickness, and reconstruction wants spacings that vary slowly: with 0.2, a plate of 1.5 % of
  // the diagonal was lost.
  constexpr double flat = 0.5;
  // Not more than one sample for two input points
  constexpr double densest = 0.5;

  const std::size_t n = points.size();
  const double number = static_cast<double>(number_of_samples);
  double total_area = 0.;
  for (double area : area_of_point)
    total_area += area;
  const double spacing = lattice_spacing(number / total_area);
  const double radius = (std::max)(1.5 * spacing, 3. * noise);

  // Ranges of the Hilbert curve; each is represented by the point in its middle.
  const std::size_t ranges = (std::min)(n, 2 * number_of_samples + 1);
  const auto begin = [&](std::size_t i) { return i * n / ranges; };
  std::vector<double> curvature(ranges), area(ranges), range_area(ranges), range_density(ranges);
  for_each_index<ConcurrencyTag>(
      ranges, progress,
      [&](std::size_t i)
      {
        const std::size_t size = begin(i + 1) - begin(i);
        double sum = 0.;
        for (std::size_t j = begin(i); j < begin(i + 1); ++j)
          sum += area_of_point[j];
        range_area[i] = sum;
        const double points_in_ball = CGAL_PI * radius * radius * static_cast<double>(size) / sum;
        const std::size_t k = (std::min)(
            n, static_cast<std::size_t>((std::min)(400., (std::max)(16., points_in_ball))) + 1);
        const Deviation deviation =
            deviation_from_plane(search, points[(begin(i) + begin(i + 1)) / 2], k);
        const double count = static_cast<double>(k);
        const double signal =
            deviation.squared_height - noise * noise * (1. + 2. * std::sqrt(2. / count));
        curvature[i] = deviation.squared_radius > 0.
                           ? std::sqrt((std::max)(signal, 0.)) / deviation.squared_radius
                           : 0.;
        area[i] = CGAL_PI * deviation.squared_radius / (std::max)(count - 1., 1.);
      });

  double mean = 0.;
  for (std::size_t i = 0; i < ranges; ++i)
    mean += range_area[i] / total_area * std::pow(curvature[i], exponent);
  const double least = mean > 0. ? flat * std::pow(mean, 1. / exponent) : 1.;
  double total = 0.;
  for (std::size_t i = 0; i < ranges; ++i)
  {
    range_density[i] = std::pow(curvature[i] * curvature[i] + least * least, exponent / 2.);
    total += range_density[i] * range_area[i];
  }
  // What the bound takes away goes to all others; a second and third round settle it.
  for (int round = 0; round < 3; ++round)
  {
    const double factor = number / total;
    total = 0.;
    for (std::size_t i = 0; i < ranges; ++i)
    {
      const double point_density = static_cast<double>(begin(i + 1) - begin(i)) / range_area[i];
      range_density[i] = (std::min)(factor * range_density[i], densest * point_density);
      total += range_density[i] * range_area[i];
    }
  }

  Sampling_density result{std::vector<double>(n), std::vector<double>(n), spacing};
  for (std::size_t i = 0; i < ranges; ++i)
    for (std::size_t j = begin(i); j < begin(i + 1); ++j)
    {
      result.density[j] = range_density[i] * number / total;
      result.area[j] = area[i];
    }
  return result;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SAMPLING_DENSITY_H
