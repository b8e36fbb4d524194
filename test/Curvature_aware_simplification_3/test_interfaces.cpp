// Kernels, ranges, property maps, named parameters in any order, and the change from CGAL's WLOP.
// This is a second translation unit of the same program: the headers may be included in many.

#include "surfaces.h"

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/curvature_aware_random_simplify_point_set.h>
#include <CGAL/curvature_aware_simplify_point_set.h>
#include <CGAL/estimate_surface_variation.h>
#include <CGAL/wlop_simplify_and_regularize_point_set.h>

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <list>
#include <numeric>
#include <random>
#include <tuple>
#include <vector>

namespace {

using Tag = CGAL::Parallel_if_available_tag;
namespace np = CGAL::parameters;

template <typename Kernel>
class Kernels : public testing::Test
{};

using All_kernels = testing::Types<CGAL::Simple_cartesian<double>, CGAL::Simple_cartesian<float>,
                                   CGAL::Exact_predicates_inexact_constructions_kernel,
                                   CGAL::Exact_predicates_exact_constructions_kernel>;
TYPED_TEST_SUITE(Kernels, All_kernels, ); // the comma: -Wpedantic wants a variadic argument

// A coordinate that all number types hold. Without `volatile`, g++ 12 leaves out the conversion where
// it vectorizes.
double rounded_to_float(double x)
{
  const volatile float result = static_cast<float>(x);
  return static_cast<double>(result);
}

TYPED_TEST(Kernels, give_the_same_result)
{
  using Point = typename TypeParam::Point_3;
  using FT = typename TypeParam::FT;
  std::vector<surfaces::Point> points;
  std::vector<Point> converted;
  for (const surfaces::Point& p : surfaces::torus(2000, 3., 1., 1))
  {
    points.emplace_back(rounded_to_float(p.x()), rounded_to_float(p.y()), rounded_to_float(p.z()));
    const surfaces::Point& q = points.back();
    converted.emplace_back(FT(q.x()), FT(q.y()), FT(q.z()));
  }

  std::vector<surfaces::Point> expected;
  CGAL::curvature_aware_simplify_point_set<Tag>(points, std::back_inserter(expected));
  std::vector<Point> output;
  CGAL::curvature_aware_simplify_point_set<Tag>(converted, std::back_inserter(output));
  ASSERT_EQ(output.size(), expected.size());
  for (std::size_t i = 0; i < output.size(); ++i)
  {
    EXPECT_NEAR(CGAL::to_double(output[i].x()), expected[i].x(), 1e-6);
    EXPECT_NEAR(CGAL::to_double(output[i].y()), expected[i].y(), 1e-6);
    EXPECT_NEAR(CGAL::to_double(output[i].z()), expected[i].z(), 1e-6);
  }
}

TYPED_TEST(Kernels, know_their_rounding_error)
{
  // a tilted plane far from the origin: what its coordinates lose must not look like a feature
  using FT = typename TypeParam::FT;
  using Element = std::pair<typename TypeParam::Point_3, double>;
  std::vector<Element> points;
  for (const surfaces::Point& p : surfaces::square(500, 2))
  {
    const double x = 1000. + p.x();
    points.emplace_back(typename TypeParam::Point_3(FT(rounded_to_float(x)),
                                                    FT(rounded_to_float(p.y())),
                                                    FT(rounded_to_float(0.5 * x - p.y()))),
                        -1.);
  }
  CGAL::estimate_surface_variation<Tag>(points, 16, CGAL::Second_of_pair_property_map<Element>(),
                                        np::point_map(CGAL::First_of_pair_property_map<Element>()));
  for (const Element& element : points) // of floats, whatever they are held in
    EXPECT_EQ(element.second, 0.);
}

// The intervals of such points are wide, whatever they are close to: each point after a rational
// motion and the motion back is exactly the same.
TEST(Exact_kernel, points_are_evaluated)
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  const Exact::FT c = Exact::FT(3) / 5, s = Exact::FT(4) / 5;
  const Exact::Aff_transformation_3 motion(c, -s, 0, Exact::FT(1) / 3, s, c, 0, Exact::FT(1) / 7, 0,
                                           0, 1, 0),
      back = motion.inverse();
  std::vector<Exact::Point_3> once, twice;
  for (const surfaces::Point& p : surfaces::torus(500, 3., 1., 1))
  {
    once.emplace_back(p.x(), p.y(), p.z());
    twice.push_back(once.back());
    twice.push_back(back(motion(once.back())));
  }
  const auto simplified = [](const std::vector<Exact::Point_3>& points) {
    std::vector<Exact::Point_3> output;
    CGAL::Curvature_aware_simplification_report report;
    CGAL::curvature_aware_simplify_point_set<Tag>(
        points, std::back_inserter(output),
        np::number_of_output_points(50).simplification_report(std::ref(report)));
    EXPECT_EQ(report.number_of_distinct_points, 500u);
    return output;
  };
  EXPECT_EQ(simplified(twice), simplified(once));
}

TEST(Float_kernel, has_no_infinite_results)
{
  using Float_point = CGAL::Simple_cartesian<float>::Point_3;
  constexpr float most = (std::numeric_limits<float>::max)();
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(-1.f, 1.f);
  std::vector<Float_point> points, output;
  for (int i = 0; i < 4000; ++i)
  {
    const float y = uniform(random), z = uniform(random);
    points.emplace_back(most * (1.f - 0.3f * y * y - 0.3f * z * z), most * y, most * z);
  }
  CGAL::curvature_aware_simplify_point_set<Tag>(points, std::back_inserter(output),
                                                np::select_percentage(20));
  EXPECT_EQ(output.size(), 800u);
  for (const Float_point& p : output)
    EXPECT_TRUE(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z())) << p;
}

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Color = std::array<unsigned char, 3>;
using Element = std::tuple<Point, Color, int>;
using Point_map = CGAL::Nth_of_tuple_property_map<0, Element>;

std::vector<Element> elements(std::size_t n)
{
  std::vector<Element> result;
  for (const Point& p : surfaces::torus(n, 3., 1., 3))
  {
    const int index = static_cast<int>(result.size());
    result.emplace_back(p, Color{static_cast<unsigned char>(index % 256), 0, 1}, index);
  }
  return result;
}

// An application whose functions have the names of ours, for any argument
namespace application {

template <typename Range>
std::size_t number_of_elements(const Range& range)
{
  return range.size();
}
template <typename Range, typename Map>
std::vector<Point> read_coordinates(const Range&, const Map&);
template <typename Concurrency, typename Range, typename Parameters>
void read_cloud(const Range&, const Parameters&);
template <typename Parameters>
int read_parameters(const Parameters&, std::size_t);
template <typename Parameters>
int read_selection_parameters(const Parameters&, std::size_t);
template <typename Parameters>
int read_callback(const Parameters&);
template <typename Parameters, typename Name>
int number(const Parameters&, const Name&, double);
template <typename Concurrency, typename Range, typename Output, typename Parameters,
          typename Settings>
void simplify_point_set(const Range&, Output, const Parameters&, const Settings&);

struct Vertex
{
  Point place;
};

struct Place
{
  using key_type = Vertex;
  using value_type = Point;
  using reference = const Point&;
  using category = boost::readable_property_map_tag;

  friend const Point& get(const Place&, const Vertex& vertex) { return vertex.place; }
};

} // namespace application

TEST(Ranges, of_types_with_functions_of_the_same_names)
{
  std::vector<application::Vertex> vertices, selected;
  for (const Point& p : surfaces::torus(200, 3., 1., 4))
    vertices.push_back({p});
  std::vector<Point> output;
  const auto parameters = np::point_map(application::Place());
  CGAL::curvature_aware_simplify_point_set<Tag>(vertices, std::back_inserter(output), parameters);
  CGAL::curvature_aware_random_simplify_point_set<Tag>(vertices, std::back_inserter(selected),
                                                       parameters);
  EXPECT_EQ(output.size(), 10u);
  EXPECT_EQ(selected.size(), 10u);
}

TEST(Ranges, of_elements_with_attributes)
{
  const std::vector<Element> range = elements(1000);
  std::vector<Element> subset;
  CGAL::curvature_aware_random_simplify_point_set<Tag>(range, std::back_inserter(subset),
                                                       np::point_map(Point_map()));
  ASSERT_EQ(subset.size(), 50u);
  for (const Element& element : subset)
    EXPECT_EQ(element, range[static_cast<std::size_t>(std::get<2>(element))]);

  std::vector<Point> output, expected;
  CGAL::curvature_aware_simplify_point_set<Tag>(range, std::back_inserter(output),
                                                np::point_map(Point_map()));
  CGAL::curvature_aware_simplify_point_set<Tag>(surfaces::torus(1000, 3., 1., 3),
                                                std::back_inserter(expected));
  EXPECT_EQ(output, expected);
}

TEST(Ranges, of_other_kinds)
{
  const std::vector<Point> points = surfaces::torus(1000, 3., 1., 4);
  std::vector<Point> expected;
  CGAL::curvature_aware_simplify_point_set<Tag>(points, std::back_inserter(expected));

  const std::list<Point> list(points.begin(), points.end());
  std::vector<Point> output;
  CGAL::curvature_aware_simplify_point_set<Tag>(list, std::back_inserter(output));
  EXPECT_EQ(output, expected);

  output.clear();
  CGAL::curvature_aware_simplify_point_set<Tag>(CGAL::make_range(points.begin(), points.end()),
                                                std::back_inserter(output));
  EXPECT_EQ(output, expected);

  // indices into an array
  std::vector<std::size_t> indices(points.size());
  for (std::size_t i = 0; i < indices.size(); ++i)
    indices[i] = i;
  const auto map = CGAL::make_property_map(points.data());
  output.clear();
  CGAL::curvature_aware_simplify_point_set<Tag>(indices, std::back_inserter(output),
                                                np::point_map(map));
  EXPECT_EQ(output, expected);

  // an output iterator that is not a back inserter, and what is returned
  std::vector<Point> place(50);
  EXPECT_EQ(CGAL::curvature_aware_simplify_point_set<Tag>(points, place.begin()), place.end());
  EXPECT_EQ(place, expected);
}

// Pointers are property maps of Boost, also where those of CGAL are declared.
TEST(Ranges, with_pointers_as_maps)
{
  const std::vector<Point> points = surfaces::torus(500, 3., 1., 4);
  std::vector<std::ptrdiff_t> indices(points.size()); // the keys of pointers
  std::iota(indices.begin(), indices.end(), 0);
  std::vector<double> variation(points.size(), -1.), expected(points.size(), -2.);
  EXPECT_TRUE(CGAL::estimate_surface_variation<Tag>(indices, 16, variation.data(),
                                                    np::point_map(points.data())));
  EXPECT_TRUE(
      CGAL::estimate_surface_variation<Tag>(indices, 16, CGAL::make_property_map(expected.data()),
                                            np::point_map(CGAL::make_property_map(points.data()))));
  EXPECT_EQ(variation, expected);
}

// as the manual says of each function
TEST(Ranges, may_be_the_output_as_well)
{
  const std::vector<Point> points = surfaces::torus(1000, 3., 1., 4);
  std::vector<Point> simplified, selected;
  CGAL::curvature_aware_simplify_point_set<Tag>(points, std::back_inserter(simplified));
  CGAL::curvature_aware_random_simplify_point_set<Tag>(points, std::back_inserter(selected));

  std::vector<Point> both = points;
  both.shrink_to_fit();
  CGAL::curvature_aware_simplify_point_set<Tag>(both, std::back_inserter(both));
  EXPECT_EQ(std::vector<Point>(both.begin() + 1000, both.end()), simplified);

  both = points;
  both.erase(CGAL::curvature_aware_random_simplify_point_set<Tag>(both, both.begin()), both.end());
  EXPECT_EQ(both, selected);
}

TEST(Ranges, of_point_set_3)
{
  using Point_set = CGAL::Point_set_3<Point>;
  Point_set points;
  for (const Point& p : surfaces::torus(1000, 3., 1., 5))
    points.insert(p);
  auto variation = points.add_property_map<double>("variation", -1.).first;
  ASSERT_TRUE(CGAL::estimate_surface_variation<Tag>(points, 16, variation));
  for (const Point_set::Index& i : points)
  {
    EXPECT_GT(variation[i], 0.);
    EXPECT_LT(variation[i], 1. / 3.);
  }

  const Point_set& constant = points;
  Point_set output;
  CGAL::curvature_aware_simplify_point_set<Tag>(constant, output.point_back_inserter());
  EXPECT_EQ(output.size(), 50u);
  std::vector<Point_set::Index> subset;
  CGAL::curvature_aware_random_simplify_point_set<Tag>(constant, std::back_inserter(subset));
  EXPECT_EQ(subset.size(), 50u);
}

// A model of DiagonalizeTraits that counts its uses
struct Counting_traits
{
  using Base = CGAL::Default_diagonalize_traits<double, 3>;
  using Vector = Base::Vector;
  using Matrix = Base::Matrix;
  using Covariance_matrix = Base::Covariance_matrix;
  static std::atomic<int> uses;
  static bool diagonalize_selfadjoint_covariance_matrix(const Covariance_matrix& m, Vector& v)
  {
    ++uses;
    return Base::diagonalize_selfadjoint_covariance_matrix(m, v);
  }
};
std::atomic<int> Counting_traits::uses{0};

TEST(Named_parameters, chain_in_any_order)
{
  const std::vector<Element> range = elements(500);
  CGAL::Curvature_aware_simplification_report report;
  const std::function<bool(double)> go_on = [](double) { return true; };

  std::vector<Point> first, second;
  CGAL::curvature_aware_simplify_point_set<Tag>(range, std::back_inserter(first),
                                                np::point_map(Point_map())
                                                    .settings_of_the_paper(true)
                                                    .select_percentage(5)
                                                    .curvature_dependence(2.5)
                                                    .curvature_weight(0.6)
                                                    .adaptivity(0.5)
                                                    .number_of_neighbors(12)
                                                    .repulsion_weight(0.4)
                                                    .recompute_curvature(true)
                                                    .simplification_report(std::ref(report))
                                                    .random_seed(3)
                                                    .number_of_iterations(4)
                                                    .neighbor_radius(1.5)
                                                    .require_uniform_sampling(true)
                                                    .callback(go_on)
                                                    .geom_traits(Kernel())
                                                    .diagonalize_traits(Counting_traits()));
  EXPECT_EQ(report.number_of_output_points, 25u);
  // each input point once, each sample before each iteration
  EXPECT_EQ(Counting_traits::uses, 500 + 25 * 4);

  CGAL::curvature_aware_simplify_point_set<Tag>(range, std::back_inserter(second),
                                                np::recompute_curvature(true)
                                                    .diagonalize_traits(Counting_traits())
                                                    .geom_traits(Kernel())
                                                    .require_uniform_sampling(true)
                                                    .neighbor_radius(1.5)
                                                    .number_of_iterations(4u)
                                                    .random_seed(3u)
                                                    .repulsion_weight(0.4f)
                                                    .number_of_neighbors(12u)
                                                    .adaptivity(0.5)
                                                    .curvature_weight(0.6)
                                                    .curvature_dependence(2.5)
                                                    .select_percentage(5.)
                                                    .settings_of_the_paper(true)
                                                    .point_map(Point_map()));
  // 0.4f is not 0.4
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i)
    EXPECT_LT(CGAL::squared_distance(first[i], second[i]), 1e-12);
}

TEST(Named_parameters, each_has_an_effect)
{
  const std::vector<Point> points = surfaces::ellipsoid(1000, 3., 6);
  const auto run = [&](const auto& parameters) {
    std::vector<Point> output;
    CGAL::curvature_aware_simplify_point_set<Tag>(points, std::back_inserter(output),
                                                  parameters.settings_of_the_paper(true));
    return output;
  };
  const std::vector<Point> standard = run(np::default_values());
  EXPECT_EQ(standard, run(np::select_percentage(5.)));
  EXPECT_EQ(standard, run(np::number_of_output_points(50)));
  EXPECT_EQ(standard, run(np::curvature_weight(0.75)));
  EXPECT_EQ(standard, run(np::curvature_dependence(2.)));
  EXPECT_EQ(standard, run(np::adaptivity(2. / 3.)));
  EXPECT_EQ(standard, run(np::number_of_neighbors(16)));
  EXPECT_EQ(standard, run(np::repulsion_weight(0.45)));
  EXPECT_EQ(standard, run(np::number_of_iterations(10)));
  EXPECT_EQ(standard, run(np::recompute_curvature(false)));
  EXPECT_EQ(standard, run(np::require_uniform_sampling(false)));
  EXPECT_NE(standard, run(np::curvature_weight(0.2)));
  EXPECT_NE(standard, run(np::curvature_dependence(1.)));
  EXPECT_NE(standard, run(np::adaptivity(0.3)));
  EXPECT_NE(standard, run(np::number_of_neighbors(30)));
  EXPECT_NE(standard, run(np::repulsion_weight(0.3)));
  EXPECT_NE(standard, run(np::number_of_iterations(11)));
  EXPECT_NE(standard, run(np::recompute_curvature(true)));
  EXPECT_NE(standard, run(np::require_uniform_sampling(true)));
  EXPECT_NE(standard, run(np::neighbor_radius(0.7)));
}

// A program that calls CGAL's WLOP; the test replaces the name and nothing else.
#define CGAL_TEST_PROGRAM(function)                                                                \
  [](std::vector<Point> points) {                                                                  \
    std::vector<Point> output;                                                                     \
    const double retain_percentage = 2.;                                                           \
    const double neighbor_radius = 0.5;                                                            \
    CGAL::function<Tag>(points, std::back_inserter(output),                                        \
                        CGAL::parameters::select_percentage(retain_percentage)                     \
                            .neighbor_radius(neighbor_radius)                                      \
                            .number_of_iterations(5)                                               \
                            .require_uniform_sampling(true));                                      \
    return output.size();                                                                          \
  }

TEST(Change_from_WLOP, needs_a_new_name_only)
{
  const std::vector<Point> points = surfaces::torus(2000, 3., 1., 7);
  EXPECT_EQ(CGAL_TEST_PROGRAM(wlop_simplify_and_regularize_point_set)(points), 40u);
  EXPECT_EQ(CGAL_TEST_PROGRAM(curvature_aware_simplify_point_set)(points), 40u);
}

TEST(Change_from_WLOP, may_share_named_parameters)
{
  std::vector<Point> points = surfaces::torus(2000, 3., 1., 7), output;
  const auto parameters = np::select_percentage(2).curvature_dependence(1.);
  CGAL::wlop_simplify_and_regularize_point_set<Tag>(points, std::back_inserter(output), parameters);
  EXPECT_EQ(output.size(), 40u);
}

} // namespace
