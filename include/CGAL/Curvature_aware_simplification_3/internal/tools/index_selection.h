// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_INDEX_SELECTION_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_INDEX_SELECTION_H

#include <CGAL/Curvature_aware_simplification_3/internal/tools/Flags.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The i in [0, size) for which predicate(i), called once for each, holds; in order. In two parallel
// rounds: blocks by themselves, and then behind what comes before them.
template <typename ConcurrencyTag, typename Predicate>
std::vector<std::size_t> indices_where(std::size_t size, const Predicate& predicate)
{
  std::vector<std::vector<std::size_t>> found((size + block_size - 1) / block_size);
  for_each_index<ConcurrencyTag>(0, found.size(), [&](std::size_t block) {
    for (std::size_t i = block * block_size; i < (std::min)(size, (block + 1) * block_size); ++i)
      if (predicate(i))
        found[block].push_back(i);
  });

  std::vector<std::size_t> first(found.size() + 1, 0); // position in the result, of each block
  for (std::size_t block = 0; block < found.size(); ++block)
    first[block + 1] = first[block] + found[block].size();
  std::vector<std::size_t> result(first.back());
  for_each_index<ConcurrencyTag>(0, found.size(), [&](std::size_t block) {
    std::copy(found[block].begin(), found[block].end(),
              result.begin() + static_cast<std::ptrdiff_t>(first[block]));
  });
  return result;
}

// How many these are
template <typename ConcurrencyTag, typename Predicate>
std::size_t number_where(std::size_t size, const Predicate& predicate)
{
  return reduce_indices<ConcurrencyTag>(
      size, std::size_t(0), [&](std::size_t i) { return std::size_t(predicate(i) ? 1 : 0); },
      std::plus<std::size_t>());
}

template <typename ConcurrencyTag>
std::vector<std::size_t> flagged_indices(const Flags& flags)
{
  return indices_where<ConcurrencyTag>(flags.size(), [&](std::size_t i) { return flags[i] != 0; });
}

template <typename ConcurrencyTag>
std::size_t number_of_flagged(const Flags& flags)
{
  return number_where<ConcurrencyTag>(flags.size(), [&](std::size_t i) { return flags[i] != 0; });
}

template <typename ConcurrencyTag, typename T>
std::vector<T> elements_at(const std::vector<std::size_t>& indices, const std::vector<T>& elements)
{
  std::vector<T> result(indices.size());
  for_each_index<ConcurrencyTag>(0, indices.size(),
                                 [&](std::size_t i) { result[i] = elements[indices[i]]; });
  return result;
}

// Those of some indices for which predicate(index) holds. For few indices and a predicate that
// takes long: threads share them one by one, and not by blocks.
template <typename ConcurrencyTag, typename Predicate>
std::vector<std::size_t> those_where(const std::vector<std::size_t>& indices,
                                     const Predicate& predicate)
{
  Flags holds(indices.size());
  for_each_index<ConcurrencyTag>(0, indices.size(),
                                 [&](std::size_t i) { holds[i] = predicate(indices[i]) ? 1 : 0; });
  return elements_at<ConcurrencyTag>(flagged_indices<ConcurrencyTag>(holds), indices);
}

// Keeps the elements at some indices, which are in order, in the memory that they have: a part at a
// time, which is read as a whole before it is written, over elements that no later part reads
template <typename ConcurrencyTag, typename T, typename Allocator>
void keep_elements(const std::vector<std::size_t>& indices, std::vector<T, Allocator>& elements)
{
  constexpr std::size_t size_of_part = 64 * block_size; // enough for many threads to share
  std::vector<T> part((std::min)(size_of_part, indices.size()));
  for (std::size_t begin = 0; begin < indices.size(); begin += size_of_part)
  {
    const std::size_t end = (std::min)(indices.size(), begin + size_of_part);
    for_each_index<ConcurrencyTag>(begin, end,
                                   [&](std::size_t i) { part[i - begin] = elements[indices[i]]; });
    for_each_index<ConcurrencyTag>(begin, end,
                                   [&](std::size_t i) { elements[i] = part[i - begin]; });
  }
  elements.resize(indices.size());
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_INDEX_SELECTION_H
