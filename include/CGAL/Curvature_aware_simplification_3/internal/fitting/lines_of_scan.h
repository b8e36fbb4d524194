// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_LINES_OF_SCAN_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_LINES_OF_SCAN_H

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Local_surface.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Neighborhood.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Parabola_sums.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Surface_fit.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/fit_quadric.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/principal_axes.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Whether the neighbors do not tell the height at the center, whatever is left out of them: noise
// would be larger there than at a point, and visibly so. The center is between two lines of a scan,
// whose lines are farther apart than the points on them; of 19 random points, less than 1 % are so
// badly placed.
inline bool is_between_lines(const Surface_fit& fit, const Neighborhood& neighborhood,
                             const Local_surface& surface)
{
  const auto is_unknown = [&](const Local_surface& s) {
    return s.amplification > 1. &&
           s.amplification * fit.noise.independent_level > fit.noise.visible_error;
  };
  if (!is_unknown(surface))
    return false;
  static thread_local Neighborhood all; // whatever was left out
  all = neighborhood;
  all.weight_by_distance();
  Local_surface of_all = surface;
  return fit_quadric(all, fit.noise.independent_level, of_all) && is_unknown(of_all);
}

// Whether the neighbors are on one line of a scan, whose lines are much farther apart than the
// points on them. They tell the height at the center, but the surface turns about the line: without
// noise, as the line bends.
inline bool is_on_line(const Surface_fit& fit, const Local_surface& surface)
{
  // without what noise gives a line
  const double squared_width = surface.width * surface.width - fit.noise.level * fit.noise.level;
  return surface.radius > 0. &&
         squared_width < least_breadth * least_breadth * surface.length * surface.length;
}

// The width across a line that bends in the plane of the surface: of y over a parabola in x, which
// is along the line
inline double width_across_parabola(const Neighborhood& neighborhood, const Local_surface& surface)
{
  const Vector along = line_direction(neighborhood);
  const Vector across = cross_product(surface.n, along);
  Parabola_sums<1> sums;
  double sum_of_squares = 0.;
  for (const Neighborhood::Neighbor& neighbor : neighborhood.neighbors)
  {
    const double x = neighbor.position * along / neighborhood.radius;
    const double y = neighbor.position * across / neighborhood.radius;
    sums.add(x, Parabola_sums<1>::Value(y), neighbor.weight);
    sum_of_squares += neighbor.weight * y * y;
  }
  const double left = sum_of_squares - sums.coefficients().col(0).dot(sums.right.col(0));
  return neighborhood.radius * std::sqrt((std::max)(left, 0.) / sums.matrix(0, 0));
}

// Whether the neighbors are on one line that bends, maybe more than a parabola tells: with as few
// as 19, chance would decide.
inline bool is_on_bent_line(const Neighborhood& neighborhood, const Local_surface& surface)
{
  if (neighborhood.is_along_curve())
    return true;
  static thread_local Neighborhood all; // whatever was left out
  all = neighborhood;
  all.weight_by_distance();
  return width_across_parabola(all, surface) < least_breadth * surface.length;
}

// The line that neighbors are on
struct Line_of_points
{
  Point center;
  Vector direction;
  double radius; // of the ball that holds them
};

inline Line_of_points line_of_points(const Neighborhood& neighborhood)
{
  return {neighborhood.center + covariance_sums(neighborhood).mean(), line_direction(neighborhood),
          neighborhood.radius};
}

// Whether there are points on both sides of the line in a plane through it, as where it is one of
// the lines of a scan. Beside a wire or a pole, there is nothing or, farther away, the ground or
// another wire. Lines within twice the radius are those of a scan: up to 19 times the distance of
// the points on them. With 1.5 or 2.5, errors of scans in lines, 2 to 60 times as dense along as
// across, are the same within 1 %: where lines are farther apart, samples stay on them anyway. Lines
// nearer than half the radius would have been among the neighbors, which are less than 0.05 as wide
// as long. So the ball has room for eight lines with 38 points each; if it holds twice as many, it
// may hold any number, and something much denser is in it, which is no line of the same scan.
inline bool has_lines_beside(const Line_of_points& line, const Vector& normal,
                             const Neighbor_search& search)
{
  constexpr double off_the_line = 0.5, farthest = 2.; // in radii
  constexpr std::size_t most = 2 * 8 * 38;
  const Vector across = cross_product(normal, line.direction);
  static thread_local Neighborhood around;
  around.collect_within(search, line.center, farthest * line.radius, most);
  bool below = false, above = false;
  for (const Neighborhood::Neighbor& neighbor : around.neighbors)
  {
    const double side = neighbor.position * across, height = neighbor.position * normal;
    const bool is_off =
        std::abs(side) >= off_the_line * line.radius && std::abs(side) >= std::abs(height);
    below = below || (is_off && side < 0.);
    above = above || (is_off && side > 0.);
  }
  return below && above && around.size() <= most;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FITTING_LINES_OF_SCAN_H
