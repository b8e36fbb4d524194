#ifndef CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_VOXEL_CENTROIDS_H
#define CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_VOXEL_CENTROIDS_H

#include <comparison/baselines/search.h>
#include <comparison/types.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/bounding_box.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

namespace comparison {

// 21 bits for each of three coordinates fit into a key of 64
constexpr int bits_per_cell_coordinate = 21;
constexpr double cells_per_side = double(1 << bits_per_cell_coordinate);

// The centroids of the points in each occupied cell of a cubic grid, which starts at the corner of
// the bounding box, in the order of the cells. O(M log M)
inline Points voxel_centroids(const Points& points, double cell_size)
{
  const CGAL::Bbox_3 box = CGAL::bbox_3(points.begin(), points.end());
  if (!(std::max({box.x_span(), box.y_span(), box.z_span()}) < cells_per_side * cell_size))
    throw std::invalid_argument("the cells are too small for keys of 64 bits");

  const auto cell = [&](const Point& p) {
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis)
      key = (key << bits_per_cell_coordinate) |
            static_cast<std::uint64_t>((p[axis] - box.min(axis)) / cell_size);
    return key;
  };
  std::vector<std::pair<std::uint64_t, std::size_t>> cells;
  cells.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    cells.emplace_back(cell(points[i]), i);
  std::sort(cells.begin(), cells.end());

  Points centroids;
  for (auto begin = cells.begin(); begin != cells.end();)
  {
    // relative to the first point, so that large coordinates lose no digits
    const Point& first = points[begin->second];
    Vector sum(0., 0., 0.);
    auto end = begin;
    for (; end != cells.end() && end->first == begin->first; ++end)
      sum = sum + (points[end->second] - first);
    centroids.push_back(first + sum / static_cast<double>(end - begin));
    begin = end;
  }
  return centroids;
}

// The same with the cell size that gives the count nearest to n. The count jumps when a point
// crosses a wall, mostly by 1: n is met exactly unless points are on a lattice themselves.
inline Points voxel_centroids_to_count(const Points& points, std::size_t n)
{
  const double size = diagonal(points);
  if (!(size > 0.))
    return Points(points.begin(), points.begin() + (points.empty() ? 0 : 1));
  return search_count([&](double cell_size) { return voxel_centroids(points, cell_size); },
                      2. * size, 2. * size / cells_per_side, n);
}

} // namespace comparison

#endif // CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_VOXEL_CENTROIDS_H
