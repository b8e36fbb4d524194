// Copyright (c) 2026 The authors of Curvature_aware_simplification_3.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PAPER_SAMPLE_SPACING_H
#define CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PAPER_SAMPLE_SPACING_H

#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Curvature_aware_simplification_3 {
namespace internal {

// The default of h: the ball around a sample holds two rings of others. CGAL's manual of WLOP asks
// for at least that, and theta lets more have no effect.
inline constexpr double radius_in_spacings = 2.;

// Typical distance that the samples will have when they are spread evenly; 0 if there are no two
// distinct ones.
//
// They are selected at random, so the nearest neighbor tells little: the density is taken from a
// disk around each, up to the 18th nearest, as many as the two rings of a hexagonal lattice have. A
// lattice of spacing s has 2 / (sqrt(3) s^2) points per area; with 18 in a disk of radius R this
// gives s = R sqrt(2 pi / (18 sqrt(3))). Of fewer samples, all take the place of the 18.
//
// The median keeps out what is special: isolated samples on outliers, and dense ones on sharp
// features. The samples are measured, and not the ratio of M and N, since that knows neither how
// the selection distributed them nor whether they lie on a surface, along a line or in clusters.
template <typename ConcurrencyTag>
double sample_spacing(const std::vector<Point>& samples)
{
  constexpr std::size_t number_of_neighbors = 18;
  const std::size_t size = (std::min)(number_of_neighbors + 1, samples.size());
  const Neighbor_search search(samples, ConcurrencyTag());

  std::vector<double> squared_radius(samples.size(), 0.);
  for_each_index<ConcurrencyTag>(0, samples.size(), [&](std::size_t i) {
    squared_radius[i] = search.squared_distance_of_nearest(samples[i], size);
  });

  // samples that coincide with all their neighbors tell nothing
  squared_radius.erase(std::remove(squared_radius.begin(), squared_radius.end(), 0.),
                       squared_radius.end());
  if (squared_radius.empty())
    return 0.;

  // Halfway between the two values in the middle: h, a multiple of it, is then not the distance of
  // a pair of samples, about which rounding would decide whether they are neighbors.
  const std::size_t middle = squared_radius.size() / 2;
  const auto median = squared_radius.begin() + static_cast<std::ptrdiff_t>(middle);
  std::nth_element(squared_radius.begin(), median, squared_radius.end());
  const double below = middle > 0 ? *std::max_element(squared_radius.begin(), median) : *median;
  const double radius = (std::sqrt(below) + std::sqrt(*median)) / 2.;
  return radius * std::sqrt(2. * CGAL_PI / (static_cast<double>(size - 1) * std::sqrt(3.)));
}

} // namespace internal
} // namespace Curvature_aware_simplification_3
} // namespace CGAL

#endif // CGAL_CURVATURE_AWARE_SIMPLIFICATION_3_INTERNAL_PAPER_SAMPLE_SPACING_H
