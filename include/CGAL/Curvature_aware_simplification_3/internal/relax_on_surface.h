// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_RELAX_ON_SURFACE_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_RELAX_ON_SURFACE_H

#include <CGAL/Curvature_aware_simplification_3/internal/Progress.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Surface_border.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fit_local_surface.h>
#include <CGAL/Curvature_aware_simplification_3/internal/loops.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// A sample with the surface that it moves on
struct Surface_sample
{
  Local_surface surface;
  Surface_border border;
  double a = 0., b = 0.; // position on the surface
  double spacing = 0.;   // wanted distance to its neighbors, s
  Point point = Point(0., 0., 0.);
  Vector normal = Vector(0., 0., 1.);

  void move_to(double new_a, double new_b)
  {
    a = new_a;
    b = new_b;
    point = surface.point(a, b);
    normal = surface.normal(a, b);
  }

  // fits the surface around x, and puts the sample on it
  void place(const Surface_fit& fit, const Point& x, const Vector& guess)
  {
    static thread_local Neighborhood neighborhood;
    surface = fit_local_surface(fit, x, guess, surface.neighbors, neighborhood);
    border = fit.settings.keep_borders ? find_border(neighborhood, surface) : Surface_border();
    double at_a = 0., at_b = 0.;
    border.restrict(at_a, at_b);
    move_to(at_a, at_b);
  }
};

// Second term of eq. 8 in the tangent plane of the sample: the mean of (x - x_i) with the weights
// beta_i phi_2.
//
// Distances are measured in spacings, rho = |x - x_i| / s. phi_2 = s_i^2: where n phi_2 is the same
// everywhere, the forces balance, so the density n of the samples tends to what is wanted, 1 / s^2;
// it falls with the curvature as in eq. 3 and 4.
inline Vector tangential_repulsion(const std::vector<Surface_sample>& samples,
                                   const Neighbor_search& search, std::size_t sample,
                                   const Adaptive_settings& settings)
{
  constexpr double reach = 2.; // in spacings, where theta has fallen to 0.0025: two rings
  const Surface_sample& x = samples[sample];
  const double inverse = 1. / (x.spacing * x.spacing);
  Vector sum(0., 0., 0.);
  double weight = 0.;
  search.for_each_within(x.point, reach * x.spacing,
                         [&](std::size_t i, const Point& x_i, double squared_distance)
                         {
    if (squared_distance == 0.) // itself; of others, no direction leads away
      return;
    const Vector d = x.point - x_i;
    const double h = d * x.normal;
    const Vector t = d - h * x.normal;
    const double rho2 = (t.squared_length() + settings.weight_of_height * h * h) * inverse;
    const double phi = samples[i].spacing * samples[i].spacing * inverse;
    const double beta = std::exp(-settings.sharpness_of_repulsion * rho2) / std::sqrt(rho2) * phi;
    sum = sum + beta * t;
    weight += beta;
  });
  return weight > 0. ? sum / weight : Vector(0., 0., 0.);
}

// One iteration for all samples at once. The first term of eq. 8, which draws samples to the input,
// has become the surface that each sample moves on: it is exact to third order, where a mean is to
// first, and is fitted again when the sample leaves the part that it was fitted to.
template <typename ConcurrencyTag>
std::vector<Surface_sample> relax_on_surface(const std::vector<Surface_sample>& samples,
                                             const Surface_fit& fit, double repulsion_weight,
                                             const Progress& progress)
{
  constexpr double trusted = 0.7; // of the radius of a fit: half of its area
  std::vector<Point> points(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i)
    points[i] = samples[i].point;
  const Neighbor_search search(points, ConcurrencyTag());

  std::vector<Surface_sample> moved = samples;
  for_each_index<ConcurrencyTag>(samples.size(), progress,
                                 [&](std::size_t i)
                                 {
    Surface_sample& x = moved[i];
    Vector step = repulsion_weight * tangential_repulsion(samples, search, i, fit.settings);
    const double length = std::sqrt(step.squared_length());
    if (length > 0.5 * x.spacing) // further, and neighbors could pass each other
      step = step * (0.5 * x.spacing / length);
    double a = x.a + step * x.surface.u, b = x.b + step * x.surface.v;
    x.border.restrict(a, b);
    const double distance = std::sqrt(a * a + b * b);
    if (distance <= trusted * x.surface.radius)
    {
      x.move_to(a, b);
      return;
    }
    // beyond the fit, it is followed for half its radius at most
    const double part = (std::min)(1., 1.5 * x.surface.radius / distance);
    x.place(fit, x.surface.point(part * a, part * b), x.surface.normal(part * a, part * b));
  });
  return moved;
}

// The wanted spacings as the mean over a sample and its 8 nearest, in logarithms: what one ball
// measures is rough, and samples can only follow what varies slowly.
template <typename ConcurrencyTag>
void smooth_spacings(std::vector<Surface_sample>& samples)
{
  std::vector<Point> points(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i)
    points[i] = samples[i].point;
  const Neighbor_search search(points, ConcurrencyTag());
  const std::size_t k = (std::min)(std::size_t(9), samples.size());
  std::vector<double> smooth(samples.size());
  for_each_index<ConcurrencyTag>(0, samples.size(),
                                 [&](std::size_t i)
                                 {
    double sum = 0.;
    search.for_each_nearest(points[i], k,
                            [&](std::size_t j, const Point&, double)
                            { sum += std::log(samples[j].spacing); });
    smooth[i] = std::exp(sum / static_cast<double>(k));
  });
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i].spacing = smooth[i];
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_RELAX_ON_SURFACE_H
