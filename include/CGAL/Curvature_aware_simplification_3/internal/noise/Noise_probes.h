// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_NOISE_PROBES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_NOISE_PROBES_H

#include <CGAL/Curvature_aware_simplification_3/internal/input/Searchable_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Layer.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Curve_ranges.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Flags.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/median.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Points at which noise is measured, evenly along the Hilbert curve. Each range of the curve has a
// median over those of them that are nearest to its middle.
struct Noise_probes
{
  const Neighbor_search& search; // among all points, for what is around the probes
  std::vector<Point> points;
  std::vector<std::size_t> index; // of each, among the points of the curve
  std::vector<std::vector<std::size_t>> of_range;

  // The range that probe i is in; it may count for others
  std::size_t range_around(std::size_t i) const
  {
    return Curve_ranges{of_range.size(), points.size()}.range_of(i);
  }

  // The probes around one of `number_of_ranges` ranges of the curve, which may not be those here
  const std::vector<std::size_t>& around(std::size_t range, std::size_t number_of_ranges) const
  {
    return of_range[middle_of_part(range, number_of_ranges, of_range.size())];
  }
};

inline std::vector<std::size_t> all_ranges(const Noise_probes& probes)
{
  std::vector<std::size_t> ranges(probes.of_range.size());
  std::iota(ranges.begin(), ranges.end(), std::size_t(0));
  return ranges;
}

// So many probes tell whether there is any noise: they take 3 % of the time of a clean call.
inline constexpr std::size_t few_probes = 512;

// So many tell how much there is at each place: one for 16 points, so that the smallest layers of
// two, of 17 points, hardly overlap, and at most `most`.
inline std::size_t many_probes(std::size_t number_of_points, std::size_t most)
{
  constexpr std::size_t points_for_each = 16;
  return (std::max)((std::min)(number_of_points / points_for_each, most), few_probes);
}

// At most so many probes
template <typename ConcurrencyTag>
Noise_probes noise_probes(const Searchable_points& cloud, std::size_t most)
{
  constexpr std::size_t in_range = 8;
  constexpr std::size_t in_median = 64; // gives a median to about 8 % of the noise

  Noise_probes probes{*cloud.search, {}, {}, {}};
  const std::size_t number = (std::min)(most, cloud.size());
  for (std::size_t i = 0; i < number; ++i)
  {
    probes.index.push_back(middle_of_part(i, number, cloud.size()));
    probes.points.push_back(cloud.points[probes.index.back()]);
  }
  const std::size_t ranges = (std::max)(number / in_range, std::size_t(1));
  probes.of_range.resize(ranges);
  const Neighbor_search search_probes(probes.points, ConcurrencyTag());
  for_each_index<ConcurrencyTag>(0, ranges, [&](std::size_t range) {
    const Point& middle = probes.points[middle_of_part(range, ranges, number)];
    search_probes.for_each_nearest(middle, in_median, [&](std::size_t i, const Point&, double) {
      probes.of_range[range].push_back(i);
    });
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

// function(i) at the probes of some ranges; those of others are left empty
template <typename ConcurrencyTag, typename Function>
auto at_probes(const Noise_probes& probes, const std::vector<std::size_t>& ranges,
               const Function& function)
{
  Flags is_needed(probes.points.size(), 0);
  for (std::size_t range : ranges)
    for (std::size_t i : probes.of_range[range])
      is_needed[i] = 1;
  std::vector<std::decay_t<decltype(function(std::size_t(0)))>> values(probes.points.size());
  for_each_index<ConcurrencyTag>(0, values.size(), [&](std::size_t i) {
    if (is_needed[i] != 0)
      values[i] = function(i);
  });
  return values;
}

// median_over(probes) of some ranges; those of others are left empty
template <typename ConcurrencyTag, typename MedianOver>
auto medians_of_ranges(const Noise_probes& probes, const std::vector<std::size_t>& ranges,
                       const MedianOver& median_over)
{
  std::vector<std::decay_t<decltype(median_over(probes.of_range[0]))>> medians(
      probes.of_range.size());
  for_each_index<ConcurrencyTag>(0, ranges.size(), [&](std::size_t r) {
    medians[ranges[r]] = median_over(probes.of_range[ranges[r]]);
  });
  return medians;
}

// The median layers of k points, of some ranges; those of others are left empty.
// `layer_around(search, place, k)` is the layer at a probe.
template <typename ConcurrencyTag, typename LayerAround>
std::vector<Layer> median_layers(const Noise_probes& probes, const std::vector<std::size_t>& ranges,
                                 std::size_t k, const LayerAround& layer_around)
{
  const std::vector<Layer> layers = at_probes<ConcurrencyTag>(probes, ranges, [&](std::size_t i) {
    return layer_around(probes.search, probes.points[i], k);
  });
  return medians_of_ranges<ConcurrencyTag>(
      probes, ranges, [&](const std::vector<std::size_t>& of_range) {
        const auto median_of_all = [&](double Layer::*value) {
          return median_of(of_range, [&](std::size_t i) { return layers[i].*value; });
        };
        return Layer{median_of_all(&Layer::thickness), median_of_all(&Layer::width),
                     median_of_all(&Layer::length), median_of_all(&Layer::kurtosis),
                     median_of_all(&Layer::middle)};
      });
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_NOISE_NOISE_PROBES_H
