// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_INPUT_SEARCHABLE_POINTS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_INPUT_SEARCHABLE_POINTS_H

#include <CGAL/Curvature_aware_simplification_3/internal/tools/Computation_kernel.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Points along a Hilbert curve, in the frame, and the search for neighbors among them, which has
// copies of the points as they were when it was built. Its indices are those of `points`, until
// some are hidden in it and left out of these.
struct Searchable_points
{
  std::vector<Point> points;
  std::unique_ptr<Neighbor_search> search;
  double coordinate_error = 0.; // of the points, from rounding in the input

  std::size_t size() const { return points.size(); }

  // To be called when the points have changed. The old tree goes first: two at once would take the
  // most memory of a call.
  template <typename ConcurrencyTag>
  void rebuild_search()
  {
    search.reset();
    search = std::make_unique<Neighbor_search>(points, ConcurrencyTag());
  }
};

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_INPUT_SEARCHABLE_POINTS_H
