#pragma once
#include <CGAL/Curvature_aware_simplification_3/internal/Cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fit_patch.h>
#include <CGAL/Curvature_aware_simplification_3/internal/loops.h>
namespace CGAL { namespace Curvature_aware_simplification_3 { namespace internal {

// (median residual of quadrics, median radius) at probes for k neighbors
template <typename Tag>
std::pair<double, double> median_residual(const std::vector<Point>& points, const Neighbor_search& search, std::size_t k, std::size_t probes)
{
  std::vector<double> s(probes), rad(probes);
  for_each_index<Tag>(0, probes, [&](std::size_t i) {
    const Point& x = points[(2 * i + 1) * points.size() / (2 * probes)];
    Neighbors nb; sort_neighbors(search, x, k, nb);
    double r2 = 0; for (auto& q : nb) r2 = (std::max)(r2, q.d2);
    rad[i] = std::sqrt(r2);
    if (!(r2 > 0)) return;
    std::vector<double> w(nb.size(), 1.);
    Patch p; p.n = pca_normal(nb, w); p.origin = x; p.radius = std::sqrt(r2); complete_frame(p);
    double l; Vector off(0, 0, 0);
    if (!solve_quadric(nb, w, off, p, l)) return;
    std::vector<double> res; double s2 = 0;
    for (auto& q : nb) { const double e = q.p * p.n - p.height(q.p * p.u, q.p * p.v); s2 += e * e; }
    s[i] = std::sqrt(s2 / (std::max)(nb.size() - 6., 1.));
  });
  auto med = [](std::vector<double> v) { auto m = v.begin() + v.size() / 2; std::nth_element(v.begin(), m, v.end()); return *m; };
  return {med(s), med(rad)};
}

template <typename Tag>
double noise_level(const std::vector<Point>& points, const Neighbor_search& search)
{
  const std::size_t probes = (std::min)(std::size_t(512), points.size());
  std::size_t k = 17;
  double s = 0, r = 0;
  for (;;)
  {
    std::tie(s, r) = median_residual<Tag>(points, search, (std::min)(k, points.size()), probes);
    if (r >= 4 * s || k > 500 || k >= points.size()) break;
    k = 2 * k;
  }
  const std::size_t k2 = 2 * k;
  if (k2 > points.size()) return 0;
  const double s2 = median_residual<Tag>(points, search, k2, probes).first;
  // s_k^2 = sigma^2 + c k^3: the residual of a smooth surface is cubic in the radius
  return std::sqrt((std::max)(0., (8. * s * s - s2 * s2) / 7.));
}
} } }
