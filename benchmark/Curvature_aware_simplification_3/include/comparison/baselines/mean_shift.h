#ifndef CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_MEAN_SHIFT_H
#define CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_MEAN_SHIFT_H

#include <comparison/baselines/principal_axes.h>
#include <comparison/types.h>

#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace comparison {

// A point of the feature space: position and normal, whose sign is not known
struct Feature
{
  Point position;
  Vector normal;
};

// Adaptive mean shift (Georgescu et al. 2003) in the feature space of position and normal. From a
// point i, (x, n) moves to the mean of the features (p_j, n_j) with the weights
//
//   exp(-2 |x - p_j|^2 / h_i^2) exp(-2 |n - n_j|^2 / w^2),
//
// over p_j in the ball of the bandwidth h_i, the distance from i to its k-th neighbor, until it
// rests: on a local mode of the density of features.
class Mean_shift
{
public:
  Mean_shift(const Points& points, std::size_t number_of_neighbors)
    : m_points(points),
      m_search(points, Tag()),
      m_size(std::min(number_of_neighbors + 1, points.size())),
      m_bandwidth(points.size()),
      m_normal(points.size())
  {
    CGAL::Curvature_aware_simplification_3::internal::for_each_index<Tag>(
        0, points.size(), [&](std::size_t i) { estimate(i); });
  }

  Feature mode(std::size_t i) const
  {
    Feature feature{m_points[i], m_normal[i]};
    // a hundredth of the bandwidth is nothing next to a cluster; ridges of the density are long,
    // and on them the shift becomes slow without an end
    const double tolerance = 0.01 * m_bandwidth[i];
    for (int iteration = 0; iteration < 30; ++iteration)
    {
      const Feature next = shifted(feature, m_bandwidth[i]);
      const bool rests =
          CGAL::squared_distance(next.position, feature.position) <= tolerance * tolerance;
      feature = next;
      if (rests)
        break;
    }
    return feature;
  }

private:
  using Neighbor_search = CGAL::Curvature_aware_simplification_3::internal::Neighbor_search;

  // w: normals that differ by 0.5, 30 degrees, belong to different sides of a feature
  static constexpr double normal_bandwidth = 0.5;

  void estimate(std::size_t i)
  {
    Moments moments(m_points[i]);
    double largest = 0.;
    m_search.for_each_nearest(m_points[i], m_size,
                              [&](std::size_t, const Point& p, double squared_distance) {
                                moments.add(1., p);
                                largest = std::max(largest, squared_distance);
                              });
    m_bandwidth[i] = std::sqrt(largest);
    m_normal[i] = moments.principal_axes().axes[0];
  }

  Feature shifted(const Feature& feature, double h) const
  {
    double sum = 0.;
    Vector position(0., 0., 0.), normal(0., 0., 0.);
    m_search.for_each_within(
        feature.position, h, [&](std::size_t j, const Point& p, double squared_distance) {
          const double cosine = feature.normal * m_normal[j];
          // of unit normals whose signs are chosen so that it is the smallest
          const double squared_difference = 2. - 2. * std::abs(cosine);
          const double weight =
              std::exp(-2. * squared_distance / (h * h) -
                       2. * squared_difference / (normal_bandwidth * normal_bandwidth));
          sum += weight;
          position = position + weight * (p - feature.position);
          normal = normal + std::copysign(weight, cosine) * m_normal[j];
        });
    // sums of normals of one side never vanish
    return sum > 0. ? Feature{feature.position + position / sum,
                              normal / std::sqrt(normal.squared_length())}
                    : feature;
  }

  const Points& m_points;
  Neighbor_search m_search;
  std::size_t m_size;
  std::vector<double> m_bandwidth;
  std::vector<Vector> m_normal;
};

// for each point its mode
inline Points mean_shift_modes(const Points& points, std::size_t number_of_neighbors)
{
  const Mean_shift mean_shift(points, number_of_neighbors);
  Points modes(points.size());
  CGAL::Curvature_aware_simplification_3::internal::for_each_index<Tag>(
      0, points.size(), [&](std::size_t i) { modes[i] = mean_shift.mode(i).position; });
  return modes;
}

} // namespace comparison

#endif // CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_MEAN_SHIFT_H
