#ifndef CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_PRINCIPAL_AXES_H
#define CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_PRINCIPAL_AXES_H

#include <comparison/types.h>

#include <Eigen/Dense>

#include <array>

namespace comparison {

// Principal component analysis: the center of weighted points, the directions in which they extend
// and the variances along these, the least first. axes[0] is the normal of the least squares plane.
struct Principal_axes
{
  Point center;
  std::array<Vector, 3> axes;
  std::array<double, 3> variances;

  // surface variation (Pauly et al. 2002), in [0, 1/3]; 0 for points that coincide
  double variation() const
  {
    const double sum = variances[0] + variances[1] + variances[2];
    return sum > 0. && variances[0] > 0. ? variances[0] / sum : 0.;
  }
};

// Sums over weighted points, relative to one near them, so that large coordinates lose no digits
class Moments
{
public:
  explicit Moments(const Point& near) : m_near(near) {}

  void add(double weight, const Point& p)
  {
    const Eigen::Vector3d v(p.x() - m_near.x(), p.y() - m_near.y(), p.z() - m_near.z());
    m_weight += weight;
    m_first += weight * v;
    m_second += weight * v * v.transpose();
  }

  Point center() const
  {
    const Eigen::Vector3d mean = m_first / m_weight;
    return m_near + Vector(mean.x(), mean.y(), mean.z());
  }

  Principal_axes principal_axes() const
  {
    const Eigen::Vector3d mean = m_first / m_weight;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(m_second / m_weight -
                                                                mean * mean.transpose());
    Principal_axes result;
    result.center = center();
    for (int i = 0; i < 3; ++i)
    {
      const auto axis = solver.eigenvectors().col(i);
      const auto k = static_cast<std::size_t>(i);
      result.axes[k] = Vector(axis.x(), axis.y(), axis.z());
      result.variances[k] = solver.eigenvalues()(i);
    }
    return result;
  }

private:
  Point m_near;
  double m_weight = 0.;
  Eigen::Vector3d m_first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d m_second = Eigen::Matrix3d::Zero();
};

} // namespace comparison

#endif // CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_BASELINES_PRINCIPAL_AXES_H
