// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_NEIGHBORHOOD_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_NEIGHBORHOOD_H

#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// (1 - r^2 / R^2)^2: smooth, and 0 at the border, so that a point that enters a neighborhood makes
// no difference. One that is alone on the border keeps a trace of weight.
class Weight_by_distance
{
public:
  explicit Weight_by_distance(double radius) : m_factor(1. / (1.0001 * radius * radius)) {}

  double operator()(double squared_distance) const
  {
    const double t = 1. - m_factor * squared_distance;
    return t * t;
  }

private:
  double m_factor;
};

// The nearest input points of a point, relative to it, and the weight of each in a fit. Made to be
// reused, so that a thread allocates memory once.
struct Neighborhood
{
  struct Neighbor
  {
    Vector position; // relative to the center
    double squared_distance;
    double weight;
  };

  Point center = Point(0., 0., 0.);
  std::vector<Neighbor> neighbors;
  double radius = 0.; // distance of the farthest

  void collect(const Neighbor_search& search, const Point& query, std::size_t k)
  {
    center = query;
    neighbors.clear();
    double squared_radius = 0.;
    search.for_each_nearest(query, k, [&](std::size_t, const Point& p, double squared_distance) {
      squared_radius = (std::max)(squared_radius, squared_distance);
      neighbors.push_back({p - query, squared_distance, 1.});
    });
    radius = std::sqrt(squared_radius);
  }

  // All in the ball; far fewer operations than for as many nearest ones. If there are more than
  // `most`, only some of them, but more than that.
  void collect_within(const Neighbor_search& search, const Point& query, double ball_radius,
                      std::size_t most = (std::numeric_limits<std::size_t>::max)())
  {
    center = query;
    neighbors.clear();
    radius = ball_radius;
    search.for_each_within(
        query, ball_radius,
        [&](std::size_t, const Point& p, double squared_distance) {
          neighbors.push_back({p - query, squared_distance, 1.});
        },
        most);
  }

  // those of another neighborhood that are in the ball
  void take_within(const Neighborhood& other, const Point& query, double ball_radius)
  {
    center = query;
    radius = ball_radius;
    const Vector offset = other.center - query;
    // Each is written, and the next one over it if it is outside: a branch would be guessed wrong
    // as often as not. A noisy call takes 5 % less.
    neighbors.resize(other.size());
    std::size_t number = 0;
    for (const Neighbor& neighbor : other.neighbors)
    {
      const Vector position = neighbor.position + offset;
      const double squared_distance = position.squared_length();
      neighbors[number] = {position, squared_distance, 1.};
      number += squared_distance <= ball_radius * ball_radius ? 1 : 0;
    }
    neighbors.resize(number);
  }

  // An even part of the neighbors, if there are more than `most`. A search hands on what is in one
  // leaf of its tree after the other, so that every m-th is from all of the ball.
  void thin(std::size_t most)
  {
    if (neighbors.size() <= most)
      return;
    const std::size_t step = (neighbors.size() + most - 1) / most;
    std::size_t number = 0;
    for (std::size_t i = 0; i < neighbors.size(); i += step)
      neighbors[number++] = neighbors[i];
    neighbors.resize(number);
  }

  std::size_t size() const { return neighbors.size(); }

  // Whether the neighbors are along a curve, however it bends: half of those are in the inner half
  // of the ball, of a surface only a quarter. The center is on it.
  bool is_along_curve() const
  {
    constexpr double between = 3. / 8.;
    const double squared_radius = radius * radius / 4.;
    const auto inner =
        std::count_if(neighbors.begin(), neighbors.end(), [&](const Neighbor& neighbor) {
          return neighbor.squared_distance < squared_radius;
        });
    return static_cast<double>(inner) > between * static_cast<double>(size());
  }

  // the neighbor nearest to x; there is at least one
  Point nearest(const Point& x) const
  {
    const Vector offset = center - x;
    const auto found = std::min_element(
        neighbors.begin(), neighbors.end(), [&](const Neighbor& p, const Neighbor& q) {
          return (p.position + offset).squared_length() < (q.position + offset).squared_length();
        });
    return center + found->position;
  }

  // The weights vanish at the border of the ball, or at a distance of `support` that is larger.
  void weight_by_distance() { weight_by_distance(radius); }

  void weight_by_distance(double support)
  {
    weight_by_distance(support, [](const Neighbor& neighbor) { return neighbor.squared_distance; });
  }

  template <typename SquaredDistance>
  void weight_by_distance(double support, const SquaredDistance& squared_distance)
  {
    const Weight_by_distance weight(support);
    for (Neighbor& neighbor : neighbors)
      neighbor.weight = weight(squared_distance(neighbor));
  }
};

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_NEIGHBORHOOD_H
