// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_COUNTER_BASED_RANDOM_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_COUNTER_BASED_RANDOM_H

#include <cstddef>
#include <cstdint>
#include <utility>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Random numbers that are a function of (seed, stream, index): the same whatever the order in which
// points are visited, the number of threads or the standard library. The generator is SplitMix64
// (Steele, Lea, Flood: Fast splittable pseudorandom number generators, OOPSLA 2014), whose n-th
// output needs none of the earlier ones.
class Counter_based_random
{
public:
  Counter_based_random(std::uint64_t seed, std::uint64_t stream)
    : m_key(mix(mix(seed + increment) + (stream + 1) * increment))
  {}

  // uniform over all 64-bit integers
  std::uint64_t bits(std::uint64_t index) const { return mix(m_key + (index + 1) * increment); }

  // uniform in [0, 1), a multiple of 2^-53
  double uniform(std::uint64_t index) const
  {
    return static_cast<double>(bits(index) >> 11) * 0x1p-53;
  }

private:
  static std::uint64_t mix(std::uint64_t z)
  {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }

  static constexpr std::uint64_t increment = 0x9E3779B97F4A7C15u; // 2^64 / golden ratio, odd

  std::uint64_t m_key;
};

// Indices in random order are those with increasing keys. The first of the streams of a seed draws.
class Random_order
{
public:
  explicit Random_order(std::uint64_t seed) : m_random(seed, 1) {}

  std::pair<std::uint64_t, std::size_t> key(std::size_t i) const { return {m_random.bits(i), i}; }

private:
  Counter_based_random m_random;
};

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_TOOLS_COUNTER_BASED_RANDOM_H
