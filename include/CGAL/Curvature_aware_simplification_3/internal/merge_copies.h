// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_MERGE_COPIES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_MERGE_COPIES_H

#include <CGAL/Curvature_aware_simplification_3/internal/Cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Computation_kernel.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Counter_based_random.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Curve_ranges.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/Surface_fit.h>
#include <CGAL/Curvature_aware_simplification_3/internal/loops.h>
#include <CGAL/Curvature_aware_simplification_3/internal/median.h>
#include <CGAL/Curvature_aware_simplification_3/internal/prefix_sums.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

// Places that were measured several times: by a scanner at rest, or in files that differ by
// rounding. Copies of a place tell nothing of the surface around it, but crowd out the neighbors
// that do: where there are more of them than neighbors, all of a neighborhood is one place.

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The distances of some points to their nearest neighbors, each in increasing order. More copies
// of a place than these are not recognized.
template <typename ConcurrencyTag>
std::vector<std::vector<double>> distances_of_neighbors(const std::vector<Point>& points,
                                                        const Neighbor_search& search)
{
  constexpr std::size_t most_probes = 128, number_of_neighbors = 64;
  std::vector<std::vector<double>> distances((std::min)(most_probes, points.size()));
  for_each_index<ConcurrencyTag>(0, distances.size(),
                                 [&](std::size_t probe)
                                 {
    std::vector<double>& here = distances[probe];
    const Point& p = points[middle_of_part(probe, distances.size(), points.size())];
    search.for_each_nearest(p, number_of_neighbors + 1,
                            [&](std::size_t, const Point&, double squared_distance)
                            { here.push_back(std::sqrt(squared_distance)); });
    std::sort(here.begin(), here.end());
    here.erase(here.begin()); // the point itself
  });
  return distances;
}

// Of distances in increasing order, how many are no longer than r
inline std::ptrdiff_t number_within(const std::vector<double>& distances, double r)
{
  return std::upper_bound(distances.begin(), distances.end(), r) - distances.begin();
}

// Whether neighbors within r fill a volume, as copies do with errors in all directions: there, a
// ball holds eight times as many as one half as wide, of a surface four times, of a curve twice.
inline bool fill_volumes(const std::vector<std::vector<double>>& distances, double r)
{
  constexpr std::ptrdiff_t few = 10; // for which the ratio is chance
  constexpr double more_than_surfaces = 5.5;
  std::ptrdiff_t within_eighth = 0, within_fourth = 0;
  for (const std::vector<double>& here : distances)
  {
    within_eighth += number_within(here, r / 8.);
    within_fourth += number_within(here, r / 4.);
  }
  return within_eighth >= few && static_cast<double>(within_fourth) >=
                                     more_than_surfaces * static_cast<double>(within_eighth);
}

// By how much the neighbors within r are more than twice those between r and a larger distance;
// negative if they are not. Up to 2 r, a curve has as many as within r, and a surface three times as
// many; if they are half as many, they belong to other places. But so it is for small parts that
// are far from each other, as blades of grass and pieces of scan lines, which are no copies: what
// may be a curve or a surface must be alone up to 5 r.
inline double surplus_of_copies(const std::vector<std::vector<double>>& distances, double r)
{
  const double gap = fill_volumes(distances, r) ? 2. : 5.;
  std::ptrdiff_t within = 0, beyond = 0;
  for (const std::vector<double>& here : distances)
  {
    const std::ptrdiff_t all = here.end() - here.begin();
    const std::ptrdiff_t in_ball = number_within(here, r);
    const std::ptrdiff_t in_larger_ball = number_within(here, gap * r);
    within += in_ball;
    // with all of them, as if there were as many more: there may be others that were not looked at
    beyond += in_larger_ball < all ? in_larger_ball - in_ball : all;
  }
  return static_cast<double>(within - 2 * beyond);
}

// The distance within which points are copies of each other, to a tenth of it; 0 if there are none
template <typename ConcurrencyTag>
double distance_of_copies(const std::vector<Point>& points, const Neighbor_search& search)
{
  constexpr double step = 1.1;
  constexpr std::size_t tenth = 10; // fewer points with copies do little harm
  const std::vector<std::vector<double>> distances =
      distances_of_neighbors<ConcurrencyTag>(points, search);
  std::vector<double> nearest, farthest;
  for (const std::vector<double>& here : distances)
  {
    nearest.push_back(here.front());
    farthest.push_back(here.back());
  }
  std::sort(nearest.begin(), nearest.end());
  const double smallest = nearest[nearest.size() / tenth], largest = median(farthest);
  double result = 0., most = 0.;
  for (double r = smallest; r > 0. && r < largest; r *= step)
  {
    const double surplus = surplus_of_copies(distances, r);
    if (surplus > most)
    {
      most = surplus;
      result = r;
    }
  }
  return result;
}

// The points that stand for all within r of them: those whose turn comes before that of any other
// there. By random turns, some of a dense part are left as well, where all are within r of the next.
template <typename ConcurrencyTag>
std::vector<std::size_t> first_points_within(const std::vector<Point>& points,
                                             const Neighbor_search& search, double r)
{
  const Counter_based_random turns(0, 0);
  return indices_where<ConcurrencyTag>(points.size(),
                                       [&](std::size_t i)
                                       {
    bool is_first = true;
    search.for_each_within(points[i], r,
                           [&](std::size_t j, const Point&, double)
                           { is_first = is_first && turns.bits(i) <= turns.bits(j); });
    return is_first;
  });
}

// Leaves one point for all copies of a place, at their mean, so that their errors are averaged.
// Returns how many points are less. The indices in the cloud are dropped before.
//
// Parts that are small and far from each other look the same. As long as there are no fewer places
// than samples, no more is lost of them than samples could show; and places must be enough to fit
// surfaces to.
template <typename ConcurrencyTag>
std::size_t merge_copies(Cloud& cloud, std::unique_ptr<Neighbor_search>& search,
                         std::size_t number_of_samples)
{
  const double r = distance_of_copies<ConcurrencyTag>(cloud.points, *search);
  if (!(r > 0.))
    return 0;
  const std::vector<std::size_t> first =
      first_points_within<ConcurrencyTag>(cloud.points, *search, r);
  if (first.size() < (std::max)(number_of_samples, fewest_points_to_fit))
    return 0;
  const std::size_t number_merged = cloud.size() - first.size();
  std::vector<Point> places(first.size());
  for_each_index<ConcurrencyTag>(0, places.size(),
                                 [&](std::size_t i)
                                 {
    const Point& p = cloud.points[first[i]];
    Vector sum(0., 0., 0.);
    double number = 0.;
    search->for_each_within(p, r,
                            [&](std::size_t, const Point& copy, double)
                            {
      sum = sum + (copy - p);
      number += 1.;
    });
    places[i] = p + sum / number;
  });
  search.reset(); // before the next one takes as much memory
  cloud.points = std::move(places);
  search = std::make_unique<Neighbor_search>(cloud.points, ConcurrencyTag());
  return number_merged;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_MERGE_COPIES_H
