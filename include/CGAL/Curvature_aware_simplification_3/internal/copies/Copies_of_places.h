// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_COPIES_COPIES_OF_PLACES_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_COPIES_COPIES_OF_PLACES_H

#include <CGAL/Curvature_aware_simplification_3/internal/input/Searchable_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Computation_kernel.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Curve_ranges.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/median.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// Places that were measured several times: by a scanner at rest, or in files that differ by
// rounding. Copies of a place tell nothing of the surface around it, but crowd out the neighbors
// that do: where there are more of them than neighbors, all of a neighborhood is one place.

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The distances of some points to so many of their nearest neighbors, each in increasing order. As
// many distances are enough, however many are at one point: with half of them, pairs on a curve
// look like copies by chance.
template <typename ConcurrencyTag>
std::vector<std::vector<double>> distances_of_neighbors(const Searchable_points& cloud,
                                                        std::size_t number_of_neighbors)
{
  constexpr std::size_t enough = 128 * 64;
  std::vector<std::vector<double>> distances(
      (std::min)(enough / number_of_neighbors, cloud.size()));
  for_each_index<ConcurrencyTag>(0, distances.size(), [&](std::size_t probe) {
    std::vector<double>& here = distances[probe];
    const Point& p = cloud.points[middle_of_part(probe, distances.size(), cloud.size())];
    cloud.search->for_each_nearest(p, number_of_neighbors + 1,
                                   [&](std::size_t, const Point&, double squared_distance) {
                                     here.push_back(std::sqrt(squared_distance));
                                   });
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
  // Where there are 40 within a sixth, the ratio of a surface, 4, is from 2.5 to 5.5 within two
  // standard deviations.
  constexpr std::ptrdiff_t few = 40;
  constexpr double more_than_surfaces = 5.5;
  std::ptrdiff_t within_sixth = 0, within_third = 0;
  for (const std::vector<double>& here : distances)
  {
    within_sixth += number_within(here, r / 6.);
    within_third += number_within(here, r / 3.);
  }
  return within_sixth >= few &&
         static_cast<double>(within_third) > more_than_surfaces * static_cast<double>(within_sixth);
}

// Where copies are within r, the next places are beyond gap * r.
inline double gap_around_copies(const std::vector<std::vector<double>>& distances, double r)
{
  // Copies fill volumes, and twice the distance is far enough then. Small parts that are far from
  // each other, as blades of grass and pieces of scan lines, are curves or surfaces. With 5, tubes
  // of CAD models whose vertices are in rings,
  // five of their radii apart, would be taken for copies.
  return fill_volumes(distances, r) ? 2. : 10.;
}

// By how much the neighbors within r are more than twice those in the gap; negative if they are
// not. Up to 2 r, a curve has as many as within r, and a surface three times as many: half as many
// are of other places, or copies with large errors.
inline double surplus_of_copies(const std::vector<std::vector<double>>& distances, double r)
{
  const double end_of_gap = gap_around_copies(distances, r) * r;
  std::ptrdiff_t within = 0, beyond = 0;
  for (const std::vector<double>& here : distances)
  {
    const std::ptrdiff_t all = here.end() - here.begin();
    const std::ptrdiff_t in_ball = number_within(here, r);
    const std::ptrdiff_t up_to_end = number_within(here, end_of_gap);
    within += in_ball;
    // with all of them, as if there were as many more: there may be others that were not looked at
    beyond += up_to_end < all ? up_to_end - in_ball : all;
  }
  return static_cast<double>(within - 2 * beyond);
}

// The distance within which points are copies of each other, in the middle of the gap by its
// logarithm, so that copies with large errors are not left alone; 0 if there are no copies
template <typename ConcurrencyTag>
double distance_of_copies(const Searchable_points& cloud, std::size_t most_copies)
{
  constexpr double step = 1.1;
  constexpr std::size_t tenth = 10; // fewer points with copies do little harm
  const std::vector<std::vector<double>> distances =
      distances_of_neighbors<ConcurrencyTag>(cloud, most_copies);
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
      result = std::sqrt(gap_around_copies(distances, r)) * r;
    }
  }
  return result;
}

struct Copies_of_places
{
  double distance;  // within which points are copies of each other; 0 if there are none
  std::size_t most; // of a place, that were looked for
};

// Looks for up to 64 copies of each place and, where there are none, for 128 and 256, until that is
// twice as many as there are points for each sample: no fewer places are left than samples, and
// places differ. 64 take 0.4 % of the time of a call for Igea, and so does each round.
template <typename ConcurrencyTag>
Copies_of_places find_copies(const Searchable_points& cloud, std::size_t number_of_samples)
{
  constexpr std::size_t usual = 64, largest = 256;
  const std::size_t enough = (std::min)(2 * (cloud.size() / number_of_samples), largest);
  for (std::size_t most = usual;; most *= 2)
  {
    const double distance = distance_of_copies<ConcurrencyTag>(cloud, most);
    if (distance > 0. || most >= enough)
      return {distance, most};
  }
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_COPIES_COPIES_OF_PLACES_H
