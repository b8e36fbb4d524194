#ifndef CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_MEASURES_H
#define CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_MEASURES_H

#include <comparison/input.h>
#include <comparison/moving_least_squares.h>
#include <comparison/reconstruction.h>
#include <comparison/regularity.h>
#include <comparison/types.h>

#include <CGAL/estimate_surface_variation.h>
#include <CGAL/property_map.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace comparison {

// kappa in [0, 20] of the clean points, as the paper's measure takes it
inline std::vector<double> scaled_curvature(const Points& points)
{
  using Element = std::pair<Point, double>;
  std::vector<Element> elements;
  for (const Point& p : points)
    elements.emplace_back(p, 0.);
  CGAL::estimate_surface_variation<Tag>(
      elements, 16, CGAL::Second_of_pair_property_map<Element>(),
      CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Element>()));
  double maximum = 0.;
  for (const Element& e : elements)
    maximum = std::max(maximum, e.second);
  std::vector<double> result;
  for (const Element& e : elements)
    result.push_back(maximum > 0. ? 20. * e.second / maximum : 0.);
  return result;
}

inline std::vector<double> at_nearest(const Points& queries, const Points& points,
                                      const std::vector<double>& values)
{
  const Neighbor_search search(points, Tag());
  std::vector<double> result;
  for (const Point& q : queries)
    search.for_each_nearest(
        q, 1, [&](std::size_t i, const Point&, double) { result.push_back(values[i]); });
  return result;
}

// How far the output stays from the border: for each point of the reference's border the distance
// to the nearest output point, in output spacings
inline Distance_statistics border_distance(const Points& output, const Points& border,
                                           double spacing)
{
  const Neighbor_search search(output, Tag());
  std::vector<double> result;
  for (const Point& p : border)
    search.for_each_nearest(p, 1, [&](std::size_t, const Point&, double squared_distance) {
      result.push_back(std::sqrt(squared_distance) / spacing);
    });
  return statistics(result);
}

// All measures of an output of at least four points. Lengths are divided by the diagonal of the
// clean points. `mesh` is the reconstruction, or what a method gives itself.
inline nlohmann::json measure(const Points& output, const Mesh& mesh, const Input& input,
                              double spacing)
{
  const double unit = diagonal(input.clean);
  const std::vector<double> to_surface = distances(output, input.reference.distance);
  const Distance_statistics d = statistics(to_surface);

  const Mls_projection projection(input.clean);
  const Distance_statistics mls = statistics(distances(
      output, [&](const Point& p) { return std::sqrt(CGAL::squared_distance(p, projection(p))); }));
  const Regularity m =
      regularity(output, at_nearest(output, input.clean, scaled_curvature(input.clean)), unit);
  const double far = static_cast<double>(std::count_if(to_surface.begin(), to_surface.end(),
                                                       [=](double x) { return x > 0.01 * unit; }));
  const Distance_statistics r = reconstruction_error(mesh, input.reference.samples);

  nlohmann::json result = {{"points", output.size()},
                           {"distance_mean", d.mean / unit},
                           {"distance_rms", d.root_mean_square / unit},
                           {"distance_max", d.maximum / unit},
                           {"delta_mls", mls.mean / unit},
                           {"far_share", far / static_cast<double>(output.size())},
                           {"recon_mean", r.mean / unit},
                           {"recon_rms", r.root_mean_square / unit},
                           {"recon_p99", r.percentile_99 / unit},
                           {"recon_max", r.maximum / unit},
                           {"m", m.m},
                           {"m_as_stated", m.as_stated},
                           {"spacing_variation", spacing_variation(output)}};
  if (!input.reference.border.empty())
  {
    const Distance_statistics b = border_distance(output, input.reference.border, spacing);
    result["border_mean"] = b.mean;
    result["border_max"] = b.maximum;
  }
  return result;
}

} // namespace comparison

#endif // CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_MEASURES_H
