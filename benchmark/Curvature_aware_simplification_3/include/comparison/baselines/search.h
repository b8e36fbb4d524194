#ifndef CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_SEARCH_H
#define CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_SEARCH_H

#include <cmath>
#include <cstddef>
#include <utility>

namespace comparison {

// For methods that know a size and no count: bisection over the positive parameter of
// `simplify(parameter)`, which returns few points for `few` and more towards `many`.
//
// Returned is the result whose size() is the nearest to n of all that were tried. The search ends
// when the count is n, or the interval has shrunk to a relative width of 1e-12, where the parameter
// separates the two sides of one jump of the count: what remains is less than the height of that
// jump, unless n lies outside of what the interval reaches, or the count is not monotone.
// The bisection is of the logarithm, since the interval spans orders of magnitude.
template <typename Simplify>
auto search_count(const Simplify& simplify, double few, double many, std::size_t n)
{
  auto best = simplify(few);
  const auto difference = [n](std::size_t count) { return count < n ? n - count : count - n; };
  const auto try_parameter = [&](double parameter) {
    auto result = simplify(parameter);
    const std::size_t count = result.size();
    if (difference(count) < difference(best.size()))
      best = std::move(result);
    return count;
  };

  if (best.size() >= n || try_parameter(many) <= n)
    return best;
  while (best.size() != n && std::abs(few / many - 1.) > 1e-12)
  {
    const double middle = few * std::sqrt(many / few);
    (try_parameter(middle) < n ? few : many) = middle;
  }
  return best;
}

} // namespace comparison

#endif // CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_SEARCH_H
