#ifndef CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_MLS_PARTICLE_SIMULATION_H
#define CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_MLS_PARTICLE_SIMULATION_H

#include <comparison/baselines/point_set_surface.h>
#include <comparison/baselines/principal_axes.h>
#include <comparison/baselines/random_subset.h>
#include <comparison/types.h>

#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace comparison {

struct Particle_simulation_parameters
{
  double force_constant = 0.5; // k
  double scale = 0.01;         // s, infinity for particles spread evenly
  double radius = 1.;          // c
  std::size_t iterations = 40;
  std::size_t number_of_neighbors = 24; // of the moving least squares
  bool adapts_initial_spreading = true; // false: a uniform random subset of the points
  std::uint64_t random_seed = 0;
};

// Particle simulation on the moving least squares surface (Pauly et al. 2002, sec. 3.3).
//
// A particle at x is repulsed by those at x_i within the radius r,
//
//   F(x) = k sum_i (r - |x - x_i|) (x - x_i) / r,
//
// moves by F and back onto the tangent plane at the nearest point; at the end it is projected onto
// the surface. The division by r makes k a number without unit. The radius is scaled by the inverse
// of the surface variation sigma, softly bounded, for a pair by that of its mean:
//
//   r = R / (1 + sigma / s),
//
// so s is the variation that halves the radius. R is c times the spacing that particles spread in
// this way have on a hexagonal lattice. The force vanishes at the distance 0 as at r, so that for c
// much above 1, with several particles inside the radius, they clump.
class Particle_simulation
{
public:
  Particle_simulation(const Points& points, const Particle_simulation_parameters& parameters)
    : m_parameters(parameters), m_points(points), m_search(points, Tag()), m_local(points.size())
  {
    CGAL::Curvature_aware_simplification_3::internal::for_each_index<Tag>(
        0, points.size(), [&](std::size_t i) { m_local[i] = local(points[i]); });
  }

  Points run(std::size_t n) const
  {
    // how many particles each point calls for, up to a factor
    std::vector<double> demand(m_points.size());
    for (std::size_t j = 0; j < demand.size(); ++j)
      demand[j] = m_local[j].area * m_local[j].density * m_local[j].density;
    const double sum = std::accumulate(demand.begin(), demand.end(), 0.);
    // a hexagonal lattice of spacing d has 2 / (sqrt(3) d^2) points per area
    const double spacing = std::sqrt(2. / std::sqrt(3.) * sum / static_cast<double>(n));

    Points particles = m_parameters.adapts_initial_spreading
                           ? random_subset(m_points, demand, n, m_parameters.random_seed)
                           : random_subset(m_points, n, m_parameters.random_seed);
    for (std::size_t i = 0; i < m_parameters.iterations; ++i)
      particles = iteration(particles, m_parameters.radius * spacing);

    const Point_set_surface surface(m_points, m_parameters.number_of_neighbors);
    return transformed(particles, [&](std::size_t i) { return surface.project(particles[i]); });
  }

  // one step of all particles, with R = `radius`
  Points iteration(const Points& particles, double radius) const
  {
    const Neighbor_search others(particles, Tag());
    std::vector<double> density(particles.size());
    CGAL::Curvature_aware_simplification_3::internal::for_each_index<Tag>(
        0, particles.size(),
        [&](std::size_t i) { density[i] = m_local[nearest(particles[i])].density; });
    return transformed(particles, [&](std::size_t i) {
      const Point x =
          particles[i] + displacement(particles[i], density[i], radius, others, density);
      const Principal_axes& plane = m_local[nearest(x)].axes;
      return x - ((x - plane.center) * plane.axes[0]) * plane.axes[0];
    });
  }

private:
  using Neighbor_search = CGAL::Curvature_aware_simplification_3::internal::Neighbor_search;

  struct Local
  {
    Principal_axes axes; // of a point's neighborhood
    double area;         // of its share of the surface
    double density;      // 1 + sigma / s, the inverse of its particles' distance up to a factor
  };

  // from 16 neighbors, as the variation of this package
  Local local(const Point& p) const
  {
    const std::size_t size = std::min<std::size_t>(17, m_points.size());
    double largest = 0.;
    Moments moments(p);
    m_search.for_each_nearest(p, size, [&](std::size_t, const Point& q, double squared_distance) {
      moments.add(1., q);
      largest = std::max(largest, squared_distance);
    });
    const Principal_axes axes = moments.principal_axes();
    return {axes, CGAL_PI * largest / static_cast<double>(size),
            1. + axes.variation() / m_parameters.scale};
  }

  std::size_t nearest(const Point& x) const
  {
    std::size_t result = 0;
    m_search.for_each_nearest(x, 1, [&](std::size_t j, const Point&, double) { result = j; });
    return result;
  }

  // F, at most half the own radius: farther away, the tangent plane is another
  Vector displacement(const Point& x, double own_density, double radius,
                      const Neighbor_search& others, const std::vector<double>& density) const
  {
    const double own_radius = radius / own_density;
    Vector sum(0., 0., 0.);
    // no pair's radius is above twice the smaller one
    others.for_each_within(x, 2. * own_radius,
                           [&](std::size_t i, const Point& x_i, double squared_distance) {
                             const double r = 2. * radius / (own_density + density[i]);
                             const double distance = std::sqrt(squared_distance);
                             if (distance < r)
                               sum = sum + (r - distance) / r * (x - x_i);
                           });
    sum = m_parameters.force_constant * sum;
    const double length = std::sqrt(sum.squared_length());
    return length > own_radius / 2. ? own_radius / 2. / length * sum : sum;
  }

  template <typename Position>
  static Points transformed(const Points& particles, const Position& position)
  {
    Points result(particles.size());
    CGAL::Curvature_aware_simplification_3::internal::for_each_index<Tag>(
        0, particles.size(), [&](std::size_t i) { result[i] = position(i); });
    return result;
  }

  Particle_simulation_parameters m_parameters;
  const Points& m_points;
  Neighbor_search m_search;
  std::vector<Local> m_local;
};

// min(n, M) particles
inline Points mls_particle_simulation(const Points& points, std::size_t n,
                                      const Particle_simulation_parameters& parameters = {})
{
  return Particle_simulation(points, parameters).run(n);
}

} // namespace comparison

#endif // CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_MLS_PARTICLE_SIMULATION_H
