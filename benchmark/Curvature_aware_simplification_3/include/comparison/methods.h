#ifndef CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_METHODS_H
#define CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_METHODS_H

#include <comparison/types.h>

#include <CGAL/Curvature_aware_simplification_report.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace comparison {

// What a method is asked for
struct Task
{
  Points points;
  Mesh mesh;         // the clean surface, for the row that is no peer; empty if there is none
  std::size_t count; // N
  double spacing;    // of N points spread evenly over the input, the unit of radii
  unsigned int seed;
};

// One way to call a method. The first setting of a method is its default, the others are its search
// for the best result: small, stated, and the same for every input.
struct Setting
{
  std::string name;
  std::function<Points(const Task&)> run;
};

struct Method
{
  std::string name;
  std::vector<Setting> settings;
};

std::vector<Method> methods();

// This package with some parameters given as text: `adaptivity=0 iterations=30`, the members of
// Adaptive_settings, or `paper=1 curvature_weight=0 radius=2`, the radius in output spacings or
// `paper`; with `remove_outliers=2` after CGAL's function, the threshold in input spacings
Setting with_parameters(const std::string& parameters);

// The stages of the last call of this package
CGAL::Curvature_aware_simplification_report& last_report();

} // namespace comparison

#endif // CURVATURE_AWARE_SIMPLIFICATION_3_COMPARISON_METHODS_H
