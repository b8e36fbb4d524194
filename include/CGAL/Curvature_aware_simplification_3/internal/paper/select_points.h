// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PAPER_SELECT_POINTS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PAPER_SELECT_POINTS_H

#include <CGAL/Curvature_aware_simplification_3/internal/features/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Parameters.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Counter_based_random.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/index_selection.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Curvature- and density-aware stochastic selection (paper, sec. 4.1)
class Selection_probability
{
public:
  // N of M points, `curvature_weight` = w_kappa = 1 - w_rho, `adaptivity` = alpha
  Selection_probability(double ratio, double curvature_weight, double adaptivity,
                        double mean_curvature, double mean_inverse_density)
    : m_ratio(ratio),
      m_curvature_weight(curvature_weight),
      m_adaptivity(adaptivity),
      m_mean_curvature(mean_curvature),
      m_mean_inverse_density(mean_inverse_density)
  {}

  // F_i = (N/M) (w_rho   (1 + alpha ((1/rho_i) / mean(1/rho) - 1))
  //            + w_kappa (1 + alpha (kappa_i   / mean(kappa) - 1)))
  double operator()(double curvature, double inverse_density) const
  {
    return m_ratio * ((1. - m_curvature_weight) * factor(inverse_density, m_mean_inverse_density) +
                      m_curvature_weight * factor(curvature, m_mean_curvature));
  }

private:
  // 1 + alpha (value / mean - 1); 1, as for a value that is the same everywhere, where all vanish
  double factor(double value, double mean) const
  {
    return mean > 0. ? 1. + m_adaptivity * (value / mean - 1.) : 1.;
  }

  double m_ratio;
  double m_curvature_weight;
  double m_adaptivity;
  double m_mean_curvature;
  double m_mean_inverse_density;
};

// Exactly `number_of_output_points` positions in the input, in increasing order: every distinct
// point is drawn with probability F_i, then points are removed or inserted at random until the
// count is met. Duplicates are inserted only when there are not enough distinct points. O(M + N
// log N)
template <typename ConcurrencyTag>
std::vector<std::size_t> select_points(const Cloud& cloud, const Features& features,
                                       const Selection_parameters& parameters)
{
  const std::size_t number_of_points = parameters.number_of_output_points;
  const Selection_probability probability(
      static_cast<double>(number_of_points) / static_cast<double>(cloud.size()),
      parameters.curvature_weight, parameters.adaptivity,
      mean<ConcurrencyTag>(cloud.size(),
                           [&](std::size_t i) { return features.surface_variation[i]; }),
      mean<ConcurrencyTag>(cloud.size(),
                           [&](std::size_t i) { return features.inverse_density[i]; }));

  // `std::uint8_t` and not `bool`: neighboring elements are written by different threads
  enum State : std::uint8_t
  {
    DRAWN,
    NOT_DRAWN,
    DUPLICATE // nor drawn
  };
  const Counter_based_random draw(parameters.random_seed, 0);
  std::vector<State> state(cloud.input_size(), DUPLICATE);
  for_each_index<ConcurrencyTag>(0, cloud.size(), [&](std::size_t j) {
    const std::size_t i = cloud.input_index[j];
    state[i] =
        draw.uniform(i) < probability(features.surface_variation[j], features.inverse_density[j])
            ? DRAWN
            : NOT_DRAWN;
  });

  std::vector<std::size_t> selected =
      indices_where<ConcurrencyTag>(state.size(), [&](std::size_t i) { return state[i] == DRAWN; });

  const Random_order order(parameters.random_seed);
  // Of a set in random order, duplicates last, the first `count` elements
  const auto choose = [&](std::vector<std::size_t>& set, std::size_t count) {
    const auto key = [&](std::size_t i) {
      return std::make_pair(state[i] == DUPLICATE, order.key(i));
    };
    if (count < set.size())
      std::nth_element(set.begin(), set.begin() + static_cast<std::ptrdiff_t>(count), set.end(),
                       [&](std::size_t i, std::size_t j) { return key(i) < key(j); });
    set.resize(count);
  };
  if (selected.size() > number_of_points)
    choose(selected, number_of_points);
  else if (selected.size() < number_of_points)
  {
    std::vector<std::size_t> others = indices_where<ConcurrencyTag>(
        state.size(), [&](std::size_t i) { return state[i] != DRAWN; });
    choose(others, number_of_points - selected.size());
    selected.insert(selected.end(), others.begin(), others.end());
  }
  std::sort(selected.begin(), selected.end());
  return selected;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PAPER_SELECT_POINTS_H
