#pragma once
#include <CGAL/Curvature_aware_simplification_3/internal/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tune.h>
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>
namespace CGAL { namespace Curvature_aware_simplification_3 { namespace internal {

struct Patch
{
  Point origin;
  Vector u, v, n;
  double c[6] = {0, 0, 0, 0, 0, 0}; // f = c0 + c1 a + c2 b + c3 a^2 + c4 ab + c5 b^2
  double radius = 0.;               // of the neighborhood
  double error = 0.;                // standard deviation of the height at the origin
  double spread = 0.;               // of the residuals
  bool has_border = false; double border_limit = -1.;        // (x - origin) * outward <= border_limit, if not negative
  double border_x = 0, border_y = 0;
  double height(double a, double b) const { return c[0] + c[1] * a + c[2] * b + c[3] * a * a + c[4] * a * b + c[5] * b * b; }
  Point at(double a, double b) const { return origin + a * u + b * v + height(a, b) * n; }
  Vector normal(double a, double b) const
  {
    const double fa = c[1] + 2 * c[3] * a + c[4] * b, fb = c[2] + c[4] * a + 2 * c[5] * b;
    const Vector m = n - fa * u - fb * v;
    return m / std::sqrt(m.squared_length());
  }
};

inline void complete_frame(Patch& p)
{
  const Vector& n = p.n;
  const Vector axis = std::abs(n.x()) < std::abs(n.y()) ? (std::abs(n.x()) < std::abs(n.z()) ? Vector(1, 0, 0) : Vector(0, 0, 1))
                                                         : (std::abs(n.y()) < std::abs(n.z()) ? Vector(0, 1, 0) : Vector(0, 0, 1));
  p.u = cross_product(n, axis);
  p.u = p.u / std::sqrt(p.u.squared_length());
  p.v = cross_product(n, p.u);
}

struct Neighbor { double d2; Vector p; double w; }; // relative to the query
using Neighbors = std::vector<Neighbor>;

struct Fit_scale { double sigma; double spacing; };

inline void sort_neighbors(const Neighbor_search& search, const Point& x, std::size_t k, Neighbors& out)
{
  out.clear();
  search.for_each_nearest(x, k, [&](std::size_t, const Point& p, double d2) { out.push_back({d2, p - x, 1.}); });
}

// plane of the weighted neighbors
inline Vector pca_normal(const Neighbors& nb, const std::vector<double>& w)
{
  double s = 0; Eigen::Vector3d m(0, 0, 0); Eigen::Matrix3d c = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < nb.size(); ++i) { Eigen::Vector3d q(nb[i].p.x(), nb[i].p.y(), nb[i].p.z()); s += w[i]; m += w[i] * q; c += w[i] * q * q.transpose(); }
  if (!(s > 0)) return Vector(0, 0, 1);
  m /= s; c = c / s - m * m.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> e; e.computeDirect(c);
  Eigen::Vector3d n = e.eigenvectors().col(0);
  double l = n.norm();
  if (!(l > 0.5)) return Vector(0, 0, 1);
  n /= l;
  return Vector(n.x(), n.y(), n.z());
}

// weighted least-squares quadric in the frame of patch; w: weights. Leverage -> error factor
inline bool solve_quadric(const Neighbors& nb, const std::vector<double>& w, const Vector& offset, Patch& p, double& leverage)
{
  Eigen::Matrix<double, 6, 6> A = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> b = Eigen::Matrix<double, 6, 1>::Zero();
  const double inv = 1. / p.radius;
  double sw = 0, sw2 = 0;
  for (std::size_t i = 0; i < nb.size(); ++i)
  {
    if (!(w[i] > 0)) continue;
    const Vector q = nb[i].p - offset;
    const double a = (q * p.u) * inv, bb = (q * p.v) * inv, h = (q * p.n) * inv;
    Eigen::Matrix<double, 6, 1> r; r << 1, a, bb, a * a, a * bb, bb * bb;
    A.template selfadjointView<Eigen::Lower>().rankUpdate(r, w[i]);
    b += w[i] * h * r; sw += w[i]; sw2 += w[i] * w[i];
  }
  if (!(sw > 0)) return false;
  static const double RIDGE = tune("RIDGE", 1e-3);
  for (int i = 1; i < 6; ++i) A(i, i) += (i < 3 ? 1e-9 : RIDGE * 0.01) * sw;
  Eigen::LDLT<Eigen::Matrix<double, 6, 6>> ldlt(A.template selfadjointView<Eigen::Lower>());
  Eigen::Matrix<double, 6, 1> c = ldlt.solve(b);
  Eigen::Matrix<double, 6, 1> e = Eigen::Matrix<double, 6, 1>::Zero(); e(0) = 1;
  Eigen::Matrix<double, 6, 1> l = ldlt.solve(e);
  leverage = std::sqrt((std::max)(l(0), 0.) * sw2 / sw);
  if (!c.allFinite()) return false;
  p.c[0] = c(0) * p.radius; p.c[1] = c(1); p.c[2] = c(2); for (int i = 3; i < 6; ++i) p.c[i] = c(i) * inv;
  return true;
}

inline double robust_spread(std::vector<double>& r)
{
  if (r.empty()) return 0;
  auto m = r.begin() + r.size() / 2; std::nth_element(r.begin(), m, r.end());
  return 1.4826 * *m;
}

// The same surface from its foot point: origin and normal move there, the second order is taken along.
inline void recenter(Patch& p)
{
  const Vector nn = p.normal(0, 0); const double cosine = nn * p.n, c0 = p.c[0];
  const Vector foot = (c0 * cosine) * nn;
  Patch q = p; q.n = nn; complete_frame(q);
  const double rest = p.height(foot * p.u, foot * p.v) - foot * p.n;
  q.origin = p.origin + foot + (rest * cosine) * nn;
  const double uu = q.u * p.u, uv = q.u * p.v, vu = q.v * p.u, vv = q.v * p.v;
  q.c[0] = q.c[1] = q.c[2] = 0;
  q.c[3] = cosine * (p.c[3] * uu * uu + p.c[4] * uu * uv + p.c[5] * uv * uv);
  q.c[4] = cosine * (2 * p.c[3] * uu * vu + p.c[4] * (uu * vv + uv * vu) + 2 * p.c[5] * uv * vv);
  q.c[5] = cosine * (p.c[3] * vu * vu + p.c[4] * vu * vv + p.c[5] * vv * vv);
  p = q;
}

// The patch of the input around x: local quadrics at growing scales, aggregated. `guess`: normal or null vector.
inline Patch fit_patch(const Neighbor_search& search, std::size_t number_of_points, const Point& x, const Vector& guess, double sigma, double spacing, bool fine = true, double minr = 6., std::vector<Patch>* scales = nullptr)
{
  TUNE(K0, 18); TUNE(KMAX, 288);  TUNE(TOL, 0.01); TUNE(LEPSKI, 2.); TUNE(MOVES, 3); TUNE(RECENTER, 0.5); TUNE(CYL, 1); TUNE(ROBUST, 2.5); TUNE(IRLS, 2); TUNE(GROW, 2.); TUNE(SOFT, 1); TUNE(BFLOOR, 0.5);
  static thread_local Neighbors nb, all; static thread_local std::vector<double> w, res;
  Patch p; p.origin = x; p.n = guess == NULL_VECTOR ? Vector(0, 0, 1) : guess;
  std::size_t k = (std::min)(static_cast<std::size_t>(K0) + 1, number_of_points);
  const std::size_t kmax = (std::min)(static_cast<std::size_t>(KMAX) + 1, number_of_points);
  bool have = false; int moves = 0;
  Vector offset(0, 0, 0);
  for (;;)
  {
    sort_neighbors(search, p.origin, k, nb);
    double r2 = 0; for (auto& q : nb) r2 = (std::max)(r2, q.d2);
    const double r = std::sqrt(r2);
    const bool last = k >= kmax;
    if (!last && r < minr * sigma) { k = (std::min)(kmax, static_cast<std::size_t>(k * (std::min)(4., (std::max)(1.2, 1.1 * std::pow(minr * sigma / (r + 1e-300), 2))) + 1)); continue; }
    if (!(r > 0)) break;
    w.resize(nb.size());
    const auto theta = [&](std::size_t i) { double d2 = nb[i].d2; if (CYL > 0 && sigma > 0 && have) { const double h = nb[i].p * p.n; d2 -= h * h; } double t = 1. - d2 / (r2 * 1.0001); return t * t; };
    const auto residual = [&](const Patch& q, std::size_t i) { const Vector& d = nb[i].p; return d * q.n - q.height(d * q.u, d * q.v); };
    double leverage = 1;
    if (!have)
    {
      p.radius = r;
      for (std::size_t i = 0; i < nb.size(); ++i) w[i] = theta(i);
      if (guess == NULL_VECTOR && moves == 0) p.n = pca_normal(nb, w);
      complete_frame(p);
      bool ok = solve_quadric(nb, w, offset, p, leverage);
      for (int it = 0; it <= IRLS && ok; ++it)
      {
        res.clear();
        for (std::size_t i = 0; i < nb.size(); ++i) res.push_back(std::abs(residual(p, i)));
        p.spread = (std::max)(robust_spread(res) * std::sqrt(nb.size() / (std::max)(nb.size() - 5., 1.)), sigma);
        if (!(p.spread > 0) || it >= IRLS) break;
        for (std::size_t i = 0; i < nb.size(); ++i) { const double e = residual(p, i) / (ROBUST * p.spread); w[i] = theta(i) * std::exp(-0.5 * e * e); }
        ok = solve_quadric(nb, w, offset, p, leverage);
      }
      if (!ok) { for (double& c : p.c) c = 0; break; }
      // a neighborhood around a point off the surface is biased towards it: once more around its foot point
      const double moved = std::abs(p.c[0]);
      recenter(p);
      if (moved > RECENTER * sigma && moves < static_cast<int>(MOVES) && sigma > 0)
      {
        ++moves; for (double& c : p.c) c = 0;
        continue;
      }
      p.error = sigma * leverage;
      have = true; if (scales) scales->push_back(p);
    }
    else
    {
      // the model so far tells which points belong to the sheet; its uncertainty grows away from the center
      for (std::size_t i = 0; i < nb.size(); ++i)
      {
        const double grow = 1. + BFLOOR * nb[i].d2 / (p.radius * p.radius);
        const double e = residual(p, i) / (ROBUST * p.spread * grow); w[i] = theta(i) * std::exp(-0.5 * e * e);
      }
      Patch q = p; q.radius = r;
      if (!solve_quadric(nb, w, offset, q, leverage)) break;
      q.error = sigma * leverage;
      if (!(q.error < p.error)) break;
      if (scales) { recenter(q); p = q; scales->push_back(p); if (last) break; k = (std::min)(kmax, static_cast<std::size_t>(GROW * k)); continue; }
      const double shift = q.c[0] - p.c[0];
      const double variance = (std::max)(p.error * p.error - q.error * q.error, 1e-300);
      const double t = shift * shift / (LEPSKI * LEPSKI * variance);
      const double g = SOFT > 0 ? (t < 1 ? 1. : std::exp(-2. * (t - 1))) : (t < 1 ? 1. : 0.);
      if (g < 0.05) break;
      for (int i = 0; i < 6; ++i) p.c[i] += g * (q.c[i] - p.c[i]);
      p.error += g * (q.error - p.error);
      p.radius += g * (r - p.radius);
      recenter(p);
      if (g < 0.5) break;
    }
    if (last || (!scales && (!fine || p.error < TOL * spacing))) break;
    k = (std::min)(kmax, static_cast<std::size_t>(GROW * k));
  }
  if (!have) complete_frame(p);
  return p;
}
} } }
