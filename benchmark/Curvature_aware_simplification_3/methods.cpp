#include <comparison/baselines/classical_lop.h>
#include <comparison/baselines/farthest_points.h>
#include <comparison/baselines/grid.h>
#include <comparison/baselines/hierarchy.h>
#include <comparison/baselines/mean_shift_clustering.h>
#include <comparison/baselines/mls_particle_simulation.h>
#include <comparison/baselines/stochastic_sampling.h>
#include <comparison/baselines/voxel_centroids.h>
#include <comparison/chains.h>
#include <comparison/methods.h>

#include <CGAL/Real_timer.h>
#include <CGAL/curvature_aware_simplify_point_set.h>
#include <CGAL/random_simplify_point_set.h>

#include <cstdio>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace comparison {

namespace {

namespace np = CGAL::parameters;

std::string text(const char* format, double value)
{
  char buffer[80];
  std::snprintf(buffer, sizeof(buffer), format, value);
  return buffer;
}

// radii in output spacings, from one ring of samples to CGAL's advice of two
const std::vector<double> radii = {0.8, 1., 1.25, 1.6, 2.};

using CGAL::Curvature_aware_simplification_3::internal::Adaptive_settings;

template <typename NamedParameters>
Points curvature_aware(const Task& task, const NamedParameters& parameters,
                       const Adaptive_settings& settings = Adaptive_settings())
{
  Points output;
  CGAL::Curvature_aware_simplification_3::internal::simplify_point_set<Tag>(
      task.points, std::back_inserter(output),
      parameters.number_of_output_points(task.count).simplification_report(std::ref(last_report())),
      settings);
  return output;
}

Method this_package()
{
  Method method{"this package", {{"defaults", [](const Task& t) {
                                    return curvature_aware(t, np::random_seed(t.seed));
                                  }}}};
  for (double adaptivity : {0.5, 1.})
    method.settings.push_back({text("adaptivity %g", adaptivity), [=](const Task& t) {
                                 return curvature_aware(t, np::adaptivity(adaptivity));
                               }});
  return method;
}

// the radius of the paper, read as 4 D / sqrt(M)
double radius_of_the_paper(const Task& t)
{
  return 4. * diagonal(t.points) / std::sqrt(static_cast<double>(t.points.size()));
}

Method this_package_with_the_settings_of_the_paper()
{
  const auto literal = np::settings_of_the_paper(true);
  Method method{"this package, settings of the paper",
                {{"radius 4 D / sqrt(M)",
                  [=](const Task& t) {
                    return curvature_aware(t, literal.neighbor_radius(radius_of_the_paper(t)));
                  }},
                 {"radius 4 D / sqrt(M), curvature recomputed", [=](const Task& t) {
                    return curvature_aware(
                        t,
                        literal.neighbor_radius(radius_of_the_paper(t)).recompute_curvature(true));
                  }}}};
  for (double radius : {2., 3., 4.})
    method.settings.push_back({text("radius %g spacings", radius), [=](const Task& t) {
                                 return curvature_aware(
                                     t, literal.neighbor_radius(radius * t.spacing));
                               }});
  return method;
}

Method this_package_uniform()
{
  return {"this package, uniform",
          {{"adaptivity 0", [](const Task& t) { return curvature_aware(t, np::adaptivity(0.)); }}}};
}

Method cgal_wlop()
{
  Method method{"CGAL WLOP",
                {{"defaults", [](const Task& t) { return wlop(t.points, t.count, 0., 35); }}}};
  for (unsigned int iterations : {10u, 35u})
    for (double radius : radii)
      method.settings.push_back(
          {text("radius %g spacings, ", radius) + std::to_string(iterations) + " iterations",
           [=](const Task& t) { return wlop(t.points, t.count, radius * t.spacing, iterations); }});
  return method;
}

// A simplifier after preparations of the points, each preparation with each setting of it
Method chain(const std::string& name,
             const std::vector<std::pair<std::string, std::function<Points(const Task&)>>>& first,
             const std::vector<Setting>& second)
{
  Method method{name, {}};
  for (const auto& [first_name, prepare] : first)
    for (const Setting& setting : second)
      method.settings.push_back(
          {first_name + ", " + setting.name, [prepare = prepare, setting](const Task& t) {
             Task prepared = t;
             prepared.points = prepare(t);
             return setting.run(prepared);
           }});
  return method;
}

Method one_setting(const std::string& name,
                   const std::function<Points(const Points&, std::size_t)>& simplify)
{
  return {name, {{"no parameters", [=](const Task& t) { return simplify(t.points, t.count); }}}};
}

Method lop()
{
  // from two rings of samples, CGAL's advice for WLOP, to four
  Method method{"classical LOP", {}};
  for (double radius : {2., 2.5, 3., 4.})
    method.settings.push_back(
        {text("radius %g spacings, 10 iterations", radius), [=](const Task& t) {
           return classical_lop(t.points, t.count, radius * t.spacing, 10, t.seed);
         }});
  return method;
}

// M near the mean size of a cluster leaves nothing to T, which is searched for the count; a large M
// leaves all to it
Method clustering(const std::string& name,
                  const std::function<Points(const Points&, std::size_t, std::size_t)>& simplify)
{
  Method method{name, {}};
  for (double factor : {3., 2., 5.})
    method.settings.push_back(
        {text("clusters of at most %g times the mean size", factor), [=](const Task& t) {
           const double mean_size =
               static_cast<double>(t.points.size()) / static_cast<double>(t.count);
           const double size = std::max(2., factor * mean_size);
           return simplify(t.points, t.count, static_cast<std::size_t>(size));
         }});
  return method;
}

Method particle_simulation()
{
  Method method{"MLS particle simulation", {}};
  for (double scale : {0.01, 0.005, 0.02, 1e9}) // the last one spreads evenly
    for (double force : {0.5, 0.8})
      method.settings.push_back(
          {text("k = %g, ", force) + text("s = %g", scale), [=](const Task& t) {
             Particle_simulation_parameters parameters;
             parameters.force_constant = force;
             parameters.scale = scale;
             parameters.random_seed = t.seed;
             return mls_particle_simulation(t.points, t.count, parameters);
           }});
  return method;
}

std::vector<Setting> short_wlop()
{
  std::vector<Setting> settings;
  for (double radius : {1., 1.6})
    settings.push_back({text("radius %g spacings, 10 iterations", radius), [=](const Task& t) {
                          return wlop(t.points, t.count, radius * t.spacing, 10);
                        }});
  return settings;
}

Method cgal_random()
{
  return {"CGAL random",
          {{"defaults", [](const Task& t) {
              Points points = t.points;
              const double removed = 100. * (1. - (static_cast<double>(t.count) + 0.5) /
                                                      static_cast<double>(points.size()));
              points.erase(CGAL::random_simplify_point_set(points, removed), points.end());
              return points;
            }}}};
}

} // namespace

Setting with_parameters(const std::string& parameters)
{
  std::map<std::string, std::string> values;
  std::istringstream stream(parameters);
  for (std::string word; stream >> word;)
    values[word.substr(0, word.find('='))] = word.substr(word.find('=') + 1);
  const auto number = [values](const std::string& name, double standard) {
    return values.count(name) != 0 ? std::stod(values.at(name)) : standard;
  };

  std::set<std::string> known = {
      "adaptivity", "curvature_dependence", "curvature_weight", "iterations", "paper",
      "radius",     "remove_outliers",      "repulsion_weight"};
  Adaptive_settings settings;
  const auto set = [&](const char* name, auto& setting) {
    known.insert(name);
    setting =
        static_cast<std::decay_t<decltype(setting)>>(number(name, static_cast<double>(setting)));
  };
  set("undo_rounding", settings.undo_rounding);
  set("tell_cameras", settings.tell_cameras);
  set("merge_copies", settings.merge_copies);
  set("find_outliers", settings.find_outliers);
  set("measure_noise", settings.measure_noise);
  set("find_columns", settings.find_columns);
  set("noise_by_place", settings.noise_by_place);
  set("most_noise_probes", settings.most_noise_probes);
  set("tell_two_sheets", settings.tell_two_sheets);
  set("limit_noise_by_shape", settings.limit_noise_by_shape);
  set("noise_around_planes", settings.noise_around_planes);
  set("tell_standing_fits", settings.tell_standing_fits);
  set("limit_noise_by_planes", settings.limit_noise_by_planes);
  set("curvature_radius", settings.curvature_radius);
  set("least_curvature", settings.least_curvature);
  set("average_curvature", settings.average_curvature);
  set("densest", settings.densest);
  set("reach_of_repulsion", settings.reach_of_repulsion);
  set("smooth_points", settings.smooth_points);
  set("thin_dense_noise", settings.thin_dense_noise);
  set("correct_bias_of_noise", settings.correct_bias_of_noise);
  set("smooth_around_foot_points", settings.smooth_around_foot_points);
  set("spare_thin_parts", settings.spare_thin_parts);
  set("smooth_by_shape", settings.smooth_by_shape);
  set("residuals_explained_by_noise", settings.residuals_explained_by_noise);
  set("weight_of_height", settings.weight_of_height);
  set("turns", settings.turns);
  set("length_of_first_steps", settings.length_of_first_steps);
  set("least_weight_of_neighbors", settings.least_weight_of_neighbors);
  set("keep_borders", settings.keep_borders);
  set("widen_between_lines", settings.widen_between_lines);
  set("find_clusters", settings.find_clusters);
  set("keep_sparse_surfaces", settings.keep_sparse_surfaces);
  set("keep_noisy_layers", settings.keep_noisy_layers);
  set("keep_lone_points", settings.keep_lone_points);
  set("moves_to_foot_point", settings.moves_to_foot_point);
  set("denoise", settings.denoise);
  set("even_out", settings.even_out);
  set("points_of_widest_fit", settings.points_of_widest_fit);
  set("missed_shape", settings.missed_shape);
  set("correct_by_points", settings.correct_by_points);
  set("stay_near_points", settings.stay_near_points);
  set("largest_amplification", settings.largest_amplification);
  set("move_to_edges", settings.move_to_edges);
  set("move_to_corners", settings.move_to_corners);
  set("share_to_insert", settings.share_to_insert);
  for (const auto& value : values)
    if (known.count(value.first) == 0)
      throw std::invalid_argument("there is no parameter " + value.first);

  return {parameters, [=](const Task& given) {
            Task t = given;
            if (values.count("remove_outliers") != 0)
              t.points = without_outliers(t.points, number("remove_outliers", 2.));
            const auto chosen = np::settings_of_the_paper(number("paper", 0.) != 0.)
                                    .adaptivity(number("adaptivity", 2. / 3.))
                                    .curvature_weight(number("curvature_weight", 0.75))
                                    .curvature_dependence(number("curvature_dependence", 2.))
                                    .number_of_iterations(number("iterations", 10.))
                                    .repulsion_weight(number("repulsion_weight", 0.45))
                                    .random_seed(t.seed);
            if (values.count("radius") == 0)
              return curvature_aware(t, chosen, settings);
            const double radius = values.at("radius") == "paper" ? radius_of_the_paper(t)
                                                                 : number("radius", 2.) * t.spacing;
            return curvature_aware(t, chosen.neighbor_radius(radius));
          }};
}

CGAL::Curvature_aware_simplification_report& last_report()
{
  static CGAL::Curvature_aware_simplification_report report;
  return report;
}

std::vector<Method> methods()
{
  const auto no_outliers = [](double spacings) {
    return std::make_pair(text("outliers beyond %g spacings removed", spacings),
                          std::function<Points(const Task&)>(
                              [=](const Task& t) { return without_outliers(t.points, spacings); }));
  };
  const auto smooth = [](unsigned int k) {
    return std::make_pair(
        "smoothed over " + std::to_string(k),
        std::function<Points(const Task&)>([=](const Task& t) { return smoothed(t.points, k); }));
  };
  // both without a parameter of their own, with outliers and noise in one input
  const auto no_outliers_and_smooth =
      std::make_pair(std::string("outliers beyond 2 spacings removed, smoothed over 24"),
                     std::function<Points(const Task&)>([](const Task& t) {
                       return smoothed(without_outliers(t.points, 2.), 24);
                     }));
  const std::vector<Setting> then_wlop = short_wlop();
  const std::vector<Setting> then_voxels = one_setting("", [](const Points& p, std::size_t n) {
                                             return voxel_centroids_to_count(p, n);
                                           }).settings;

  return {
      this_package(),
      this_package_with_the_settings_of_the_paper(),
      this_package_uniform(),
      lop(),
      cgal_wlop(),
      clustering("CGAL hierarchy",
                 [](const Points& p, std::size_t n, std::size_t size) {
                   return hierarchy_points_of_size(p, n, static_cast<unsigned int>(size));
                 }),
      one_setting("CGAL grid", grid_points_to_count),
      cgal_random(),
      one_setting("voxel centroids",
                  [](const Points& p, std::size_t n) { return voxel_centroids_to_count(p, n); }),
      one_setting("stochastic sampling",
                  [](const Points& p, std::size_t n) { return stochastic_sampling(p, n); }),
      clustering("mean-shift clustering", mean_shift_points_of_size),
      particle_simulation(),
      one_setting("farthest points", farthest_points),
      chain("remove_outliers, then CGAL WLOP", {no_outliers(2.), no_outliers(1.5)}, then_wlop),
      chain("remove_outliers, then voxel centroids", {no_outliers(2.), no_outliers(1.5)},
            then_voxels),
      chain("jet_smooth, then CGAL WLOP", {smooth(24), smooth(60)}, then_wlop),
      chain("jet_smooth, then voxel centroids", {smooth(24), smooth(60)}, then_voxels),
      chain("remove_outliers, jet_smooth, then CGAL WLOP", {no_outliers_and_smooth}, then_wlop)};
}

} // namespace comparison
