// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PAPER_THETA_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PAPER_THETA_H

#include <cmath>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// theta(r) = exp(-r^2 / (h/4)^2), the weight that localizes both energies (Huang et al. 2009).
// At the border of its support, r = h, it has fallen to 1e-7.
class Theta
{
public:
  explicit Theta(double h) : m_factor(-16. / (h * h)) {}

  double operator()(double squared_distance) const { return std::exp(m_factor * squared_distance); }

private:
  double m_factor;
};

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PAPER_THETA_H
