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
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// How points look around a place: a layer with a thickness, what a quadric leaves of their heights, and an
// extent
struct Layer
{
  double thickness = 0.; // standard deviation
  double width = 0.;     // radius of a disk with the lesser of the two extents in its plane
};

inline Layer layer_around(const Neighbor_search& search, const Point& probe, std::size_t k)
{
  static thread_local Neighborhood neighborhood;
  neighborhood.collect(search, probe, k);
  Local_surface surface;
  if (!(neighborhood.radius > 0.) || !fit_quadric_over_plane(neighborhood, 0., surface))
    return Layer();
  double sum = 0.;
  Covariance_sums positions;
  for (const Neighborhood::Neighbor& neighbor : neighborhood.neighbors)
  {
    const double e = surface.residual(neighbor.position);
    sum += e * e;
    positions.add(neighbor.position);
  }
  // a quadric has 6 coefficients; lambda_1 of a disk is a quarter of the square of its radius
  return {std::sqrt(sum / (std::max)(static_cast<double>(neighborhood.size()) - 6., 1.)),
          2. * std::sqrt((std::max)(eigenvalues(positions)(1), 0.))};
}

// Points at which noise is measured, evenly along the Hilbert curve. Each range of the curve has a median
// over those of them that are nearest to its middle.
struct Noise_probes
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> of_range;
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
  const std::size_t ranges = (std::max)(number / in_range, std::size_t(1));
  probes.of_range.resize(ranges);
  const Neighbor_search search(probes.points, ConcurrencyTag());
  for_each_index<ConcurrencyTag>(0, ranges,
                                 [&](std::size_t range)
                                 {
    const Point& middle = probes.points[(2 * range + 1) * number / (2 * ranges)];
    search.for_each_nearest(middle, (std::min)(in_median, number),
                            [&](std::size_t i, const Point&, double)
                            { probes.of_range[range].push_back(i); });
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

// The median layers of k points, of some ranges; those of others are left empty
template <typename ConcurrencyTag>
std::vector<Layer> median_layers(const Noise_probes& probes, const std::vector<std::size_t>& ranges,
                                 const Neighbor_search& search, std::size_t k)
{
  std::vector<std::uint8_t> is_needed(probes.points.size(), 0);
  for (std::size_t range : ranges)
    for (std::size_t i : probes.of_range[range])
      is_needed[i] = 1;
  std::vector<Layer> layers(probes.points.size());
  for_each_index<ConcurrencyTag>(0, layers.size(),
                                 [&](std::size_t i)
                                 {
    if (is_needed[i] != 0)
      layers[i] = layer_around(search, probes.points[i], k);
  });
  std::vector<Layer> medians(probes.of_range.size());
  for_each_index<ConcurrencyTag>(0, ranges.size(),
                                 [&](std::size_t r)
                                 {
    const std::vector<std::size_t>& near = probes.of_range[ranges[r]];
    medians[ranges[r]] = {median_of(near, [&](std::size_t i) { return layers[i].thickness; }),
                          median_of(near, [&](std::size_t i) { return layers[i].width; })};
  });
  return medians;
}

// Standard deviation sigma of the distance of the points to the surface, by place.
//
// The thickness s of the layer of the k nearest points holds noise and shape. Noise is the same for all
// sizes, but what a quadric misses of the shape is not: on smooth surfaces it grows with the cube of the
// radius, on scanned ones, which have details of all sizes, about with its square (s_2k^2 is 2 to 7 times
// s_k^2 on clean shapes, 4 in the mean). So s_k^2 = sigma^2 + c k^2, and two sizes tell the two apart:
// sigma^2 = (4 s_k^2 - s_2k^2) / 3. The first must be wide against the noise: in a layer as thick as wide, a
// fit turns along the noise.
//
// Where there is no such k up to about 500, the noise is all there is to see, and sigma is the thickness;
// but if that is more than the median, it may be that of a thin part, and the median counts. If the points
// end before for most ranges, they are too few to tell noise from shape, and are taken as they are.
template <typename ConcurrencyTag>
Noise_levels measure_noise(const std::vector<Point>& points, const Neighbor_search& search)
{
  constexpr std::size_t smallest = 17, largest = 1000;
  // The width over the thickness. With 4, edges are lost in the neighborhoods of CAD parts with noise (p99 up
  // to 8 % larger); with less, noise that is wider than the spacing of the points hides more of itself.
  constexpr double wide_enough = 3.3;

  const Noise_probes probes = noise_probes<ConcurrencyTag>(points);
  const std::size_t ranges = probes.of_range.size();
  Noise_levels result{std::vector<Noise>(ranges), points.size()};
  const auto set_level = [&](std::size_t range, double level) {
    result.of_range[range] = {level, level};
  };

  std::vector<std::size_t> unknown(ranges);
  std::iota(unknown.begin(), unknown.end(), std::size_t(0));
  std::size_t k = smallest;
  std::vector<Layer> narrow = median_layers<ConcurrencyTag>(probes, unknown, search, k);
  for (; !unknown.empty() && k <= largest && 2 * k <= points.size(); k *= 2)
  {
    std::vector<Layer> wide = median_layers<ConcurrencyTag>(probes, unknown, search, 2 * k);
    std::vector<std::size_t> thick;
    for (std::size_t range : unknown)
    {
      const double s = narrow[range].thickness, wider = wide[range].thickness;
      if (narrow[range].width >= wide_enough * s)
        set_level(range, std::sqrt((std::max)(0., (4. * s * s - wider * wider) / 3.)));
      else
      {
        set_level(range, wider); // until a larger size tells more
        thick.push_back(range);
      }
    }
    unknown.swap(thick);
    narrow.swap(wide);
  }
  const bool are_too_few = k <= largest && 2 * unknown.size() >= ranges;
  const double limit = are_too_few ? 0. : result.median();
  for (std::size_t range : unknown)
    set_level(range, (std::min)(result.of_range[range].level, limit));
  return result;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_MEASURE_NOISE_H
