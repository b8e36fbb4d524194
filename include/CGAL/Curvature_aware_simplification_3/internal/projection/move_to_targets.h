// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_MOVE_TO_TARGETS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_MOVE_TO_TARGETS_H

#include <CGAL/Curvature_aware_simplification_3/internal/samples/Sample_neighbors.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/Surface_sample.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Where a sample may be moved to
struct Target
{
  Point point;
  double distance; // in spacings
};

// Moves samples to their targets, but none that would come closer than `too_close` spacings to the
// target of a neighbor that has less far to go.
template <typename ConcurrencyTag>
void move_to_targets(std::vector<Surface_sample>& samples,
                     const std::vector<std::optional<Target>>& targets,
                     const Sample_neighbors& neighbors, double too_close)
{
  for_each_index<ConcurrencyTag>(0, samples.size(), [&](std::size_t i) {
    const std::optional<Target>& own = targets[i];
    if (!own)
      return;
    const double gap = too_close * samples[i].spacing;
    for (std::size_t j : neighbors.of(i))
    {
      const std::optional<Target>& other = targets[j];
      if (other && std::make_pair(other->distance, j) < std::make_pair(own->distance, i) &&
          (other->point - own->point).squared_length() < gap * gap)
        return;
    }
    samples[i].point = own->point;
  });
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PROJECTION_MOVE_TO_TARGETS_H
