#pragma once
#include <CGAL/Curvature_aware_simplification_3/internal/Cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/loops.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tune.h>
#include <atomic>
#include <cstdint>
namespace CGAL { namespace Curvature_aware_simplification_3 { namespace internal {

template <typename Tag>
std::vector<std::uint8_t> find_outliers(const Cloud& cloud, const Neighbor_search& search, const Features& f, std::size_t k)
{
  TUNE(OUT_DEG, 0.25); TUNE(OUT_R, 3.); TUNE(OUT_KAPPA, 0.07); TUNE(PASSES, 10);
  const std::size_t n = cloud.size();
  std::vector<double> r2(f.inverse_density);
  auto m = r2.begin() + n / 2; std::nth_element(r2.begin(), m, r2.end());
  const double median = *m;
  std::vector<std::uint8_t> out(n);
  std::vector<std::atomic<std::uint32_t>> votes(n);
  for (std::size_t i = 0; i < n; ++i) votes[i] = f.in_degree[i];
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < n; ++i)
  {
    const bool far = f.inverse_density[i] > OUT_R * OUT_R * median && f.curvature[i] > OUT_KAPPA;
    out[i] = far || f.in_degree[i] < OUT_DEG * k;
    if (out[i]) found.push_back(i);
  }
  for (int pass = 0; pass < PASSES && !found.empty(); ++pass)
  {
    for_each_index<Tag>(0, found.size(), [&](std::size_t q) { search.for_each_nearest(cloud.points[found[q]], k + 1, [&](std::size_t j, const Point&, double) { if (j != found[q]) votes[j].fetch_sub(1, std::memory_order_relaxed); }); });
    found.clear();
    for (std::size_t i = 0; i < n; ++i) if (!out[i] && votes[i] < OUT_DEG * k) { out[i] = 1; found.push_back(i); }
  }
  return out;
}
} } }
