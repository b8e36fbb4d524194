#ifndef CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_REFERENCE_H
#define CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_REFERENCE_H

#include <comparison/types.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Random.h>
#if __has_include(<CGAL/AABB_traits_3.h>) // since CGAL 6, where the other two are deprecated
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace comparison {

// The surface that an output is measured against
struct Reference
{
  std::function<double(const Point&)> distance;
  Points samples; // dense, uniform per area
  Points border;  // dense along the border, empty for a closed surface
};

// Distances to a triangle mesh
class Mesh_distance
{
public:
  explicit Mesh_distance(const Mesh& mesh)
  {
    for (const Triangle& t : mesh.triangles)
    {
      const Kernel::Triangle_3 triangle(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
      if (!triangle.is_degenerate())
        m_triangles.push_back(triangle);
    }
    m_tree.rebuild(m_triangles.begin(), m_triangles.end());
    m_tree.accelerate_distance_queries();
  }
  Mesh_distance(const Mesh_distance&) = delete;
  Mesh_distance& operator=(const Mesh_distance&) = delete;

  double operator()(const Point& p) const { return std::sqrt(m_tree.squared_distance(p)); }

private:
  using Triangles = std::vector<Kernel::Triangle_3>;
#if __has_include(<CGAL/AABB_traits_3.h>)
  using Primitive = CGAL::AABB_triangle_primitive_3<Kernel, Triangles::const_iterator>;
  using Traits = CGAL::AABB_traits_3<Kernel, Primitive>;
#else
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
  using Traits = CGAL::AABB_traits<Kernel, Primitive>;
#endif

  Triangles m_triangles;
  CGAL::AABB_tree<Traits> m_tree;
};

// n points, uniform per area
inline Points sample(const Mesh& mesh, std::size_t n, unsigned int seed)
{
  std::vector<double> cumulative_area;
  double area = 0.;
  for (const Triangle& t : mesh.triangles)
  {
    area += std::sqrt(CGAL::squared_area(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]));
    cumulative_area.push_back(area);
  }

  CGAL::Random random(seed);
  Points result;
  result.reserve(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    const double position = random.uniform_real(0., area);
    const auto found =
        std::upper_bound(cumulative_area.begin(), cumulative_area.end() - 1, position);
    const Triangle& t = mesh.triangles[static_cast<std::size_t>(found - cumulative_area.begin())];
    double u = random.uniform_real(0., 1.), v = random.uniform_real(0., 1.);
    if (u + v > 1.)
    {
      u = 1. - u;
      v = 1. - v;
    }
    const Point& origin = mesh.points[t[0]];
    result.push_back(origin + u * (mesh.points[t[1]] - origin) + v * (mesh.points[t[2]] - origin));
  }
  return result;
}

// points along the edges that have one triangle, no farther apart than `step`
inline Points border(const Mesh& mesh, double step)
{
  std::map<std::pair<std::size_t, std::size_t>, int> triangles_of_edge;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      ++triangles_of_edge[std::minmax(t[i], t[(i + 1) % 3])];

  Points result;
  for (const auto& [edge, count] : triangles_of_edge)
    if (count == 1)
    {
      const Point &a = mesh.points[edge.first], &b = mesh.points[edge.second];
      const double length = std::sqrt(CGAL::squared_distance(a, b));
      const int steps = static_cast<int>(std::ceil(length / step)) + 1;
      for (int i = 0; i < steps; ++i)
        result.push_back(a + (static_cast<double>(i) / steps) * (b - a));
    }
  return result;
}

inline Reference reference_of(const Mesh& mesh, std::size_t number_of_samples, unsigned int seed)
{
  const auto distance = std::make_shared<Mesh_distance>(mesh);
  return {[distance](const Point& p) { return (*distance)(p); },
          sample(mesh, number_of_samples, seed), border(mesh, 1e-3 * diagonal(mesh.points))};
}

} // namespace comparison

#endif // CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_REFERENCE_H
