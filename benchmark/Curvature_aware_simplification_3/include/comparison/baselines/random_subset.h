#ifndef CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_RANDOM_SUBSET_H
#define CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_RANDOM_SUBSET_H

#include <comparison/types.h>

#include <CGAL/Curvature_aware_simplification_3/internal/tools/Counter_based_random.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace comparison {

// min(n, M) of the M points, drawn one after the other without replacement with probabilities
// proportional to their weights: those with the n earliest arrivals -log(u_i) / w_i of independent
// exponential clocks (Efraimidis and Spirakis 2006). In the order of the input. O(M)
inline Points random_subset(const Points& points, const std::vector<double>& weights, std::size_t n,
                            std::uint64_t seed)
{
  const CGAL::Curvature_aware_simplification_3::internal::Counter_based_random random(seed, 0);
  std::vector<double> arrival(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    arrival[i] = -std::log1p(-random.uniform(i)) / weights[i]; // infinite: last, if w_i = 0

  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  n = std::min(n, points.size());
  const auto earlier = [&](std::size_t i, std::size_t j) {
    return arrival[i] != arrival[j] ? arrival[i] < arrival[j] : i < j;
  };
  if (n < points.size())
    std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(n), order.end(),
                     earlier);
  order.resize(n);
  std::sort(order.begin(), order.end());

  Points subset;
  subset.reserve(n);
  for (std::size_t i : order)
    subset.push_back(points[i]);
  return subset;
}

// every subset with the same probability
inline Points random_subset(const Points& points, std::size_t n, std::uint64_t seed)
{
  return random_subset(points, std::vector<double>(points.size(), 1.), n, seed);
}

} // namespace comparison

#endif // CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_RANDOM_SUBSET_H
