#ifndef CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_GRID_H
#define CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_GRID_H

#include <comparison/baselines/search.h>
#include <comparison/types.h>

#include <CGAL/grid_simplify_point_set.h>

#include <cstddef>

namespace comparison {

// CGAL's grid_simplify_point_set: the first point in each occupied cell of a cubic grid
inline Points grid_points(Points points, double epsilon)
{
  points.erase(CGAL::grid_simplify_point_set(points, epsilon), points.end());
  return points;
}

// The same with the cell size epsilon that gives the count nearest to n. The count jumps when a
// point crosses a wall, mostly by 1: n is met exactly unless points are on a lattice themselves.
inline Points grid_points_to_count(const Points& points, std::size_t n)
{
  const double size = diagonal(points);
  if (!(size > 0.))
    return Points(points.begin(), points.begin() + (points.empty() ? 0 : 1));
  // 2^20 cells a side are more than any point set fills
  return search_count([&](double epsilon) { return grid_points(points, epsilon); }, 2. * size,
                      size / (1 << 20), n);
}

} // namespace comparison

#endif // CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_GRID_H
