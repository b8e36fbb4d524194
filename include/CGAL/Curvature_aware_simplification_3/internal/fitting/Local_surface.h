// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_LOCAL_SURFACE_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_LOCAL_SURFACE_H

#include <CGAL/Curvature_aware_simplification_3/internal/tools/Computation_kernel.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Lanes.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The surface around a sample: a quadric over a tangent plane,
// x(a, b) = origin + a u + b v + f(a, b) n,  f = c0 + c1 a + c2 b + c3 a^2 + c4 a b + c5 b^2
struct Local_surface
{
  Point origin = Point(0., 0., 0.);
  Vector u = Vector(1., 0., 0.), v = Vector(0., 1., 0.), n = Vector(0., 0., 1.);
  double c[6] = {0., 0., 0., 0., 0., 0.};
  std::size_t neighbors = 0; // it was fitted to
  double radius = 0.;        // of their ball; 0: not fitted
  double length = 0.;        // their standard deviation in the plane, where it is largest
  double width = 0.;         // and across
  bool is_curve = false;     // the input around is a curve, as far as fits reach
  double spread = 0.;        // of the heights of the neighbors over it
  double error = 0.;         // standard deviation of c0 caused by noise
  double amplification = 0.; // the same over that of one point, for independent noise

  // The height over (a, b); of two places at once as well, see Lanes
  template <typename Number>
  Number height(const Number& a, const Number& b) const
  {
    return c[0] + c[1] * a + c[2] * b + c[3] * a * a + c[4] * a * b + c[5] * b * b;
  }

  // of a point with the position `d` relative to the origin: its distance along n
  double residual(const Vector& d) const { return d * n - height(d * u, d * v); }

  Lanes residual(const Vector_lanes& d) const { return d * n - height<Lanes>(d * u, d * v); }

  Point point(double a, double b) const { return origin + a * u + b * v + height(a, b) * n; }

  Vector normal(double a, double b) const
  {
    const double slope_a = c[1] + 2. * c[3] * a + c[4] * b;
    const double slope_b = c[2] + c[4] * a + 2. * c[5] * b;
    const Vector m = n - slope_a * u - slope_b * v;
    return m / std::sqrt(m.squared_length());
  }

  // n is given: u and v complete an orthonormal frame, from the axis that is farthest from n
  void complete_frame()
  {
    const double x = std::abs(n.x()), y = std::abs(n.y()), z = std::abs(n.z());
    const Vector axis = x <= y && x <= z ? Vector(1., 0., 0.)
                        : y <= z         ? Vector(0., 1., 0.)
                                         : Vector(0., 0., 1.);
    u = cross_product(n, axis);
    u = u / std::sqrt(u.squared_length());
    v = cross_product(n, u);
  }

  // The same surface in the frame of the foot point of its origin, so that c0 = c1 = c2 = 0. The
  // second order is rotated with the frame; the tilt is small, and its square is left out.
  void move_to_foot_point()
  {
    const Vector normal_here = normal(0., 0.);
    const double cosine = normal_here * n;
    const Vector foot = (c[0] * cosine) * normal_here;
    const double rest = height(foot * u, foot * v) - foot * n;

    Local_surface s = *this;
    s.n = normal_here;
    s.complete_frame();
    s.origin = origin + foot + (rest * cosine) * normal_here;
    const double uu = s.u * u, uv = s.u * v, vu = s.v * u, vv = s.v * v;
    s.c[0] = s.c[1] = s.c[2] = 0.;
    s.c[3] = cosine * (c[3] * uu * uu + c[4] * uu * uv + c[5] * uv * uv);
    s.c[4] = cosine * (2. * c[3] * uu * vu + c[4] * (uu * vv + uv * vu) + 2. * c[5] * uv * vv);
    s.c[5] = cosine * (c[3] * vu * vu + c[4] * vu * vv + c[5] * vv * vv);
    *this = s;
  }
};

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_LOCAL_SURFACE_H
