#ifndef CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_INPUT_H
#define CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_INPUT_H

#include <comparison/analytic_surfaces.h>
#include <comparison/degradations.h>
#include <comparison/moving_least_squares.h>
#include <comparison/reference.h>
#include <comparison/types.h>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/IO/read_points.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace comparison {

struct Input
{
  Points clean;        // points on the surface
  Points degraded;     // what the methods are given
  Mesh mesh;           // empty if there is none
  Reference reference; // the clean surface
};

// A file of a mesh (its vertices are the points, or `number_of_points` random points on it), of
// points (which are then the surface, by moving least squares), or the name of an analytic surface
inline Input make_input(const std::string& name, std::size_t number_of_points,
                        const std::string& degradation, unsigned int seed)
{
  const std::size_t reference_samples = 100000;
  Input input;
  const std::vector<std::string> analytic = analytic_surface_names();
  if (std::find(analytic.begin(), analytic.end(), name) != analytic.end())
  {
    const Analytic_surface surface = analytic_surface(name);
    input.clean = sample(surface, number_of_points > 0 ? number_of_points : 100000, seed);
    input.reference = {surface.distance, sample(surface, reference_samples, seed + 1), {}};
    for (std::size_t i = 0; surface.border && i < 4000; ++i)
      input.reference.border.push_back(surface.border(static_cast<double>(i) / 4000.));
  }
  else
  {
    std::vector<std::vector<std::size_t>> faces;
    if (!CGAL::IO::read_polygon_soup(name, input.mesh.points, faces) || faces.empty())
    {
      input.mesh = Mesh();
      if (!CGAL::IO::read_points(name, std::back_inserter(input.clean)) || input.clean.empty())
        throw std::runtime_error("cannot read " + name);
      const auto projection = std::make_shared<Mls_projection>(input.clean);
      input.reference.distance = [projection](const Point& p) {
        return std::sqrt(CGAL::squared_distance(p, (*projection)(p)));
      };
      input.reference.samples = input.clean;
    }
    else
    {
      for (const std::vector<std::size_t>& face : faces)
        for (std::size_t i = 2; i < face.size(); ++i)
          input.mesh.triangles.push_back({face[0], face[i - 1], face[i]});
      input.clean =
          number_of_points > 0 ? sample(input.mesh, number_of_points, seed) : input.mesh.points;
      input.reference = reference_of(input.mesh, reference_samples, seed + 1);
    }
  }
  input.degraded = degraded(input.clean, degradation, seed + 2);
  return input;
}

} // namespace comparison

#endif // CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_INPUT_H
