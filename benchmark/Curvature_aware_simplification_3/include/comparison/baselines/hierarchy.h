#ifndef CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_HIERARCHY_H
#define CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_HIERARCHY_H

#include <comparison/baselines/search.h>
#include <comparison/types.h>

#include <CGAL/hierarchy_simplify_point_set.h>

#include <cmath>
#include <cstddef>

namespace comparison {

// CGAL's hierarchy_simplify_point_set: the hierarchical clustering of Pauly et al. (2002). Clusters
// are halved until they have at most M = `size` points and at most the surface variation
// T = `maximum_variation`; the point nearest to the centroid of each is kept.
inline Points hierarchy_points(Points points, unsigned int size, double maximum_variation)
{
  points.erase(CGAL::hierarchy_simplify_point_set(
                   points, CGAL::parameters::size(size).maximum_variation(maximum_variation)),
               points.end());
  return points;
}

// The same with the T that gives the count nearest to n. The clusters are those of one tree, cut
// higher or lower, so the count is monotone, and jumps by what one split sets free, mostly 1. The
// size M bounds it from below: if T = 1/3, the largest there is, gives more than n, that is
// returned.
inline Points hierarchy_points_of_size(const Points& points, std::size_t n, unsigned int size)
{
  // below 1e-12 lies the rounding error of the variation
  return search_count([&](double variation) { return hierarchy_points(points, size, variation); },
                      1. / 3., 1e-12, n);
}

// The same with the size M that gives the count nearest to n for a given T. M is an integer, and
// the count about inverse to it: what remains is up to about n / (2 M).
inline Points hierarchy_points_of_variation(const Points& points, std::size_t n,
                                            double maximum_variation)
{
  return search_count(
      [&](double size) {
        return hierarchy_points(points, static_cast<unsigned int>(std::lround(size)),
                                maximum_variation);
      },
      static_cast<double>(points.size()), 1., n);
}

} // namespace comparison

#endif // CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_HIERARCHY_H
