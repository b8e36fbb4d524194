// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_EQUAL_POINTS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_EQUAL_POINTS_H

#include <CGAL/Curvature_aware_simplification_3/internal/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/loops.h>
#include <CGAL/Curvature_aware_simplification_3/internal/scan.h>

#include <boost/functional/hash.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_sort.h>
#endif

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

template <typename ConcurrencyTag, typename T>
void sort(std::vector<T>& values)
{
#ifdef CGAL_LINKED_WITH_TBB
  if (std::is_convertible<ConcurrencyTag, Parallel_tag>::value)
  {
    tbb::parallel_sort(values.begin(), values.end());
    return;
  }
#endif
  std::sort(values.begin(), values.end());
}

// Which values occurred, and which of them more than once: two bits each. Threads may add values at the
// same time, and what is found does not depend on their order.
class Repeated_values
{
public:
  explicit Repeated_values(std::size_t number_of_values) : m_words(number_of_values / 32 + 1) {}

  void add(std::size_t value)
  {
    std::atomic<std::uint64_t>& word = m_words[value / 32];
    if ((word.fetch_or(once(value), std::memory_order_relaxed) & once(value)) != 0)
      word.fetch_or(again(value), std::memory_order_relaxed);
  }

  bool is_repeated(std::size_t value) const
  {
    return (m_words[value / 32].load(std::memory_order_relaxed) & again(value)) != 0;
  }

private:
  static std::uint64_t once(std::size_t value) { return std::uint64_t(1) << (2 * (value % 32)); }
  static std::uint64_t again(std::size_t value) { return once(value) << 1; }

  std::vector<std::atomic<std::uint64_t>> m_words;
};

// The positions of all points that have an equal, and of few others, in increasing order: of those whose
// hash value is that of another point. Which these are does not depend on the order of the threads. O(n)
template <typename ConcurrencyTag>
std::vector<std::size_t> points_with_equal_hash(const std::vector<Point>& points)
{
  // So many for each point: one point in 16 shares its own by chance.
  constexpr std::size_t hash_values = 16;
  const std::size_t size = hash_values * points.size();
  const auto hash = [&](std::size_t i)
  {
    const Point& p = points[i];
    std::size_t value = 0;
    boost::hash_combine(value, p.x());
    boost::hash_combine(value, p.y());
    boost::hash_combine(value, p.z());
    return value % size;
  };
  Repeated_values values(size);
  for_each_index<ConcurrencyTag>(0, points.size(), [&](std::size_t i) { values.add(hash(i)); });
  return indices_where<ConcurrencyTag>(points.size(),
                                       [&](std::size_t i) { return values.is_repeated(hash(i)); });
}

// For each point, the first one in the input that is equal to it, itself if it is the first. Only points
// of equal hash values are sorted: few, unless there are many duplicates.
template <typename ConcurrencyTag>
std::vector<std::size_t> first_of_equal_points(const std::vector<Point>& points)
{
  std::vector<std::size_t> first(points.size());
  for_each_index<ConcurrencyTag>(0, first.size(), [&](std::size_t i) { first[i] = i; });

  const std::vector<std::size_t> candidates = points_with_equal_hash<ConcurrencyTag>(points);
  using Point_and_index = std::pair<Point, std::size_t>;
  std::vector<Point_and_index> sorted(candidates.size());
  for_each_index<ConcurrencyTag>(0, sorted.size(),
                                 [&](std::size_t c) {
    sorted[c] = {points[candidates[c]], candidates[c]};
  });
  sort<ConcurrencyTag>(sorted);
  const std::vector<std::size_t> groups =
      indices_where<ConcurrencyTag>(sorted.size(), [&](std::size_t i)
                                    { return i == 0 || sorted[i].first != sorted[i - 1].first; });
  for_each_index<ConcurrencyTag>(0, groups.size(),
                                 [&](std::size_t g)
                                 {
    const std::size_t end = g + 1 < groups.size() ? groups[g + 1] : sorted.size();
    for (std::size_t i = groups[g]; i < end; ++i)
      first[sorted[i].second] = sorted[groups[g]].second;
  });
  return first;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_EQUAL_POINTS_H
