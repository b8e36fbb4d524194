// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SAMPLES_DISTINCT_SAMPLES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SAMPLES_DISTINCT_SAMPLES_H

#include <CGAL/Curvature_aware_simplification_3/internal/input/Cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Counter_based_random.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/index_selection.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The distinct positions of the selected points, along the Hilbert curve of the cloud, so that
// samples that are neighbors in space are neighbors in memory
struct Distinct_samples
{
  std::vector<Point> points;
  std::vector<std::size_t> copies; // how many of the selected points are at each position
};

// Duplicates are selected only where there are too few distinct points. Nothing would tell their
// samples apart in eq. 8, so one is relaxed for all of them.
template <typename ConcurrencyTag>
Distinct_samples distinct_samples(const Cloud& cloud, const std::vector<std::size_t>& selected)
{
  std::vector<std::size_t> order =
      elements_at<ConcurrencyTag>(selected, distinct_indices<ConcurrencyTag>(cloud));
  std::sort(order.begin(), order.end());

  Distinct_samples samples;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    if (i > 0 && order[i] == order[i - 1])
      ++samples.copies.back();
    else
    {
      samples.points.push_back(cloud.points[order[i]]);
      samples.copies.push_back(1);
    }
  }
  return samples;
}

// All distinct points, and so many of their duplicates that they are `number`, those that
// select_points() would choose: it asks for features, which decide nothing here
template <typename ConcurrencyTag>
Distinct_samples all_and_duplicates(const Cloud& cloud, std::size_t number, std::uint64_t seed)
{
  Distinct_samples samples{cloud.points, std::vector<std::size_t>(cloud.size(), 1)};
  if (number == cloud.size())
    return samples;
  const Random_order order(seed);
  std::vector<Duplicate> chosen = cloud.duplicates;
  const auto end = chosen.begin() + static_cast<std::ptrdiff_t>(number - cloud.size());
  if (end != chosen.end())
    std::nth_element(chosen.begin(), end, chosen.end(),
                     [&](const Duplicate& d, const Duplicate& e) {
                       return order.key(d.index) < order.key(e.index);
                     });
  const std::vector<std::size_t> distinct = distinct_indices<ConcurrencyTag>(cloud);
  std::for_each(chosen.begin(), end,
                [&](const Duplicate& d) { ++samples.copies[distinct[d.index]]; });
  return samples;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SAMPLES_DISTINCT_SAMPLES_H
