// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_SURFACE_FIT_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_SURFACE_FIT_H

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Neighborhood.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Noise.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/Adaptive_settings.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// With that, no points are sparse.
inline constexpr double infinite_inverse_density = std::numeric_limits<double>::infinity();

// How a local surface is fitted to the input at a place
struct Surface_fit
{
  const Neighbor_search& search;
  const Noise& noise = no_noise; // of the points near the place
  const Adaptive_settings& settings = default_settings;
  double sparse_inverse_density = infinite_inverse_density; // 1 / rho of points far from others

  bool points_share_noise() const { return noise.level < noise.independent_level; }
};

// The same at any place: each has its own noise.
struct Surface_fitter
{
  const Neighbor_search& search;
  const Adaptive_settings& settings = default_settings;
  double sparse_inverse_density = infinite_inverse_density;

  Surface_fit at(const Noise& noise) const
  {
    return {search, noise, settings, sparse_inverse_density};
  }
  Surface_fit at(Noise&&) const = delete; // it is referred to
};

// 18 neighbors, two rings around a point: three for each coefficient of a quadric
inline constexpr std::size_t smallest_neighborhood = 19;

// A fit to more than a third of all points does not tell what is between them: samples of 19 to 45
// points on a sphere would be up to 0.7 to 0.4 of its radius off it, of 57 points 0.14.
inline constexpr std::size_t fewest_points_to_fit = 3 * smallest_neighborhood;
// Four doublings above. Then noise is down to sigma / 7, and time grows faster than accuracy.
inline constexpr std::size_t largest_neighborhood = 16 * 18 + 1;
// Where a ball surely holds more than are taken, it does not matter how many more.
inline constexpr double too_many_neighbors = 2. * largest_neighborhood;
static_assert(Adaptive_settings().points_of_widest_fit == 2 * largest_neighborhood,
              "the widest fit has twice the points of the largest neighborhood");
// In units of sigma. In a ball of that radius, the layer of noisy points looks flat; in a much
// smaller one it looks as thick as wide and has no normal.
inline constexpr double smallest_radius_in_noise = 7.;

// Collects the neighbors of x that a fit needs: `smallest` nearest, or all in the ball that noise
// asks for. `expected_neighbors` is about how many points are in that ball, or 0 if not known.
inline void collect_neighbors(const Surface_fit& fit, const Point& x, std::size_t smallest,
                              double wanted_radius, std::size_t expected_neighbors,
                              Neighborhood& neighborhood)
{
  neighborhood.neighbors.clear();
  smallest = (std::min)(smallest, fit.search.size());
  const std::size_t largest = (std::min)(largest_neighborhood, fit.search.size());
  if (expected_neighbors <= smallest)
  {
    neighborhood.collect(fit.search, x, smallest);
    if (neighborhood.radius >= wanted_radius || smallest == largest)
      return;
    // points on a surface grow with the square of the radius
    const double ratio = wanted_radius / neighborhood.radius; // may be infinite
    expected_neighbors = static_cast<std::size_t>(
        (std::min)(ratio * ratio * static_cast<double>(smallest), too_many_neighbors));
  }
  if (expected_neighbors < 2 * largest) // otherwise the ball holds more anyway
  {
    neighborhood.collect_within(fit.search, x, wanted_radius, largest);
    if (neighborhood.size() < smallest)
      neighborhood.collect(fit.search, x, smallest);
    if (neighborhood.size() <= largest)
      return;
  }
  neighborhood.collect(fit.search, x, largest);
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_SURFACE_FIT_H
