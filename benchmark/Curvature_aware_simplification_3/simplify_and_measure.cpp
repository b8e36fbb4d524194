// Runs one method on one input and measures the result; see --help. One JSON object for each
// setting of the method is printed, a line each. A process of its own for each method keeps apart
// their memory and their failures.

#include <comparison/input.h>
#include <comparison/measures.h>
#include <comparison/memory.h>
#include <comparison/methods.h>
#include <comparison/quadric_edge_collapse.h>

#include <CGAL/Curvature_aware_simplification_3/internal/paper/sample_spacing.h>
#include <CGAL/IO/write_points.h>
#include <CGAL/Real_timer.h>

#include <boost/program_options.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#ifdef __GLIBC__
#include <malloc.h>
#endif

using namespace comparison;
using nlohmann::json;
namespace po = boost::program_options;

namespace {

// The spacing that n points have when they are spread evenly: measured on n random clean points
double even_spacing(const Points& points, std::size_t n)
{
  CGAL::Random random(0);
  Points subset;
  for (std::size_t i = 0; i < n; ++i)
    subset.push_back(
        points[static_cast<std::size_t>(random.get_int(0, static_cast<int>(points.size())))]);
  return CGAL::Curvature_aware_simplification_3::internal::sample_spacing<Tag>(subset);
}

json run(const Setting& setting, const Task& task, const Input& input, std::size_t rounds,
         bool is_measured, Points& output)
{
  std::vector<double> times;
#ifdef __GLIBC__
  malloc_trim(0); // memory that was freed before must not hide what the method needs
#endif
  const double memory_before = status("VmRSS");
  reset_peak_memory();
  for (std::size_t i = 0; i < rounds; ++i)
  {
    CGAL::Real_timer timer;
    timer.start();
    output = setting.run(task);
    times.push_back(timer.time());
  }
  const double peak = status("VmHWM");
  if (times.size() > 1)
    times.erase(times.begin()); // the first one warms up
  std::sort(times.begin(), times.end());

  json result = {{"setting", setting.name},
                 {"seconds", times[times.size() / 2]},
                 {"peak_bytes", std::max(0., peak - memory_before)}};
  if (output.size() < 4)
    throw std::runtime_error("returned " + std::to_string(output.size()) + " points");
  if (is_measured)
    result.update(measure(output, reconstruct(output), input, task.spacing));
  return result;
}

json stages()
{
  const CGAL::Curvature_aware_simplification_report& r = last_report();
  return {{"sorting", r.sorting_time},       {"features", r.features_time},
          {"outliers", r.outliers_time},     {"noise", r.noise_time},
          {"smoothing", r.smoothing_time},   {"selection", r.selection_time},
          {"relaxation", r.relaxation_time}, {"projection", r.projection_time}};
}

} // namespace

int main(int argc, char* argv[])
{
  std::string input_name, degradation, method_name, setting_name, measured_file, output_file,
      input_file, parameters;
  std::size_t count = 0, number_of_points = 0, rounds = 1;
  double percentage = 10.;
  unsigned int seed = 0;
  po::options_description options("Options");
  // clang-format off
  options.add_options()
    ("help,h", "show this text and exit")
    ("list", "print the methods and their settings and exit")
    ("input", po::value(&input_name), "file of a mesh or of points, or an analytic surface: sphere, torus, ellipsoid, rounded_box, wavy_patch, tree, street")
    ("sample", po::value(&number_of_points), "this many random points on the surface, instead of the vertices of the mesh")
    ("degradation", po::value(&degradation)->default_value("clean"), "clean, noise:PERCENT, uneven_noise:PERCENT, outliers:PERCENT, clusters:PERCENT, density:FACTOR, hole:PERCENT, duplicates:PERCENT, lines:PERCENT, range_noise:PERCENT, rounding:PERCENT, depth:PERCENT, cameras:PERCENT, frames:PERCENT, copies:PERCENT, shift:PERCENT, or several as in density:10+noise:0.2")
    ("count", po::value(&count), "number of output points")
    ("percentage", po::value(&percentage), "of the input points, if no count is given")
    ("method", po::value(&method_name), "a method of the list")
    ("setting", po::value(&setting_name), "one setting only")
    ("parameters", po::value(&parameters), "of this package, instead of a method: iterations=30 adaptivity=0, or paper=1 curvature_weight=0 curvature_dependence=2 radius=2 or radius=paper")
    ("defaults-only", "the first setting of the method only")
    ("rounds", po::value(&rounds), "calls of each setting; their median time counts, without the first")
    ("time-only", "measures the time and nothing else")
    ("seed", po::value(&seed), "of the input")
    ("measure", po::value(&measured_file), "measures the points of this file and runs nothing")
    ("write-input", po::value(&input_file), "writes the degraded points and exits")
    ("write", po::value(&output_file), "writes the output of the last setting");
  // clang-format on
  try
  {
    po::variables_map values;
    po::store(po::parse_command_line(argc, argv, options), values);
    po::notify(values);
    if (values.count("help") != 0)
      std::cout << options;
    if (values.count("list") != 0)
    {
      nlohmann::ordered_json list; // in the order of the tables
      for (const Method& method : methods())
        for (const Setting& setting : method.settings)
          list[method.name].push_back(setting.name);
      std::cout << list.dump(2) << std::endl;
    }
    if (input_name.empty())
      return EXIT_SUCCESS;

    const Input input = make_input(input_name, number_of_points, degradation, seed);
    if (count == 0)
      count = std::max<std::size_t>(
          4, static_cast<std::size_t>(percentage / 100. * static_cast<double>(input.clean.size())));
    const Task task{input.degraded, input.mesh, count, even_spacing(input.clean, count), seed};
    const json description = {{"input", input_name},
                              {"degradation", degradation},
                              {"input_points", input.degraded.size()},
                              {"count", count}};
    if (!input_file.empty())
    {
      CGAL::IO::write_points(input_file, input.degraded, CGAL::parameters::stream_precision(17));
      return EXIT_SUCCESS;
    }
    const auto print = [&](json result) {
      result.update(description);
      result["method"] = method_name;
      std::cout << result.dump() << std::endl;
    };

    if (!measured_file.empty())
    {
      Points output;
      if (!CGAL::IO::read_points(measured_file, std::back_inserter(output)))
        throw std::runtime_error("cannot read " + measured_file);
      print(measure(output, reconstruct(output), input, task.spacing));
      return EXIT_SUCCESS;
    }
    if (method_name == "quadric edge collapse (no peer: it is given the mesh)")
    {
      const Mesh mesh = quadric_edge_collapse(input.mesh, count);
      print(measure(mesh.points, mesh, input, task.spacing));
      return EXIT_SUCCESS;
    }

    std::vector<Setting> settings;
    for (const Method& method : methods())
      if (method.name == method_name)
        settings = method.settings;
    if (!parameters.empty())
    {
      method_name = "this package";
      settings = {with_parameters(parameters)};
    }
    if (!setting_name.empty())
      settings.erase(std::remove_if(settings.begin(), settings.end(),
                                    [&](const Setting& s) { return s.name != setting_name; }),
                     settings.end());
    if (values.count("defaults-only") != 0 && settings.size() > 1)
      settings.resize(1);
    if (settings.empty())
      throw std::invalid_argument("there is no method or setting of this name; see --list");

    Points output;
    for (const Setting& setting : settings)
      try
      {
        json result = run(setting, task, input, rounds, values.count("time-only") == 0, output);
        if (method_name.rfind("this package", 0) == 0)
          result["stages"] = stages();
        print(result);
      }
      catch (const std::exception& error)
      {
        print({{"setting", setting.name}, {"error", error.what()}});
      }
    if (!output_file.empty())
      CGAL::IO::write_points(output_file, output, CGAL::parameters::stream_precision(17));
    return EXIT_SUCCESS;
  }
  catch (const std::exception& error)
  {
    std::cerr << "simplify_and_measure: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
