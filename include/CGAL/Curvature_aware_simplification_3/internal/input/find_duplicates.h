// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_INPUT_FIND_DUPLICATES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_INPUT_FIND_DUPLICATES_H

#include <CGAL/Curvature_aware_simplification_3/internal/tools/Computation_kernel.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Flags.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/index_selection.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/sort.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Which values occurred, and which of them more than once: two bits each. Threads may add values at
// the same time, and what is found does not depend on their order.
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

// The positions of all points that have an equal, and of few others, in increasing order: of those
// whose hash value is that of another point. Which these are does not depend on the order of the
// threads. O(n)
template <typename ConcurrencyTag>
std::vector<std::size_t> points_with_equal_hash(const std::vector<Point>& points)
{
  // So many for each point: one point in 16 shares its own by chance.
  constexpr std::size_t hash_values = 16;
  // The values of millions of points do not fit into caches. A thread waits for each atomic write,
  // but has many reads under way: all of a batch come before the first write. That halves the time
  // for 10 million.
  constexpr std::size_t batch_size = 64;

  const std::size_t n = points.size();
  const auto hash = [&](const Point& p) {
    std::size_t value = 0;
    boost::hash_combine(value, p.x());
    boost::hash_combine(value, p.y());
    boost::hash_combine(value, p.z());
    return value % (hash_values * n);
  };
  Repeated_values values(hash_values * n);
  // function(position, hash value, whether it is known to be repeated)
  const auto for_each_point = [&](const auto& function) {
    for_each_index<ConcurrencyTag>(0, (n + batch_size - 1) / batch_size, [&](std::size_t batch) {
      const std::size_t begin = batch * batch_size, size = (std::min)(batch_size, n - begin);
      std::array<std::size_t, batch_size> value;
      std::array<bool, batch_size> is_repeated;
      for (std::size_t i = 0; i < size; ++i)
        value[i] = hash(points[begin + i]);
      for (std::size_t i = 0; i < size; ++i)
        is_repeated[i] = values.is_repeated(value[i]);
      for (std::size_t i = 0; i < size; ++i)
        function(begin + i, value[i], is_repeated[i]);
    });
  };

  for_each_point([&](std::size_t, std::size_t value, bool is_repeated) {
    if (!is_repeated)
      values.add(value);
  });
  Flags is_found(n);
  for_each_point(
      [&](std::size_t i, std::size_t, bool is_repeated) { is_found[i] = is_repeated ? 1 : 0; });
  return flagged_indices<ConcurrencyTag>(is_found);
}

// A point that is equal to one before it in the input
struct Duplicate
{
  std::size_t index;
  std::size_t first; // the first of all that are equal to it
};

// All duplicates, those of one point together. Only points of equal hash values are sorted: few,
// unless there are many duplicates.
template <typename ConcurrencyTag>
std::vector<Duplicate> find_duplicates(const std::vector<Point>& points)
{
  const std::vector<std::size_t> candidates = points_with_equal_hash<ConcurrencyTag>(points);
  using Point_and_index = std::pair<Point, std::size_t>;
  std::vector<Point_and_index> sorted(candidates.size());
  for_each_index<ConcurrencyTag>(0, sorted.size(), [&](std::size_t c) {
    sorted[c] = {points[candidates[c]], candidates[c]};
  });
  sort<ConcurrencyTag>(sorted);

  const std::vector<std::size_t> groups =
      indices_where<ConcurrencyTag>(sorted.size(), [&](std::size_t c) {
        return c == 0 || sorted[c].first != sorted[c - 1].first;
      });
  std::vector<Duplicate> duplicates(sorted.size() - groups.size());
  for_each_index<ConcurrencyTag>(0, groups.size(), [&](std::size_t g) {
    const std::size_t end = g + 1 < groups.size() ? groups[g + 1] : sorted.size();
    for (std::size_t c = groups[g] + 1; c < end; ++c) // g + 1 first points come before
      duplicates[c - g - 1] = {sorted[c].second, sorted[groups[g]].second};
  });
  return duplicates;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_INPUT_FIND_DUPLICATES_H
