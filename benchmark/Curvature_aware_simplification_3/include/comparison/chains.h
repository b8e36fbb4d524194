#ifndef CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_CHAINS_H
#define CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_CHAINS_H

#include <comparison/types.h>

#include <CGAL/compute_average_spacing.h>
#include <CGAL/jet_smooth_point_set.h>
#include <CGAL/remove_outliers.h>
#include <CGAL/wlop_simplify_and_regularize_point_set.h>

#include <cstddef>
#include <iterator>
#include <vector>

// CGAL's functions as steps of the chains that a user builds by hand
namespace comparison {

// As in the manual's example: all points that are, on average, farther from their 24 neighbors than
// `spacings` times the average spacing are taken for outliers.
inline Points without_outliers(Points points, double spacings)
{
  const unsigned int k = 24;
  const double spacing = CGAL::compute_average_spacing<Tag>(points, k);
  points.erase(
      CGAL::remove_outliers<Tag>(
          points, k,
          CGAL::parameters::threshold_percent(100.).threshold_distance(spacings * spacing)),
      points.end());
  return points;
}

inline Points smoothed(Points points, unsigned int neighbors)
{
  CGAL::jet_smooth_point_set<Tag>(points, neighbors);
  return points;
}

// `radius` 0 is the default of CGAL. It shuffles its input, hence the copy.
inline Points wlop(Points points, std::size_t n, double radius, unsigned int iterations)
{
  const double percentage =
      100. * (static_cast<double>(n) + 0.5) / static_cast<double>(points.size());
  Points output;
  const auto parameters = CGAL::parameters::select_percentage(std::min(percentage, 100.))
                              .number_of_iterations(iterations);
  if (radius > 0.)
    CGAL::wlop_simplify_and_regularize_point_set<Tag>(points, std::back_inserter(output),
                                                      parameters.neighbor_radius(radius));
  else
    CGAL::wlop_simplify_and_regularize_point_set<Tag>(points, std::back_inserter(output),
                                                      parameters);
  return output;
}

} // namespace comparison

#endif // CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_CHAINS_H
