// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_SEPARATE_COPIES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_SEPARATE_COPIES_H

#include <CGAL/Curvature_aware_simplification_3/internal/projection/fill_gaps.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/Sample_neighbors.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/Surface_sample.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Flags.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/index_selection.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/sort.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Whether a sample is at the place of a neighbor before it: two that come to the same gap of a
// curve, or stop at the same end of it, from which no direction leads away.
inline bool is_copy_of_neighbor(const std::vector<Surface_sample>& samples, std::size_t i,
                                const Neighbor_indices& neighbors)
{
  // In spacings: of copies on curves, nine of ten are within 1e-6, the others within 1e-3; of
  // random points on a sphere, no two samples are within 0.01.
  constexpr double same_place = 1e-3;
  const double limit = same_place * samples[i].spacing;
  for (std::size_t j : neighbors)
    if (j < i && squared_distance(samples[i].point, samples[j].point) <= limit * limit)
      return true;
  return false;
}

// Samples at the place of one before them. Those that went to a point of the input may have met
// there others that were far from them when neighbors were looked for: they are exactly there.
template <typename ConcurrencyTag>
std::vector<std::size_t> copies_of_others(const std::vector<Surface_sample>& samples,
                                          const Sample_neighbors& neighbors)
{
  const std::size_t n = samples.size();
  Flags is_copy(n, 0);
  std::vector<std::pair<Point, std::size_t>> places(n);
  for_each_index<ConcurrencyTag>(0, n, [&](std::size_t i) {
    is_copy[i] = is_copy_of_neighbor(samples, i, neighbors.of(i)) ? 1 : 0;
    places[i] = {samples[i].point, i};
  });
  internal::sort<ConcurrencyTag>(places);
  for_each_index<ConcurrencyTag>(1, n, [&](std::size_t m) {
    if (places[m].first == places[m - 1].first)
      is_copy[places[m].second] = 1;
  });
  return flagged_indices<ConcurrencyTag>(is_copy);
}

// Moves each sample at the place of another into a gap of its own.
template <typename ConcurrencyTag>
void separate_copies(std::vector<Surface_sample>& samples, const Sample_neighbors& neighbors,
                     const Neighbor_search& input)
{
  fill_gaps<ConcurrencyTag>(samples, copies_of_others<ConcurrencyTag>(samples, neighbors), input);
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_SEPARATE_COPIES_H
