// Time of each stage for M points of a torus, M / 10 samples, on one and on two threads

#include <comparison/analytic_surfaces.h>
#include <comparison/types.h>

#include <CGAL/Curvature_aware_simplification_3/internal/Scan.h>
#include <CGAL/Curvature_aware_simplification_3/internal/density/even_density.h>
#include <CGAL/Curvature_aware_simplification_3/internal/density/sampling_density.h>
#include <CGAL/Curvature_aware_simplification_3/internal/features/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/features/shared_features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/paper/relax_repeatedly.h>
#include <CGAL/Curvature_aware_simplification_3/internal/paper/sample_spacing.h>
#include <CGAL/Curvature_aware_simplification_3/internal/paper/select_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/parameters/read_parameters.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/Distinct_samples.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/relax_on_surface.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/lattice_spacing.h>
#include <CGAL/pca_estimate_normals.h>

#include <benchmark/benchmark.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Curvature_aware_simplification_3::internal;
using comparison::Tag;
using Diagonalize_traits = CGAL::Default_diagonalize_traits<double, 3>;

const std::function<bool(double)> no_callback;
const double relative_error = std::numeric_limits<double>::epsilon();

// All that the stages need, computed once for each M
struct Stages
{
  explicit Stages(std::size_t size)
    : points(comparison::sample(comparison::torus(), size, 0)),
      cloud(make_cloud<Tag>(points, relative_error, Progress(no_callback))),
      features(compute_features<Tag, Diagonalize_traits>(cloud, 16, Progress(no_callback))),
      parameters(read_parameters(
          CGAL::parameters::number_of_output_points(size / 10).number_of_iterations(1), size)),
      samples(distinct_samples<Tag>(cloud, select_points<Tag>(cloud, features, parameters)).points),
      radius(radius_in_spacings * sample_spacing<Tag>(samples)),
      fitter{*cloud.search},
      scan{{cloud.points, nullptr, cloud.coordinate_error},
           features.inverse_density,
           uniform_noise(0., cloud.size()),
           even_density<Tag>(features.inverse_density, size / 10, default_settings.densest),
           {},
           infinite_inverse_density,
           false}
  {}

  std::vector<Point> points;
  Cloud cloud;
  Features features;
  Parameters parameters;
  std::vector<Point> samples;
  double radius;
  Surface_fitter fitter;
  Scan scan;
  std::vector<Surface_sample>
      surface_samples; // by the projection, before the first relaxation step
};

Stages& stages(const benchmark::State& state)
{
  static std::map<std::int64_t, std::unique_ptr<Stages>> all;
  std::unique_ptr<Stages>& s = all[state.range(0)];
  if (!s)
    s = std::make_unique<Stages>(static_cast<std::size_t>(state.range(0)));
  return *s;
}

template <typename Function>
void measure(benchmark::State& state, const Function& function)
{
  Stages& s = stages(state);
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(state.range(1)));
#endif
  for (auto _ : state)
    function(s);
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

void sorting(benchmark::State& state)
{
  measure(state, [](Stages& s) {
    benchmark::DoNotOptimize(make_cloud<Tag>(s.points, relative_error, Progress(no_callback)));
  });
}

void tree_building(benchmark::State& state)
{
  measure(state, [](Stages& s) { Neighbor_search search(s.cloud.points, Tag()); });
}

void features(benchmark::State& state)
{
  measure(state, [](Stages& s) {
    benchmark::DoNotOptimize(
        compute_features<Tag, Diagonalize_traits>(s.cloud, 16, Progress(no_callback)));
  });
}

void shared_features(benchmark::State& state)
{
  measure(state, [](Stages& s) {
    benchmark::DoNotOptimize(
        compute_shared_features<Tag, Diagonalize_traits>(s.cloud, 16, Progress(no_callback)));
  });
}

void selection(benchmark::State& state)
{
  measure(state, [](Stages& s) {
    benchmark::DoNotOptimize(select_points<Tag>(s.cloud, s.features, s.parameters));
  });
}

void one_relaxation_step(benchmark::State& state)
{
  measure(state, [](Stages& s) {
    benchmark::DoNotOptimize(relax_repeatedly<Tag, Diagonalize_traits>(
        s.samples, s.cloud, s.features, s.radius, s.parameters, Progress(no_callback)));
  });
}

void sampling_density(benchmark::State& state)
{
  measure(state, [](Stages& s) {
    benchmark::DoNotOptimize(
        CGAL::Curvature_aware_simplification_3::internal::sampling_density<Tag>(
            s.scan, s.samples.size(), 2. / 3., Adaptive_settings(), Progress(no_callback)));
  });
}

// fits the local surface of each sample and puts the sample on it
void projection(benchmark::State& state)
{
  measure(state, [](Stages& s) {
    s.surface_samples.assign(s.samples.size(), Surface_sample());
    for_each_index<Tag>(0, s.samples.size(), [&](std::size_t i) {
      s.surface_samples[i].spacing = s.radius / radius_in_spacings;
      s.surface_samples[i].place(s.fitter.at(no_noise), s.samples[i], CGAL::NULL_VECTOR,
                                 rounds_to_stay);
    });
  });
}

void one_adaptive_relaxation_step(benchmark::State& state)
{
  measure(state, [](Stages& s) {
    std::vector<Surface_sample> samples = s.surface_samples;
    relax_on_surface<Tag>(samples, s.fitter, 1, 0.45, Progress(no_callback));
    benchmark::DoNotOptimize(samples);
  });
}

// the unit in which the costs are compared
void cgal_pca_estimate_normals(benchmark::State& state)
{
  using Element = std::pair<Point, Vector>;
  measure(state, [](Stages& s) {
    std::vector<Element> elements;
    for (const Point& p : s.points)
      elements.emplace_back(p, Vector());
    CGAL::pca_estimate_normals<Tag>(
        elements, 16,
        CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Element>())
            .normal_map(CGAL::Second_of_pair_property_map<Element>()));
  });
}

void sizes_and_threads(benchmark::internal::Benchmark* b)
{
  b->ArgNames({"M", "threads"})->UseRealTime()->Unit(benchmark::kMillisecond);
  for (std::int64_t size : {10000, 100000, 1000000})
    for (std::int64_t threads : {1, 2})
      b->Args({size, threads});
}

BENCHMARK(sorting)->Apply(sizes_and_threads);
BENCHMARK(tree_building)->Apply(sizes_and_threads);
BENCHMARK(features)->Apply(sizes_and_threads);
BENCHMARK(shared_features)->Apply(sizes_and_threads);
BENCHMARK(selection)->Apply(sizes_and_threads);
BENCHMARK(one_relaxation_step)->Apply(sizes_and_threads);
BENCHMARK(sampling_density)->Apply(sizes_and_threads);
BENCHMARK(projection)->Apply(sizes_and_threads);
BENCHMARK(one_adaptive_relaxation_step)->Apply(sizes_and_threads);
BENCHMARK(cgal_pca_estimate_normals)->Apply(sizes_and_threads);

} // namespace

BENCHMARK_MAIN();
