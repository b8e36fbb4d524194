// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PAPER_RELAX_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PAPER_RELAX_H

#include <CGAL/Curvature_aware_simplification_3/internal/paper/Curvature_weights.h>
#include <CGAL/Curvature_aware_simplification_3/internal/paper/Theta.h>
#include <CGAL/Curvature_aware_simplification_3/internal/paper/density_weights.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The input points as eq. 8 sees them
struct Attractors
{
  const Neighbor_search& search;
  std::vector<double> weight; // phi_1(kappa_j), over the density v_j if that is wanted
};

// What stays the same in all iterations
struct Relaxation
{
  double radius;            // h, the support of theta
  double repulsion_weight;  // mu
  bool use_density_weights; // of Huang et al. (2009)
};

// One term of eq. 8: a weighted mean
class Weighted_mean
{
public:
  void add(double weight, const Vector& v)
  {
    m_weighted_sum = m_weighted_sum + weight * v;
    m_weight += weight;
  }

  // the null vector if nothing was added
  Vector mean() const { return m_weight > 0. ? m_weighted_sum / m_weight : Vector(0., 0., 0.); }

private:
  Vector m_weighted_sum = Vector(0., 0., 0.);
  double m_weight = 0.;
};

// What a sample meets in its ball of radius h
struct Attraction
{
  Vector mean;                        // first term of eq. 8, relative to the sample
  std::optional<std::size_t> nearest; // input point, if any is in the ball
};

// The mean of (p_j - x) with the weights alpha_j phi_1(kappa_j), alpha_j = theta(r) / r, r = |x -
// p_j|
inline Attraction attraction(const Attractors& attractors, const Point& x, double radius)
{
  const Theta theta(radius);
  // "A very small value added to all denominators" (paper, sec. 5), small against h: a sample that
  // lies on an input point is held by it.
  const double tiny = 1e-6 * radius;

  Weighted_mean mean;
  std::optional<std::size_t> nearest;
  double least = std::numeric_limits<double>::infinity();
  attractors.search.for_each_within(
      x, radius, [&](std::size_t j, const Point& p, double squared_distance) {
        if (squared_distance < least)
        {
          least = squared_distance;
          nearest = j;
        }
        const double alpha = theta(squared_distance) / (std::sqrt(squared_distance) + tiny);
        mean.add(alpha * attractors.weight[j], p - x);
      });
  return {mean.mean(), nearest};
}

// Second term of eq. 8: the mean of (x - x_i) with the weights beta_i phi_2(kappa, kappa_i),
// beta_i = theta(r) / r |eta'(r)| with eta(r) = -r (Huang et al. 2009), so |eta'| = 1.
// `density` holds the weights w_i of Huang et al., or is empty.
inline Vector repulsion(const std::vector<Point>& samples, const Neighbor_search& search,
                        const std::vector<double>& amplitude, const std::vector<double>& density,
                        double radius, std::size_t sample)
{
  const Theta theta(radius);
  const Point& x = samples[sample];

  Weighted_mean mean;
  search.for_each_within(x, radius, [&](std::size_t i, const Point& x_i, double squared_distance) {
    if (squared_distance == 0.) // the sample itself; of others, no direction leads away
      return;
    const double beta = theta(squared_distance) / std::sqrt(squared_distance);
    const double phi = Curvature_weights::repulsion(amplitude[sample], amplitude[i]);
    mean.add(beta * phi * (density.empty() ? 1. : density[i]), x - x_i);
  });
  return mean.mean();
}

// One iteration of eq. 8 for all samples at once; `curvature_at(x, nearest)` is the scaled surface
// variation of a sample at x, whose nearest input point is known if it is in the ball. O(N (log M +
// neighbors))
template <typename ConcurrencyTag, typename CurvatureAt>
std::vector<Point> relax(const std::vector<Point>& samples, const Attractors& attractors,
                         const Curvature_weights& curvature_weights, const Relaxation& relaxation,
                         const CurvatureAt& curvature_at, const Progress& progress)
{
  const std::size_t n = samples.size();
  const double h = relaxation.radius;
  std::vector<Vector> attracted(n);
  std::vector<double> amplitude(n);
  for_each_index<ConcurrencyTag>(n, progress.part(0., 0.8), [&](std::size_t i) {
    const Attraction found = attraction(attractors, samples[i], h);
    attracted[i] = found.mean;
    amplitude[i] = curvature_weights.repulsion_amplitude(curvature_at(samples[i], found.nearest));
  });

  const Neighbor_search search(samples, ConcurrencyTag());
  std::vector<double> density;
  if (relaxation.use_density_weights)
    density = density_weights<ConcurrencyTag>(samples, search, h, progress.part(0.8, 0.8));
  std::vector<Point> moved(n);
  for_each_index<ConcurrencyTag>(n, progress.part(0.8, 1.), [&](std::size_t i) {
    moved[i] = samples[i] + attracted[i] +
               relaxation.repulsion_weight * repulsion(samples, search, amplitude, density, h, i);
  });
  return moved;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PAPER_RELAX_H
