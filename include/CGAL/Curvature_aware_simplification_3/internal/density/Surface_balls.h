// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DENSITY_SURFACE_BALLS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DENSITY_SURFACE_BALLS_H

#include <CGAL/Curvature_aware_simplification_3/internal/density/surface_pieces.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Progress.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Uninitialized_vector.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <CGAL/Iterator_range.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The pieces of the surface in a ball around each of some centers: as many as wanted, the nearest
// ones, in no particular order
class Surface_balls
{
public:
  // O(n log n + sum of the numbers wanted, times log n), with n centers of pieces
  template <typename ConcurrencyTag>
  Surface_balls(const std::vector<Point>& centers,
                const Uninitialized_vector<Surface_piece>& pieces,
                const std::vector<std::size_t>& number_wanted, const Progress& progress,
                const ConcurrencyTag& tag)
    : m_first(centers.size() + 1, 0)
  {
    for (std::size_t i = 0; i < centers.size(); ++i)
      m_first[i + 1] = m_first[i] + number_wanted[i];
    m_pieces.resize(m_first.back());
    const Neighbor_search search(centers_of<ConcurrencyTag>(pieces), tag);
    for_each_index<ConcurrencyTag>(centers.size(), progress, [&](std::size_t i) {
      std::size_t next = m_first[i];
      search.for_each_nearest(centers[i], number_wanted[i],
                              [&](std::size_t j, const Point&, double) {
                                m_pieces[next++] = static_cast<std::uint32_t>(j);
                              });
    });
  }

  Iterator_range<const std::uint32_t*> of(std::size_t center) const
  {
    return make_range(m_pieces.data() + m_first[center], m_pieces.data() + m_first[center + 1]);
  }

private:
  std::vector<std::size_t> m_first;             // of each center, and the end of all
  Uninitialized_vector<std::uint32_t> m_pieces; // of which there are Curve_ranges::most at most
};

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_DENSITY_SURFACE_BALLS_H
