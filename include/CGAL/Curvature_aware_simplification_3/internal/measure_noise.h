// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_MEASURE_NOISE_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_MEASURE_NOISE_H

#include <CGAL/Curvature_aware_simplification_3/internal/Noise_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fit_quadric.h>
#include <CGAL/Curvature_aware_simplification_3/internal/loops.h>
#include <CGAL/Curvature_aware_simplification_3/internal/median.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// What a quadric leaves of the heights of the nearest points, and how wide these are
struct Residual
{
  double deviation = 0.; // standard deviation
  double width = 0.; // radius of a disk with the same extent in its plane, the lesser of the two
};

inline Residual residual_around(const Neighbor_search& search, const Point& probe, std::size_t k)
{
  static thread_local Neighborhood neighborhood;
  neighborhood.collect(search, probe, k);
  Local_surface surface;
  if (!(neighborhood.radius > 0.) || !fit_quadric_over_plane(neighborhood, 0., surface))
    return Residual();
  double sum = 0.;
  Covariance_sums positions;
  for (const Neighborhood::Neighbor& neighbor : neighborhood.neighbors)
  {
    const double e = surface.residual(neighbor.position);
    sum += e * e;
    positions.add(neighbor.position);
  }
  // lambda_1 of a disk is a quarter of the square of its radius
  return {std::sqrt(sum / (std::max)(static_cast<double>(neighborhood.size()) - 6., 1.)),
          2. * std::sqrt((std::max)(eigenvalues(positions)(1), 0.))};
}

// Where noise is measured: probes, evenly along the Hilbert curve, and for each range of them, which of
// them are nearest to its middle
struct Noise_probes
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> near_range;
};

template <typename ConcurrencyTag>
Noise_probes noise_probes(const std::vector<Point>& points)
{
  // 64 values give a median to about 8 % of the noise, and 512 probes take 2 % of the time of a call.
  constexpr std::size_t most = 512, in_range = 8, in_median = 64;

  Noise_probes probes;
  const std::size_t number = (std::min)(most, points.size());
  for (std::size_t i = 0; i < number; ++i)
    probes.points.push_back(points[(2 * i + 1) * points.size() / (2 * number)]);
  const Neighbor_search search(probes.points, ConcurrencyTag());
  probes.near_range.resize((std::max)(number / in_range, std::size_t(1)));
  const std::size_t ranges = probes.near_range.size();
  for_each_index<ConcurrencyTag>(0, ranges,
                                 [&](std::size_t range)
                                 {
    const Point& middle = probes.points[(2 * range + 1) * number / (2 * ranges)];
    search.for_each_nearest(middle, (std::min)(in_median, number),
                            [&](std::size_t i, const Point&, double)
                            { probes.near_range[range].push_back(i); });
  });
  return probes;
}

template <typename Value>
double median_of(const std::vector<std::size_t>& indices, const Value& value)
{
  std::vector<double> values;
  for (std::size_t i : indices)
    values.push_back(value(i));
  return median(values);
}

// The medians around each range, for the k nearest points of a probe
template <typename ConcurrencyTag>
std::vector<Residual> median_residuals(const Noise_probes& probes, const Neighbor_search& search,
                                       std::size_t k)
{
  std::vector<Residual> residuals(probes.points.size());
  for_each_index<ConcurrencyTag>(0, residuals.size(),
                                 [&](std::size_t i)
                                 { residuals[i] = residual_around(search, probes.points[i], k); });
  std::vector<Residual> medians(probes.near_range.size());
  for_each_index<ConcurrencyTag>(0, medians.size(),
                                 [&](std::size_t range)
                                 {
    const std::vector<std::size_t>& near = probes.near_range[range];
    medians[range] = {median_of(near, [&](std::size_t i) { return residuals[i].deviation; }),
                      median_of(near, [&](std::size_t i) { return residuals[i].width; })};
  });
  return medians;
}

// Standard deviation sigma of the distance of the points to the surface, by place.
//
// The residual s of quadrics holds noise and shape. Noise is the same for all sizes of neighborhoods, but
// what a quadric misses of the shape is not: on smooth surfaces s grows with the cube of the radius, on
// scanned ones, which have details of all sizes, about with its square. So s_k^2 = sigma^2 + c k^2, and
// two sizes tell the two apart: sigma^2 = (4 s_k^2 - s_2k^2) / 3. The first must be wide against the noise:
// where the points look as thick as wide, a fit turns along the noise. If there is no such k up to about
// 1000, the layer of noise is all there is to see, and its residual is the answer; but if it is thicker
// than elsewhere, this may be a thin part, and the median is. If the points end before, they are too few to
// tell noise from shape, and are taken as they are.
template <typename ConcurrencyTag>
Noise_levels measure_noise(const std::vector<Point>& points, const Neighbor_search& search)
{
  constexpr std::size_t smallest = 17, largest = 1000;
  // The width over the residual. With 4, edges are lost in the neighborhoods of CAD parts with noise (p99 up to
  // 8 % larger); with less, noise that is wider than the spacing of the points hides more of itself.
  constexpr double wide_enough = 3.3;

  const Noise_probes probes = noise_probes<ConcurrencyTag>(points);
  Noise_levels result{std::vector<Noise>(probes.near_range.size()), points.size()};
  const auto set_level = [&](std::size_t range, double level) {
    result.of_range[range] = {level, level};
  };
  std::vector<std::size_t> unknown(result.of_range.size());
  std::iota(unknown.begin(), unknown.end(), std::size_t(0));
  for (std::size_t k = smallest; !unknown.empty() && 2 * k <= points.size(); k *= 2)
  {
    const std::vector<Residual> narrow = median_residuals<ConcurrencyTag>(probes, search, k);
    std::vector<std::size_t> thick, flat;
    for (std::size_t range : unknown)
      (narrow[range].width < wide_enough * narrow[range].deviation ? thick : flat).push_back(range);
    if (!flat.empty())
    {
      const std::vector<Residual> wide = median_residuals<ConcurrencyTag>(probes, search, 2 * k);
      for (std::size_t range : flat)
      {
        const double s = narrow[range].deviation, wider = wide[range].deviation;
        set_level(range, std::sqrt((std::max)(0., (4. * s * s - wider * wider) / 3.)));
      }
    }
    if (k > largest)
    {
      for (std::size_t range : thick)
        set_level(range, narrow[range].deviation);
      const double median_level = result.median();
      for (std::size_t range : thick)
        set_level(range, (std::min)(narrow[range].deviation, median_level));
      break;
    }
    unknown.swap(thick);
  }
  return result;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_MEASURE_NOISE_H
