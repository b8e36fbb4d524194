// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DENSITY_SURFACE_CURVATURE_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DENSITY_SURFACE_CURVATURE_H

#include <CGAL/Curvature_aware_simplification_3/internal/Scan.h>
#include <CGAL/Curvature_aware_simplification_3/internal/density/Surface_balls.h>
#include <CGAL/Curvature_aware_simplification_3/internal/density/mean_over_balls.h>
#include <CGAL/Curvature_aware_simplification_3/internal/density/surface_pieces.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Noise.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Adaptive_settings.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Curve_ranges.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Progress.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Uninitialized_vector.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// What is measured of the surface at the distance of the samples, for each range of the curve
struct Surface_curvature
{
  Curve_ranges ranges;
  std::vector<double> area;               // of its points together
  std::vector<double> area_of_point;      // that each of them stands for, more on borders
  std::vector<double> curvature;          // up to a constant
  std::vector<double> possible_curvature; // which the noise may hide

  explicit Surface_curvature(const Curve_ranges& curve_ranges)
    : ranges(curve_ranges),
      area(ranges.number),
      area_of_point(ranges.number),
      curvature(ranges.number),
      possible_curvature(ranges.number)
  {}
};

// Of means of the curvature: a few large values do not decide them. It is that of the default
// alpha, and not alpha itself, for which the bound from below would vanish with alpha: then flat
// parts would get less of a density that is nearly uniform.
inline constexpr double order_of_mean = 2. / 3.;

// How many pieces a ball of `radius` holds: where `area` is that of one, and `points` the number of
// its points
inline std::size_t pieces_in_ball(double radius, double area, double points)
{
  // Pieces are small against the balls, about 16 in each. Where the input is sparse, balls hold no
  // fewer than 4, which is one piece to each side, and no fewer points than about 17, so that the
  // height over their plane is more than chance; where it is dense, no more than 64, which say as
  // much as all. With half or twice as many pieces or points, the mean error of what is made of it
  // is the same to 1 %.
  constexpr double fewest = 4., most = 64., fewest_points = 17.;
  if (!(radius > 0.)) // an area may vanish where squares of coordinates underflow
    return static_cast<std::size_t>(fewest);
  const double wanted =
      (std::max)({CGAL_PI * radius * radius / area, fewest, fewest_points / points});
  return static_cast<std::size_t>((std::min)(wanted, most));
}

struct Local_curvature
{
  double curvature = 0., possible_curvature = 0.;
};

// From how far the points around are off a plane. Beyond the noise, and two standard deviations of
// what the points say of it, so that noise alone is taken for flat. But it may hide so much.
//
// Of n independent points, that standard deviation is sigma^2 sqrt(2 / n). Points that share their
// noise, as smoothed ones do, say as little as n sigma^2 / sigma_i^2 of those, whose mean errs as
// much as that of n points with independent noise sigma_i.
inline Local_curvature curvature_of(const Deviation& deviation, const Noise& noise)
{
  if (!(deviation.trace > 0.))
    return Local_curvature();
  const double variance = noise.level * noise.level;
  const double signal = deviation.squared_height - variance;
  const double hidden = 2. * noise.level * (std::max)(noise.level, noise.independent_level) *
                        std::sqrt(2. / deviation.number);
  return {std::sqrt((std::max)(signal - hidden, 0.)) / deviation.trace,
          std::sqrt((std::max)(signal, hidden)) / deviation.trace};
}

// On a border, samples stand for half a cell: the area counts twice, as that of the ball does, on
// one side of which there are no points. The mean of half a disk is 4 r / 3 pi off its center.
inline double area_of_point(const Deviation& deviation)
{
  const double one_sided = deviation.trace > 0. ? (9. * CGAL_PI * CGAL_PI / 32. - 1.) *
                                                      deviation.squared_offset / deviation.trace
                                                : 0.;
  return (1. + one_sided) * deviation.area / deviation.number;
}

// The curvature at the distance of the samples, by how far the points of a ball are off a plane: in
// balls with a radius R of 1.5 spacings, it is sqrt(lambda_0) / R^2 up to a constant, with the
// trace of the covariance for R^2 / 2. From lambda_0, sigma^2 is taken off for the noise. R is 3
// sigma at least; what is sparse or dense has larger or smaller balls.
template <typename ConcurrencyTag>
Surface_curvature surface_curvature(const Scan& scan, std::size_t number_of_samples,
                                    const Adaptive_settings& settings, const Progress& progress)
{
  // Ranges of the Hilbert curve, about one for each sample, represented by the point in its middle.
  // Each is two pieces, unless these would be of fewer than two points, which saves nothing.
  const std::size_t n = scan.points.size();
  const Curve_ranges ranges{(std::min)({n, number_of_samples, Curve_ranges::most / 2}), n};
  const std::size_t pieces_in_range = n / ranges.number < 4 ? 1 : 2;
  const Uninitialized_vector<Surface_piece> pieces = surface_pieces<ConcurrencyTag>(
      scan.points, scan.inverse_density, pieces_in_range * ranges.number);

  const double radius = settings.curvature_radius * scan.spacing();
  Surface_curvature result(ranges);
  std::vector<Point> centers(ranges.number);
  std::vector<const Noise*> noise_of_range(ranges.number);
  std::vector<std::size_t> number_of_pieces(ranges.number);
  for_each_index<ConcurrencyTag>(0, ranges.number, [&](std::size_t i) {
    const std::size_t middle = ranges.first_point(i) + ranges.size(i) / 2;
    centers[i] = scan.points[middle];
    noise_of_range[i] = &scan.noise.at(middle);
    for (std::size_t piece = pieces_in_range * i; piece < pieces_in_range * (i + 1); ++piece)
      result.area[i] += pieces[piece].area;
    const double in_range = static_cast<double>(pieces_in_range);
    // In less than 3 sigma, noise makes a layer look like a volume.
    const std::size_t wanted =
        pieces_in_ball((std::max)(radius, 3. * noise_of_range[i]->level), result.area[i] / in_range,
                       static_cast<double>(ranges.size(i)) / in_range);
    number_of_pieces[i] = (std::min)(wanted, pieces.size());
  });
  const Surface_balls balls(centers, pieces, number_of_pieces, progress, ConcurrencyTag());

  for_each_index<ConcurrencyTag>(0, ranges.number, [&](std::size_t i) {
    const Deviation deviation =
        deviation_from_plane(pieces, balls.of(i), centers[i], scan.coordinate_error);
    const Local_curvature local = curvature_of(deviation, *noise_of_range[i]);
    result.curvature[i] = local.curvature;
    result.possible_curvature[i] = local.possible_curvature;
    result.area_of_point[i] = area_of_point(deviation);
  });

  // Reconstruction wants spacings that vary slowly, and where they change at once, the relaxation
  // takes long.
  if (settings.average_curvature)
    result.curvature = mean_over_balls<ConcurrencyTag>(result.curvature, order_of_mean, pieces,
                                                       pieces_in_range, balls);
  return result;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DENSITY_SURFACE_CURVATURE_H
