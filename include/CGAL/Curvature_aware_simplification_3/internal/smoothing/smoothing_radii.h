// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SMOOTHING_SMOOTHING_RADII_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SMOOTHING_SMOOTHING_RADII_H

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Fit_difference.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Neighborhood.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Surface_fit.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Searchable_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Noise_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Noise_probes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Adaptive_settings.h>
#include <CGAL/Curvature_aware_simplification_3/internal/smoothing/fit_smoothing_quadric.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The narrowest balls that smooth points, where the widest are 4 sigma. A
// ball around a point off the surface holds more of the noise on its side: of 3 sigma, the point
// would keep a seventh of its height (exp(-0.22 r^2 / sigma^2) of it, as was measured on planes),
// and it still keeps some if the ball is moved to its foot point. With balls down to 2.5 sigma,
// samples are up to 13 % farther from the surface, and meshes of them 2 % nearer to 6 % farther.
inline constexpr double smallest_smoothing_radius_in_noise = 3.;

// The radius r of the ball in which a point is smoothed, for a shape of which nothing is known but
// that it has details of all sizes. What a quadric over the ball misses of it grows with r^2, and
// matters against what the samples miss, which grows with the square of their spacing s; the noise
// that it leaves shrinks with sigma / r. The sum of the squares, (r / s)^4 and (sigma / r)^2 times
// constants, is least for r^3 ~ s^2 sigma. Of the constants 1.4 to 1.7 times the cube root, the
// smaller ones are better for scanned shapes and worse for smooth ones.
inline double usual_smoothing_radius(double sigma, double spacing_of_samples)
{
  // the cube root of s^2 sigma, which might underflow
  const double worth = 1.6 * spacing_of_samples * std::cbrt(sigma / spacing_of_samples);
  return (std::min)(largest_smoothing_radius_in_noise * sigma, worth);
}

// An even part of the neighbors in a ball. The nearest would be in a part of it that is no wider
// than the noise, and tell nothing of the shape. Returns whether it is known: a ball may hold any
// number.
inline bool collect_part_within(const Neighbor_search& search, const Point& center, double radius,
                                Neighborhood& neighborhood)
{
  // With half as many, the results are the same to 2 %; with all, such calls take 5 % more.
  constexpr std::size_t enough = 4 * largest_neighborhood, too_many = 16 * enough;
  neighborhood.collect_within(search, center, radius, too_many);
  const bool is_known = neighborhood.size() <= too_many;
  neighborhood.thin(enough);
  return is_known;
}

// By how much the heights of quadrics in balls of radius r and sqrt(2) r around the foot point of x
// differ
inline Fit_difference difference_of_fits(const Surface_fit& fit, const Point& x, double radius)
{
  Neighborhood wide;
  const double sigma = fit.noise.level, large_radius = std::sqrt(2.) * radius;
  Local_surface around_point;
  if (!collect_part_within(fit.search, x, large_radius, wide) ||
      !fit_smoothing_quadric(wide, x, radius, sigma, around_point))
    return {};
  around_point.move_to_foot_point();
  const Point foot = around_point.origin;
  // The ball is moved there: around a point off the surface, narrow balls hold more of the noise on
  // its side than wide ones, and fits would differ by that.
  Local_surface narrower, wider;
  if (!collect_part_within(fit.search, foot, large_radius, wide) ||
      !fit_smoothing_quadric(wide, foot, radius, sigma, narrower) ||
      !fit_smoothing_quadric(wide, foot, large_radius, sigma, wider))
    return {};
  const double expected = narrower.error * narrower.error - wider.error * wider.error;
  narrower.move_to_foot_point();
  wider.move_to_foot_point();
  const double difference = (wider.origin - narrower.origin) * wider.n;
  return {difference * difference, (std::max)(expected, 0.)};
}

// The factor t by which balls of radius r are to be larger, so that what fits in them miss of the
// shape and the noise that they leave are least in sum, from the squares q of the differences of
// some places and the variance v that noise gives them.
//
// A fit in a ball with half the points leaves the variance V, one in the larger ball V / 2, and the
// difference of nested fits has V - V / 2 = v. What is missed of the shape grows like r^2: b and
// 2 b, and the difference is b. So with t r, V / t^2 + b^2 t^4 is to be least, with V = 2 v and
// b^2 = q - v, which is at
//   t^6 = v / (q - v).
// Balls larger than those that were looked at are not asked for.
inline double factor_of_radius(const std::vector<Fit_difference>& differences,
                               const std::vector<std::size_t>& places)
{
  Fit_difference sum;
  for (std::size_t i : places)
    sum.add(differences[i]);
  if (!(sum.expected > 0.))
    return 1.;
  const double least_shape = sum.expected / 8.; // t = sqrt(2)
  return std::pow(sum.expected / (std::max)(sum.square - sum.expected, least_shape), 1. / 6.);
}

// The radius of the narrower balls in which the shape is looked at. In less than 3 sigma, noise
// makes a layer look like a volume, and fits differ by far more than noise explains even on a
// plane. With 3.5, samples are nearer to smooth shapes, and meshes are farther from thin parts.
inline double radius_to_compare(const Noise& noise)
{
  return (std::max)(noise.smoothing_radius, smallest_smoothing_radius_in_noise * noise.level);
}

// The places at which the shape is looked at: as many as those of visible noise
template <typename ConcurrencyTag>
Noise_probes smoothing_probes(const Searchable_points& cloud, const Adaptive_settings& settings)
{
  return noise_probes<ConcurrencyTag>(cloud, many_probes(cloud.size(), settings.most_noise_probes));
}

// function(place, noise there) at the probes where noise is visible; those at others are left empty
template <typename ConcurrencyTag, typename Function>
auto at_visible_noise(const Noise_probes& probes, const Noise_levels& noise,
                      const Function& function)
{
  using Value = std::decay_t<decltype(function(probes.points[0], noise.of_range[0]))>;
  std::vector<Value> values(probes.points.size());
  for_each_index<ConcurrencyTag>(0, values.size(), [&](std::size_t i) {
    const Noise& here = noise.at(probes.index[i]);
    if (here.is_visible)
      values[i] = function(probes.points[i], here);
  });
  return values;
}

// Decides in which balls the points of each range with visible noise are smoothed: wide ones where
// the shape is smooth, narrow ones where it has details.
template <typename ConcurrencyTag>
void set_smoothing_radii(Noise_levels& noise, const Noise_probes& probes, double spacing_of_samples,
                         const Adaptive_settings& settings)
{
  for (Noise& here : noise.of_range)
    here.smoothing_radius = usual_smoothing_radius(here.level, spacing_of_samples);
  if (!settings.smooth_by_shape)
    return;

  const Surface_fitter fitter{probes.search, settings};
  const std::vector<Fit_difference> differences =
      at_visible_noise<ConcurrencyTag>(probes, noise, [&](const Point& place, const Noise& here) {
        return difference_of_fits(fitter.at(here), place, radius_to_compare(here));
      });
  for (std::size_t range = 0; range < noise.of_range.size(); ++range)
  {
    Noise& here = noise.of_range[range];
    if (!here.may_be_narrowed())
      continue;
    const double usual = here.smoothing_radius;
    const double least = (std::min)(smallest_smoothing_radius_in_noise * here.level, usual);
    const double most = largest_smoothing_radius_in_noise * here.level;
    const double wanted =
        radius_to_compare(here) *
        factor_of_radius(differences, probes.around(range, noise.of_range.size()));
    here.smoothing_radius = (std::min)((std::max)(wanted, least), most);
  }
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SMOOTHING_SMOOTHING_RADII_H
