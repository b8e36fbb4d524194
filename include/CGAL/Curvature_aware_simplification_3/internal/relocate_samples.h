// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_RELOCATE_SAMPLES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_RELOCATE_SAMPLES_H

#include <CGAL/Curvature_aware_simplification_3/internal/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Sample_neighbors.h>
#include <CGAL/Curvature_aware_simplification_3/internal/loops.h>
#include <CGAL/Curvature_aware_simplification_3/internal/move_to_targets.h>
#include <CGAL/Curvature_aware_simplification_3/internal/relax_on_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Samples around a point, relative to it, in the plane with the normal n through it
class Surrounding_samples
{
public:
  Surrounding_samples(const Point& center, const Vector& normal) : m_center(center)
  {
    m_plane.n = normal;
    m_plane.complete_frame();
  }

  // Only those that are seen under less than 60 degrees from the plane: others are on another sheet.
  void add(const Point& sample)
  {
    const Vector position = sample - m_center;
    const double a = position * m_plane.u, b = position * m_plane.v;
    const double squared_distance = a * a + b * b, height = position * m_plane.n;
    if (height * height < 3. * squared_distance)
      m_samples[m_size++] = {position, a, b, squared_distance};
  }

  // Distance of the center from the triangle over it in the Delaunay triangulation of the nearest samples
  // in the plane, an estimate of how far it is from a surface reconstructed from them. Infinity if there
  // is no triangle.
  //
  // Of all triangles around the center, with barycentric coordinates w_i there, it is the one of least
  // sum w_i |a_i|^2: the height over the center of the lower hull of the samples lifted to a paraboloid.
  double distance_to_triangle()
  {
    // the ring around the center, and some more
    constexpr std::size_t most = 9;
    const std::size_t n = (std::min)(most, m_size);
    std::partial_sort(m_samples.begin(), m_samples.begin() + static_cast<std::ptrdiff_t>(n),
                      m_samples.begin() + static_cast<std::ptrdiff_t>(m_size),
                      [](const Sample& s, const Sample& t)
                      { return s.position.squared_length() < t.position.squared_length(); });
    double least = std::numeric_limits<double>::infinity(), distance = least;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 1; j < n; ++j)
        for (std::size_t k = j + 1; k < n; ++k)
        {
          const Sample &p = m_samples[i], &q = m_samples[j], &r = m_samples[k];
          // twice the areas of the triangles of the center and two of them, with one sign if it is inside
          const double of_p = cross(q, r), of_q = cross(r, p), of_r = cross(p, q);
          const double area = of_p + of_q + of_r;
          if (!(of_p * area >= 0. && of_q * area >= 0. && of_r * area >= 0. && area != 0.))
            continue;
          const double height =
              (of_p * p.squared_distance + of_q * q.squared_distance + of_r * r.squared_distance) /
              area;
          if (height < least)
          {
            least = height;
            const Vector normal = cross_product(q.position - p.position, r.position - p.position);
            distance = std::abs(normal * p.position) / std::sqrt(normal.squared_length());
          }
        }
    return distance;
  }

private:
  struct Sample
  {
    Vector position = Vector(0., 0., 0.);
    double a = 0., b = 0., squared_distance = 0.; // in the plane
  };

  static double cross(const Sample& s, const Sample& t) { return s.a * t.b - s.b * t.a; }

  Point m_center;
  Local_surface m_plane;
  std::array<Sample, Sample_neighbors::most + 1> m_samples; // neighbors of a sample, and itself
  std::size_t m_size = 0;
};

// How far the surface would be from a sample if it were not there
template <typename Neighbors>
double distance_without(const Surface_sample& x, const Neighbors& neighbors,
                        const std::vector<Point>& points)
{
  Surrounding_samples surrounding(x.point, x.normal);
  for (std::size_t i : neighbors)
    surrounding.add(points[i]);
  return surrounding.distance_to_triangle();
}

// The point of the input that is farthest from the surface of the samples, of those nearest to one sample
struct Gap
{
  double distance = 0.;
  Point point = Point(0., 0., 0.);
  Vector normal = Vector(0., 0., 1.); // of the sample
  double spacing = 0.;                // wanted there
};

// Of the spacing. A point that is farther off its local surface is a stray one, and attracts no sample.
constexpr double largest_distance_from_surface = 0.1;

template <typename Neighbors>
Gap largest_gap(const Surface_sample& x, const Neighbors& neighbors,
                const std::vector<Point>& points, const Surface_fit& fit)
{
  // In spacings. No point is farther than 0.58 from a sample of a lattice; a hole is closed from its rim.
  constexpr double reach = 0.8;
  // Of the spacing, above 2 sigma, which one point in 20 is beyond: less does not show. With twice as
  // much, errors at 1 % of the points fall by two thirds as much.
  constexpr double visible = 0.02;
  // Points looked at in the area of a lattice cell: their distance to the farthest of a dense input is
  // an eighth of the spacing at most.
  constexpr std::size_t enough = 16;

  const std::size_t step =
      (std::max)(fit.number_of_points / (enough * points.size()), std::size_t(1));
  const double least = visible * x.spacing + 2. * fit.noise;
  Gap gap{0., x.point, x.normal, x.spacing};
  if (2. * fit.noise > largest_distance_from_surface * x.spacing)
    return gap; // what sticks out is noise
  fit.search.for_each_within(x.point, reach * x.spacing,
                             [&](std::size_t index, const Point& p, double squared_distance_to_x)
                             {
    // On a paraboloid with its apex at the sample, the farthest point is as far from the triangles as
    // from the tangent plane: c s^2 / 6 for a height of c r^2 / 2. Most points need no more than that.
    if (index % step != 0 || !(std::abs((p - x.point) * x.normal) > least))
      return;
    for (std::size_t i : neighbors)
      if (squared_distance(points[i], p) < squared_distance_to_x)
        return; // it is nearer to that one
    Surrounding_samples surrounding(p, x.normal);
    surrounding.add(x.point);
    for (std::size_t i : neighbors)
      surrounding.add(points[i]);
    // where there is no triangle, the surface ends, at the sample at most
    const double distance =
        (std::min)(surrounding.distance_to_triangle(), std::sqrt(squared_distance_to_x));
    if (distance > (std::max)(least, gap.distance))
    {
      gap.distance = distance;
      gap.point = p;
    }
  });
  return gap;
}

// Moves samples from where they are missed least to where the input is farthest from the surface of the
// samples: what the density asks for on average, chance in the selection and details of the shape leave
// wanting here and there. `neighbors` are those of about these places.
template <typename ConcurrencyTag>
void relocate_samples(std::vector<Surface_sample>& samples, const Sample_neighbors& neighbors,
                      const Surface_fit& fit)
{
  // A sample comes to a gap only if the one that it leaves is less than half of it.
  constexpr double gain = 2.;

  const std::size_t n = samples.size();
  const std::vector<Point> points = points_of<ConcurrencyTag>(samples);
  std::vector<double> cost(n);
  std::vector<Gap> gaps(n);
  for_each_index<ConcurrencyTag>(0, n,
                                 [&](std::size_t i)
                                 {
    cost[i] = distance_without(samples[i], neighbors.of(i), points);
    gaps[i] = largest_gap(samples[i], neighbors.of(i), points, fit);
  });
  std::vector<std::size_t> wanting =
      indices_where<ConcurrencyTag>(n, [&](std::size_t i) { return gaps[i].distance > 0.; });
  std::sort(wanting.begin(), wanting.end(),
            [&](std::size_t i, std::size_t j)
            { return std::make_pair(gaps[i].distance, i) > std::make_pair(gaps[j].distance, j); });
  // those that hold a border stay
  std::vector<std::size_t> spare = indices_where<ConcurrencyTag>(
      n, [&](std::size_t i) { return std::isfinite(cost[i]) && !samples[i].border.exists; });
  std::sort(spare.begin(), spare.end(),
            [&](std::size_t i, std::size_t j)
            { return std::make_pair(cost[i], i) < std::make_pair(cost[j], j); });

  // From the largest gap and the least missed sample on. Gaps within a spacing are closed by one
  // sample; of neighbors, only one goes.
  std::vector<std::uint8_t> is_closed(n, 0), is_needed(n, 0);
  std::vector<std::pair<std::size_t, std::size_t>> moves;
  auto next = spare.begin();
  for (std::size_t i : wanting)
  {
    if (is_closed[i] != 0)
      continue;
    while (next != spare.end() && is_needed[*next] != 0)
      ++next;
    if (next == spare.end() || !(gaps[i].distance > gain * cost[*next]))
      break;
    moves.push_back({*next, i});
    for (std::size_t j : neighbors.of(*next))
      is_needed[j] = 1;
    ++next;
    for (std::size_t j : neighbors.of(i))
      if (squared_distance(gaps[j].point, gaps[i].point) < gaps[i].spacing * gaps[i].spacing)
        is_closed[j] = 1;
  }

  for_each_index<ConcurrencyTag>(0, moves.size(),
                                 [&](std::size_t i)
                                 {
    const Gap& gap = gaps[moves[i].second];
    Surface_sample moved;
    moved.spacing = gap.spacing;
    moved.place(fit, gap.point, gap.normal);
    if (squared_distance(moved.point, gap.point) <=
        largest_distance_from_surface * largest_distance_from_surface * gap.spacing * gap.spacing)
      samples[moves[i].first] = moved;
  });
}

// The iterations of relax_on_surface.h, with samples relocated before the last two: these close what the
// samples leave, and spread them where they come. With 3 or 4 iterations afterwards, the errors are the
// same; with three relocations, those at 1 % of the points fall by another 3 %, in 1.3 times the time of
// the whole call.
template <typename ConcurrencyTag>
Sample_neighbors relax_and_relocate(std::vector<Surface_sample>& samples, const Surface_fit& fit,
                                    std::size_t number_of_iterations, double repulsion_weight,
                                    const Progress& progress)
{
  constexpr std::size_t afterwards = 2;
  if (number_of_iterations <= afterwards)
    return relax_on_surface<ConcurrencyTag>(samples, fit, number_of_iterations, repulsion_weight,
                                            progress);
  const Sample_neighbors neighbors = relax_on_surface<ConcurrencyTag>(
      samples, fit, number_of_iterations - afterwards, repulsion_weight, progress.part(0., 0.7));
  relocate_samples<ConcurrencyTag>(samples, neighbors, fit);
  return relax_on_surface<ConcurrencyTag>(samples, fit, afterwards, repulsion_weight,
                                          progress.part(0.8, 1.));
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_RELOCATE_SAMPLES_H
