// Distance to the surface and running time of this package and of CGAL's WLOP, on the vertices of a
// mesh, in one process: each method in turn, and the median of several rounds.
//
//   compare_with_wlop MESH NUMBER_OF_OUTPUT_POINTS [ROUNDS]

#include <comparison/reference.h>
#include <comparison/types.h>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Real_timer.h>
#include <CGAL/curvature_aware_simplify_point_set.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/wlop_simplify_and_regularize_point_set.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

using comparison::Kernel;
using comparison::Point;
using comparison::Tag;
namespace np = CGAL::parameters;

struct Method
{
  std::string name;
  std::function<std::vector<Point>(std::vector<Point>)> run;
  std::vector<Point> output = {};
  std::vector<double> times = {};
};

int main(int argc, char* argv[])
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> faces;
  if (argc < 3 || !CGAL::IO::read_polygon_soup(argv[1], points, faces) || faces.empty())
  {
    std::cerr << "Usage: compare_with_wlop MESH NUMBER_OF_OUTPUT_POINTS [ROUNDS]" << std::endl;
    return EXIT_FAILURE;
  }
  const std::size_t n = std::stoul(argv[2]);
  const std::size_t rounds = argc > 3 ? std::stoul(argv[3]) : 5;

  comparison::Mesh mesh{points, {}};
  for (const std::vector<std::size_t>& face : faces)
    for (std::size_t i = 2; i < face.size(); ++i)
      mesh.triangles.push_back({face[0], face[i - 1], face[i]});
  const comparison::Mesh_distance distance_to_mesh(mesh);

  const double diagonal = comparison::diagonal(points);
  const double size = static_cast<double>(points.size());
  const double paper_radius = 4. * diagonal / std::sqrt(size);
  const double percentage = 100. * (static_cast<double>(n) + 0.5) / size;

  const auto ours = [n](const auto& parameters) {
    return [n, parameters](const std::vector<Point>& input) {
      std::vector<Point> output;
      CGAL::curvature_aware_simplify_point_set<Tag>(input, std::back_inserter(output),
                                                    parameters.number_of_output_points(n));
      return output;
    };
  };
  const auto wlop = [percentage](const auto& parameters) {
    return [percentage, parameters](std::vector<Point> input) // it shuffles its input
    {
      std::vector<Point> output;
      CGAL::wlop_simplify_and_regularize_point_set<Tag>(input, std::back_inserter(output),
                                                        parameters.select_percentage(percentage));
      return output;
    };
  };
  // the unit of time: it returns no points
  const auto pca = [](const std::vector<Point>& input) {
    std::vector<std::pair<Point, Kernel::Vector_3>> points_with_normals;
    for (const Point& p : input)
      points_with_normals.emplace_back(p, CGAL::NULL_VECTOR);
    using Element = std::pair<Point, Kernel::Vector_3>;
    CGAL::pca_estimate_normals<Tag>(points_with_normals, 16,
                                    np::point_map(CGAL::First_of_pair_property_map<Element>())
                                        .normal_map(CGAL::Second_of_pair_property_map<Element>()));
    return std::vector<Point>();
  };
  std::vector<Method> methods = {
      {"CGAL pca_estimate_normals, k = 16", pca},
      {"this package, defaults", ours(np::random_seed(0))},
      {"this package, settings of the paper",
       ours(np::settings_of_the_paper(true).neighbor_radius(paper_radius))},
      {"CGAL WLOP, defaults", wlop(np::require_uniform_sampling(false))},
      {"CGAL WLOP, radius and iterations of the paper",
       wlop(np::neighbor_radius(paper_radius).number_of_iterations(10))}};

  for (std::size_t round = 0; round < rounds; ++round)
    for (Method& method : methods)
    {
      CGAL::Real_timer timer;
      timer.start();
      method.output = method.run(points);
      method.times.push_back(timer.time());
    }

  std::printf("%s: %zu -> %zu points, radius of the paper 4 D / sqrt(M) = %.4g D, %zu rounds\n",
              argv[1], points.size(), n, paper_radius / diagonal, rounds);
  std::printf("%-46s %7s %12s %12s %9s %9s\n", "method", "points", "mean dist./D", "max dist./D",
              "median s", "ratio");
  for (Method& method : methods)
  {
    double sum = 0., largest = 0.;
    for (const Point& p : method.output)
    {
      const double distance = distance_to_mesh(p) / diagonal;
      sum += distance;
      largest = std::max(largest, distance);
    }
    const auto median = [](std::vector<double> values) {
      std::sort(values.begin(), values.end());
      return values[values.size() / 2];
    };
    std::vector<double> ratios; // of times of the same round
    for (std::size_t round = 0; round < rounds; ++round)
      ratios.push_back(method.times[round] / methods.front().times[round]);
    const double number = static_cast<double>((std::max)(method.output.size(), std::size_t(1)));
    std::printf("%-46s %7zu %12.3g %12.3g %9.3f %9.2f\n", method.name.c_str(), method.output.size(),
                sum / number, largest, median(method.times), median(ratios));
  }
  return EXIT_SUCCESS;
}
