// Neighborhoods and what is fitted to them

#include "inputs.h"

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Local_surface.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Neighborhood.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Surface_border.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/fit_local_surface.h>
#include <CGAL/Curvature_aware_simplification_3/internal/fitting/lines_of_scan.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/Surface_sample.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/median.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <set>
#include <vector>

namespace {

using namespace inputs;

TEST(Local_surface, moves_to_its_foot_point)
{
  // the paraboloid z = 1 + a^2 + b^2 / 2 seen from the origin, whose nearest point is the vertex
  Local_surface surface;
  surface.c[0] = 1.;
  surface.c[3] = 1.;
  surface.c[5] = 0.5;
  surface.move_to_foot_point();
  EXPECT_EQ(surface.origin, Point(0., 0., 1.));
  EXPECT_NEAR(surface.n.z(), 1., 1e-15);
  // the frame may be turned, the surface is the same
  const double x = 0.3, y = -0.2;
  const Vector d = Point(x, y, 1. + x * x + y * y / 2.) - surface.origin;
  EXPECT_NEAR(surface.residual(d), 0., 1e-15);

  // the plane z = 1 + x / 2: its point nearest to the origin is (-0.4, 0, 0.8)
  Local_surface plane;
  plane.c[0] = 1.;
  plane.c[1] = 0.5;
  plane.move_to_foot_point();
  EXPECT_NEAR(plane.origin.x(), -0.4, 1e-15);
  EXPECT_NEAR(plane.origin.y(), 0., 1e-15);
  EXPECT_NEAR(plane.origin.z(), 0.8, 1e-15);
  EXPECT_NEAR(plane.n.x() / plane.n.z(), -0.5, 1e-15);
}

TEST(Neighborhood, has_the_direction_of_its_line)
{
  Neighborhood neighborhood;
  for (int i = -3; i <= 3; ++i) // along (1, 2, 2), and next to it
    neighborhood.neighbors.push_back({Vector(i, 2. * i, 2. * i + 0.01 * (i % 2)), 1., 1.});
  const Vector line = line_direction(neighborhood);
  EXPECT_NEAR(std::abs(line * Vector(1., 2., 2.)) / 3., 1., 1e-5);
  EXPECT_NEAR(line * plane_normal(neighborhood), 0., 1e-9);
}

TEST(Fit, of_a_quadric_is_exact)
{
  const auto f = [](double x, double y) {
    return 0.1 + 0.2 * x - 0.1 * y + 0.5 * x * x - 0.3 * x * y + 0.7 * y * y;
  };
  const std::vector<Point> points = patch(200, 1, f);
  const Neighbor_search search(points, Tag());
  Neighborhood neighborhood;
  neighborhood.collect(search, Point(0., 0., 0.), 60);
  neighborhood.weight_by_distance();
  Local_surface surface; // over the plane z = 0
  surface.n = Vector(0., 0., 1.);
  surface.u = Vector(1., 0., 0.);
  surface.v = Vector(0., 1., 0.);
  ASSERT_TRUE(fit_quadric(neighborhood, 0., surface));
  const double expected[6] = {0.1, 0.2, -0.1, 0.5, -0.3, 0.7};
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR(surface.c[i], expected[i], 1e-3) << i; // the penalty is 1e-5 relative
}

TEST(Fit, knows_its_error)
{
  // the standard deviation of c0 over 2000 draws of the noise
  const double sigma = 0.01;
  double squares = 0., predicted = 0.;
  const unsigned int draws = 2000;
  CGAL::Random random(2);
  for (unsigned int draw = 0; draw < draws; ++draw)
  {
    std::vector<Point> points =
        patch(40, 7, [&](double, double) { return sigma * surfaces::normal_deviate(random); });
    const Neighbor_search search(points, CGAL::Sequential_tag());
    Neighborhood neighborhood;
    neighborhood.collect(search, Point(0., 0., 0.), 40);
    Local_surface surface;
    ASSERT_TRUE(fit_quadric(neighborhood, sigma, surface));
    squares += surface.c[0] * surface.c[0] / draws;
    predicted = surface.error;
    EXPECT_DOUBLE_EQ(surface.amplification, predicted / sigma);
  }
  EXPECT_NEAR(std::sqrt(squares) / predicted, 1., 0.08); // 5 / sqrt(2 draws)
}

TEST(Fit, of_a_local_surface_ignores_an_outlier)
{
  std::vector<Point> points = patch(400, 3, [](double x, double y) { return x * x - y * y; });
  points.emplace_back(0.01, 0., 0.08);
  const Neighbor_search search(points, Tag());
  const Surface_fit fit{search};
  Neighborhood neighborhood;
  for (int rounds : {rounds_to_move, rounds_to_stay})
  {
    const Local_surface surface = fit_local_surface(fit, Point(0., 0., 0.02), CGAL::NULL_VECTOR,
                                                    Local_surface(), rounds, neighborhood);
    EXPECT_LT(std::abs(surface.origin.z()), 1e-3) << rounds;
    EXPECT_GT(std::abs(surface.n.z()), 0.999) << rounds;
  }
}

TEST(Fit, is_reweighted_again_only_with_noise)
{
  // no quadric, so that weights make a difference
  std::vector<Point> points;
  for (int i = -20; i <= 20; ++i)
    for (int j = -20; j <= 20; ++j)
    {
      const double x = 0.05 * i, y = 0.05 * j;
      points.emplace_back(x, y, x * x + y * y + x * x * x);
    }
  const auto height = [](const std::vector<Point>& p, bool is_visible, int rounds) {
    const Neighbor_search search(p, Tag());
    Noise noise;
    noise.is_visible = is_visible;
    Neighborhood neighborhood;
    return fit_local_surface(Surface_fit{search, noise}, Point(0., 0., 0.), CGAL::NULL_VECTOR,
                             Local_surface(), rounds, neighborhood)
        .origin.z();
  };
  EXPECT_EQ(height(points, false, rounds_to_stay), height(points, false, rounds_to_move));
  EXPECT_NE(height(points, true, rounds_to_stay), height(points, true, rounds_to_move));
}

// Lines of a scan, ten times as far apart as the points on them: the 19 nearest of a place between
// two lines are on these two, and tell nothing of the curvature across.
TEST(Fit, between_two_lines_of_a_scan_takes_more_of_them)
{
  const double sigma = 0.01;
  double squares_of_19 = 0., squares = 0.;
  const unsigned int draws = 200;
  CGAL::Random random(5);
  for (unsigned int draw = 0; draw < draws; ++draw)
  {
    std::vector<Point> points;
    for (double y : {-2.5, -1.5, -0.5, 0.5, 1.5, 2.5})
      for (int i = -30; i <= 30; ++i)
      {
        const double x = 0.1 * (i + random.get_double());
        points.emplace_back(x, y, sigma * surfaces::normal_deviate(random));
      }
    const Neighbor_search search(points, CGAL::Sequential_tag());
    Noise noise{sigma, sigma};
    const auto fitted = [&](double visible_error) {
      noise.visible_error = visible_error;
      Neighborhood neighborhood;
      return fit_local_surface(Surface_fit{search, noise}, Point(0., 0.1, 0.), Vector(0., 0., 1.),
                               Local_surface(), rounds_to_move, neighborhood);
    };
    const Local_surface of_19 = fitted(100. * sigma), surface = fitted(sigma);
    EXPECT_EQ(of_19.neighbors, 19U);
    EXPECT_GE(surface.neighbors, 37U);
    EXPECT_LE(surface.amplification, 1.);
    squares_of_19 += of_19.origin.z() * of_19.origin.z() / draws;
    squares += surface.origin.z() * surface.origin.z() / draws;
  }
  EXPECT_LT(std::sqrt(squares), sigma);
  EXPECT_GT(std::sqrt(squares_of_19), 1.3 * std::sqrt(squares));
}

// of a cylinder around the z axis
std::vector<Point> rings(int number, double distance, int points_on_ring)
{
  std::vector<Point> points;
  for (int ring = 0; ring < number; ++ring)
    for (int i = 0; i < points_on_ring; ++i)
    {
      const double angle = 2. * CGAL_PI / points_on_ring * i;
      points.emplace_back(std::cos(angle), std::sin(angle), distance * ring);
    }
  return points;
}

// Ten times as far apart as the points on them: the 19 nearest of a point are on its ring, and in
// the plane of that.
TEST(Fit, on_one_line_of_a_scan_takes_more_of_them)
{
  const std::vector<Point> points = rings(12, 0.1, 600);
  const Neighbor_search search(points, Tag());
  Neighborhood neighborhood;
  for (const Vector& guess : {Vector(0., 0., 0.), Vector(1., 0., 0.), Vector(0., 0., 1.)})
    for (double z : {0.5, 0.52}) // on a ring, and beside it
    {
      const Local_surface surface =
          fit_local_surface(Surface_fit{search}, Point(1., 0., z), guess, Local_surface(),
                            rounds_to_move, neighborhood);
      EXPECT_TRUE(surface.neighbors >= 37U || z != 0.5) << guess;
      EXPECT_FALSE(surface.is_curve);
      EXPECT_GT(std::abs(surface.n.x()), 0.9999) << z << ' ' << guess;
      EXPECT_NEAR(surface.origin.x(), 1., 1e-4) << z << ' ' << guess;
    }
}

// A ring may bend before the ball reaches the next, which then has little weight. Up to 19 times as
// far apart as their points, rings are lines of a scan; beyond, each is a curve.
TEST(Fit, on_one_line_that_bends_takes_more_points_if_lines_are_near)
{
  Neighborhood neighborhood;
  for (int points_on_ring : {500, 2000}) // 17 and 67 times as far apart
  {
    const std::vector<Point> points = rings(20, 0.21, points_on_ring);
    const Neighbor_search search(points, Tag());
    for (const Vector& guess : {Vector(0., 0., 0.), Vector(1., 0., 0.), Vector(0., 0., 1.)})
    {
      const Local_surface surface =
          fit_local_surface(Surface_fit{search}, Point(1., 0., 2.1), guess, Local_surface(),
                            rounds_to_move, neighborhood);
      EXPECT_EQ(surface.is_curve, points_on_ring == 2000) << guess;
      EXPECT_TRUE(std::abs(surface.n.x()) > 0.9999 || surface.is_curve) << guess;
      EXPECT_LT(std::sqrt(CGAL::squared_distance(surface.origin, Point(1., 0., 2.1))), 1e-4);
    }
  }
}

// n points around the origin, and the surface that is the plane z = 0
Local_surface collect_in_plane(const std::vector<Point>& points, Neighborhood& neighborhood)
{
  neighborhood.collect(Neighbor_search(points, Tag()), Point(0., 0., 0.), points.size());
  neighborhood.weight_by_distance();
  Local_surface surface;
  surface.complete_frame();
  EXPECT_TRUE(fit_plane(neighborhood, surface));
  return surface;
}

TEST(Line, that_bends_is_one)
{
  Neighborhood neighborhood;
  std::vector<Point> parabola, third_of_circle, three_lines;
  for (int i = -40; i <= 40; ++i)
  {
    const double x = i / 40.;
    parabola.emplace_back(x, 0.5 * x * x, 0.);
    third_of_circle.emplace_back(std::sin(x), std::cos(x) - 1., 0.);
    for (double y : {-0.5, 0., 0.5})
      three_lines.emplace_back(x, y, 0.);
  }
  Local_surface surface = collect_in_plane(parabola, neighborhood);
  EXPECT_GT(surface.width, 0.1 * surface.length);
  EXPECT_NEAR(width_across_parabola(neighborhood, surface), 0., 1e-7);
  EXPECT_TRUE(is_on_bent_line(neighborhood, surface));
  surface = collect_in_plane(third_of_circle, neighborhood);
  EXPECT_TRUE(is_on_bent_line(neighborhood, surface));
  // no line, and no parabola fits it
  surface = collect_in_plane(three_lines, neighborhood);
  EXPECT_NEAR(width_across_parabola(neighborhood, surface), surface.width, 1e-7);
  EXPECT_FALSE(is_on_bent_line(neighborhood, surface));
  std::vector<Point> disk = patch(500, 3, [](double, double) { return 0.; });
  disk.erase(std::remove_if(disk.begin(), disk.end(),
                            [](const Point& p) { return std::hypot(p.x(), p.y()) > 0.5; }),
             disk.end());
  surface = collect_in_plane(disk, neighborhood);
  EXPECT_FALSE(is_on_bent_line(neighborhood, surface));
}

// A wire: no neighborhood is broad, and the narrowest is next to the point. Also where the most
// that are asked for are half of a circle.
TEST(Fit, to_a_curve_takes_as_few_points_as_elsewhere)
{
  for (int number : {500, 3000})
  {
    const std::vector<Point> points = rings(1, 0., number);
    const Neighbor_search search(points, Tag());
    const Surface_fit fit{search};
    Neighborhood neighborhood;
    Local_surface surface;
    for (int times = 0; times < 2; ++times)
    {
      surface = fit_local_surface(fit, points[7], CGAL::NULL_VECTOR, surface, rounds_to_move,
                                  neighborhood);
      EXPECT_TRUE(surface.is_curve) << number;
      EXPECT_EQ(surface.neighbors, smallest_neighborhood);
      EXPECT_EQ(neighborhood.size(), smallest_neighborhood);
    }
  }
}

// Also where the first fit is given up: next to gaps
TEST(Fit, starts_from_the_point_and_the_normal_it_is_given)
{
  CGAL::Random random(7);
  std::vector<Point> points; // sparse lines, with noise
  for (int line = 0; line < 40; ++line)
    for (int i = 0; i < 200; ++i)
    {
      const double x = 0.005 * (i + random.get_double());
      points.emplace_back(x, 0.05 * line, 0.02 * surfaces::normal_deviate(random));
    }
  const Neighbor_search search(points, CGAL::Sequential_tag());
  const Surface_fit fit{search, Noise(), Adaptive_settings()};
  for (const Point& p : points)
  {
    Surface_sample own, given;
    own.place(fit, p, CGAL::NULL_VECTOR, rounds_to_move);
    own.point = own.point + Vector(0., 0.02, 0.);
    given = own;
    own.place(fit, own.point, own.normal(), rounds_to_stay);
    const Point x = given.point;
    const Vector normal = given.normal();
    given.place(fit, x, normal, rounds_to_stay);
    EXPECT_EQ(own.point, given.point);
  }
}

// A strip of 40 rows of three points along y, as a scanner sees of a pole: beside it, the height is
// known more than four times less well than that of a point.
TEST(Surface_sample, does_not_stay_beside_sparse_exact_points)
{
  std::vector<Point> points;
  for (int row = 0; row < 40; ++row)
    for (int i = -1; i <= 1; ++i)
      points.emplace_back(0.2 * i, 0.3 * row, -0.05 * i * i);
  const Neighbor_search search(points, Tag());
  const Point beside(0.6, 6., -0.45);
  const auto distance_beside = [&](double sparse_inverse_density) {
    Surface_sample x;
    x.spacing = 1.;
    x.place({search, no_noise, default_settings, sparse_inverse_density}, beside,
            Vector(0., 0., 1.), rounds_to_move);
    return x.point.x();
  };
  // 1 / rho of the fit, its squared radius over 19, is between these
  EXPECT_LT(distance_beside(0.05), 0.25);
  EXPECT_GT(distance_beside(0.1), 0.29);
}

// Noise makes the ball of a fit wide, and one over a gap between two feet has points on all sides.
TEST(Surface_sample, does_not_stay_in_a_gap_between_noisy_points)
{
  const double sigma = 0.02, half_gap = 3. * sigma;
  CGAL::Random random(8);
  std::vector<Point> points =
      patch(40000, 9, [&](double, double) { return sigma * surfaces::normal_deviate(random); });
  points.erase(std::remove_if(points.begin(), points.end(),
                              [&](const Point& p) { return std::abs(p.x()) < half_gap; }),
               points.end());
  const Neighbor_search search(points, Tag());
  const Surface_fit fit{search, Noise{sigma, sigma, 0., true, 0.}};
  for (double y : {-0.2, 0., 0.2})
    for (double x : {-0.01, 0., 0.01})
    {
      Surface_sample sample;
      sample.place(fit, Point(x, y, 0.), Vector(0., 0., 1.), rounds_to_move);
      EXPECT_GT(std::abs(sample.point.x()), half_gap - sigma) << x << ' ' << y;
    }
}

TEST(Fit, of_a_local_surface_separates_two_sheets)
{
  // 0.035 apart, while 18 neighbors of one sheet have a radius of 0.038
  const double gap = 0.035;
  std::vector<Point> points = patch(4000, 4, [](double, double) { return 0.; });
  const std::vector<Point> other = patch(4000, 5, [=](double, double) { return gap; });
  points.insert(points.end(), other.begin(), other.end());
  const Neighbor_search search(points, Tag());
  const Surface_fit fit{search};
  Neighborhood neighborhood;
  for (std::size_t i = 0; i < points.size(); i += 97)
  {
    const Local_surface surface = fit_local_surface(fit, points[i], CGAL::NULL_VECTOR,
                                                    Local_surface(), rounds_to_stay, neighborhood);
    EXPECT_NEAR(surface.origin.z(), i < 4000 ? 0. : gap, 1e-3) << i;
  }
}

TEST(Fit, that_leaves_its_ball_is_none)
{
  // all neighbors on one side, on a parabola that is 5.6 high over the center
  Neighborhood neighborhood;
  CGAL::Random random(97);
  for (int i = 0; i < 20; ++i)
  {
    const double x = random.uniform_real(0.5, 1.), y = random.uniform_real(-0.3, 0.3);
    const Vector position(x, y, 10. * (x - 0.75) * (x - 0.75));
    neighborhood.neighbors.push_back({position, position.squared_length(), 1.});
  }
  neighborhood.radius = 1.2;
  Local_surface surface;
  const std::vector<Point> points = {Point(0., 0., 0.)};
  const Neighbor_search search(points, Tag());
  const Surface_fit fit{search};
  EXPECT_TRUE(fit_quadric(neighborhood, 0., surface));
  EXPECT_GT(surface.c[0], 2. * neighborhood.radius);
  Local_surface unchanged;
  EXPECT_FALSE(fit_trusted_quadric(fit, neighborhood, unchanged));
  EXPECT_EQ(unchanged.c[0], 0.);
}

// In a disk, the mean square of the distances to the center is R^2 / 2, and of the nearest third of
// the points a third of that.
TEST(Neighborhood, is_thinned_evenly)
{
  const std::vector<Point> points = patch(20000, 11, [](double, double) { return 0.; });
  const Neighbor_search search(points, Tag());
  Neighborhood neighborhood;
  neighborhood.collect_within(search, Point(0., 0., 0.), 0.4);
  const std::size_t all = neighborhood.size();
  neighborhood.thin(all);
  EXPECT_EQ(neighborhood.size(), all);
  neighborhood.thin(all / 3);
  EXPECT_LE(neighborhood.size(), all / 3);
  EXPECT_GE(neighborhood.size(), all / 4);
  double sum = 0.;
  for (const Neighborhood::Neighbor& neighbor : neighborhood.neighbors)
    sum += neighbor.squared_distance;
  EXPECT_NEAR(sum / static_cast<double>(neighborhood.size()), 0.08, 0.004);
}

TEST(Neighborhood, in_a_ball_agrees_with_brute_force)
{
  const std::vector<Point> points = patch(500, 11, [](double x, double y) { return x * y; });
  const Neighbor_search search(points, Tag());
  Neighborhood wide, narrow;
  wide.collect_within(search, Point(0.1, 0., 0.), 0.3);
  const Point center(0.12, 0.03, 0.01);
  narrow.take_within(wide, center, 0.2);
  EXPECT_EQ(narrow.radius, 0.2);
  std::vector<Point> expected, found;
  for (const Point& p : points)
    if (CGAL::squared_distance(p, center) <= 0.2 * 0.2)
      expected.push_back(p);
  for (const Neighborhood::Neighbor& neighbor : narrow.neighbors)
  {
    found.push_back(center + neighbor.position);
    EXPECT_NEAR(neighbor.squared_distance, neighbor.position.squared_length(), 1e-15);
  }
  ASSERT_EQ(found.size(), expected.size());
  std::sort(expected.begin(), expected.end());
  std::sort(found.begin(), found.end());
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_LT(CGAL::squared_distance(found[i], expected[i]), 1e-28);
}

// The midpoint of two neighboring numbers is one of them: a split there leaves one side empty, and
// would be made again and again.
TEST(Neighborhood, is_found_where_no_number_is_between_the_coordinates)
{
  std::vector<Point> points;
  for (int i = 0; i < 100; ++i)
    points.emplace_back(i % 2 == 0 ? 0.5 : std::nextafter(0.5, 1.), 1e-19 * i, 0.);
  const Neighbor_search search(points, Tag());
  std::set<std::size_t> found;
  search.for_each_nearest(Point(0.5, 0., 0.), 10,
                          [&](std::size_t i, const Point&, double) { found.insert(i); });
  EXPECT_EQ(found, (std::set<std::size_t>{0, 2, 4, 6, 8, 10, 12, 14, 16, 18}));
}

TEST(Median, is_what_sorting_finds)
{
  std::mt19937 generator(31);
  // one digit: most values occur more than once
  std::uniform_int_distribution<int> digit(0, 9);
  for (std::size_t n = 1; n <= 70; ++n) // counted up to 32, selected beyond
    for (int round = 0; round < 20; ++round)
    {
      std::vector<double> values(n);
      for (double& value : values)
        value = digit(generator);
      std::vector<double> sorted = values;
      std::sort(sorted.begin(), sorted.end());
      EXPECT_EQ(median(values), sorted[n / 2]) << n;
    }
}

TEST(Border, of_a_half_plane_and_of_none)
{
  const std::vector<Point> points = surfaces::square(20000, 6);
  const Neighbor_search search(points, Tag());
  const Surface_fit fit{search};
  Neighborhood neighborhood;
  int found_at_border = 0, found_inside = 0;
  for (int i = 1; i < 100; ++i)
  {
    const double t = 0.01 * i;
    const Local_surface at_border = fit_local_surface(
        fit, Point(0.001, t, 0.), CGAL::NULL_VECTOR, Local_surface(), rounds_to_stay, neighborhood);
    const Surface_border border = find_border(neighborhood, at_border);
    found_at_border += border.exists ? 1 : 0;
    if (border.exists)
    {
      // outwards, and not farther than the last neighbor and the mean distance of neighbors from
      // there
      EXPECT_LT((border.x * at_border.u + border.y * at_border.v).x(), 0.) << t;
      EXPECT_LT(border.limit, 0.02) << t;          // of a neighborhood with a radius of 0.017
      double a = 1. * border.x, b = 1. * border.y; // far out
      border.move_back(a, b);
      EXPECT_NEAR(a * border.x + b * border.y, border.limit, 1e-12);
      double c = -0.01 * border.x, d = -0.01 * border.y; // inside
      border.move_back(c, d);
      EXPECT_EQ(c, -0.01 * border.x);
    }

    const Local_surface inside =
        fit_local_surface(fit, Point(0.5, 0.1 + 0.8 * t, 0.), CGAL::NULL_VECTOR, Local_surface(),
                          rounds_to_stay, neighborhood);
    found_inside += find_border(neighborhood, inside).exists ? 1 : 0;
  }
  EXPECT_GT(found_at_border, 80);
  EXPECT_LT(found_inside, 35); // which do no harm
}

TEST(Neighborhood, of_a_fit_is_a_ball_that_is_neither_empty_nor_too_full)
{
  const std::vector<Point> points = surfaces::square(100000, 72);
  const Neighbor_search search(points, Tag());
  for (double radius : {0.001, 0.02, 0.05, 0.2})
  {
    std::size_t number = 0;
    const Point x(0.5, 0.5, 0.);
    search.for_each_within(x, radius, [&](std::size_t, const Point&, double) { ++number; });
    const std::size_t wanted =
        (std::min)((std::max)(number, std::size_t(25)), largest_neighborhood);
    for (std::size_t expected : {std::size_t(0), number})
    {
      Neighborhood neighborhood;
      collect_neighbors(Surface_fit{search}, x, 25, radius, expected, neighborhood);
      EXPECT_EQ(neighborhood.size(), wanted) << radius << " " << expected;
    }
  }
}

} // namespace
