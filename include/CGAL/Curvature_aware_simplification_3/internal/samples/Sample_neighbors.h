// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SAMPLES_SAMPLE_NEIGHBORS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SAMPLES_SAMPLE_NEIGHBORS_H

#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Uninitialized_vector.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The neighbors of one sample among all
using Neighbor_indices = Iterator_range<const std::size_t*>;

// The nearest other samples of each sample. They are kept while samples move little, as in the
// neighbor lists of molecular dynamics: to search anew in each iteration would take most of its
// time.
class Sample_neighbors
{
public:
  // 16 samples of a hexagonal lattice reach 2.1 spacings far, and theta is below 0.01 beyond 1.5,
  // so that two samples may approach each other by 0.6 before they miss each other. Where two
  // sheets share the list, it reaches 1.5 on each. With 12 to 24, ten iterations give the same
  // within 1 %; but where the density changes, 12 or 14 end so near that samples never rest.
  static constexpr std::size_t most = 16;

  template <typename ConcurrencyTag>
  void search(const std::vector<Point>& samples, std::size_t number, const ConcurrencyTag& tag)
  {
    // not at the same time as the tree and the new ones
    m_indices = Uninitialized_vector<std::size_t>();
    const Neighbor_search neighbor_search(samples, tag);
    const std::size_t n = samples.size();
    m_number = (std::min)({number, most, n - 1});
    m_indices.resize(n * m_number);
    for_each_index<ConcurrencyTag>(0, n, [&](std::size_t i) {
      std::array<Neighbor, most + 1> found;
      std::size_t number_found = 0;
      neighbor_search.for_each_nearest(samples[i], m_number + 1,
                                       [&](std::size_t j, const Point&, double squared_distance) {
                                         if (j != i)
                                           found[number_found++] = {squared_distance, j};
                                       });
      // where more than that many coincide, the sample may not be among its nearest: one is too
      // many
      if (number_found > m_number)
        std::swap(*std::max_element(found.begin(),
                                    found.begin() + static_cast<std::ptrdiff_t>(number_found)),
                  found[m_number]);
      for (std::size_t m = 0; m < m_number; ++m)
        m_indices[i * m_number + m] = found[m].second;
    });
  }

  // Puts the neighbors of each sample in the order of their distances.
  template <typename ConcurrencyTag>
  void sort(const std::vector<Point>& samples, const ConcurrencyTag&)
  {
    for_each_index<ConcurrencyTag>(0, samples.size(), [&](std::size_t i) {
      std::array<Neighbor, most> neighbors;
      for (std::size_t m = 0; m < m_number; ++m)
      {
        const std::size_t j = m_indices[i * m_number + m];
        neighbors[m] = {squared_distance(samples[i], samples[j]), j};
      }
      std::sort(neighbors.begin(), neighbors.begin() + static_cast<std::ptrdiff_t>(m_number));
      for (std::size_t m = 0; m < m_number; ++m)
        m_indices[i * m_number + m] = neighbors[m].second;
    });
  }

  Neighbor_indices of(std::size_t sample) const
  {
    const std::size_t* first = m_indices.data() + sample * m_number;
    return make_range(first, first + m_number);
  }

private:
  using Neighbor = std::pair<double, std::size_t>;

  std::size_t m_number = 0; // for each sample
  Uninitialized_vector<std::size_t> m_indices;
};

// The first ones, at most so many: the nearest if they are in the order of their distances
inline Neighbor_indices first_of(const Neighbor_indices& neighbors, std::size_t most)
{
  return make_range(neighbors.begin(), neighbors.begin() + (std::min)(most, neighbors.size()));
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SAMPLES_SAMPLE_NEIGHBORS_H
