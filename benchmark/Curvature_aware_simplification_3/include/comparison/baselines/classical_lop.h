#ifndef CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_CLASSICAL_LOP_H
#define CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_CLASSICAL_LOP_H

#include <comparison/baselines/random_subset.h>
#include <comparison/types.h>

#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace comparison {

// The locally optimal projection (Lipman et al. 2007) of particles onto the points.
//
//   x' = sum_j alpha_j p_j / sum_j alpha_j + mu sum_i beta_i (x - x_i) / sum_i beta_i       (eq. 7)
//   alpha_j = theta(r) / r, beta_i = theta(r) / r |eta'(r)|, theta(r) = exp(-16 r^2 / h^2),
//   eta(r) = 1 / (3 r^3), so that |eta'(r)| = r^-4,
//
// with r the distance of x to p_j or x_i. At r = h, theta has fallen to 1e-7, and the sums end.
class Locally_optimal_projection
{
public:
  // h is the support of theta; mu below 1/2 makes the operator converge, 0.45 is Lipman's choice
  Locally_optimal_projection(const Points& points, double h, double mu = 0.45)
    : m_search(points, Tag()), m_h(h), m_mu(mu)
  {}

  // The first iteration is the mean with the weights theta and without repulsion (Lipman et al.,
  // sec. 3): particles start on points, where alpha is infinite.
  Points first_iteration(const Points& particles) const
  {
    return for_each_particle(particles, [&](const Point& x) { return x + attraction(x, 0.); });
  }

  Points iteration(const Points& particles) const
  {
    const Neighbor_search others(particles, Tag());
    return for_each_particle(particles, [&](const Point& x) {
      return x + attraction(x, 1.) + m_mu * repulsion(x, others);
    });
  }

private:
  using Neighbor_search = CGAL::Curvature_aware_simplification_3::internal::Neighbor_search;

  template <typename Move>
  static Points for_each_particle(const Points& particles, const Move& move)
  {
    Points moved(particles.size());
    CGAL::Curvature_aware_simplification_3::internal::for_each_index<Tag>(
        0, particles.size(), [&](std::size_t i) { moved[i] = move(particles[i]); });
    return moved;
  }

  double theta(double squared_distance) const
  {
    return std::exp(-16. * squared_distance / (m_h * m_h));
  }

  // "A very small value added to all denominators" (paper, sec. 5), in the unit h: it only
  // eliminates a division by 0.
  static constexpr double tiny = 1e-12;

  // mean of p_j - x with the weights theta(r) / r^exponent; none if no point is near
  Vector attraction(const Point& x, double exponent) const
  {
    return mean_within(m_search, x, 1., [&](double squared_distance) {
      return theta(squared_distance) / std::pow(std::sqrt(squared_distance) / m_h + tiny, exponent);
    });
  }

  // mean of x - x_i with the weights theta(r) / r^5, over all other particles. Of those at the same
  // place no direction leads away.
  Vector repulsion(const Point& x, const Neighbor_search& others) const
  {
    return mean_within(others, x, -1., [&](double squared_distance) {
      return squared_distance > 0.
                 ? theta(squared_distance) / std::pow(std::sqrt(squared_distance) / m_h + tiny, 5)
                 : 0.;
    });
  }

  template <typename Weight>
  Vector mean_within(const Neighbor_search& search, const Point& x, double sign,
                     const Weight& weight) const
  {
    double sum = 0.;
    Vector weighted_sum(0., 0., 0.);
    search.for_each_within(x, m_h, [&](std::size_t, const Point& p, double squared_distance) {
      const double w = weight(squared_distance);
      sum += w;
      weighted_sum = weighted_sum + w * (p - x);
    });
    return sum > 0. ? sign / sum * weighted_sum : Vector(0., 0., 0.);
  }

  Neighbor_search m_search;
  double m_h;
  double m_mu;
};

// min(n, M) particles from a uniform random subset, after the first and `iterations` more
// iterations
inline Points classical_lop(const Points& points, std::size_t n, double h, std::size_t iterations,
                            std::uint64_t seed = 0)
{
  const Locally_optimal_projection projection(points, h);
  Points particles = projection.first_iteration(random_subset(points, n, seed));
  for (std::size_t i = 0; i < iterations; ++i)
    particles = projection.iteration(particles);
  return particles;
}

} // namespace comparison

#endif // CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_CLASSICAL_LOP_H
