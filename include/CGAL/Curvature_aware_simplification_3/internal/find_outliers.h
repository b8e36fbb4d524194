// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FIND_OUTLIERS_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FIND_OUTLIERS_H

#include <CGAL/Curvature_aware_simplification_3/internal/Cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/loops.h>
#include <CGAL/Curvature_aware_simplification_3/internal/scan.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// Marks those that have less votes than needed, and returns them.
template <typename ConcurrencyTag>
std::vector<std::size_t>
mark_those_with_less_votes(const std::vector<std::atomic<std::uint32_t>>& votes,
                           std::size_t needed_votes, std::vector<std::uint8_t>& is_outlier)
{
  return indices_where<ConcurrencyTag>(votes.size(),
                                       [&](std::size_t i)
                                       {
    if (is_outlier[i] != 0 || votes[i].load(std::memory_order_relaxed) >= needed_votes)
      return false;
    is_outlier[i] = 1;
    return true;
  });
}

// Which points do not belong to a surface: 1 for outliers. Takes
// O(k + log n) for each outlier, and a pass over all points for each round of uncovering, of which
// there are few.
//
// Every point votes for its k nearest. A point on a surface gets about k votes, at a corner of an
// open surface half of them, and the density of the input cancels out: sparse regions vote for
// themselves. An outlier near a surface has neighbors there, but is no neighbor of theirs. Outliers
// far away vote for each other; they are those whose neighborhood is as thick as wide and has more
// than 3 times the median radius. The votes of outliers do not count, which uncovers others.
template <typename ConcurrencyTag>
std::vector<std::uint8_t> find_outliers(const Cloud& cloud, const Neighbor_search& search,
                                        const Features& features, std::size_t k)
{
  // kappa of points spread evenly in space: 0.17 on average for k = 16, and 97 % are above 0.07;
  // that of a surface is, by Gaussian noise as large as the neighborhood, about 0.1 as well, but
  // noise does not widen neighborhoods to 3 times the median
  constexpr double volumetric = 0.07;
  constexpr double far_radius = 3.;

  const std::size_t n = cloud.size();
  // the median of some points, evenly along the curve: it need not be exact
  const std::size_t number_of_probes = (std::min)(std::size_t(10000), n);
  std::vector<double> area(number_of_probes);
  for (std::size_t i = 0; i < number_of_probes; ++i)
    area[i] = features.inverse_density[i * n / number_of_probes];
  const auto median = area.begin() + static_cast<std::ptrdiff_t>(number_of_probes / 2);
  std::nth_element(area.begin(), median, area.end());
  const double far_area = far_radius * far_radius * *median;

  std::vector<std::uint8_t> is_outlier(n, 0);
  std::vector<std::atomic<std::uint32_t>> votes(n); // sums of integers: the order does not matter
  // A quarter of the votes: a corner of an open surface, the least that a surface has, gets a half.
  const std::size_t few_votes = (std::max)(k / 4, std::size_t(1));
  for_each_index<ConcurrencyTag>(0, n,
                                 [&](std::size_t i)
                                 {
    votes[i].store(features.votes[i], std::memory_order_relaxed);
    is_outlier[i] = features.votes[i] < few_votes || (features.inverse_density[i] > far_area &&
                                                      features.curvature[i] > volumetric)
                        ? 1
                        : 0;
  });
  // Outliers found take their votes back, until that uncovers no more.
  const auto take_votes_back = [&](std::vector<std::size_t> found)
  {
    while (!found.empty())
    {
      for_each_index<ConcurrencyTag>(0, found.size(),
                                     [&](std::size_t i)
                                     {
        search.for_each_nearest(cloud.points[found[i]], k + 1,
                                [&](std::size_t j, const Point&, double)
                                { votes[j].fetch_sub(1, std::memory_order_relaxed); });
      });
      found = mark_those_with_less_votes<ConcurrencyTag>(votes, few_votes, is_outlier);
    }
  };
  std::vector<std::size_t> found =
      indices_where<ConcurrencyTag>(n, [&](std::size_t i) { return is_outlier[i] != 0; });
  // Where there are more than a few outliers, some hide near the surface, between its corners' votes
  // and those of points farther off: a second look asks for half of the votes. Only once, because a
  // border has little more than half; asked again and again, border after border would go.
  const bool are_many = found.size() > n / 1000;
  take_votes_back(std::move(found));
  if (are_many)
    take_votes_back(mark_those_with_less_votes<ConcurrencyTag>(votes, k / 2, is_outlier));
  return is_outlier;
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_FIND_OUTLIERS_H
