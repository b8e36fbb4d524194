// What the manual promises of the adaptive method, from end to end

#include "inputs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <random>
#include <vector>

namespace {

using namespace inputs;

TEST(Adaptive, lies_on_the_surface)
{
  CGAL::Curvature_aware_simplification_report report;
  const auto parameters = np::number_of_output_points(2000).simplification_report(std::ref(report));
  const std::vector<Point> output = simplified(surfaces::torus(40000, 3., 1., 23), parameters);
  // the neighborhood of 18 points has a radius of about 0.2 and a quadric misses its third order
  for (const Point& p : output)
    EXPECT_LT(surfaces::distance_to_torus(p, 3., 1.), 2e-3);
  EXPECT_LT(
      mean_distance(output, [](const Point& p) { return surfaces::distance_to_torus(p, 3., 1.); }),
      1e-4);
  EXPECT_EQ(report.number_of_outliers, 0u);
  EXPECT_LT(report.noise_level, 1e-3);
}

// Scanners measure more densely along a line than across. Samples between lines were pushed off the
// surface by a tenth to a quarter of the distance of the lines: fits had turned about one of them.
TEST(Adaptive, lies_on_a_surface_that_was_scanned_in_lines)
{
  const int lines = 60;
  const auto height = [](double x, double y) { return 0.1 * std::sin(6. * x) * std::cos(5. * y); };
  for (int points_on_a_distance : {5, 6, 8, 10, 20, 40})
    for (bool is_random : {false, true})
    {
      CGAL::Random random(49);
      std::vector<Point> points;
      const int on_line = lines * points_on_a_distance;
      for (int i = 0; i < lines; ++i)
        for (int j = 0; j < on_line; ++j)
        {
          const double x = (i + 0.5) / lines;
          const double y = is_random ? random.get_double() : (j + 0.5) / on_line;
          points.emplace_back(x, y, height(x, y));
        }
      const std::vector<Point> output =
          simplified(points, np::number_of_output_points(500).random_seed(1));
      const double mean = mean_distance(
          output, [&](const Point& p) { return std::abs(p.z() - height(p.x(), p.y())); });
      EXPECT_LT(mean, 0.004 / lines) << points_on_a_distance << ' ' << is_random;
    }
}

// Rings of a cylinder up to 67 times as far apart as the points on them: samples were off it by up
// to 0.6 of their distances.
TEST(Adaptive, lies_on_a_surface_that_was_scanned_in_lines_that_bend)
{
  for (int on_ring : {500, 1000, 2000})
  {
    std::vector<Point> points;
    for (int ring = 0; ring < 20; ++ring)
      for (int i = 0; i < on_ring; ++i)
      {
        const double angle = 2. * CGAL_PI / on_ring * i;
        points.emplace_back(std::cos(angle), std::sin(angle), 0.21 * ring);
      }
    const std::vector<Point> output =
        simplified(points, np::number_of_output_points(points.size() / 5));
    for (const Point& p : output)
      EXPECT_NEAR(std::hypot(p.x(), p.y()), 1., 1e-3) << on_ring;
  }
}

// They were in its plane, and up to six spacings of the points off it.
TEST(Adaptive, lies_on_a_curve)
{
  std::vector<Point> points;
  for (int i = 0; i < 500; ++i)
    points.emplace_back(std::cos(CGAL_PI / 250. * i), std::sin(CGAL_PI / 250. * i), 0.);
  for (const Point& p : simplified(points, np::number_of_output_points(100)))
  {
    EXPECT_NEAR(p.z(), 0., 1e-12);
    EXPECT_NEAR(std::hypot(p.x(), p.y()), 1., 1.01 * CGAL_PI / 250.); // of one spacing
  }
}

// Fits to the points of a wire were widened until they held the ground or the next wire as well,
// and samples were pushed to where there is nothing between these: a third were farther from the
// wires than their points are from each other, by up to eight times that.
TEST(Adaptive, lies_on_wires_over_a_ground)
{
  CGAL::Random random(43);
  std::vector<Point> points;
  const auto add = [&](double x, double y, double z) {
    const double dx = surfaces::normal_deviate(random), dy = surfaces::normal_deviate(random);
    points.push_back(Point(x, y, z) + 0.01 * Vector(dx, dy, surfaces::normal_deviate(random)));
  };
  const auto height = [](double x) { return 4. + 0.01 * x * x; };
  for (double x = -10.; x < 10.; x += 0.15)
    for (double y = -10.; y < 10.; y += 0.15)
      add(x, y, 0.);
  for (double x = -10.; x < 10.; x += 0.08)
    for (double y : {-4., 0., 4.})
      add(x, y, height(x));
  std::size_t on_wires = 0, off_wires = 0;
  for (const Point& p : simplified(points, np::number_of_output_points(1500)))
  {
    if (p.z() < 2.)
      continue;
    const double y = p.y() - 4. * std::round(p.y() / 4.);
    ++(std::hypot(y, p.z() - height(p.x())) < 0.04 ? on_wires : off_wires);
  }
  EXPECT_GT(on_wires, 100u);
  EXPECT_LT(off_wires, on_wires / 20);
}

// Of poles, of which a scanner sees a strip of a few points, fits beside them were no more than a
// guess: one sample in twenty was up to half the distance of samples off.
TEST(Adaptive, lies_on_poles)
{
  constexpr double radius = 0.06;
  for (unsigned int seed : {44u, 45u})
  {
    CGAL::Random random(seed);
    std::vector<Point> points;
    for (double x = -10.; x < 10.; x += 0.15)
      for (double y = -10.; y < 10.; y += 0.15)
        points.emplace_back(x, y, 0.);
    for (double x : {-6., -2., 2., 6.})
      for (double y : {-5., 5.})
        for (double z = 0.1; z < 6.; z += 0.1)
          for (int i = 0; i < 3; ++i)
          {
            const double angle = random.uniform_real(-1.2, 1.2);
            points.emplace_back(x + radius * std::cos(angle), y + radius * std::sin(angle), z);
          }
    for (Point& p : points)
    {
      const double x = surfaces::normal_deviate(random), y = surfaces::normal_deviate(random);
      p = p + 0.004 * Vector(x, y, surfaces::normal_deviate(random));
    }
    const Neighbor_search search(points, Tag());
    std::size_t on_poles = 0, off_poles = 0;
    double farthest_from_points = 0.;
    for (const Point& p : simplified(points, np::number_of_output_points(1500)))
    {
      if (p.z() < 0.5)
        continue;
      const double x = p.x() - 2. - 4. * std::round((p.x() - 2.) / 4.);
      const double y = std::abs(p.y()) - 5.;
      ++(std::abs(std::hypot(x, y) - radius) < 0.1 ? on_poles : off_poles);
      farthest_from_points =
          (std::max)(farthest_from_points, std::sqrt(squared_distance(p, search.nearest(p))));
    }
    EXPECT_GT(on_poles, 100u);
    EXPECT_LT(off_poles, on_poles / 30);
    // a third of their spacing, as near to points as they may stay; of 30 inputs 0.195, and in the
    // air, beside wide fits, 0.5
    EXPECT_LT(farthest_from_points, 0.2);
  }
}

// From where a scanner stands, it meets the ground everywhere and far posts here and there: fits
// held several of them, or a strip of one, and their samples hung in the air between and beside
// them.
TEST(Adaptive, lies_on_what_one_laser_scanner_meets)
{
  constexpr double radius = 0.1, height = 6., farthest = 25.;
  const Point scanner(0., 0., 1.7);
  CGAL::Random random(47);
  std::vector<Point> feet;
  for (int i = 0; i < 30; ++i)
  {
    const double angle = random.uniform_real(0., 2. * CGAL_PI);
    const double distance = random.uniform_real(4., 20.);
    feet.emplace_back(distance * std::cos(angle), distance * std::sin(angle), 0.);
  }
  const auto distance = [&](const Point& p) {
    double result = std::abs(p.z());
    for (const Point& foot : feet)
    {
      const double from_side = std::abs(std::hypot(p.x() - foot.x(), p.y() - foot.y()) - radius);
      result = (std::min)(result, std::hypot(from_side, (std::max)(p.z() - height, 0.)));
    }
    return result;
  };
  std::vector<Point> points;
  for (int row = 0; row < 200; ++row) // each 0.7 degrees, from 60 below the horizon
    for (int column = 0; column < 500; ++column)
    {
      const double up = -1.05 + 0.012 * row, around = 2. * CGAL_PI * column / 500.;
      const Vector ray(std::cos(up) * std::cos(around), std::cos(up) * std::sin(around),
                       std::sin(up));
      double nearest = ray.z() < 0. ? -scanner.z() / ray.z() : 2. * farthest;
      for (const Point& foot : feet)
      {
        const double a = ray.x() * ray.x() + ray.y() * ray.y();
        const double b = ray.x() * foot.x() + ray.y() * foot.y();
        const double c = foot.x() * foot.x() + foot.y() * foot.y() - radius * radius;
        const double t = (b - std::sqrt((std::max)(b * b - a * c, 0.))) / a;
        if (b * b > a * c && t > 0. && t < nearest && scanner.z() + t * ray.z() < height)
          nearest = t;
      }
      if (nearest < farthest)
        points.push_back(scanner + nearest * ray);
    }
  const std::vector<Point> output = simplified(points, np::number_of_output_points(1500));
  std::size_t off = 0;
  for (const Point& p : output)
    off += distance(p) > 0.1 ? 1 : 0;
  // Of four scans, 14 to 26 are off, 0.0035 to 0.0061 in the mean of all; 46 to 106 and 0.012 to
  // 0.027 where it was not asked how well fits to exact points are known.
  EXPECT_LT(off, 40u);
  EXPECT_LT(mean_distance(output, distance), 0.009);
}

// Of a closed curve, a fit to nearly all points is as wide as a surface: samples were up to five of
// their spacings off it. And the points next to one were taken for a column of them, which rises
// from the plane of the whole curve, and the quarter of its radius for noise: up to eight spacings.
TEST(Adaptive, lies_on_a_closed_curve)
{
  for (const auto& [size, wave] : {std::make_pair(300, 0.), std::make_pair(1000, 0.3),
                                   std::make_pair(1000, 0.), std::make_pair(4000, 0.3)})
    for (int part : {2, 4, 20})
    {
      const int count = size / part;
      std::vector<Point> points, curve;
      for (int i = 0; i < 100 * size; ++i)
      {
        const double t = 2. * CGAL_PI * i / (100. * size);
        curve.emplace_back(std::cos(t), std::sin(t), wave * std::sin(2. * t));
        if (i % 100 == 0)
          points.push_back(curve.back());
      }
      const Neighbor_search search(curve, Tag());
      const double spacing = 2. * CGAL_PI / count; // about
      CGAL::Curvature_aware_simplification_report report;
      for (const Point& p :
           simplified(points, np::number_of_output_points(static_cast<std::size_t>(count))
                                  .simplification_report(std::ref(report))))
        EXPECT_LT(std::sqrt(CGAL::squared_distance(p, search.nearest(p))), 1.5 * spacing)
            << size << ' ' << wave << ' ' << count;
      EXPECT_LT(report.noise_level, CGAL_PI / size); // half a spacing of the points
    }
}

// Depth cameras round depth to steps. These were taken for faces, and no noise was found: samples
// were off the surface by as much as the points.
TEST(Adaptive, lies_on_a_surface_whose_depth_was_rounded)
{
  for (double step : {2., 3., 5., 8.})
    for (double sigma : {0., 0.3 * step})
    {
      CGAL::Random random(65);
      const std::vector<Point> frame = depth_frame(200, step, [&](double x, double y) {
        return waves(x, y) + sigma * surfaces::normal_deviate(random);
      });
      CGAL::Curvature_aware_simplification_report report;
      const auto parameters =
          np::number_of_output_points(2000).simplification_report(std::ref(report));
      const auto error = [&](const Point& p) {
        return std::abs(p.z() - waves(p.x(), p.y())) / step;
      };
      EXPECT_LT(mean_distance(simplified(frame, parameters), error), sigma > 0. ? 0.16 : 0.08)
          << step << ' ' << sigma;
      EXPECT_NEAR(report.depth_step, step, 1e-9);
      EXPECT_GE(report.noise_level, 0.0999 * step);
      EXPECT_LT(
          mean_distance(each(simplified(each(frame, turned), parameters), turned_back), error),
          sigma > 0. ? 0.16 : 0.08);
      EXPECT_NEAR(report.depth_step, step, 1e-9);
    }
}

// The nearest points were on one line of sight, and fits along it: samples were as far off as the
// points, and the more frames, the worse.
TEST(Adaptive, removes_noise_of_a_scanner_at_rest)
{
  for (int frames : {5, 10, 20})
    for (double sigma : {0.1, 0.3})
    {
      CGAL::Curvature_aware_simplification_report report;
      const std::vector<Point> output =
          simplified(frames_of_a_scanner_at_rest(80, frames, sigma, 50),
                     np::number_of_output_points(1000).simplification_report(std::ref(report)));
      const double mean = mean_distance(
          output, [](const Point& p) { return std::abs(p.z() - waves(p.x(), p.y())); });
      EXPECT_LT(mean, 0.3 * sigma) << frames << ' ' << sigma;
      EXPECT_LT(report.noise_level, sigma); // and not what balls are measured in
    }
}

// A square with 40,000 points in frames of a scanner at rest, whose directions are in no order
std::vector<Point> frames_of_square(int frames, double sigma, unsigned int seed)
{
  CGAL::Random random(seed);
  const std::vector<Point> directions =
      surfaces::square(static_cast<std::size_t>(40000 / frames), 3);
  std::vector<Point> points;
  for (int frame = 0; frame < frames; ++frame)
    for (const Point& p : directions)
      points.push_back(p + sigma * surfaces::normal_deviate(random) * Vector(0., 0., 1.));
  return points;
}

// Directions in no order, as vertices of a mesh: columns of five points were not found, or what one
// of them told counted, and balls held too few to tell the surface. Samples were 0.3 to 1.3 sigma
// off.
TEST(Adaptive, removes_noise_of_frames_with_any_directions)
{
  for (int frames : {5, 10, 20})
    for (double sigma : {0.2, 0.45}) // of the distance of the directions
    {
      const double distance = std::sqrt(frames / 40000.);
      CGAL::Curvature_aware_simplification_report report;
      const std::vector<Point> output =
          simplified(frames_of_square(frames, sigma * distance, 1),
                     np::number_of_output_points(500).simplification_report(std::ref(report)));
      const double mean = mean_distance(output, [](const Point& p) { return std::abs(p.z()); });
      EXPECT_LT(mean, 0.25 * sigma * distance) << frames << ' ' << sigma;
      EXPECT_NEAR(report.noise_level / (sigma * distance), 0.95, 0.1) << frames << ' ' << sigma;
    }
}

// Smoothing kept fewer points than a fit needs of columns of which few were asked for, and the same
// fit was made again and again, without end.
TEST(Adaptive, ends_on_columns_of_which_few_are_asked_for)
{
  for (int frames : {20, 50, 200})
  {
    CGAL::Random random(5);
    std::vector<Point> columns;
    for (int frame = 0; frame < frames; ++frame)
      for (int i = 0; i < 64; ++i)
        columns.emplace_back(i % 8, i / 8, random.uniform_real(-0.02, 0.02));
    for (std::size_t n = 1; n <= 9; ++n)
      EXPECT_EQ(simplified(columns, np::number_of_output_points(n)).size(), n);
  }
}

// Of fewer points than a fit needs, samples were pushed far off all of them: of three on a line, by
// a distance.
TEST(Adaptive, selects_of_few_points)
{
  const std::vector<Point> sphere = surfaces::sphere(56, 3);
  const std::vector<std::vector<Point>> inputs = {
      {Point(0., 0., 0.), Point(1., 0., 0.), Point(2., 0., 0.)},
      {Point(0., 0., 0.), Point(1., 0., 0.), Point(0., 1., 0.), Point(0., 0., 1.)},
      sphere};
  for (const std::vector<Point>& points : inputs)
    for (std::size_t n = 1; n <= points.size(); ++n)
      for (const Point& p : simplified(points, np::number_of_output_points(n)))
        EXPECT_TRUE(std::any_of(points.begin(), points.end(), [&](const Point& q) {
          return CGAL::squared_distance(p, q) < 1e-28;
        })) << p;
  // whatever their order and the parameters of the paper
  const std::vector<Point> reversed(sphere.rbegin(), sphere.rend());
  for (std::uint64_t seed = 0; seed < 20; ++seed)
  {
    const auto parameters = np::number_of_output_points(9).random_seed(seed);
    const std::vector<Point> output = simplified(sphere, parameters);
    EXPECT_EQ(simplified(reversed, parameters), output);
    EXPECT_EQ(simplified(sphere, parameters.curvature_weight(0.)), output);
  }
}

TEST(Adaptive, removes_noise)
{
  const double sigma = 0.02;
  CGAL::Curvature_aware_simplification_report report;
  const std::vector<Point> output =
      simplified(with_noise(surfaces::sphere(40000, 24), sigma, 25),
                 np::number_of_output_points(2000).simplification_report(std::ref(report)));
  // noise wider than the spacing of the points hides some of itself
  EXPECT_NEAR(report.noise_level / sigma, 1., 0.25);
  // the mean of |x| is 0.8 sigma in the input
  EXPECT_LT(mean_distance(output, distance_to_sphere), 0.17 * sigma);
}

TEST(Adaptive, removes_noise_that_differs_by_place)
{
  // from 0.002 at the lower pole to 0.038 at the upper one, 0.02 on average
  const auto sigma_at = [](const Point& p) { return 0.02 + 0.018 * p.z(); };
  std::vector<Point> points = surfaces::sphere(40000, 24);
  CGAL::Random random(25);
  for (Point& p : points)
    p = p + sigma_at(p) * surfaces::normal_deviate(random) * (p - CGAL::ORIGIN);
  const auto mean_in_sigma = [&](bool noise_by_place) {
    Adaptive_settings settings;
    settings.noise_by_place = noise_by_place;
    std::vector<Point> output;
    simplify_point_set<Tag>(points, std::back_inserter(output), np::number_of_output_points(2000),
                            settings);
    return mean_distance(output,
                         [&](const Point& p) { return distance_to_sphere(p) / sigma_at(p); });
  };
  const double by_place = mean_in_sigma(true);
  EXPECT_LT(by_place, 0.22);
  EXPECT_GT(mean_in_sigma(false), 1.25 * by_place);
}

TEST(Adaptive, ignores_outliers)
{
  std::vector<Point> points = with_noise(surfaces::sphere(20000, 26), 0.001, 27);
  add_outliers(points, 2000, 1.2, 28);
  CGAL::Curvature_aware_simplification_report report;
  const std::vector<Point> output =
      simplified(points, np::number_of_output_points(2000).simplification_report(std::ref(report)));
  ASSERT_EQ(output.size(), 2000u);
  EXPECT_NEAR(static_cast<double>(report.number_of_outliers), 2000., 300.);
  for (const Point& p : output)
    EXPECT_LT(distance_to_sphere(p), 0.06); // outliers nearer than the spacing are no outliers
  EXPECT_LT(mean_distance(output, distance_to_sphere), 1e-3);
}

TEST(Adaptive, is_dense_where_the_surface_bends)
{
  const double c = 3.;
  const std::vector<Point> points = surfaces::ellipsoid(40000, c, 29);
  const auto share_at_tips = [&](const std::vector<Point>& set) {
    return static_cast<double>(std::count_if(
               set.begin(), set.end(), [=](const Point& p) { return std::abs(p.z()) > 0.9 * c; })) /
           static_cast<double>(set.size());
  };
  const double uniform = share_at_tips(points);
  EXPECT_NEAR(share_at_tips(simplified(points, np::adaptivity(0.))) / uniform, 1., 0.1);
  EXPECT_GT(share_at_tips(simplified(points)) / uniform, 1.3);
  EXPECT_GT(share_at_tips(simplified(points, np::adaptivity(1.))),
            share_at_tips(simplified(points)));
}

TEST(Adaptive, spreads_evenly_whatever_the_density_of_the_input)
{
  // density 10 : 1 from pole to pole; the output of a sphere has the same density everywhere
  std::vector<Point> points;
  CGAL::Random random(30);
  for (const Point& p : surfaces::sphere(100000, 30))
    if (random.uniform_real(0., 1.) < std::pow(10., -(p.z() + 1.) / 2.))
      points.push_back(p);
  const std::vector<Point> output = simplified(points, np::number_of_output_points(2000));
  const double north = static_cast<double>(
      std::count_if(output.begin(), output.end(), [](const Point& p) { return p.z() > 0.; }));
  EXPECT_NEAR(north / 2000., 0.5, 0.05);
  double largest_gap = 0.;
  const Neighbor_search search(output, Tag());
  for (const Point& p : surfaces::sphere(20000, 31))
    search.for_each_nearest(p, 1, [&](std::size_t, const Point&, double squared_distance) {
      largest_gap = std::max(largest_gap, std::sqrt(squared_distance));
    });
  // the spacing of a hexagonal lattice, whose gaps are 0.58 of it
  EXPECT_LT(largest_gap, 1.3 * std::sqrt(4. * CGAL_PI / 2000. * 2. / std::sqrt(3.)));
}

TEST(Adaptive, spreads_evenly_on_a_noisy_plane)
{
  const double spacing = std::sqrt(2. / std::sqrt(3.) / 2000.);
  for (double sigma : {0., 0.001, 0.003, 0.01}) // up to 0.4 spacings of the output
  {
    const std::vector<Point> output = simplified(with_noise(surfaces::square(40000, 21), sigma, 22),
                                                 np::number_of_output_points(2000));
    const Neighbor_search search(output, Tag());
    std::vector<double> distances; // to the six neighbors in a lattice, away from the border
    for (const Point& p : output)
      if (std::min({p.x(), p.y(), 1. - p.x(), 1. - p.y()}) > 3. * spacing)
      {
        double sum = 0.;
        search.for_each_nearest(p, 7, [&](std::size_t, const Point&, double squared_distance) {
          sum += std::sqrt(squared_distance);
        });
        distances.push_back(sum / 6.);
      }
    std::sort(distances.begin(), distances.end());
    const double low = distances[distances.size() / 20],
                 high = distances[distances.size() * 19 / 20];
    EXPECT_LT(high / low, 1.4) << sigma; // 1.6 if chance decides where the plane is bent
  }
}

TEST(Adaptive, places_no_sample_in_a_gap)
{
  // where a sample goes from near the middle of a hole with this radius, in a plane of points 0.1
  // apart
  const auto place = [](double hole) {
    std::vector<Point> points;
    for (int i = -30; i <= 30; ++i)
      for (int j = -30; j <= 30; ++j)
        if (i * i + j * j > 100. * hole * hole)
          points.emplace_back(0.1 * i, 0.1 * j, 0.);
    const Neighbor_search search(points, Tag());
    const Surface_fit fit{search};
    Surface_sample sample;
    sample.place(fit, Point(0.02, 0.01, 0.001), Vector(0., 0., 1.), rounds_to_move);
    EXPECT_NEAR(sample.point.z(), 0., 1e-12);
    return std::hypot(sample.point.x(), sample.point.y());
  };
  EXPECT_NEAR(place(0.05), 0.022, 0.002); // one point is missing
  EXPECT_NEAR(place(0.12), 0.022, 0.002); // five points are
  // 21 are: the ball around the sample is empty in the middle, and the density in it looks low
  EXPECT_NEAR(place(0.25), 0.3, 0.03);
  EXPECT_NEAR(place(0.52), 0.54, 0.03); // to the point (0.5, 0.2) of the rim
}

// Strips as wide as the gaps between them, 7 spacings of the points and 1.5 of the samples: these
// were pushed into the gaps, where the low density hid that there is none. Of the clean ones, 20
// were more than half a spacing off, of the noisy ones 94.
TEST(Adaptive, leaves_samples_on_strips_with_gaps_between_them)
{
  const double width = 0.05;
  for (double sigma : {0., 0.003})
  {
    CGAL::Random random(99);
    std::vector<Point> points;
    for (int i = 0; i < 40000; ++i)
    {
      const auto noise = [&] { return sigma * surfaces::normal_deviate(random); };
      const double x = 2. * width * (i % 20) + random.uniform_real(0., width);
      const double y = random.uniform_real(0., 2.);
      points.emplace_back(x + noise(), y + noise(), noise());
    }
    CGAL::Curvature_aware_simplification_report report;
    const std::vector<Point> output = simplified(
        points, np::number_of_output_points(2000).simplification_report(std::ref(report)));
    const auto is_off = [&](const Point& p) {
      const double x = p.x() - 2. * width * std::round((p.x() - width / 2.) / (2. * width));
      const double along = (std::max)({-x, x - width, 0.});
      return std::hypot(along, p.z()) > 0.5 * report.output_spacing;
    };
    EXPECT_LE(std::count_if(output.begin(), output.end(), is_off), sigma > 0. ? 15 : 1) << sigma;
  }
}

TEST(Adaptive, leaves_no_sample_far_from_a_sparse_comb)
{
  // Plates and walls, 1/20 apart, sampled ten times as densely on one end as on the other, where
  // the neighbors of a point are on three of them. Without the limit on quadrics, samples are up to
  // 32 spacings off in 7 of the first 30; without that on gaps, up to 7 spacings in 4 of 300, and
  // in 4 others when neighbors of samples were searched for more often: these, and 16.
  std::vector<unsigned int> seeds = {106, 110, 147, 179, 214, 254, 289};
  for (unsigned int seed = 1; seed <= 30; ++seed)
    seeds.push_back(seed);
  for (unsigned int seed : seeds)
  {
    CGAL::Random random(seed);
    std::vector<Point> points;
    while (points.size() < 10000)
    {
      const double x = random.uniform_real(0., 1.), y = random.uniform_real(0., 1.);
      const int i = random.get_int(0, 20);
      if (random.uniform_real(0., 1.) > std::pow(10., -x))
        continue;
      if (random.uniform_real(0., 1.) < 0.5)
        points.emplace_back(x, 0.3 * y, 0.05 * i);
      else
        points.emplace_back(x, i % 2 == 0 ? 0. : 0.3, 0.05 * (i + y));
    }
    CGAL::Curvature_aware_simplification_report report;
    const std::vector<Point> output = simplified(
        points, np::number_of_output_points(1000).simplification_report(std::ref(report)));
    const Neighbor_search search(points, Tag());
    for (const Point& p : output)
      search.for_each_nearest(p, 1, [&](std::size_t, const Point&, double squared_distance) {
        EXPECT_LT(std::sqrt(squared_distance), 1.5 * report.output_spacing) << seed;
      });
  }
}

TEST(Adaptive, keeps_the_border_of_a_square)
{
  CGAL::Curvature_aware_simplification_report report;
  const std::vector<Point> output =
      simplified(surfaces::square(100000, 32),
                 np::number_of_output_points(2000).simplification_report(std::ref(report)));
  const double spacing = std::sqrt(1. / 2000. * 2. / std::sqrt(3.));
  EXPECT_NEAR(report.output_spacing / spacing, 1., 0.03);
  const Neighbor_search search(output, Tag());
  const auto distance = [&](double x, double y) {
    double result = 0.;
    search.for_each_nearest(Point(x, y, 0.), 1,
                            [&](std::size_t, const Point&, double squared_distance) {
                              result = std::sqrt(squared_distance);
                            });
    return result;
  };
  for (double x : {0., 1.})
    for (double y : {0., 1.})
      EXPECT_LT(distance(x, y), spacing);
  // per side, the outermost points of strips of two spacings
  const int strips = static_cast<int>(0.5 / spacing);
  for (int side = 0; side < 4; ++side)
  {
    std::vector<double> outermost(static_cast<std::size_t>(strips), 1.);
    for (const Point& p : output)
    {
      const double t = side < 2 ? p.y() : p.x();
      const double d = side == 0 ? p.x() : side == 1 ? 1. - p.x() : side == 2 ? p.y() : 1. - p.y();
      double& o = outermost[static_cast<std::size_t>(
          std::min(std::max(static_cast<int>(t * strips), 0), strips - 1))];
      o = std::min(o, d);
    }
    for (double d : outermost)
      EXPECT_LT(std::abs(d), 0.5 * spacing) << side;
  }
  // and hardly beyond it: on average by less than a third of the input's spacing, 0.003
  double sum = 0., beyond = 0.;
  for (const Point& p : output)
  {
    const double d = (std::max)({-p.x(), p.x() - 1., -p.y(), p.y() - 1.});
    if (d > 0.)
    {
      sum += d;
      beyond += 1.;
    }
  }
  EXPECT_LE(sum, 0.001 * beyond);
}

TEST(Adaptive, does_not_mix_the_sides_of_a_thin_plate)
{
  // the samples of each side are 0.024 apart, its points 0.005
  const double thickness = 0.015;
  std::vector<Point> points;
  for (double z : {0., thickness})
    for (const Point& p : surfaces::square(40000, z > 0. ? 33u : 34u))
      points.emplace_back(p.x(), p.y(), z);
  int between = 0;
  for (const Point& p : simplified(points, np::number_of_output_points(4000)))
    between += std::min(std::abs(p.z()), std::abs(p.z() - thickness)) > 1e-4 ? 1 : 0;
  EXPECT_LE(between, 4);
}

TEST(Adaptive, is_on_the_sides_of_a_plate_as_thin_as_its_points_are_apart)
{
  // how many of 2000 samples are more than a tenth of the thickness away from both sides
  const auto between = [](double thickness_in_spacings, bool correct_by_points, bool outliers) {
    Adaptive_settings settings;
    settings.correct_by_points = correct_by_points;
    std::vector<Point> points = thin_plate(thickness_in_spacings);
    const double thickness = points.back().z();
    CGAL::Random random(38);
    while (outliers && points.size() < 42000)
      points.emplace_back(random.uniform_real(0., 1.), random.uniform_real(0., 1.),
                          random.uniform_real(-0.5, 0.5));
    std::vector<Point> output;
    simplify_point_set<Tag>(points, std::back_inserter(output), np::number_of_output_points(2000),
                            settings);
    return std::count_if(output.begin(), output.end(), [&](const Point& p) {
      return std::min(std::abs(p.z()), std::abs(p.z() - thickness)) > 0.1 * thickness;
    });
  };
  // 1938 if the plate is taken for noise, 57 if fits are not corrected
  EXPECT_LE(between(1.6, true, false), 45);
  EXPECT_LT(static_cast<double>(between(1.4, true, false)),
            0.7 * static_cast<double>(between(1.4, false, false)));
  // the nearest point may be an outlier: no correction
  EXPECT_EQ(between(1.4, true, true), between(1.4, false, true));
}

// Noise was taken to be 1.3 times as much, and no fit was corrected: of 2000 samples, 107 were more
// than a fifth of the thickness away from both sides.
TEST(Adaptive, is_on_the_sides_of_a_noisy_plate_as_thin_as_its_points_are_apart)
{
  std::vector<Point> plate = thin_plate(2.);
  const double thickness = plate.back().z();
  const std::vector<Point> output = simplified(with_noise(std::move(plate), 0.1 * thickness, 10),
                                               np::number_of_output_points(2000));
  EXPECT_LE(std::count_if(output.begin(), output.end(),
                          [&](const Point& p) {
                            return std::min(std::abs(p.z()), std::abs(p.z() - thickness)) >
                                   0.2 * thickness;
                          }),
            95);
}

// Half as many samples as points: a point may be the nearest one of several samples whose fits miss
// it.
TEST(Adaptive, puts_no_two_samples_on_one_point)
{
  std::vector<Point> output =
      simplified(thin_plate(1.4), np::number_of_output_points(20000).random_seed(1));
  std::sort(output.begin(), output.end());
  EXPECT_EQ(std::adjacent_find(output.begin(), output.end()), output.end());
}

TEST(Adaptive, does_not_mix_the_sides_of_a_noisy_plate)
{
  // Sheets 9 standard deviations apart. Of points 3 or more off, a fit sees no layer; the samples
  // that start there were lost between the sheets, 21 of the 4000.
  const double sigma = 0.004, thickness = 9. * sigma;
  CGAL::Random random(35);
  std::vector<Point> points;
  for (double z : {0., thickness})
    for (const Point& p : surfaces::square(20000, z > 0. ? 36u : 37u))
      points.emplace_back(p.x(), p.y(), z + sigma * surfaces::normal_deviate(random));
  int between = 0;
  double distances = 0., inner = 0.;
  for (const Point& p : simplified(points, np::number_of_output_points(4000)))
    if (std::min({p.x(), p.y(), 1. - p.x(), 1. - p.y()}) > 0.06)
    {
      between += p.z() > 2.5 * sigma && p.z() < thickness - 2.5 * sigma ? 1 : 0;
      distances += std::min(std::abs(p.z()), std::abs(p.z() - thickness));
      inner += 1.;
    }
  EXPECT_LE(between, 10);
  // 0.4 if wide fits let a bit of the other sheet in
  EXPECT_LT(distances / inner, 0.2 * sigma);
}

TEST(Adaptive, relaxation_ends_when_the_samples_rest)
{
  const std::vector<Point> points = surfaces::torus(20000, 3., 1., 46);
  const auto after = [&](unsigned int iterations) {
    return simplified(points, np::number_of_output_points(1000).number_of_iterations(iterations));
  };
  EXPECT_NE(after(50), after(51));
  EXPECT_EQ(after(400), after(800));
}

// of each point to the nearest other one
std::vector<double> distances_to_others(const std::vector<Point>& points)
{
  const Neighbor_search search(points, Tag());
  std::vector<double> result;
  for (const Point& p : points)
  {
    double largest = 0.; // of those of the point itself and of the nearest other
    search.for_each_nearest(p, 2, [&](std::size_t, const Point&, double squared_distance) {
      largest = (std::max)(largest, std::sqrt(squared_distance));
    });
    result.push_back(largest);
  }
  return result;
}

// Where most samples rest, those that still travel met others that were not among their neighbors:
// in half of all runs, samples were within 0.4 spacings of each other.
TEST(Adaptive, many_iterations_bring_no_samples_together)
{
  const double spacing = std::sqrt(2. / std::sqrt(3.) * 4. * CGAL_PI / 2000.);
  for (unsigned int seed = 0; seed < 6; ++seed)
  {
    const std::vector<Point> output = simplified(
        surfaces::sphere(20000, seed), np::number_of_output_points(2000).number_of_iterations(70));
    const std::vector<double> distances = distances_to_others(output);
    EXPECT_GT(*std::min_element(distances.begin(), distances.end()), 0.5 * spacing) << seed;
  }
}

// The fits that noisy samples are projected to lean, and brought 37 and 246 of them close to
// others. Noise that smoothed points share was taken for curvature, and 43 of the second were.
TEST(Adaptive, noise_brings_few_samples_together)
{
  const double spacing = std::sqrt(2. / std::sqrt(3.) / 2000.);
  for (const auto& [sigma, most] : {std::make_pair(0.0042, 12), std::make_pair(0.014, 36)})
  {
    std::ptrdiff_t close = 0;
    for (unsigned int seed : {1u, 2u, 3u})
    {
      const std::vector<double> distances = distances_to_others(
          simplified(with_noise(surfaces::square(20000, seed), sigma, seed + 10),
                     np::number_of_output_points(2000)));
      close += std::count_if(distances.begin(), distances.end(),
                             [&](double d) { return d < 0.4 * spacing; });
    }
    EXPECT_LE(close, most) << sigma;
  }
}

// Noise carries points apart, and frames put them on top of each other. With their density, the
// spacing was 1.4 of what it is in strong noise, 0.25 where there are 40 frames, and then 294 of
// 500 samples were close to others.
TEST(Adaptive, knows_the_spacing_of_the_samples_in_noise_and_in_frames)
{
  const double spacing = std::sqrt(2. / std::sqrt(3.) / 500.);
  for (const auto& [frames, sigma] : {std::make_pair(1, 0.003), std::make_pair(1, 0.01),
                                      std::make_pair(20, 0.003), std::make_pair(40, 0.003)})
  {
    CGAL::Curvature_aware_simplification_report report;
    const std::vector<double> distances = distances_to_others(
        simplified(frames_of_square(frames, sigma, 6),
                   np::number_of_output_points(500).simplification_report(std::ref(report))));
    EXPECT_NEAR(report.output_spacing / spacing, 1., 0.1) << frames << ' ' << sigma;
    EXPECT_LE(std::count_if(distances.begin(), distances.end(),
                            [&](double d) { return d < 0.4 * spacing; }),
              20)
        << frames << ' ' << sigma;
  }
}

// Samples that are far apart were pushed along their fits far beyond the points of these, and one of
// 200 was 17 sigma off.
TEST(Adaptive, pushes_no_noisy_sample_beyond_its_fit)
{
  const double sigma = 0.02;
  const std::vector<Point> output = simplified(
      with_noise(surfaces::torus(100000, 3., 1., 6), sigma, 7), np::number_of_output_points(200));
  const auto distance = [](const Point& p) {
    return std::abs(std::hypot(std::hypot(p.x(), p.y()) - 3., p.z()) - 1.);
  };
  EXPECT_LT(mean_distance(output, distance), 0.3 * sigma);
  for (const Point& p : output)
    EXPECT_LT(distance(p), 3. * sigma) << p;
}

TEST(Adaptive, moves_no_sample_without_iterations_or_repulsion)
{
  // With noise, the projection is followed by two more rounds.
  const std::vector<Point> points = with_noise(surfaces::square(20000, 4), 0.004, 5);
  const auto output = [&](unsigned int iterations, double weight) {
    return simplified(points, np::number_of_output_points(2000)
                                  .number_of_iterations(iterations)
                                  .repulsion_weight(weight));
  };
  const std::vector<Point> at_rest = output(0, 0.45);
  EXPECT_EQ(output(10, 0.), at_rest);
  EXPECT_NE(output(1, 0.45), at_rest);
}

TEST(Adaptive, does_not_depend_on_the_order_of_the_input)
{
  std::vector<Point> points = surfaces::torus(10000, 3., 1., 35);
  const std::vector<Point> expected = simplified(points);
  std::mt19937 random(36);
  std::shuffle(points.begin(), points.end(), random);
  EXPECT_EQ(simplified(points), expected);
}

TEST(Adaptive, is_the_same_kind_of_result_when_turned)
{
  // another curve, another start: not the same points, but as many at each place, as near
  const std::vector<Point> points = surfaces::torus(40000, 3., 1., 37);
  const std::vector<Point> output = simplified(points);
  const std::vector<Point> other = each(simplified(each(points, turned)), turned_back);
  const auto error = [](const Point& p) { return surfaces::distance_to_torus(p, 3., 1.); };
  EXPECT_NEAR(mean_distance(output, error) / mean_distance(other, error), 1., 0.2);
  const auto inner = [](const std::vector<Point>& set) {
    return static_cast<double>(std::count_if(
        set.begin(), set.end(), [](const Point& p) { return std::hypot(p.x(), p.y()) < 3.; }));
  };
  EXPECT_NEAR(inner(output) / inner(other), 1., 0.03);
}

TEST(Adaptive, each_parameter_has_an_effect)
{
  const std::vector<Point> points = surfaces::ellipsoid(5000, 3., 38);
  const std::vector<Point> standard = simplified(points);
  EXPECT_EQ(standard, simplified(points, np::adaptivity(2. / 3.)));
  EXPECT_EQ(standard, simplified(points, np::repulsion_weight(0.45)));
  EXPECT_EQ(standard, simplified(points, np::number_of_iterations(10)));
  EXPECT_EQ(standard, simplified(points, np::number_of_neighbors(16)));
  EXPECT_EQ(standard, simplified(points, np::settings_of_the_paper(false)));
  EXPECT_NE(standard, simplified(points, np::adaptivity(0.3)));
  EXPECT_NE(standard, simplified(points, np::repulsion_weight(0.3)));
  EXPECT_NE(standard, simplified(points, np::number_of_iterations(4)));
  EXPECT_NE(standard, simplified(points, np::number_of_neighbors(30)));
  EXPECT_NE(standard, simplified(points, np::random_seed(1)));
  EXPECT_NE(standard, simplified(points, np::settings_of_the_paper(true)));
  // what only the method of the paper knows
  EXPECT_EQ(standard, simplified(points, np::neighbor_radius(0.5)
                                             .curvature_weight(0.1)
                                             .curvature_dependence(1.)
                                             .require_uniform_sampling(true)
                                             .recompute_curvature(true)));
}

// The ground behind what was scanned is a hundredth of the points, and nearly all of the area.
TEST(Adaptive, sees_noise_in_front_of_far_points)
{
  std::vector<Point> points;
  CGAL::Random random(7);
  for (const Point& p : surfaces::sphere(50000, 6))
    points.push_back(CGAL::ORIGIN +
                     (1. + 0.005 * surfaces::normal_deviate(random)) * (p - CGAL::ORIGIN));
  const auto error = [&](double half_width) {
    std::vector<Point> input = points;
    for (int i = 0; i < (half_width > 0. ? 500 : 0); ++i)
    {
      const double x = random.uniform_real(-half_width, half_width);
      input.emplace_back(x, random.uniform_real(-half_width, half_width), -half_width / 2.);
    }
    CGAL::Curvature_aware_simplification_report report;
    std::vector<Point> output;
    CGAL::curvature_aware_simplify_point_set<Tag>(
        input, std::back_inserter(output),
        np::number_of_output_points(2000).simplification_report(std::ref(report)));
    EXPECT_GT(report.output_spacing, 0.08);
    EXPECT_LT(report.output_spacing, 0.1); // 0.5 to 5 if all areas counted
    double sum = 0., number = 0.;
    for (const Point& p : output)
    {
      const double distance = std::abs(std::sqrt((p - CGAL::ORIGIN).squared_length()) - 1.);
      if (distance < 0.5)
      {
        sum += distance;
        ++number;
      }
    }
    EXPECT_GT(number, 1500.);
    return sum / number;
  };
  const double alone = error(0.);
  EXPECT_LT(alone, 0.0007);
  for (double half_width : {10., 100.})
    EXPECT_LT(error(half_width), 1.3 * alone)
        << half_width; // 4 to 5 times as large without smoothing
}

TEST(Adaptive, reports_what_it_found)
{
  std::vector<Point> points = with_noise(surfaces::sphere(20000, 39), 0.01, 40);
  add_outliers(points, 500, 1.5, 41);
  for (Point& p : points)
    p = Point(1000. * p.x(), 1000. * p.y(), 1000. * p.z());
  CGAL::Curvature_aware_simplification_report report;
  simplified(points, np::number_of_output_points(1000).simplification_report(std::ref(report)));
  EXPECT_EQ(report.number_of_input_points, 20500u);
  EXPECT_EQ(report.number_of_output_points, 1000u);
  EXPECT_NEAR(report.noise_level, 10., 1.);
  EXPECT_NEAR(static_cast<double>(report.number_of_outliers), 500., 100.);
  EXPECT_NEAR(report.output_spacing / std::sqrt(4e6 * CGAL_PI / 1000. * 2. / std::sqrt(3.)), 1.,
              0.1);
  EXPECT_GT(report.outliers_time, 0.);
  EXPECT_GT(report.noise_time, 0.);
  EXPECT_GT(report.smoothing_time, 0.);
  EXPECT_GT(report.selection_time, 0.);
  EXPECT_GT(report.relaxation_time, 0.);
  EXPECT_GT(report.projection_time, 0.);
}

} // namespace
