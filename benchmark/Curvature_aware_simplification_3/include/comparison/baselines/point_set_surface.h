#ifndef CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_POINT_SET_SURFACE_H
#define CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_POINT_SET_SURFACE_H

#include <comparison/baselines/principal_axes.h>
#include <comparison/types.h>

#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace comparison {

// The moving least squares surface of points, with Levin's projection in two steps: onto a plane
// with Gaussian weights around the foot of the projection, then along its normal to a quadratic
// polynomial over the plane.
//
// The Gaussian exp(-r^2 / h^2) is adapted to the density as by Pauly et al. (2002): h is half of
// the distance to the k-th neighbor, whose weight is then 2%.
class Point_set_surface
{
public:
  Point_set_surface(const Points& points, std::size_t number_of_neighbors)
    : m_search(points, Tag()), m_size(std::min(number_of_neighbors, points.size()))
  {}

  Point project(const Point& x) const
  {
    Point foot = x;
    std::vector<Weighted_point> neighbors;
    Principal_axes plane;
    // The normal hardly changes while the foot slides to its place: three steps are enough.
    for (int step = 0; step < 3; ++step)
    {
      neighbors = weighted_neighbors(foot);
      Moments moments(foot);
      for (const Weighted_point& n : neighbors)
        moments.add(n.weight, n.point);
      plane = moments.principal_axes();
      foot = foot - ((foot - plane.center) * plane.axes[0]) * plane.axes[0];
    }
    return foot + height(foot, plane, neighbors) * plane.axes[0];
  }

private:
  using Neighbor_search = CGAL::Curvature_aware_simplification_3::internal::Neighbor_search;

  struct Weighted_point
  {
    Point point;
    double weight;
  };

  std::vector<Weighted_point> weighted_neighbors(const Point& x) const
  {
    std::vector<Weighted_point> neighbors;
    neighbors.reserve(m_size);
    double largest = 0.;
    m_search.for_each_nearest(x, m_size, [&](std::size_t, const Point& p, double squared_distance) {
      neighbors.push_back({p, squared_distance});
      largest = std::max(largest, squared_distance);
    });
    for (Weighted_point& n : neighbors)
      n.weight = largest > 0. ? std::exp(-4. * n.weight / largest) : 1.;
    return neighbors;
  }

  // The value at the foot of the quadratic polynomial that fits the heights over the plane; 0, the
  // plane itself, where the points do not determine one: they are too few, or lie on a line.
  static double height(const Point& foot, const Principal_axes& plane,
                       const std::vector<Weighted_point>& neighbors)
  {
    using Coefficients = Eigen::Matrix<double, 6, 1>;
    const double unit = std::sqrt(plane.variances[2]);
    if (!(plane.variances[1] > 0.))
      return 0.;
    Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Zero();
    Coefficients right_side = Coefficients::Zero();
    for (const Weighted_point& n : neighbors)
    {
      const Vector d = (n.point - foot) / unit;
      const double u = d * plane.axes[1], v = d * plane.axes[2];
      Coefficients monomials;
      monomials << 1., u, v, u * u, u * v, v * v;
      matrix += n.weight * monomials * monomials.transpose();
      right_side += n.weight * (d * plane.axes[0]) * monomials;
    }
    const Eigen::LDLT<Eigen::Matrix<double, 6, 6>> solver(matrix);
    // the square of what double precision resolves in the polynomial
    if (!(solver.rcond() > 1e-8))
      return 0.;
    const double value = unit * solver.solve(right_side)(0);
    // beyond the neighborhood, at a border, a polynomial is no surface
    return std::abs(value) < unit ? value : 0.;
  }

  Neighbor_search m_search;
  std::size_t m_size;
};

} // namespace comparison

#endif // CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_POINT_SET_SURFACE_H
