#ifndef CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_MOVING_LEAST_SQUARES_H
#define CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_MOVING_LEAST_SQUARES_H

#include <comparison/types.h>

#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace comparison {

// Projection onto the moving least squares surface of a point set (Alexa et al. 2001): a plane is
// fitted to the points around with Gaussian weights, and over it a quadratic height field, onto
// which the point is moved along the plane's normal; repeated until it rests. The order 2 keeps the
// projection free of the shrinking that planes have, which would be counted as an error.
class Mls_projection
{
public:
  explicit Mls_projection(const Points& points) : m_search(points, Tag()), m_size(points.size()) {}

  Point operator()(const Point& query) const
  {
    Point p = query;
    for (int i = 0; i < 5; ++i)
    {
      const Point next = step(p);
      const double moved = CGAL::squared_distance(p, next);
      p = next;
      if (moved <= 1e-16 * CGAL::squared_distance(p, query))
        break;
    }
    return p;
  }

private:
  using Neighbor_search = CGAL::Curvature_aware_simplification_3::internal::Neighbor_search;
  using Weighted_points = std::vector<std::pair<Eigen::Vector3d, double>>;

  static Eigen::Vector3d vector(const Point& p) { return {p.x(), p.y(), p.z()}; }

  Point step(const Point& query) const
  {
    // 24 neighbors and a Gaussian that reaches half their radius: about 10 points count, enough for
    // the 6 coefficients, and few enough not to smooth
    double squared_radius = 0.;
    Weighted_points neighbors;
    m_search.for_each_nearest(query, std::min<std::size_t>(24, m_size),
                              [&](std::size_t, const Point& p, double squared_distance) {
                                squared_radius = std::max(squared_radius, squared_distance);
                                neighbors.emplace_back(vector(p), squared_distance);
                              });
    double sum = 0.;
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    for (auto& [p, weight] : neighbors)
    {
      weight = squared_radius > 0. ? std::exp(-4. * weight / squared_radius) : 1.;
      center += weight * p;
      sum += weight;
    }
    center /= sum;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (const auto& [p, weight] : neighbors)
      covariance += weight * (p - center) * (p - center).transpose();
    const Eigen::Matrix3d axes =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors();

    // the foot of the query on the plane is the origin of the height field
    const Eigen::Vector3d q = vector(query), normal = axes.col(0);
    const Eigen::Vector3d foot = q - normal.dot(q - center) * normal;
    const double scale = std::sqrt(squared_radius) + 1e-300;
    Eigen::MatrixXd A(static_cast<Eigen::Index>(neighbors.size()), 6);
    Eigen::VectorXd b(A.rows());
    for (Eigen::Index i = 0; i < A.rows(); ++i)
    {
      const auto& [p, weight] = neighbors[static_cast<std::size_t>(i)];
      const double u = axes.col(1).dot(p - foot) / scale, v = axes.col(2).dot(p - foot) / scale;
      A.row(i) << 1., u, v, u * u, u * v, v * v;
      A.row(i) *= std::sqrt(weight);
      b(i) = std::sqrt(weight) * normal.dot(p - foot);
    }
    const double height = A.colPivHouseholderQr().solve(b)(0);
    const Eigen::Vector3d result = foot + height * normal;
    return Point(result.x(), result.y(), result.z());
  }

  Neighbor_search m_search;
  std::size_t m_size;
};

} // namespace comparison

#endif // CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_MOVING_LEAST_SQUARES_H
