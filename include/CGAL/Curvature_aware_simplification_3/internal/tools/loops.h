// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_LOOPS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_LOOPS_H

#include <CGAL/Curvature_aware_simplification_3/internal/tools/Progress.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/for_each.h>

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// A loop over a range of indices, whatever its kernel: a compiler has to make one parallel loop and
// not one for each kernel, which saves a quarter of its time. Refers to the kernel.
class Index_loop
{
public:
  template <typename Kernel>
  explicit Index_loop(const Kernel& kernel)
    : m_kernel(&kernel), m_run([](const void* any, std::size_t begin, std::size_t end) {
        const Kernel& kernel_of_type = *static_cast<const Kernel*>(any);
        for (std::size_t i = begin; i < end; ++i)
          kernel_of_type(i);
      })
  {}

  void operator()(std::size_t begin, std::size_t end) const { m_run(m_kernel, begin, end); }

private:
  const void* m_kernel;
  void (*m_run)(const void*, std::size_t, std::size_t);
};

// loop(first, last) for ranges that make up [begin, end)
template <typename ConcurrencyTag>
void run_in_parts(std::size_t begin, std::size_t end, const Index_loop& loop)
{
  using Iterator = boost::counting_iterator<std::size_t>;
  // Short loops are made of a thousand parts, enough for many threads to share; long ones of parts
  // of 64, which take long against the call of one, and not so long that threads wait for the last.
  const std::size_t size = end - begin;
  const std::size_t step = (std::min)(size / 1024 + 1, std::size_t(64));
  CGAL::for_each<ConcurrencyTag>(CGAL::make_range(Iterator(0), Iterator((size + step - 1) / step)),
                                 [&](const std::size_t& part) -> bool {
                                   loop(begin + part * step,
                                        (std::min)(end, begin + (part + 1) * step));
                                   return true;
                                 });
}

// kernel(i) for all i in [begin, end). The kernel writes only what belongs to i, or adds to atomic
// integers, whose sums do not depend on the order, so that the result depends neither on the tag
// nor on the number of threads.
template <typename ConcurrencyTag, typename Kernel>
void for_each_index(std::size_t begin, std::size_t end, const Kernel& kernel)
{
  run_in_parts<ConcurrencyTag>(begin, end, Index_loop(kernel));
}

// The same over [0, size), with progress reported between blocks. 20 blocks are often enough for a
// progress bar. Of 64 indices or more, they are long enough for many threads to share, and waiting
// for the last one costs little.
template <typename ConcurrencyTag, typename Kernel>
void for_each_index(std::size_t size, const Progress& progress, const Kernel& kernel)
{
  constexpr std::size_t most_blocks = 20, fewest_indices = 64;
  const std::size_t blocks =
      progress.is_observed() ? (std::min)(size / fewest_indices + 1, most_blocks) : 1;
  const std::size_t step = size / blocks + 1;
  for (std::size_t begin = 0; begin < size; begin += step)
  {
    const std::size_t end = (std::min)(size, begin + step);
    for_each_index<ConcurrencyTag>(begin, end, kernel);
    progress.report(static_cast<double>(end) / static_cast<double>(size));
  }
}

// Points of a block: long against a task's overhead, short against any input
inline constexpr std::size_t block_size = 4096;

// combine(... combine(combine(identity, value(0)), value(1)) ...) over [0, size), associated in
// blocks of fixed length: rounding is the same for every tag and number of threads.
template <typename ConcurrencyTag, typename T, typename Value, typename Combine>
T reduce_indices(std::size_t size, const T& identity, const Value& value, const Combine& combine)
{
  std::vector<T> partial_results((size + block_size - 1) / block_size, identity);
  for_each_index<ConcurrencyTag>(0, partial_results.size(), [&](std::size_t block) {
    const std::size_t begin = block * block_size;
    const std::size_t end = (std::min)(size, begin + block_size);
    T result = identity;
    for (std::size_t i = begin; i < end; ++i)
      result = combine(result, value(i));
    partial_results[block] = result;
  });

  T result = identity;
  for (const T& partial_result : partial_results)
    result = combine(result, partial_result);
  return result;
}

// arithmetic mean of value(i) over [0, size)
template <typename ConcurrencyTag, typename Value>
double mean(std::size_t size, const Value& value)
{
  const double sum =
      reduce_indices<ConcurrencyTag>(size, 0., value, [](double a, double b) { return a + b; });
  return sum / static_cast<double>(size);
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_LOOPS_H
