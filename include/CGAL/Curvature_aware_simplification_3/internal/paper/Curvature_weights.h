// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PAPER_CURVATURE_WEIGHTS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PAPER_CURVATURE_WEIGHTS_H

#include <cmath>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The curvature-aware weights of the two energies (paper, sec. 4.2). They take the surface
// variation scaled to [0, 20], the range for which Meyer et al. (2005) suggested r and v.
class Curvature_weights
{
public:
  explicit Curvature_weights(double curvature_dependence) : m_d(curvature_dependence) {}

  // The factor that takes kappa to [0, 20], from its maximum; 0 where kappa vanishes everywhere.
  // The lower end of the scale is kappa = 0 and not the smallest kappa: otherwise a sphere's kappa,
  // equal up to noise, would spread over the whole range.
  static double scale(double maximum_surface_variation)
  {
    return maximum_surface_variation > 0. ? maximum_curvature / maximum_surface_variation : 0.;
  }

  // eq. 5 and 6: phi_1(k) = r + 1 / (k^-d + v), from r where flat to r + 1/v where curved.
  // At k = 0, k^-d is infinite and phi_1 is r; IEEE arithmetic gives just that.
  double attraction(double curvature) const { return r + 1. / (std::pow(curvature, -m_d) + v); }

  // eq. 4: a = r + 1 / (k^d + v), from r + 1/v where flat to r where curved
  double repulsion_amplitude(double curvature) const
  {
    return r + 1. / (std::pow(curvature, m_d) + v);
  }

  // eq. 3: phi_2, from the amplitudes of the two samples
  static double repulsion(double amplitude, double other_amplitude)
  {
    return (amplitude + other_amplitude) / 2.;
  }

  static constexpr double maximum_curvature = 20.;

private:
  static constexpr double r = 0.1;
  static constexpr double v = 0.75;
  double m_d;
};

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PAPER_CURVATURE_WEIGHTS_H
