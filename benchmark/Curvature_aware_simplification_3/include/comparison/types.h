#ifndef CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_TYPES_H
#define CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_TYPES_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/bounding_box.h>
#include <CGAL/tags.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

// What the comparison programs share. Everything is as plain as can be: points are a vector.
namespace comparison {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Points = std::vector<Point>;
using Triangle = std::array<std::size_t, 3>;
using Tag = CGAL::Parallel_if_available_tag;

struct Mesh
{
  Points points;
  std::vector<Triangle> triangles;
};

inline double diagonal(const Points& points)
{
  const CGAL::Bbox_3 box = CGAL::bbox_3(points.begin(), points.end());
  return std::hypot(box.x_span(), box.y_span(), box.z_span());
}

} // namespace comparison

#endif // CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_TYPES_H
