// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_DEPTH_VIEW_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_DEPTH_VIEW_H

#include <CGAL/Curvature_aware_simplification_3/internal/depth/Depth_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Searchable_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/index_selection.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// What one of several cameras has seen, each of which has rounded depth along its own axis
struct Depth_view : Searchable_points
{
  Depth_levels levels;
  std::vector<std::size_t> indices; // of its points, among all
};

// Faces of a part may have as many, but these do not cross each other. With 10, as for one camera,
// a scan of 6,556 points was not recognized, which are too few for more.
inline constexpr std::size_t fewest_levels_of_view = 6;

// Of each point, the index of the view that it is in
using Views_of_points = std::vector<std::uint8_t>;
inline constexpr std::uint8_t in_no_view = 0xff;

template <typename ConcurrencyTag>
std::vector<std::size_t> indices_of(std::size_t view, const Views_of_points& view_of_point)
{
  return indices_where<ConcurrencyTag>(view_of_point.size(),
                                       [&](std::size_t i) { return view_of_point[i] == view; });
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DEPTH_DEPTH_VIEW_H
