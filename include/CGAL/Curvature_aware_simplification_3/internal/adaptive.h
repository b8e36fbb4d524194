#pragma once
#include <CGAL/Curvature_aware_simplification_3/internal/counter_based_random.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise_level.h>
#include <CGAL/Curvature_aware_simplification_3/internal/outliers.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters.h>
#include <CGAL/Real_timer.h>
#include <iostream>
#include <memory>
namespace CGAL { namespace Curvature_aware_simplification_3 { namespace internal {

// lambda_0 of the k nearest, and radius
inline std::pair<double, double> flatness(const Neighbor_search& search, const Point& x, std::size_t k)
{
  Eigen::Vector3d m(0, 0, 0); Eigen::Matrix3d c = Eigen::Matrix3d::Zero(); double r2 = 0, n = 0;
  search.for_each_nearest(x, k, [&](std::size_t, const Point& p, double d2) { Eigen::Vector3d q(p.x() - x.x(), p.y() - x.y(), p.z() - x.z()); m += q; c += q * q.transpose(); r2 = (std::max)(r2, d2); n += 1; });
  m /= n; c = c / n - m * m.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> e; e.computeDirect(c, Eigen::EigenvaluesOnly);
  return {(std::max)(e.eigenvalues()(0), 0.), std::sqrt(r2)};
}

struct Density { std::vector<double> n; std::vector<double> a; double mean_spacing; };

// samples per area wanted at each point
template <typename Tag>
Density target_density(const std::vector<Point>& pts, const Neighbor_search& search, const std::vector<double>& area, std::size_t N, double sigma)
{
  TUNE(CAND, 2.); TUNE(CR, 1.); TUNE(GAMMA, 0.67); TUNE(FLOOR, 0.2); TUNE(NFL, 2.); TUNE(CAP, 0.5); TUNE(RSIG, 3.);
  const std::size_t M = pts.size();
  double A = 0; for (double a : area) A += a;
  const double s = std::sqrt(2 / std::sqrt(3.) * A / N);
  const std::size_t C = (std::min)(M, static_cast<std::size_t>(CAND * N) + 1);
  std::vector<double> k(C), ca(C), sa(C);
  const auto begin = [&](std::size_t b) { return b * M / C; };
  const double R = (std::max)(CR * s, RSIG * sigma);
  for_each_index<Tag>(0, C, [&](std::size_t b) {
    const std::size_t i = (begin(b) + begin(b + 1)) / 2;
    double a = 0; for (std::size_t j = begin(b); j < begin(b + 1); ++j) a += area[j];
    ca[b] = a;
    const double number = CGAL_PI * R * R / (a / (begin(b + 1) - begin(b)));
    const std::size_t kk = (std::min)(M, static_cast<std::size_t>((std::min)(400., (std::max)(16., number))) + 1);
    const auto f = flatness(search, pts[i], kk);
    const double l = f.first - sigma * sigma * (1 + NFL * std::sqrt(2. / kk));
    sa[b] = CGAL_PI * f.second * f.second / (kk - 1);
    k[b] = f.second > 0 ? 7 * std::sqrt((std::max)(l, 0.)) / (f.second * f.second) : 0.;
  });
  double mean = 0; for (std::size_t b = 0; b < C; ++b) mean += ca[b] / A * std::pow(k[b], GAMMA);
  const double k0 = mean > 0 ? FLOOR * std::pow(mean, 1 / GAMMA) : 1.;
  std::vector<double> n(C);
  double total = 0;
  for (std::size_t b = 0; b < C; ++b) { n[b] = std::pow(k[b] * k[b] + k0 * k0, GAMMA / 2); total += n[b] * ca[b]; }
  Density d; d.n.resize(M); d.a.resize(M); d.mean_spacing = s;
  for (int it = 0; it < 3; ++it)
  {
    double f = N / total; total = 0;
    for (std::size_t b = 0; b < C; ++b) { const double a = ca[b] / (begin(b + 1) - begin(b)); n[b] = (std::min)(f * n[b], CAP / a); total += n[b] * ca[b]; }
  }
  for (std::size_t b = 0; b < C; ++b) for (std::size_t j = begin(b); j < begin(b + 1); ++j) { d.n[j] = n[b] * N / total; d.a[j] = sa[b]; }
  return d;
}

inline std::vector<std::size_t> stratified_selection(const std::vector<double>& w, std::size_t N, std::uint64_t seed)
{
  TUNE(JITTER, 0.);
  double W = 0; for (double x : w) W += x;
  const Counter_based_random random(seed, 0);
  const double u = random.uniform(0);
  std::vector<std::size_t> r; r.reserve(N);
  std::vector<char> used(w.size(), 0);
  double c = 0; std::size_t j = 0;
  for (std::size_t i = 0; i < w.size() && r.size() < N; ++i)
  {
    c += w[i];
    const double t = (j + (JITTER > 0 ? 0.5 + JITTER * (random.uniform(j + 1) - 0.5) : u)) * W / N;
    if (c > t) { r.push_back(i); used[i] = 1; ++j; }
  }
  for (std::size_t i = 0; r.size() < N && i < w.size(); ++i) if (!used[i]) { r.push_back(i); used[i] = 1; }
  std::sort(r.begin(), r.end());
  return r;
}

struct Moving { Patch patch; double a = 0, b = 0; double s = 0; Point x; Vector n; };

inline void limit(const Neighbor_search& search, std::size_t M, Patch& p)
{
  // the input's extent in the direction in which it ends
  static thread_local Neighbors nb;
  sort_neighbors(search, p.origin, (std::min)(std::size_t(19), M), nb);
  double r2 = 0; for (auto& q : nb) r2 = (std::max)(r2, q.d2);
  double mx = 0, my = 0, sw = 0;
  for (auto& q : nb) { const double t = 1 - q.d2 / (r2 * 1.0001); const double w = t * t; mx += w * (q.p * p.u); my += w * (q.p * p.v); sw += w; }
  const double l = std::sqrt(mx * mx + my * my);
  TUNE(BORDER, 0.15);
  p.has_border = false;
  if (!(l > BORDER * sw * std::sqrt(r2))) return;
  p.border_x = -mx / l; p.border_y = -my / l;
  double m = -1e300;
  for (auto& q : nb) { const double a = q.p * p.u, b = q.p * p.v; if (std::abs(a * p.border_y - b * p.border_x) < 0.5 * std::sqrt(r2)) m = (std::max)(m, a * p.border_x + b * p.border_y); }
  p.border_limit = m; p.has_border = m > -1e299;
}

template <typename Tag>
std::vector<Point> adaptive_simplify(const Cloud& cloud, const Neighbor_search& all, const Features& f, const Parameters& par, bool verbose)
{
  TUNE(OUTLIERS, 1.); TUNE(ITER, 10.); TUNE(MU, 0.45); TUNE(REP_R, 2.); TUNE(REP_E, 1.5); TUNE(HW, 2.); TUNE(TRUST, 0.7); TUNE(SMOOTH, 1.); TUNE(PHI, 2.); TUNE(FINAL, 1.); TUNE(REPP, 1.); TUNE(PLACES, 1); TUNE(FINE, 0); TUNE(MINR, 6); TUNE(SMA, 1); TUNE(Q_PCA, 0); TUNE(F_PCA, 0);
  Real_timer timer; timer.start(); auto lap = [&](const char* n) { if (verbose) std::cerr << n << " " << int(timer.time() * 1000) << "  "; timer.reset(); };
  const std::size_t N = par.number_of_output_points;
  std::vector<Point> pts; std::vector<double> area;
  std::vector<std::uint8_t> out(cloud.size(), 0);
  if (OUTLIERS > 0) out = find_outliers<Tag>(cloud, all, f, neighborhood_size(par.number_of_neighbors, cloud.size()) - 1);
  std::size_t rejected = 0; for (auto o : out) rejected += o;
  if (cloud.size() - rejected < N) { std::fill(out.begin(), out.end(), 0); rejected = 0; }
  for (std::size_t i = 0; i < cloud.size(); ++i) if (!out[i]) { pts.push_back(cloud.points[i]); area.push_back(CGAL_PI * f.inverse_density[i]); }
  std::unique_ptr<Neighbor_search> own; const Neighbor_search* sp = &all;
  if (rejected) { own.reset(new Neighbor_search(pts, Tag())); sp = own.get(); }
  const Neighbor_search& search = *sp;
  const std::size_t M = pts.size();
  lap("outliers");
  const double sigma = noise_level<Tag>(pts, search);
  lap("noise");
  const Density density = target_density<Tag>(pts, search, area, N, sigma);
  lap("density");
  std::vector<double> w(M); for (std::size_t i = 0; i < M; ++i) w[i] = density.n[i] * (SMA > 0 ? density.a[i] : area[i]);
  const std::vector<std::size_t> selected = stratified_selection(w, N, par.random_seed);
  lap("select");
  std::vector<Moving> x(selected.size());
  const auto spacing_of = [&](double n) { return std::sqrt(2 / std::sqrt(3.) / n); };
  const auto place = [&](Moving& m, const Point& p, const Vector& guess, bool fine) {
    m.patch = fit_patch(search, M, p, guess, sigma, m.s, fine, MINR); limit(search, M, m.patch);
    m.a = m.b = 0; if (m.patch.has_border && m.patch.border_limit < 0) { m.a = m.patch.border_limit * m.patch.border_x; m.b = m.patch.border_limit * m.patch.border_y; }
    m.x = m.patch.at(m.a, m.b); m.n = m.patch.normal(m.a, m.b); };
  for_each_index<Tag>(0, x.size(), [&](std::size_t i) { x[i].s = spacing_of(density.n[selected[i]]); place(x[i], pts[selected[i]], NULL_VECTOR, FINE > 0); for (int q = 1; q < PLACES; ++q) place(x[i], x[i].x, Q_PCA > 0 ? NULL_VECTOR : x[i].n, FINE > 0); });
  lap("place");
  std::vector<Point> pos(x.size());
  std::atomic<std::size_t> refits(0);
  for (int it = 0; it < static_cast<int>(ITER); ++it)
  {
    for (std::size_t i = 0; i < x.size(); ++i) pos[i] = x[i].x;
    const Neighbor_search tree(pos, Tag());
    if (it == 0)
      for (int round = 0; round < static_cast<int>(SMOOTH); ++round)
      {
        std::vector<double> ns(x.size());
        for_each_index<Tag>(0, x.size(), [&](std::size_t i) { double sum = 0, c = 0; tree.for_each_nearest(pos[i], (std::min)(std::size_t(9), pos.size()), [&](std::size_t j, const Point&, double) { sum += std::log(x[j].s); ++c; }); ns[i] = std::exp(sum / c); });
        for (std::size_t i = 0; i < x.size(); ++i) x[i].s = ns[i];
      }
    std::vector<Moving> y = x;
    for_each_index<Tag>(0, x.size(), [&](std::size_t i) {
      const Moving& m = x[i]; Moving& r = y[i];
      Vector sum(0, 0, 0); double sw = 0; const double is2 = 1 / (m.s * m.s);
      tree.for_each_within(m.x, REP_R * m.s, [&](std::size_t j, const Point& q, double d2) {
        if (j == i || !(d2 > 0)) return;
        const Vector d = m.x - q; const double h = d * m.n; const Vector t = d - h * m.n;
        const double rho2 = (t.squared_length() + HW * HW * h * h) * is2;
        const double beta = std::exp(-REP_E * rho2) / std::pow(rho2, REPP / 2) * std::pow(x[j].s / m.s, PHI);
        sum = sum + beta * t; sw += beta; });
      if (!(sw > 0)) return;
      Vector step = (MU / sw) * sum;
      const double l = std::sqrt(step.squared_length()); if (l > 0.5 * m.s) step = (0.5 * m.s / l) * step;
      double a = m.a + step * m.patch.u, b = m.b + step * m.patch.v;
      if (m.patch.has_border) { const double e = a * m.patch.border_x + b * m.patch.border_y - m.patch.border_limit; if (e > 0) { a -= e * m.patch.border_x; b -= e * m.patch.border_y; } }
      const double dist = std::sqrt(a * a + b * b);
      const double lim = TRUST * m.patch.radius;
      if (dist > lim) { const double c = (std::min)(1., 1.5 * m.patch.radius / dist); place(r, m.patch.at(c * a, c * b), m.patch.normal(c * a, c * b), FINE > 0); ++refits; }
      else { r.a = a; r.b = b; r.x = m.patch.at(a, b); r.n = m.patch.normal(a, b); } });
    x.swap(y);
  }
  lap("relax");
  TUNE(POOL, 1); TUNE(PMINR, 5); TUNE(PNB, 33); TUNE(PCLIP, 50); TUNE(PTOL, 0.01);
  if (POOL > 0 && 0.5 * sigma > PTOL * density.mean_spacing)
  { // bandwidth of the final fits: least risk, estimated from how the heights of several scales differ, pooled over neighbors
    struct Scale { Point x; Vector n; double d2, var; };
    std::vector<std::vector<Scale>> sc(x.size());
    for_each_index<Tag>(0, x.size(), [&](std::size_t i) {
      std::vector<Patch> f; fit_patch(search, M, x[i].x, x[i].n, sigma, x[i].s, true, PMINR, &f);
      for (const Patch& p : f) { const double d = (p.origin - f[0].origin) * p.n; const double dv = f[0].error * f[0].error - p.error * p.error; sc[i].push_back({p.origin, p.n, (std::min)(d * d, PCLIP * (std::max)(dv, 0.)), p.error * p.error}); }
      pos[i] = f.empty() ? x[i].x : f[0].origin; });
    const Neighbor_search tree(pos, Tag());
    std::vector<int> chosen(x.size(), 0);
    TUNE(EXC, 1);
    std::vector<double> excess;
    for (auto& q : sc) if (q.size() > 1) excess.push_back((q[1].d2 / 0.455 - (q[0].var - q[1].var)) / q[0].var);
    double E = 0; if (!excess.empty()) { auto mid = excess.begin() + excess.size() / 2; std::nth_element(excess.begin(), mid, excess.end()); E = EXC * (std::max)(*mid, 0.); }
    if (verbose) std::cerr << "  excess " << E;
    for_each_index<Tag>(0, x.size(), [&](std::size_t i) {
      if (sc[i].empty()) return;
      std::vector<double> d2(sc[i].size(), 0.), c(sc[i].size(), 0.), v(sc[i].size(), 0.);
      tree.for_each_nearest(pos[i], (std::min)(static_cast<std::size_t>(PNB), pos.size()), [&](std::size_t j, const Point&, double) { for (std::size_t m = 0; m < (std::min)(sc[i].size(), sc[j].size()); ++m) { d2[m] += sc[j][m].d2; v[m] += sc[j][m].var; c[m] += 1; } });
      double best = 1e300; const double v0 = v[0] / c[0];
      for (std::size_t m = 0; m < sc[i].size(); ++m) { const double risk = m == 0 ? (1 + E) * v0 : (std::max)(d2[m] / c[m] - (E + 1) * v0 + v[m] / c[m], 0.) + v[m] / c[m]; if (risk < best) { best = risk; chosen[i] = static_cast<int>(m); } } });
    for (std::size_t i = 0; i < x.size(); ++i) if (!sc[i].empty()) { x[i].x = sc[i][chosen[i]].x; x[i].n = sc[i][chosen[i]].n; }
    if (verbose) { std::vector<int> h(8); for (int c : chosen) ++h[c]; std::cerr << "  scales:"; for (int c : h) std::cerr << " " << c; std::cerr << "  "; }
  }
  else
    for_each_index<Tag>(0, x.size(), [&](std::size_t i) { for (int q = 0; q < FINAL; ++q) { const Moving m = x[i]; place(x[i], m.x, F_PCA > 0 ? NULL_VECTOR : m.n, true); } });
  lap("final");
  TUNE(POLISH, 0); TUNE(PREJ, 2.5);
  if (POLISH > 0 && sigma > 0)
  {
    for (std::size_t i = 0; i < x.size(); ++i) pos[i] = x[i].x;
    const Neighbor_search tree(pos, Tag());
    std::vector<Point> polished = pos;
    for_each_index<Tag>(0, x.size(), [&](std::size_t i) {
      double sum = 0, sw = 0; const Vector n = x[i].n;
      tree.for_each_nearest(pos[i], (std::min)(std::size_t(13), pos.size()), [&](std::size_t j, const Point&, double) {
        const Patch& p = x[j].patch; const Vector d = pos[i] - p.origin; const double a = d * p.u, b = d * p.v;
        const double t = 1 - (a * a + b * b) / (p.radius * p.radius); const double c = n * p.n;
        if (t <= 0 || std::abs(c) < 0.5) return;
        const double h = (p.height(a, b) - d * p.n) * c; // along n, to first order
        const double e = h / (PREJ * (std::max)(sigma, p.spread) );
        const double w = t * t * std::exp(-0.5 * e * e);
        sum += w * h; sw += w; });
      if (sw > 0) polished[i] = pos[i] + (sum / sw) * n; });
    for (std::size_t i = 0; i < x.size(); ++i) x[i].x = polished[i];
    lap("polish");
  }
  std::vector<Point> result; for (auto& m : x) result.push_back(m.x);
  if (verbose) std::cerr << "\n   rejected " << rejected << " sigma " << sigma << " s " << density.mean_spacing << " refits " << refits.load() << "\n";
  return result;
}
} } }
