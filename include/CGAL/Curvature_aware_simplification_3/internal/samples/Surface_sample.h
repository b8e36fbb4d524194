// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SAMPLES_SURFACE_SAMPLE_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SAMPLES_SURFACE_SAMPLE_H

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Noise.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Surface_border.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/fit_local_surface.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/is_in_gap.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

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
  double a = 0., b = 0.;           // position on the surface
  double spacing = 0.;             // wanted distance to its neighbors, s
  const Noise* noise = &no_noise;  // of the input around, of the levels of the scan
  Point point = Point(0., 0., 0.); // at (a, b), until the projection moves it off the surface

  Vector normal() const { return surface.normal(a, b); }

  void move_to(double new_a, double new_b)
  {
    a = new_a;
    b = new_b;
    point = surface.point(a, b);
  }

  // Fits the surface around x in so many rounds, and puts the sample on it. In a gap of the input,
  // or beside all of it, where that is no more than a guess, it goes back to the nearest point of
  // the input. Returns the point of the input that is nearest to the sample. `x` and `guess` may be
  // its own, which the first fit replaces.
  Point place(const Surface_fit& fit, Point x, Vector guess, int rounds)
  {
    static thread_local Neighborhood neighborhood;
    fit_and_move(fit, x, guess, rounds, neighborhood);
    if (!(neighborhood.radius > 0.))
      return point;
    const Point nearest = neighborhood.nearest(point);
    const Points_around around(neighborhood.radius, neighborhood.size());
    if (!is_in_gap(fit, point, nearest, around, surface.is_curve) && !is_beside_neighbors(fit))
      return nearest;
    fit_and_move(fit, nearest, guess, rounds, neighborhood);
    return neighborhood.nearest(point);
  }

private:
  // Whether the height is known less well than that of a point, as beside a pole: one sample in
  // twenty was up to half of the spacing off. Across a curve, it is not known, and not asked for.
  // Without noise, points tell more: only where they are sparse, it has to be known much less well.
  bool is_beside_neighbors(const Surface_fit& fit) const
  {
    if (surface.is_curve)
      return false;
    if (fit.noise.independent_level > 0.)
      return surface.amplification > 1.;
    return surface.amplification > fit.settings.largest_amplification &&
           surface.radius * surface.radius >
               fit.sparse_inverse_density * static_cast<double>(surface.neighbors);
  }

  void fit_and_move(const Surface_fit& fit, const Point& x, const Vector& guess, int rounds,
                    Neighborhood& neighborhood)
  {
    surface = fit_local_surface(fit, x, guess, surface, rounds, neighborhood);
    border = fit.settings.keep_borders ? find_border(neighborhood, surface) : Surface_border();
    double at_a = 0., at_b = 0.;
    border.move_back(at_a, at_b);
    move_to(at_a, at_b);
  }
};

template <typename ConcurrencyTag>
std::vector<Point> points_of(const std::vector<Surface_sample>& samples)
{
  std::vector<Point> points(samples.size());
  for_each_index<ConcurrencyTag>(0, samples.size(),
                                 [&](std::size_t i) { points[i] = samples[i].point; });
  return points;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_SAMPLES_SURFACE_SAMPLE_H
