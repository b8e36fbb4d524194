// The level of the noise and its ranges

#include "inputs.h"

#include <CGAL/Curvature_aware_simplification_3/internal/input/Cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/Noise_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/columns_of_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/limits_of_noise.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/measure_noise.h>
#include <CGAL/Curvature_aware_simplification_3/internal/noise/noise_around_quadrics.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/median.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace {

using namespace inputs;

Noise_levels noise_at_places(const Cloud& cloud,
                             const Adaptive_settings& settings = default_settings)
{
  return measure_noise<Tag>(cloud, many_probes(cloud.size(), settings.most_noise_probes), false,
                            settings);
}

double noise_of(const std::vector<Point>& points)
{
  const Cloud cloud = cloud_of(points);
  return cloud.frame.length_from_frame(noise_at_places(cloud).median());
}

TEST(Noise_level, is_found_on_smooth_surfaces)
{
  // up to about the spacing of the points, which is 0.05: there, 15.5 % of the noise hides itself
  for (double sigma : {0.005, 0.02, 0.05})
    EXPECT_NEAR(noise_of(with_noise(surfaces::torus(50000, 3., 1., 8), sigma, 9)) / sigma, 1., 0.16)
        << sigma;
  for (double sigma : {0.001, 0.003, 0.008})
    EXPECT_NEAR(noise_of(with_noise(surfaces::square(20000, 8), sigma, 10)) / sigma, 1., 0.15)
        << sigma;
  // much wider than the spacing: at least its size
  EXPECT_NEAR(noise_of(with_noise(surfaces::square(20000, 8), 0.05, 10)) / 0.05, 1., 0.5);
}

TEST(Noise_level, is_that_of_one_of_two_close_sheets)
{
  // sheets with the noise 1 at heights of a and -a: s^2 = a^2 + 1, kurtosis -2 a^4 / s^4
  EXPECT_NEAR(noise_in_thickness({std::sqrt(3.), 1., 1., -8. / 9.}), 1. / std::sqrt(3.), 1e-15);
  EXPECT_EQ(noise_in_thickness({1., 1., 1., -2.}), 0.);
  EXPECT_EQ(noise_in_thickness({1., 1., 1., -0.6}), 1.); // of one sheet, cut off by a ball
  // With noise of four spacings of the points, three sigma apart, neither is seen alone. The
  // thickness of both together is 1.8 sigma.
  std::vector<Point> points;
  for (const Point& p : surfaces::square(40000, 8))
    points.emplace_back(p.x(), p.y(), points.size() % 2 == 0 ? 0.03 : -0.03);
  EXPECT_NEAR(noise_of(with_noise(std::move(points), 0.02, 10)) / 0.02, 1., 0.25);
}

TEST(Noise_level, is_small_without_noise)
{
  EXPECT_LT(noise_of(surfaces::square(20000, 11)), 1e-9);
  // cubic terms of the shape over a neighborhood of radius 0.05
  EXPECT_LT(noise_of(surfaces::torus(50000, 3., 1., 11)), 2e-4);
}

// The level at each point of the cloud, in the unit of the input
std::vector<double> noise_of_points(const Cloud& cloud)
{
  const Noise_levels noise = noise_at_places(cloud);
  std::vector<double> levels(cloud.size());
  for (std::size_t i = 0; i < levels.size(); ++i)
    levels[i] = cloud.frame.length_from_frame(noise.at(i).level);
  return levels;
}

TEST(Noise_level, is_that_of_the_place)
{
  std::vector<Point> points = with_noise(surfaces::square(50000, 8), 0.001, 9);
  for (const Point& p : with_noise(surfaces::square(50000, 10), 0.004, 11))
    points.emplace_back(p.x() + 1., p.y(), p.z());
  const Cloud cloud = cloud_of(points);
  const std::vector<double> levels = noise_of_points(cloud);
  for (std::size_t i = 0; i < cloud.size(); ++i)
  {
    const double x = points[cloud.input_index[i]].x();
    if (x < 0.7 || x > 1.3)
    {
      // the largest of 512 medians of 64 values, each known to 8 %
      EXPECT_NEAR(levels[i] / (x < 1. ? 0.001 : 0.004), 1., 0.3) << x;
    }
  }
}

TEST(Noise_level, of_a_thin_part_is_not_its_thickness)
{
  // a wire that is hardly thicker than its noise, on a sphere; it has a fourth of the points, and
  // seven tenths
  const double sigma = 0.02;
  for (std::size_t on_wire : {10000u, 28000u})
  {
    std::vector<Point> points = surfaces::sphere(40000 - on_wire, 8);
    for (const Point& p : surfaces::square(on_wire, 9))
      points.emplace_back(1. + 4. * p.x(), 0.04 * std::cos(2. * CGAL_PI * p.y()),
                          0.04 * std::sin(2. * CGAL_PI * p.y()));
    const std::vector<double> levels = noise_of_points(cloud_of(with_noise(points, sigma, 10)));
    const auto wrong = std::count_if(levels.begin(), levels.end(), [&](double level) {
      return level < 0.7 * sigma || level > 1.3 * sigma;
    });
    EXPECT_LT(wrong, static_cast<std::ptrdiff_t>(levels.size() / 100)); // two ranges of 312
  }
}

TEST(Noise_level, of_thick_parts_is_no_more_than_that_of_others_up_to_twice_that)
{
  std::vector<Noise_of_range> of_range(10);
  const double levels[] = {1., 2., 3., 4., 5.9, 6.1, 5., 20., 2., 1.};
  for (std::size_t i = 0; i < 10; ++i)
    of_range[i].noise.level = levels[i];
  EXPECT_EQ(upper_known_noise(of_range, {3, 4, 5, 6, 7, 8}), 3.); // of 1, 1, 2 and 3
  EXPECT_FALSE(upper_known_noise(of_range, {0, 1, 2, 3, 4, 5, 6, 7, 8}));
  limit_unknown_noise({3, 4, 5, 6, 7, 8}, 5.5, of_range);
  for (std::size_t i : {3u, 4u, 6u, 8u})
    EXPECT_EQ(of_range[i].noise.limit, 3.) << i;
  for (std::size_t i : {5u, 7u}) // more than twice as much
    EXPECT_EQ(of_range[i].noise.limit, 5.5) << i;
  EXPECT_EQ(of_range[0].noise.limit, std::numeric_limits<double>::infinity());
}

TEST(Noise_level, of_thin_parts_is_not_their_shape)
{
  // 64 rods with a radius of three times the noise: no layer is wide against its thickness, which
  // grows with it
  const double sigma = 0.01;
  std::vector<Point> points;
  for (const Point& p : surfaces::square(30000, 8))
  {
    const auto rod = static_cast<int>(points.size() % 64);
    const double angle = 2. * CGAL_PI * p.y();
    points.emplace_back(0.3 * (rod % 8) + 3. * sigma * std::cos(angle),
                        0.3 * (rod / 8) + 3. * sigma * std::sin(angle), 0.4 * p.x());
  }
  EXPECT_NEAR(noise_of(with_noise(std::move(points), sigma, 10)) / sigma, 1., 0.2);
}

TEST(Noise_level, is_found_where_larger_layers_hold_another_sheet)
{
  // the 17 nearest points are on one of two sheets, of the 34 nearest some are on the other
  std::vector<Point> sheets;
  for (const Point& p : surfaces::square(20000, 8))
    sheets.emplace_back(100. * p.x(), 100. * p.y(), sheets.size() % 2 == 0 ? 0. : 2.75);
  EXPECT_NEAR(noise_of(with_noise(sheets, 0.2, 10)) / 0.2, 1., 0.2);
  EXPECT_LT(noise_of(sheets), 1e-6);
}

TEST(Layers, that_are_thick_by_shape)
{
  // thickness, width, length, kurtosis
  EXPECT_TRUE(are_thick_by_shape({1., 3., 3., 0.}, {1.5, 4.2, 4.2, 0.}));
  EXPECT_FALSE(are_thick_by_shape({1., 3., 3., 0.}, {1., 4.2, 4.2, 0.}));    // noise
  EXPECT_FALSE(are_thick_by_shape({1., 2.3, 2.3, 0.}, {1.3, 2.9, 2.9, 0.})); // a volume
}

TEST(Layers, that_hold_another_sheet)
{
  EXPECT_TRUE(holds_another_sheet({1., 7., 7., 0.}, {3., 10., 10., 0.}));
  EXPECT_FALSE(holds_another_sheet({1., 7., 7., 0.}, {1.9, 10., 10., 0.}));  // shape
  EXPECT_FALSE(holds_another_sheet({0.1, 7., 7., 0.}, {0.3, 10., 10., 0.})); // of a clean sheet
}

TEST(Layers, that_are_two_sheets)
{
  // thickness, width, length, kurtosis, middle: as measured in layers of 136 points
  EXPECT_FALSE(are_two_sheets({1., 7., 7., -0.09, 0.38})); // Gaussian noise
  EXPECT_FALSE(are_two_sheets({1., 7., 7., -0.54, 0.37})); // triangular
  EXPECT_FALSE(are_two_sheets({1., 7., 7., -1.08, 0.30})); // uniform
  EXPECT_TRUE(are_two_sheets({1., 7., 7., -0.89, 0.28}));  // two sheets 3 sigma apart
  EXPECT_TRUE(are_two_sheets({1., 7., 7., -1.13, 0.23}));  // 3.8 sigma
  EXPECT_TRUE(are_two_sheets({1., 7., 7., -1.62, 0.08}));  // 8 sigma
}

// Of Gaussian noise on two sheets at heights of 8 and -8, nothing is in the middle; of uniform noise
// sqrt(3) / 6 = 0.289, of Gaussian 0.383.
TEST(Layer_around_quadric, knows_the_share_of_heights_in_the_middle)
{
  constexpr std::size_t k = 544;
  CGAL::Random random(3);
  const std::vector<Point> square = surfaces::square(40000, 8);
  const auto middle = [&](const auto& height) {
    std::vector<Point> points;
    for (const Point& p : square)
      points.emplace_back(2000. * p.x(), 2000. * p.y(), height());
    const Neighbor_search search(points, Tag());
    return Layer_around_quadric()(search, Point(1000., 1000., 0.), k).middle;
  };
  EXPECT_EQ(middle([&] {
              const double side = random.get_bool() ? 8. : -8.;
              return side + surfaces::normal_deviate(random);
            }),
            0.);
  EXPECT_NEAR(middle([&] { return random.uniform_real(-1., 1.); }), 0.289, 0.05);
  EXPECT_NEAR(middle([&] { return surfaces::normal_deviate(random); }), 0.383, 0.05);
}

TEST(Noise_probes, are_more_where_there_are_more_points)
{
  EXPECT_EQ(many_probes(100, 4096), 512u);
  EXPECT_EQ(many_probes(16 * 600, 4096), 600u);
  EXPECT_EQ(many_probes(std::size_t(1) << 40, 4096), 4096u);
  const Searchable_points cloud = searchable(surfaces::square(1000, 8));
  const Noise_probes probes = noise_probes<Tag>(cloud, 160);
  EXPECT_EQ(probes.points.size(), 160u);
  EXPECT_EQ(probes.of_range.size(), 20u);
  for (const std::vector<std::size_t>& of_range : probes.of_range)
    EXPECT_EQ(of_range.size(), 64u);
  EXPECT_EQ(noise_probes<Tag>(cloud, 4096).points.size(), 1000u);
}

// The noise of a laser scanner is along its rays: none where these touch the surface. Medians of an
// eighth of the points hid that, and samples stayed where the points were.
TEST(Noise_level, along_one_axis_differs_by_place)
{
  const double sigma = 0.02;
  CGAL::Random random(8);
  std::vector<Point> points;
  for (const Point& p : surfaces::torus(60000, 3., 1., 8))
    points.emplace_back(p.x() + sigma * surfaces::normal_deviate(random), p.y(), p.z());
  const Cloud cloud = cloud_of(points);
  const Noise_levels noise = noise_at_places(cloud);
  double squares = 0.;
  for (std::size_t i = 0; i < cloud.size(); ++i)
  {
    const Point p = cloud.frame.from_frame(cloud.points[i], 1e300);
    const double r = std::sqrt(p.x() * p.x() + p.y() * p.y()); // of the torus around the z axis
    const double expected = sigma * std::abs((r - 3.) * p.x() / r); // sigma n_x
    const double found = cloud.frame.length_from_frame(noise.at(i).level);
    squares += (found - expected) * (found - expected);
  }
  EXPECT_LT(std::sqrt(squares / static_cast<double>(cloud.size())), 0.15 * sigma);
}

// Uniform noise was taken for two sheets, and half of it for their distance.
TEST(Noise_level, of_uniform_noise)
{
  for (int seed : {1, 2, 3})
    for (double sigma : {0.7, 1., 1.4, 2.})
    {
      CGAL::Random random(static_cast<unsigned int>(seed));
      std::vector<Point> points;
      for (const Point& p : surfaces::square(40000, static_cast<unsigned int>(seed)))
        points.emplace_back(200. * p.x(), 200. * p.y(),
                            std::sqrt(3.) * sigma * random.uniform_real(-1., 1.));
      EXPECT_NEAR(noise_of(points) / sigma, 0.95, 0.1) << sigma << ' ' << seed;
    }
}

TEST(Noise_level, of_a_thick_part_of_few_points_is_that_of_others)
{
  // 700 points on a sphere, and 300 on a wire as thick as its noise, which end before it looks flat
  const double sigma = 0.02;
  std::vector<Point> points = surfaces::sphere(700, 8);
  for (const Point& p : surfaces::square(300, 9))
    points.emplace_back(3. + 8. * p.x(), 0., 0.);
  const Cloud cloud = cloud_of(with_noise(points, sigma, 10));
  const std::vector<double> levels = noise_of_points(cloud);
  for (std::size_t i = 0; i < cloud.size(); ++i)
  {
    EXPECT_GT(levels[i], 0.5 * sigma) << points[cloud.input_index[i]];
    EXPECT_LT(levels[i], 2. * sigma) << points[cloud.input_index[i]];
  }
}

TEST(Noise_level, is_found_on_lines_of_a_scan)
{
  // Lines 1 apart, with noise of the range alone. With points 1/4 apart, the 7 nearest are on one
  // line, and with 1/10 the 17 nearest: in the plane of its noise, which does not show there. With
  // 1/8, the 8 nearest are, and some of the 17 on the next.
  for (const auto& [distance, sigma] :
       {std::make_pair(0.25, 0.05), std::make_pair(0.125, 0.04), std::make_pair(0.1, 0.03)})
  {
    CGAL::Random random(41);
    std::vector<Point> points;
    for (int i = 0; i < 50; ++i)
      for (int j = 0; j < 50. / distance; ++j)
        points.emplace_back(i, distance * j, sigma * surfaces::normal_deviate(random));
    for (double level : noise_of_points(cloud_of(points)))
      EXPECT_NEAR(level, sigma, 0.25 * sigma) << distance;
  }
}

// The nearer half of the 17 nearest points is on one line of a scan, and wider layers hold the
// other sheet: noise was not found.
TEST(Noise_level, is_found_on_lines_of_a_scan_of_two_close_sheets)
{
  constexpr double sigma = 0.04;
  CGAL::Random random(43);
  std::vector<Point> points;
  for (int sheet = 0; sheet < 2; ++sheet)
    for (int i = 0; i < 50; ++i)
      for (int j = 0; j < 250; ++j)
        points.emplace_back(i, 0.2 * (j + 0.5 * random.get_double()),
                            1.5 * sheet + sigma * surfaces::normal_deviate(random));
  for (double level : noise_of_points(cloud_of(points)))
    EXPECT_NEAR(level, sigma, 0.25 * sigma);
}

// Lines of points 1 apart, `gap` from each other, in sheets at these heights, with noise of the
// range
std::vector<Point> lines_of_a_scan(double gap, double sigma, std::vector<double> heights, int seed)
{
  const double extent = 50. * std::sqrt(gap);
  CGAL::Random random(static_cast<unsigned int>(seed));
  std::vector<Point> points;
  for (double height : heights)
    for (double y = random.uniform_real(0., gap); y < extent; y += gap)
      for (double x = random.get_double(); x < extent; x += 1.)
      {
        const double shift = random.uniform_real(-0.3, 0.3); // in this order for every compiler
        points.emplace_back(x + shift, y, height + sigma * surfaces::normal_deviate(random));
      }
  return points;
}

// The 7 nearest points, and where lines are far apart the 17 and the 28 nearest, are in the plane
// of the noise of one line, which stands on the surface: no noise was found, and samples were up to
// 2.3 sigma off.
TEST(Noise_level, as_large_as_the_distance_of_points_on_lines_of_a_scan)
{
  for (int seed : {44, 45, 46})
  {
    for (double gap : {4., 8., 16., 24.})
      for (double sigma : {1., 1.5})
        EXPECT_NEAR(noise_of(lines_of_a_scan(gap, sigma, {0.}, seed)) / sigma, 0.9, 0.15)
            << gap << ' ' << sigma << ' ' << seed;
    // of two sheets, it is not their distance
    EXPECT_NEAR(noise_of(lines_of_a_scan(4., 1., {0., 10.}, seed)), 0.9, 0.15) << seed;
  }
}

// Wider layers hold the other sheet, and planes tell nothing: the noise was lost.
TEST(Noise_level, is_found_on_lines_of_a_scan_next_to_another_sheet)
{
  for (int seed : {1, 2, 3})
    EXPECT_NEAR(noise_of(lines_of_a_scan(3.5, 0.3, {0., 5.5}, seed)) / 0.3, 0.8, 0.25);
  EXPECT_LT(noise_of(lines_of_a_scan(3.5, 0., {0., 5.5}, 1)), 1e-6);
}

TEST(Layers, that_jump_and_that_are_steady)
{
  // thickness, width, length, kurtosis
  EXPECT_TRUE(jumps({1., 7., 7., 0.}, {3.1, 10., 10., 0.}));
  EXPECT_FALSE(jumps({1., 7., 7., 0.}, {2.6, 10., 10., 0.})); // shape
  EXPECT_FALSE(jumps({0., 7., 7., 0.}, {0., 10., 10., 0.}));  // a plane
  EXPECT_TRUE(is_steady({1., 7., 7., 0.}, {1.05, 10., 10., -0.45}));
  EXPECT_FALSE(is_steady({1., 7., 7., 0.}, {1.4, 10., 10., -0.45})); // shape
  EXPECT_FALSE(is_steady({1., 7., 7., 0.}, {1.05, 10., 10., -1.}));  // two sheets
}

// Layers of 17, 34, 68 and 136 points of which the smallest stand on the surface
TEST(Noise_of_range, is_confirmed_by_layers_that_stay_as_thick)
{
  const Layer standing = {0.1, 4., 9., 0.}, lying = {1., 8., 11., 0.}, larger = {1., 12., 13., 0.},
              shape = {2., 12., 13., 0.};
  const Adaptive_settings settings;
  const Noise_around_planes nothing;
  {
    Noise_of_range range;
    EXPECT_FALSE(range.learn_from(17, standing, standing, lying, nothing, settings));
    EXPECT_FALSE(range.learn_from(34, standing, lying, larger, nothing, settings));
    EXPECT_TRUE(range.learn_from(68, lying, larger, larger, nothing, settings));
    EXPECT_NEAR(range.noise.level, 1., 1e-12);
    EXPECT_TRUE(range.noise.is_steady);
  }
  {
    Noise_of_range range;
    EXPECT_FALSE(range.learn_from(17, standing, standing, lying, nothing, settings));
    EXPECT_TRUE(range.learn_from(34, standing, lying, shape, nothing, settings));
    EXPECT_EQ(range.noise.level, 0.); // as shape alone leaves it
    EXPECT_FALSE(range.noise.is_steady);
  }
  // planes that show much less are asked for two sizes as well; others are not
  Noise_around_planes planes;
  planes.is_known = planes.is_reliable = true;
  planes.level = 0.1;
  Noise_of_range range;
  EXPECT_FALSE(range.learn_from(34, lying, lying, larger, planes, settings));
  EXPECT_TRUE(range.learn_from(68, lying, larger, larger, planes, settings));
  EXPECT_TRUE(range.noise.is_steady);
  planes.level = 0.9;
  Noise_of_range agreed;
  EXPECT_TRUE(agreed.learn_from(34, lying, lying, larger, planes, settings));
  EXPECT_FALSE(agreed.noise.is_steady);
}

TEST(Noise_level, is_found_in_columns_of_points)
{
  for (int frames : {5, 10, 20})
    for (double sigma : {0.05, 0.3, 1.})
    {
      const Cloud cloud = cloud_of(frames_of_a_scanner_at_rest(60, frames, sigma, 42));
      Noise_levels noise = noise_at_places(cloud);
      const double unit = cloud.frame.length_to_frame(1.);
      // Waves are oblique to the directions, and their noise is along these. Less is hidden by the
      // shape of as many points as are needed to see it.
      if (sigma > 0.1)
      {
        EXPECT_NEAR(noise.median() / (sigma * unit), 0.7, 0.2) << frames;
      }
      std::size_t columns = 0;
      for (const Noise& here : noise.of_range)
        if (here.radius_of_columns > 0.)
        {
          ++columns;
          EXPECT_NEAR(here.radius_of_columns / unit, 2.6, 1.2) << frames << ' ' << sigma;
        }
      EXPECT_GT(static_cast<double>(columns), 0.8 * static_cast<double>(noise.of_range.size()))
          << frames << ' ' << sigma;
    }
}

// With errors in all directions as well, the nearest point is not along the column. The oblique
// waves show 0.7 of the noise, as those without these errors do.
TEST(Noise_level, is_found_in_columns_that_scatter)
{
  for (int frames : {5, 10})
    for (double part : {0.02, 0.1, 0.2})
    {
      const double sigma = 0.3;
      const Cloud cloud = cloud_of(
          with_noise(frames_of_a_scanner_at_rest(100, frames, sigma, 42), part * sigma, 43));
      const Noise_levels noise = noise_at_places(cloud);
      EXPECT_NEAR(noise.median() / (sigma * cloud.frame.length_to_frame(1.)), 0.75, 0.1)
          << frames << ' ' << part;
      const auto columns = std::count_if(noise.of_range.begin(), noise.of_range.end(),
                                         [](const Noise& n) { return n.radius_of_columns > 0.; });
      EXPECT_GT(static_cast<double>(columns), 0.7 * static_cast<double>(noise.of_range.size()))
          << frames << ' ' << part;
    }
}

TEST(Columns_of_points, have_a_common_axis)
{
  const Vector x(1., 0., 0.), y(0., 1., 0.);
  const std::vector<Vector> vectors = {x, -x, y, CGAL::NULL_VECTOR};
  const auto vector = [&](std::size_t i) { return &vectors[i]; };
  const Common_axis of_three = common_axis({0, 1, 2}, vector, 1);
  EXPECT_NEAR(of_three.squared_cosine, 2. / 3., 1e-12);
  EXPECT_NEAR(of_three.across, 1. / 3., 1e-12);
  EXPECT_NEAR(std::abs(of_three.axis.x()), 1., 1e-12);
  EXPECT_NEAR(common_axis({0, 1, 2, 3}, vector, 1).squared_cosine, 0.5, 1e-12);
  EXPECT_EQ(common_axis({3}, vector, 1).squared_cosine, 0.);
  const Common_axis of_pairs = common_axis({0, 1}, vector, 2); // x, -x, -x, y
  EXPECT_NEAR(of_pairs.squared_cosine, 3. / 4., 1e-12);
  EXPECT_NEAR(of_pairs.across, 1. / 4., 1e-12);
}

TEST(Columns_of_points, show_no_direction_where_there_are_no_points)
{
  const std::vector<Point> points = {Point(0., 0., 0.), Point(0., 3., 4.)};
  const std::array<Vector, directions_of_place> directions =
      directions_to_nearest(Neighbor_search(points, Tag()), points[0]);
  EXPECT_NEAR((directions[0] - Vector(0., 0.6, 0.8)).squared_length(), 0., 1e-30);
  for (std::size_t i = 1; i < directions.size(); ++i)
    EXPECT_EQ(directions[i], CGAL::NULL_VECTOR);
}

TEST(Columns_of_points, are_few_until_there_are_a_dozen)
{
  // columns of five points on a unit grid, 0.1 apart
  std::vector<Point> points;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 20; ++j)
      for (int f = -2; f <= 2; ++f)
        points.emplace_back(i, j, 0.1 * f);
  const Neighbor_search search(points, Tag());
  const Point place(10., 10., 0.);
  for (const Vector& direction : directions_to_nearest(search, place))
    EXPECT_EQ(std::abs(direction.z()), 1.);
  const Vector z(0., 0., 1.);
  const Column of_17 = column_at(search, place, z, 17), of_68 = column_at(search, place, z, 68);
  EXPECT_EQ(of_17.points, 5.);
  EXPECT_NEAR(of_17.radius, std::sqrt(2.), 0.02); // 34 points: nine columns but for eleven points
  EXPECT_TRUE(of_17.is_one_of_few(17));
  // 0.075 of the radius of 68 points is 0.15, and the ends of the column are 0.12 and 0.19 off
  EXPECT_EQ(column_at(search, place, Vector(0.6, 0., 0.8), 68).points, 5.);
  EXPECT_EQ(column_at(search, place, Vector(0.96, 0., 0.28), 5).points, 3.);
  EXPECT_EQ(of_68.points, 5.);
  EXPECT_FALSE(of_68.is_one_of_few(68)); // of 13.6
  EXPECT_TRUE((Column{3., 1.}.is_one_of_few(34)));
  EXPECT_FALSE((Column{2., 1.}.is_one_of_few(17))); // the two sides of a thin part
  EXPECT_NEAR(std::abs(normal_around_column(search, place).z()), 1., 1e-5);
}

TEST(Columns_of_points, rise_from_the_surface)
{
  // five points each, at 0.1 spacings, along the direction, at random places of a square
  const auto columns = [](const Vector& direction, double scatter) {
    CGAL::Random random(68);
    const auto error = [&] { return scatter * random.uniform_real(-1., 1.); };
    std::vector<Point> points;
    for (int i = 0; i < 2000; ++i)
    {
      const Point place(random.uniform_real(0., 45.), random.uniform_real(0., 45.), 0.);
      for (int f = -2; f <= 2; ++f)
        points.push_back(place + 0.1 * f * direction + Vector(error(), error(), error()));
    }
    const Cloud cloud = cloud_of(points);
    const Noise_probes probes = noise_probes<Tag>(cloud, few_probes);
    const std::vector<std::size_t> ranges = all_ranges(probes);
    const std::vector<Vector> axes = parallel_axes<Tag>(probes, ranges);
    const std::vector<std::uint8_t> found = find_columns<Tag>(probes, ranges, axes);
    return static_cast<double>(std::count(found.begin(), found.end(), 1)) /
           static_cast<double>(found.size());
  };
  for (double scatter : {0., 0.02, 0.07})
  {
    EXPECT_GT(columns(Vector(0., 0., 1.), scatter), 0.99) << scatter;
    EXPECT_GT(columns(Vector(0.8, 0., 0.6), scatter), 0.99) << scatter;
    EXPECT_EQ(columns(Vector(0.6, 0.8, 0.), scatter), 0.) << scatter; // pieces of lines of a scan
  }
}

// The probes of a range and those that count for it
TEST(Noise_probes, are_around_the_middle_of_their_range)
{
  const Cloud cloud = cloud_of(surfaces::sphere(20000, 171));
  const Noise_probes probes = noise_probes<Tag>(cloud, 1000);
  ASSERT_EQ(probes.points.size(), 1000u);
  ASSERT_EQ(probes.of_range.size(), 125u);
  EXPECT_EQ(probes.range_around(0), 0u);
  EXPECT_EQ(probes.range_around(7), 0u);
  EXPECT_EQ(probes.range_around(8), 1u);
  EXPECT_EQ(probes.range_around(999), 124u);
  std::size_t in_own = 0; // of 64 around the middle, all but some at a jump of the curve
  for (std::size_t i = 0; i < 1000; ++i)
  {
    const std::vector<std::size_t>& own = probes.of_range[probes.range_around(i)];
    in_own += std::count(own.begin(), own.end(), i) > 0 ? 1 : 0;
  }
  EXPECT_GT(in_own, 900u);
}

TEST(Noise_level, sees_no_columns_elsewhere)
{
  CGAL::Random random(43);
  std::vector<Point> plate, lines;
  for (int i = 0; i < 20000; ++i)
  {
    const double x = random.uniform_real(0., 100.), y = random.uniform_real(0., 100.);
    plate.emplace_back(x, y, i % 2 == 0 ? 0. : 1.5);
    lines.emplace_back(i % 50, random.uniform_real(0., 50.), 0.);
  }
  // lines 6 times as far apart as their points, with noise along a direction: in a fifth of the
  // ranges, which are so wide that they bend, these look like columns
  std::vector<Point> coarse_lines;
  for (const Point& p : surfaces::torus(100000, 3., 1., 49))
    if (std::abs(p.x() / 0.35 - std::round(p.x() / 0.35)) * 0.35 < 0.01)
      coarse_lines.push_back(p + 0.025 / std::sqrt(14.) * surfaces::normal_deviate(random) *
                                     Vector(1., 2., 3.));
  const std::vector<std::vector<Point>> inputs = {
      coarse_lines,
      frames_of_a_scanner_at_rest(60, 1, 0.3, 44),
      surfaces::torus(20000, 3., 1., 45),
      with_noise(surfaces::torus(20000, 3., 1., 46), 0.05, 47),
      cube(20000, 48),
      plate,
      lines};
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    const Cloud cloud = cloud_of(inputs[i]);
    const Noise_levels noise = noise_at_places(cloud);
    for (const Noise& here : noise.of_range)
      EXPECT_EQ(here.radius_of_columns, 0.) << i;
  }
}

TEST(Noise_levels, count_for_balls_that_hold_several_columns)
{
  Noise_levels noise{{{1., 2., 6.}, {1., 2., 12.}, {1., 2.}, {4., 4., 12.}}, 4};
  noise.widen_to_columns();
  EXPECT_EQ(noise.at(0).level, 1.5);
  EXPECT_EQ(noise.at(0).independent_level, 2.);
  EXPECT_EQ(noise.at(1).level, 3.);
  EXPECT_EQ(noise.at(1).independent_level, 3.);
  EXPECT_EQ(noise.at(2).level, 1.);
  EXPECT_EQ(noise.at(3).level, 4.);
}

TEST(Noise_levels, keep_columns_when_they_are_made_uniform)
{
  Noise_levels noise{{{1., 1., 6.}, {2., 2.}, {4., 4., 12.}}, 3};
  noise.make_uniform();
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_EQ(noise.at(i).level, 2.);
    EXPECT_EQ(noise.at(i).independent_level, 2.);
  }
  EXPECT_EQ(noise.at(0).radius_of_columns, 6.);
  EXPECT_EQ(noise.at(2).radius_of_columns, 12.);
}

TEST(Noise_levels, have_ranges_of_points)
{
  const Noise_levels noise{{{1., 1.}, {3., 3.}, {2., 2.}}, 7};
  const std::vector<std::size_t> begins{0, 3, 5, 7};
  for (std::size_t range = 0; range < 3; ++range)
  {
    EXPECT_EQ(noise.first_point[range], begins[range]);
    for (std::size_t i = begins[range]; i < begins[range + 1]; ++i)
      EXPECT_EQ(noise.at(i).level, noise.of_range[range].level);
  }
  EXPECT_EQ(noise.median(), 2.);
}

TEST(Noise_levels, are_visible_above_a_bound)
{
  Noise_levels noise{{{1., 1.}, {3., 3.}}, 2};
  EXPECT_FALSE(noise.is_visible());
  noise.make_visible_above(1.);
  EXPECT_FALSE(noise.at(0).is_visible);
  EXPECT_TRUE(noise.at(1).is_visible);
  EXPECT_TRUE(noise.is_visible());
  noise.make_visible_above(1.5);
  EXPECT_FALSE(noise.is_visible());
}

TEST(Planes_of_few_points, limit_noise_where_they_are_wide_and_broad_and_in_the_surface)
{
  constexpr double none = std::numeric_limits<double>::infinity();
  constexpr Plane_of_few_points planes{7, 3.3, 0.88};
  EXPECT_EQ(planes.limit({0.88, 3.3, 6., 0.}, 0.6), 1.);
  EXPECT_EQ(planes.limit({0.88, 2.8, 6., 0.}, 0.), none);   // a volume
  EXPECT_EQ(planes.limit({0.88, 3.3, 12., 0.}, 0.), none);  // a line
  EXPECT_EQ(planes.limit({0.88, 3.3, 6., 0.}, 0.61), none); // columns
}

TEST(Planes_of_few_points, turn_from_that_of_many)
{
  // the three nearest points are on a steep plane, all together on the horizontal one
  std::vector<Point> points = {Point(0., 0., 0.), Point(0., 0.1, 0.), Point(0.03, 0., 0.04)};
  for (int i = 0; i < 8; ++i)
    points.emplace_back(std::cos(CGAL_PI / 4. * i), std::sin(CGAL_PI / 4. * i), 0.);
  const Neighbor_search search(points, Tag());
  EXPECT_NEAR(tilt_of_plane(search, points[0], 3, points.size()), 0.8, 0.01);
  EXPECT_NEAR(tilt_of_plane(search, points[0], points.size(), points.size()), 0., 1e-7);
}

// Planes that turn along the noise take no more of it than the limit allows for: here, quadrics are
// reliable and tell all of it. Planes of two columns of points stand on the surface and show none
// of it.
TEST(Planes_of_few_points, take_nothing_from_the_noise_of_planes_and_of_columns)
{
  const auto with_and_without_limit = [](const std::vector<Point>& points) {
    const Cloud cloud = cloud_of(points);
    Adaptive_settings settings;
    settings.limit_noise_by_planes = false;
    const double without = noise_at_places(cloud, settings).median();
    return std::make_pair(noise_at_places(cloud).median(), without);
  };
  for (double sigma_in_spacings : {0.1, 0.2, 0.3, 0.4, 0.6, 1., 2., 4.})
  {
    const auto [level, without] = with_and_without_limit(
        with_noise(surfaces::square(40000, 8), 0.005 * sigma_in_spacings, 10));
    EXPECT_GT(level, 0.92 * without) << sigma_in_spacings;
    const auto [of_columns, of_columns_without] =
        with_and_without_limit(frames_of_a_scanner_at_rest(60, 10, sigma_in_spacings, 44));
    EXPECT_GT(of_columns, 0.92 * of_columns_without) << sigma_in_spacings;
  }
}

TEST(Noise_level, of_a_plate_as_thin_as_its_points_are_apart_is_not_its_thickness)
{
  // With 1.6 spacings, 17 neighbors are on both sides: the level was 1.48 times the noise.
  std::vector<Point> plate = thin_plate(1.6);
  const double sigma = 0.1 * plate.back().z();
  EXPECT_NEAR(noise_of(with_noise(std::move(plate), sigma, 10)) / sigma, 1., 0.2);
  // In one that bends, without noise, 7 are as well, but 5 are not: it was 0.14 of the thickness.
  plate = thin_plate(1.);
  const double thickness = plate.back().z();
  const auto bent = [](const Point& p) {
    return p + Vector(0., 0., 0.02 * std::sin(30. * p.x()) * std::sin(30. * p.y()));
  };
  EXPECT_LT(noise_of(each(std::move(plate), bent)), 0.07 * thickness);
}

TEST(Noise_level, of_a_clean_plate_as_thin_as_its_points_are_apart_is_none)
{
  // 17 neighbors are on both sides, and look like a layer of noise; 7 are on one
  for (double level : noise_of_points(cloud_of(thin_plate(1.6))))
    EXPECT_LT(level, 1e-9);
}

} // namespace
