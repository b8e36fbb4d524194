// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SAMPLING_DENSITY_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SAMPLING_DENSITY_H

#include <CGAL/Curvature_aware_simplification_3/internal/Adaptive_settings.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Curve_ranges.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Noise_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Progress.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Surface_balls.h>
#include <CGAL/Curvature_aware_simplification_3/internal/loops.h>
#include <CGAL/Curvature_aware_simplification_3/internal/mean_over_balls.h>
#include <CGAL/Curvature_aware_simplification_3/internal/scale_to_number.h>
#include <CGAL/Curvature_aware_simplification_3/internal/surface_pieces.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// How many samples per area are wanted, in ranges of the curve
struct Sampling_density
{
  Curve_ranges ranges;
  // Their integral over the surface is N.
  std::vector<double> density;
  // Of each point of a range: density times the area of the surface that it stands for, more on borders.
  std::vector<double> weight;
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
Sampling_density sampling_density(const std::vector<Point>& points,
                                  const std::vector<double>& inverse_density,
                                  std::size_t number_of_samples, double alpha,
                                  const Noise_levels& noise, double coordinate_error,
                                  const Adaptive_settings& settings, const Progress& progress)
{
  // Pieces are small against the balls, about 16 in each. Where the input is sparse, balls hold no fewer
  // than 4, which is one piece to each side, and no fewer points than about 17, so that the height over
  // their plane is more than chance; where it is dense, no more than 64, which say as much as all. With
  // half or twice as many pieces or points, the mean error of what is made of it is the same to 1 %.
  constexpr double fewest_pieces = 4., most_pieces = 64., fewest_points = 17.;
  // Of means of the curvature: a few large values do not decide them. It is that of the default alpha, and
  // not alpha itself, for which the bound from below would vanish with alpha: then flat parts would get
  // less of a density that is nearly uniform.
  constexpr double order_of_mean = 2. / 3.;

  const std::size_t n = points.size();
  const double number = static_cast<double>(number_of_samples);
  const double total_area = area_of_surface<ConcurrencyTag>(inverse_density);
  const double spacing = lattice_spacing(number / total_area);

  // Ranges of the Hilbert curve, about one for each sample, represented by the point in its middle. Each
  // is two pieces, unless these would be of fewer than two points, which saves nothing.
  const Curve_ranges ranges{(std::min)(n, number_of_samples), n};
  const std::size_t pieces_in_range = n / ranges.number < 4 ? 1 : 2;
  const std::vector<Surface_piece> pieces =
      surface_pieces<ConcurrencyTag>(points, inverse_density, pieces_in_range * ranges.number);

  std::vector<Point> centers(ranges.number);
  std::vector<double> sigma(ranges.number), range_area(ranges.number);
  std::vector<std::size_t> pieces_in_ball(ranges.number);
  for_each_index<ConcurrencyTag>(0, ranges.number,
                                 [&](std::size_t i)
                                 {
    const std::size_t middle = ranges.first_point(i) + ranges.size(i) / 2;
    centers[i] = points[middle];
    sigma[i] = noise.at(middle).level;
    for (std::size_t piece = pieces_in_range * i; piece < pieces_in_range * (i + 1); ++piece)
      range_area[i] += pieces[piece].area;
    const double pieces_per_area = static_cast<double>(pieces_in_range) / range_area[i];
    const double points_in_piece =
        static_cast<double>(ranges.size(i)) / static_cast<double>(pieces_in_range);
    const double radius = (std::max)(settings.curvature_radius * spacing, 3. * sigma[i]);
    const double wanted = (std::max)({CGAL_PI * radius * radius * pieces_per_area, fewest_pieces,
                                      fewest_points / points_in_piece});
    pieces_in_ball[i] =
        (std::min)(static_cast<std::size_t>((std::min)(wanted, most_pieces)), pieces.size());
  });
  const Surface_balls balls(centers, pieces, pieces_in_ball, progress, ConcurrencyTag());

  std::vector<double> curvature(ranges.number), possible_curvature(ranges.number),
      area(ranges.number), density(ranges.number), weight(ranges.number);
  for_each_index<ConcurrencyTag>(0, ranges.number,
                                 [&](std::size_t i)
                                 {
    const Deviation deviation =
        deviation_from_plane(pieces, balls.of(i), centers[i], coordinate_error);
    // Beyond the noise, and two standard deviations of what the points say of it, so that noise alone is taken
    // for flat. But it may hide so much.
    const double variance = sigma[i] * sigma[i];
    const double signal = deviation.squared_height - variance;
    const double hidden = 2. * variance * std::sqrt(2. / deviation.number);
    // sqrt(lambda_0) / r^2 up to a constant
    if (deviation.trace > 0.)
    {
      curvature[i] = std::sqrt((std::max)(signal - hidden, 0.)) / deviation.trace;
      possible_curvature[i] = std::sqrt((std::max)(signal, hidden)) / deviation.trace;
    }
    // On a border, samples stand for half a cell: the area counts twice, as that of the ball does, on
    // one side of which there are no points. The mean of half a disk is 4 r / 3 pi off its center.
    const double one_sided = deviation.trace > 0. ? (9. * CGAL_PI * CGAL_PI / 32. - 1.) *
                                                        deviation.squared_offset / deviation.trace
                                                  : 0.;
    area[i] = (1. + one_sided) * deviation.area / deviation.number;
  });

  // Reconstruction wants spacings that vary slowly, and where they change at once, the relaxation takes long.
  if (settings.average_curvature)
    curvature =
        mean_over_balls<ConcurrencyTag>(curvature, order_of_mean, pieces, pieces_in_range, balls);

  // Bounded from below by a part of the mean, with what noise may hide. Without that, the few places of a
  // noisy plane that look bent by chance are the only ones that are, and get half of all samples.
  const double mean_power = reduce_indices<ConcurrencyTag>(
                                ranges.number, 0.,
                                [&](std::size_t i) {
    return range_area[i] * std::pow(possible_curvature[i], order_of_mean);
                                },
                                std::plus<double>()) /
      total_area;
  const double least =
      mean_power > 0. ? settings.least_curvature * std::pow(mean_power, 1. / order_of_mean) : 1.;
  for_each_index<ConcurrencyTag>(0, ranges.number,
                                 [&](std::size_t i) {
    density[i] = std::pow(curvature[i] * curvature[i] + least * least, alpha / 2.);
  });
  scale_to_number<ConcurrencyTag>(density, number, ranges, range_area, total_area,
                                  settings.densest_in_sparse_regions);
  for_each_index<ConcurrencyTag>(0, ranges.number,
                                 [&](std::size_t i) { weight[i] = density[i] * area[i]; });
  return {ranges, std::move(density), std::move(weight)};
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SAMPLING_DENSITY_H
