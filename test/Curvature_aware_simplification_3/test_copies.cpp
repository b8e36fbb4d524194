// Places that were measured several times: their copies count as one point.

#include "inputs.h"
#include "surfaces.h"

#include <CGAL/Curvature_aware_simplification_3/internal/copies/Copies_of_places.h>
#include <CGAL/Curvature_aware_simplification_3/internal/copies/merge_copies.h>
#include <CGAL/Curvature_aware_simplification_report.h>
#include <CGAL/Random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <vector>

namespace {

using namespace inputs;

// Each place so many times, with normally distributed errors in each coordinate
std::vector<Point> copies_of(const std::vector<Point>& places, int copies, double sigma,
                             unsigned int seed)
{
  std::vector<Point> points;
  for (int copy = 0; copy < copies; ++copy)
  {
    const std::vector<Point> next = with_noise(places, sigma, seed + static_cast<unsigned>(copy));
    points.insert(points.end(), next.begin(), next.end());
  }
  return points;
}

// n x n places a distance of 1 apart
std::vector<Point> lattice(int n)
{
  std::vector<Point> points;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      points.emplace_back(i, j, 0.);
  return points;
}

// in the unit of the points
double distance_of_copies_in(const std::vector<Point>& points)
{
  const Cloud cloud = cloud_of(points);
  return cloud.frame.length_from_frame(distance_of_copies<Tag>(cloud, 64));
}

std::vector<Point> merged(const std::vector<Point>& points, std::size_t number_of_samples)
{
  Cloud cloud = cloud_of(points);
  merge_copies<Tag>(cloud, number_of_samples, Progress(no_callback));
  EXPECT_EQ(cloud.search->size(), cloud.size());
  return each(cloud.points, [&](const Point& p) {
    return cloud.frame.from_frame(p, std::numeric_limits<double>::max());
  });
}

// The distance of the point of the unit sphere that is farthest from all samples, over that of a
// hexagonal lattice
double largest_gap_on_sphere(const std::vector<Point>& samples)
{
  const Neighbor_search search(samples, Tag());
  double largest = 0.;
  for (const Point& p : surfaces::sphere(20000, 77))
    largest = std::max(largest, squared_distance(p, search.nearest(p)));
  const double area = 4. * CGAL_PI / static_cast<double>(samples.size());
  return std::sqrt(largest / (2. / std::sqrt(3.) * area));
}

} // namespace

// From all of them to the middle of the gap, as its logarithm counts: up to 10 times as far
TEST(Copies, are_within_their_distance)
{
  // two, three and sixty of each place, 0.001 from one end to the other
  for (int copies : {2, 3, 60})
  {
    std::vector<Point> points;
    for (const Point& p : lattice(30))
      for (int copy = 0; copy < copies; ++copy)
        points.push_back(p + Vector(0., 0., 0.001 * copy / (copies - 1.)));
    const double distance = distance_of_copies_in(points);
    EXPECT_GE(distance, 0.003) << copies;
    EXPECT_LE(distance, 0.0036) << copies;
  }
}

// The square of the root of a distance may be less than the distance: of copies at the same
// distance and in the same direction, none were in a ball with that radius.
TEST(Copies, at_the_same_distance_are_merged_in_any_unit)
{
  for (const Vector& shift : {Vector(1., 1., 1.), Vector(1., 2., 1.), Vector(1., 0., 0.)})
    for (double unit : {1., 0.001, 3., 25.4})
    {
      std::vector<Point> points;
      for (const Point& p : lattice(32))
      {
        points.push_back(CGAL::ORIGIN + unit * (p - CGAL::ORIGIN));
        points.push_back(points.back() + unit / 256. * shift);
      }
      EXPECT_EQ(merged(points, 10).size(), 1024u) << shift << ' ' << unit;
    }
}

TEST(Copies, are_more_than_those_of_chance)
{
  const auto line = [](std::size_t n, unsigned int seed) {
    return surfaces::sample(n, seed,
                            [](CGAL::Random& r) { return Point(r.uniform_real(0., 1.), 0., 0.); });
  };
  const auto volume = [](std::size_t n, unsigned int seed) {
    return surfaces::sample(n, seed, [](CGAL::Random& r) {
      const double x = r.uniform_real(0., 1.), y = r.uniform_real(0., 1.);
      return Point(x, y, r.uniform_real(0., 1.));
    });
  };
  const auto number_merged = [](const std::vector<Point>& points) {
    return points.size() - merged(points, 10).size();
  };
  for (unsigned int seed = 0; seed < 50; ++seed)
    for (std::size_t n : {60u, 200u, 5000u})
    {
      EXPECT_EQ(number_merged(surfaces::sphere(n, seed)), 0u) << n << ' ' << seed;
      EXPECT_EQ(number_merged(line(n, seed)), 0u) << n << ' ' << seed;
      EXPECT_EQ(number_merged(volume(n, seed)), 0u) << n << ' ' << seed;
    }
  EXPECT_EQ(number_merged(lattice(50)), 0u);
  // lines that are 8, 30 and 100 times as far apart as their points
  for (double distance : {8., 30., 100.})
  {
    std::vector<Point> lines;
    for (int i = 0; i < 30; ++i)
      for (int j = 0; j < 300; ++j)
        lines.emplace_back(distance * i, j, 0.);
    EXPECT_EQ(number_merged(lines), 0u) << distance;
  }
  // noise of a scanner at rest that is as large as its points are apart
  EXPECT_EQ(number_merged(frames_of_a_scanner_at_rest(40, 10, 1., 1)), 0u);
}

// As many as there are points for each sample, but for no more than 256 neighbors
TEST(Copies, are_looked_for_as_long_as_there_may_be_more)
{
  const std::vector<Point> points = copies_of(lattice(10), 80, 0.001, 1);
  EXPECT_EQ(merged(points, 100).size(), 100u);
  const std::vector<Point> many = copies_of(lattice(10), 200, 0.001, 1);
  EXPECT_EQ(merged(many, 100).size(), 100u);
  EXPECT_EQ(merged(copies_of(lattice(10), 300, 0.001, 1), 100).size(), 30000u);
}

TEST(Copies, are_replaced_by_their_mean)
{
  std::vector<Point> points;
  for (const Point& p : lattice(30))
    for (double offset : {-0.001, 0., 0.001, 0.002})
      points.push_back(p + Vector(offset, -2. * offset, 3. * offset));
  std::vector<Point> places = merged(points, 900);
  ASSERT_EQ(places.size(), 900u);
  std::sort(places.begin(), places.end());
  for (std::size_t i = 0; i < 900; ++i)
  {
    const Point expected = lattice(30)[i] + Vector(0.0005, -0.001, 0.0015);
    EXPECT_LT(squared_distance(places[i], expected), 1e-24) << i;
  }
  // each sample needs a point to start from
  EXPECT_EQ(merged(points, 901).size(), 3600u);
  // few and small parts far from each other look the same
  std::vector<Point> parts;
  for (const Point& p : surfaces::square(50, 9))
    for (int i = 0; i < 40; ++i)
      parts.push_back(p + Vector(0., 0., 0.0001 * i));
  EXPECT_GT(distance_of_copies_in(parts), 0.);
  EXPECT_EQ(merged(parts, 10).size(), 2000u);
}

// Next to copies, a sphere of points that are as near to each other as these: all are left where a
// ball holds more than could be copies.
TEST(Copies, leave_dense_parts_as_they_are)
{
  std::vector<Point> points = copies_of(lattice(40), 20, 0.03, 3), dense;
  for (const Point& p : surfaces::sphere(2000, 13))
    dense.push_back(CGAL::ORIGIN + 0.25 * (p - CGAL::ORIGIN) + Vector(20., 20., 20.));
  points.insert(points.end(), dense.begin(), dense.end());
  const double r = distance_of_copies_in(points);
  ASSERT_GT(r, 0.15); // balls hold 2000 (r / 0.5)^2 = 180 points of the sphere or more
  const std::vector<Point> places = merged(points, 100);
  EXPECT_LT(places.size(), 3700u);
  const Neighbor_search search(places, Tag());
  const auto left = std::count_if(dense.begin(), dense.end(), [&](const Point& p) {
    return squared_distance(p, search.nearest(p)) < 1e-20;
  });
  EXPECT_GT(left, 0.9 * static_cast<double>(dense.size()));
}

// Many returns at the place of the scanner: the time grew with the square of their number.
TEST(Copies, are_not_looked_for_among_all_points_of_a_dense_place)
{
  std::vector<Point> points = copies_of(lattice(40), 40, 0.02, 3);
  const std::vector<Point> returns =
      with_noise(std::vector<Point>(27000, Point(20., 20., 100.)), 1e-4, 14);
  points.insert(points.end(), returns.begin(), returns.end());
  const Cloud cloud = cloud_of(points);
  const Copies_of_places copies = find_copies<Tag>(cloud, 10000);
  ASSERT_GT(copies.distance, 0.);
  EXPECT_EQ(copies.most, 64u);
  std::size_t left = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    left += merged_point(i, cloud, copies).is_left ? 1 : 0;
  EXPECT_NEAR(static_cast<double>(left), 27000. + 1600., 50.);
}

// The distances of 60 points from the middle of a ball of 1, a disk or a segment
std::vector<std::vector<double>> distances_in(double dimension)
{
  CGAL::Random random(12);
  std::vector<std::vector<double>> distances(300);
  for (std::vector<double>& here : distances)
  {
    for (int i = 0; i < 60; ++i)
      here.push_back(std::pow(random.uniform_real(0., 1.), 1. / dimension));
    std::sort(here.begin(), here.end());
  }
  return distances;
}

TEST(Copies, with_errors_in_all_directions_fill_volumes)
{
  EXPECT_TRUE(fill_volumes(distances_in(3.), 1.));
  EXPECT_FALSE(fill_volumes(distances_in(2.), 1.));
  EXPECT_FALSE(fill_volumes(distances_in(1.), 1.));
  // too few to tell: one within a sixth of r, and ten within a third
  EXPECT_FALSE(fill_volumes({{0.1, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.9}}, 1.));
}

TEST(Copies, are_more_than_the_neighbors_beyond_them)
{
  // of two points, 3 within 1, and one between 1 and 10: 6 - 2 * 2
  EXPECT_EQ(surplus_of_copies({{0.5, 0.6, 1., 9., 19.}, {0.5, 0.6, 1., 9., 19.}}, 1.), 2.);
  EXPECT_EQ(surplus_of_copies({{0.5, 0.6, 1., 11., 19.}, {0.5, 0.6, 1., 11., 19.}}, 1.), 6.);
  // there may be more within 10 than were looked at: 6 - 2 * 8
  EXPECT_EQ(surplus_of_copies({{0.5, 0.6, 1., 9.}, {0.5, 0.6, 1., 9.}}, 1.), -10.);
}

// Of 20 copies, all neighbors were one place, which has no surface: samples were as far as two
// spacings apart, and up to 44 % of the points taken for outliers.
TEST(Copies, do_not_change_the_samples)
{
  const std::vector<Point> places = surfaces::sphere(2000, 1); // 0.08 apart
  const auto distance_of_samples = [](const std::vector<Point>& samples) {
    return mean_distance(samples, distance_to_sphere);
  };
  const double expected = distance_of_samples(simplified(places, np::number_of_output_points(500)));
  for (int copies : {2, 3, 8, 16, 20, 40})
    for (double sigma : {1e-9, 1e-4, 3e-4, 1e-3, 2e-3})
    {
      if (copies < 10 && sigma > 3e-4)
        continue; // they tell too little of it
      CGAL::Curvature_aware_simplification_report report;
      const std::vector<Point> samples =
          simplified(copies_of(places, copies, sigma, 2),
                     np::number_of_output_points(500).simplification_report(std::ref(report)));
      EXPECT_EQ(report.number_of_outliers, 0u) << copies << ' ' << sigma;
      const double merged = 2000. * (copies - 1.), may_miss = copies < 8 ? 0.2 : 0.02;
      EXPECT_NEAR(static_cast<double>(report.number_of_merged_points), merged, may_miss * merged)
          << copies << ' ' << sigma;
      EXPECT_LT(largest_gap_on_sphere(samples), 0.95) << copies << ' ' << sigma;
      EXPECT_LT(distance_of_samples(samples), 1.5 * expected + 0.5 * sigma)
          << copies << ' ' << sigma;
    }
}

// Where one half has copies and the other is as dense without, the one with copies got one sample of
// twenty.
TEST(Copies, of_one_half_do_not_take_samples_from_it)
{
  std::vector<Point> points, upper;
  for (const Point& p : surfaces::sphere(60000, 4))
    if (p.z() < 0.)
      points.push_back(p);
    else if (upper.size() < 1000)
      upper.push_back(p);
  for (double sigma : {0.0001, 0.0008})
  {
    std::vector<Point> both = copies_of(upper, 20, sigma, 5);
    both.insert(both.end(), points.begin(), points.end());
    const std::vector<Point> samples = simplified(both, np::number_of_output_points(1000));
    const auto number_above =
        std::count_if(samples.begin(), samples.end(), [](const Point& p) { return p.z() > 0.; });
    EXPECT_NEAR(static_cast<double>(number_above), 470., 50.) << sigma;
  }
}

// Blades of grass, six lengths apart, of which fewer are asked for: samples on the mean surface of
// their middles would be a length and more away from all points.
TEST(Copies, are_no_small_parts_far_from_each_other)
{
  CGAL::Random random(10);
  std::vector<Point> points;
  for (const Point& p : surfaces::square(1000, 11))
  {
    const double angle = random.uniform_real(0., 2. * CGAL_PI);
    for (int i = 0; i < 50; ++i)
    {
      const double u = random.uniform_real(-0.05, 0.05), v = random.uniform_real(0., 0.5);
      points.push_back(Point(100. * p.x(), 100. * p.y(), v) +
                       u * Vector(std::cos(angle), std::sin(angle), 0.) +
                       0.3 * v * v * Vector(std::sin(angle), -std::cos(angle), 0.));
    }
  }
  CGAL::Curvature_aware_simplification_report report;
  const std::vector<Point> samples =
      simplified(points, np::number_of_output_points(600).simplification_report(std::ref(report)));
  EXPECT_EQ(report.number_of_merged_points, 0u);
  const Neighbor_search search(points, Tag());
  const auto distance_to_points = [&](const Point& p) {
    return std::sqrt(squared_distance(p, search.nearest(p)));
  };
  EXPECT_LT(mean_distance(samples, distance_to_points), 0.02);
}

// The same scan in double and in float: distances to the surface were up to eight times as large.
TEST(Copies, that_differ_by_rounding_are_merged)
{
  const std::vector<Point> places = surfaces::torus(4000, 2., 0.7, 6);
  const auto distance_of_samples = [](const std::vector<Point>& points) {
    return mean_distance(simplified(points, np::number_of_output_points(400)),
                         [](const Point& p) { return surfaces::distance_to_torus(p, 2., 0.7); });
  };
  const auto rounded = [](const Point& p) {
    const auto to_float = [](double x) { return static_cast<double>(static_cast<float>(x)); };
    return Point(to_float(p.x()), to_float(p.y()), to_float(p.z()));
  };
  const auto written = [](const Point& p) {
    const auto digits = [](double x) { return std::round(x * 1e5) / 1e5; };
    return Point(digits(p.x()), digits(p.y()), digits(p.z()));
  };
  std::vector<Point> points = places;
  for (const std::vector<Point>& other : {each(places, rounded), each(places, written)})
    points.insert(points.end(), other.begin(), other.end());
  EXPECT_LT(distance_of_samples(points), 1.1 * distance_of_samples(places));
}

TEST(Copies, are_merged_the_same_whatever_the_tag_and_the_order)
{
  std::vector<Point> points = copies_of(surfaces::sphere(1000, 7), 10, 0.001, 8);
  const auto parameters = np::number_of_output_points(200).random_seed(3);
  const std::vector<Point> expected = simplified(points, parameters);
  std::vector<Point> sequential;
  CGAL::curvature_aware_simplify_point_set<CGAL::Sequential_tag>(
      points, std::back_inserter(sequential), parameters);
  EXPECT_EQ(sequential, expected);
  std::reverse(points.begin(), points.end());
  EXPECT_EQ(simplified(points, parameters), expected);
}
