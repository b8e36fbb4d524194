// Runs a test with the adaptive method, the default, and with that of the paper

#ifndef CURVATURE_AWARE_SIMPLIFICATION_3_BOTH_METHODS_H
#define CURVATURE_AWARE_SIMPLIFICATION_3_BOTH_METHODS_H

#include "surfaces.h"

#include <CGAL/curvature_aware_random_simplify_point_set.h>
#include <CGAL/curvature_aware_simplify_point_set.h>

#include <gtest/gtest.h>

#include <iterator>
#include <vector>

namespace both_methods {

using surfaces::Kernel;
using surfaces::Point;
using surfaces::Vector;
using Tag = CGAL::Parallel_if_available_tag;
namespace np = CGAL::parameters;

// of the calls of a test: its fixture sets it
inline bool settings_of_the_paper = false;

class Both_methods : public testing::TestWithParam<bool>
{
protected:
  void SetUp() override { settings_of_the_paper = GetParam(); }
};

class Defaults : public testing::Test
{
protected:
  void SetUp() override { settings_of_the_paper = false; }
};

class Paper : public testing::Test
{
protected:
  void SetUp() override { settings_of_the_paper = true; }
};

template <typename ConcurrencyTag = Tag, typename NamedParameters = np::Default_named_parameters>
std::vector<Point> simplified(const std::vector<Point>& points,
                              const NamedParameters& parameters = np::default_values())
{
  std::vector<Point> output;
  CGAL::curvature_aware_simplify_point_set<ConcurrencyTag>(
      points, std::back_inserter(output), parameters.settings_of_the_paper(settings_of_the_paper));
  return output;
}

template <typename ConcurrencyTag = Tag, typename NamedParameters = np::Default_named_parameters>
std::vector<Point> subset(const std::vector<Point>& points,
                          const NamedParameters& parameters = np::default_values())
{
  std::vector<Point> output;
  CGAL::curvature_aware_random_simplify_point_set<ConcurrencyTag>(
      points, std::back_inserter(output), parameters);
  return output;
}

} // namespace both_methods

#endif // CURVATURE_AWARE_SIMPLIFICATION_3_BOTH_METHODS_H
