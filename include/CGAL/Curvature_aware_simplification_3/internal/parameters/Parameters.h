// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PARAMETERS_PARAMETERS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PARAMETERS_PARAMETERS_H

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The named parameters of the selection alone
struct Selection_parameters
{
  std::size_t number_of_output_points; // N
  std::size_t number_of_neighbors;     // k
  double curvature_weight;             // w_kappa = 1 - w_rho
  double adaptivity;                   // alpha
  std::uint64_t random_seed;
  std::function<bool(double)> callback;
};

// All named parameters but the property maps and traits
struct Parameters : Selection_parameters
{
  std::size_t number_of_iterations;
  double curvature_dependence;           // d
  double repulsion_weight;               // mu
  std::optional<double> neighbor_radius; // h in the caller's unit; none: derived from the samples
  bool recompute_curvature;              // paper, sec. 5.3
  bool require_uniform_sampling;         // the density weights of Huang et al. (2009)
  bool settings_of_the_paper;            // the literal method instead of the adaptive one
};

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PARAMETERS_PARAMETERS_H
