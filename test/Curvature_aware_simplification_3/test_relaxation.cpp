// Samples that repel each other, are denoised, and are corrected by the points

#include "inputs.h"

#include <CGAL/Curvature_aware_simplification_3/internal/fitting/Neighborhood.h>
#include <CGAL/Curvature_aware_simplification_3/internal/projection/correct_by_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/projection/denoise_samples.h>
#include <CGAL/Curvature_aware_simplification_3/internal/projection/separate_copies.h>
#include <CGAL/Curvature_aware_simplification_3/internal/projection/stay_near_points.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/Sample_neighbors.h>
#include <CGAL/Curvature_aware_simplification_3/internal/samples/relax_on_surface.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace {

using namespace inputs;

TEST(Sample_neighbors, agree_with_brute_force)
{
  for (std::size_t n : {1u, 2u, 10u, 300u})
    for (std::size_t wanted : {std::size_t(3), Sample_neighbors::most})
    {
      const std::vector<Point> points = patch(n, 12, [](double x, double) { return x; });
      Sample_neighbors neighbors;
      neighbors.search(points, wanted, Tag());
      neighbors.sort(points, Tag());
      for (std::size_t i = 0; i < n; ++i)
      {
        std::vector<std::pair<double, std::size_t>> expected;
        for (std::size_t j = 0; j < n; ++j)
          if (j != i)
            expected.emplace_back(CGAL::squared_distance(points[i], points[j]), j);
        std::sort(expected.begin(), expected.end());
        expected.resize(std::min(expected.size(), wanted));
        std::vector<std::size_t> indices;
        for (const auto& neighbor : expected)
          indices.push_back(neighbor.second);
        const auto found = neighbors.of(i);
        EXPECT_EQ(std::vector<std::size_t>(found.begin(), found.end()), indices);
      }
    }
  // more coincide than are kept: no sample is its own neighbor
  const std::vector<Point> equal(60, Point(1., 2., 3.));
  Sample_neighbors neighbors;
  neighbors.search(equal, Sample_neighbors::most, Tag());
  for (std::size_t i = 0; i < equal.size(); ++i)
    for (std::size_t j : neighbors.of(i))
      EXPECT_NE(i, j);
}

TEST(Sample_neighbors, are_sorted_by_the_distances_that_they_have_then)
{
  std::vector<Point> points = {Point(0., 0., 0.), Point(1., 0., 0.), Point(2., 0., 0.),
                               Point(9., 0., 0.)};
  Sample_neighbors neighbors;
  neighbors.search(points, 2, Tag());
  points[1] = Point(3., 0., 0.);
  neighbors.sort(points, Tag());
  const auto found = neighbors.of(0);
  EXPECT_EQ(std::vector<std::size_t>(found.begin(), found.end()), (std::vector<std::size_t>{2, 1}));
}

TEST(Repulsion, is_the_weighted_mean_of_the_directions_away)
{
  Surface_sample x; // at the origin, with the normal z
  x.spacing = 2.;
  // away from one neighbor by its distance; at 0.5 and 1 spacings, with the weights
  // (1 - 1/16)^6 / 0.5 and (1 - 1/4)^6 / 1; above, of equal spacing; beyond two spacings
  const std::vector<Point> points = {Point(1., 0., 0.), Point(0., 2., 0.), Point(0., 0., 1.),
                                     Point(4., 0., 0.)};
  const std::vector<double> squares(4, 4.); // of the spacings
  const Adaptive_settings settings;
  const auto repulsion = [&](std::vector<std::size_t> neighbors, const std::vector<double>& s) {
    return tangential_repulsion(x, neighbor_indices(neighbors), points, s, settings);
  };
  EXPECT_NEAR((repulsion({0}, squares) - Vector(-1., 0., 0.)).squared_length(), 0., 1e-28);
  EXPECT_EQ(repulsion({3}, squares), Vector(0., 0., 0.));
  EXPECT_EQ(repulsion({}, squares), Vector(0., 0., 0.));
  const double w0 = 1.3579, w1 = 0.17798; // (15/16)^6 * 2, (3/4)^6
  const Vector both = repulsion({0, 1}, squares);
  EXPECT_NEAR(both.x(), -w0 / (w0 + w1), 1e-4);
  EXPECT_NEAR(both.y(), -2. * w1 / (w0 + w1), 1e-4);
  // one neighbor alone, with less weight than those of a lattice, pushes by its share
  EXPECT_NEAR(repulsion({1}, squares).y(), -2. * w1, 1e-4);
  // phi: the square of the other's spacing
  const Vector sparse = repulsion({0, 1}, {4., 16., 4., 4.});
  EXPECT_NEAR(sparse.x(), -w0 / (w0 + 4. * w1), 1e-4);
  // heights count twice: 0.5 spacings above are as far as 1 beside, and push nowhere
  const Vector above = repulsion({0, 2}, squares);
  EXPECT_NEAR(above.x(), -w0 / (w0 + w1), 1e-4);
  EXPECT_NEAR(above.z(), 0., 1e-15);
}

TEST(Relaxation, has_steps_that_shrink_in_ten_iterations_or_fewer)
{
  EXPECT_EQ(length_of_steps(2., 0, 10), 2.);
  EXPECT_NEAR(length_of_steps(2., 3, 10), 2. - 3. / 9., 1e-15);
  EXPECT_EQ(length_of_steps(2., 9, 10), 1.);
  EXPECT_EQ(length_of_steps(2., 8, 40), length_of_steps(2., 8, 10));
  EXPECT_EQ(length_of_steps(2., 30, 40), 1.);
  EXPECT_EQ(length_of_steps(2., 1, 3), 1.5);
  EXPECT_EQ(length_of_steps(2., 0, 1), 1.);
}

// Samples on a square, those that `is_wanted` returns true for, after the relaxation
template <typename Is_wanted>
std::vector<Point> relaxed_on_a_square(const Adaptive_settings& settings, std::size_t iterations,
                                       const Is_wanted& is_wanted)
{
  const std::vector<Point> points = surfaces::square(20000, 9);
  const Neighbor_search search(points, Tag());
  const Surface_fitter fitter{search, settings};
  std::vector<Surface_sample> samples;
  for (const Point& p : points)
    if (is_wanted(p))
    {
      samples.emplace_back();
      samples.back().spacing = lattice_spacing(400.);
      samples.back().place(fitter.at(no_noise), p, CGAL::NULL_VECTOR, rounds_to_move);
    }
  relax_on_surface<Tag>(samples, fitter, iterations, 0.45, Progress(no_callback));
  return points_of<Tag>(samples);
}

TEST(Relaxation, evens_out_faster_with_long_first_steps)
{
  // three quarters of the samples start in the left half, and flow to the right
  const auto samples_on_the_left = [](double length_of_first_steps, std::size_t iterations) {
    Adaptive_settings settings;
    settings.length_of_first_steps = length_of_first_steps;
    std::size_t left = 0, right = 0;
    const std::vector<Point> samples =
        relaxed_on_a_square(settings, iterations, [&](const Point& p) {
          return p.x() < 0.5 ? left++ < 300 : right++ < 100;
        });
    return std::count_if(samples.begin(), samples.end(),
                         [](const Point& p) { return p.x() < 0.5; });
  };
  EXPECT_LT(samples_on_the_left(2.5, 10), samples_on_the_left(1., 10) - 5);
  // one iteration is the last one
  EXPECT_EQ(samples_on_the_left(1., 1), samples_on_the_left(2.5, 1));
}

TEST(Relaxation, leaves_no_two_samples_close_when_they_take_turns)
{
  // the least distance of two of 400 samples from a random start, in spacings of a lattice
  const auto least_distance = [](std::size_t turns) {
    Adaptive_settings settings;
    settings.turns = turns;
    std::size_t number = 0;
    const std::vector<Point> samples =
        relaxed_on_a_square(settings, 10, [&](const Point&) { return number++ < 400; });
    double least = 1.;
    for (std::size_t i = 0; i < samples.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        least = (std::min)(least, CGAL::squared_distance(samples[i], samples[j]));
    return std::sqrt(least) / lattice_spacing(400.);
  };
  const double at_once = least_distance(1), in_turns = least_distance(4);
  EXPECT_GT(in_turns, 0.6);
  EXPECT_GT(in_turns, at_once);
}

TEST(Denoising, takes_the_part_of_a_step_with_the_least_expected_error)
{
  // by how much the shape missed grows from one fit to the next
  const double c = 1. / (std::pow(2., 1.5) - 1.);
  EXPECT_NEAR(Adaptive_settings().missed_shape, c, 0.0005);
  EXPECT_EQ(part_of_step({0., 0.}, c), 1.);
  EXPECT_EQ(part_of_step({0.5, 1.}, c), 1.); // all noise
  EXPECT_NEAR(part_of_step({2., 1.}, 0.547), 0.2265, 1e-12);
  EXPECT_EQ(part_of_step({10., 1.}, c), 0.); // all shape
  EXPECT_EQ(part_of_step({4., 1.}, 0.), 0.25);
  // brute force: shape s and c s missed before it, noise v
  const double v = 1., s = 0.7;
  const auto error = [&](double w) { return std::pow(c * s + w * s, 2) + (1. - w) * (1. - w) * v; };
  double best = 0.;
  for (double w = 0.; w <= 1.; w += 0.001)
    if (error(w) < error(best))
      best = w;
  EXPECT_NEAR(part_of_step({v + s * s, v}, c), best, 0.002);
}

TEST(Correction, by_one_point_moves_the_nearest_sample_and_fills_a_gap_with_the_other)
{
  std::vector<Point> points;
  for (int x = 0; x < 5; ++x)
    points.emplace_back(x, 0., 0.);
  const std::vector<Point> places = {Point(1.2, 0., 0.3), Point(1., 0., 0.3), Point(0., 0., 0.)};
  const std::vector<Point> nearest = {points[1], points[1], points[0]};
  std::vector<Surface_sample> samples(3);
  for (std::size_t i = 0; i < 3; ++i) // on horizontal planes
  {
    samples[i].point = samples[i].surface.origin = places[i];
    samples[i].surface.radius = samples[i].spacing = 1.;
  }
  Sample_neighbors neighbors;
  neighbors.search(places, 2, Tag());
  const Neighbor_search search(points, Tag());
  correct_by_points<Tag>(samples, nearest, neighbors, search);
  EXPECT_EQ(samples[0].point,
            points[4]); // 3 from the nearest sample; no other is more than 2
  EXPECT_EQ(samples[1].point, points[1]);
  EXPECT_EQ(samples[2].point, points[0]); // not missed
}

// Samples at the place of another fill gaps, whatever brought them there, each its own: samples
// before were not looked at again, and three filled neighboring places.
TEST(Copies, of_a_sample_fill_gaps_of_their_own)
{
  std::vector<Point> points;
  for (int x = 0; x < 19; ++x)
    points.emplace_back(x, 0., 0.);
  const std::vector<Point> places(4, points[0]);
  for (double sigma : {0., 0.1})
  {
    const Noise noise{sigma, sigma, 0., sigma > 0.};
    std::vector<Surface_sample> samples(4);
    for (Surface_sample& sample : samples)
    {
      sample.point = sample.surface.origin = points[0];
      sample.surface.radius = sample.spacing = 5.;
      sample.noise = &noise;
    }
    Sample_neighbors neighbors;
    neighbors.search(places, 3, Tag());
    const Neighbor_search search(points, Tag());
    separate_copies<Tag>(samples, neighbors, search);
    EXPECT_EQ(samples[0].point, points[0]);
    EXPECT_EQ(samples[1].point, points[18]);
    EXPECT_EQ(samples[2].point, points[9]);
    EXPECT_TRUE(samples[3].point == points[4] || samples[3].point == points[5] ||
                samples[3].point == points[13] || samples[3].point == points[14])
        << samples[3].point;
  }
}

// Two that were far from each other when neighbors were looked for went to the same point.
TEST(Copies, are_found_where_they_are_no_neighbors)
{
  std::vector<Point> points;
  for (int x = 0; x < 19; ++x)
    points.emplace_back(x, 0., 0.);
  std::vector<Surface_sample> samples(4);
  std::vector<Point> before;
  for (std::size_t i = 0; i < 4; ++i)
  {
    samples[i].point = points[6 * i];
    samples[i].spacing = 6.;
    before.push_back(samples[i].point);
  }
  Sample_neighbors neighbors;
  neighbors.search(before, 1, Tag());
  const Neighbor_search search(points, Tag());
  separate_copies<Tag>(samples, neighbors, search);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(samples[i].point, points[6 * i]);
  samples[3].point = points[0];
  separate_copies<Tag>(samples, neighbors, search);
  EXPECT_EQ(samples[0].point, points[0]);
  EXPECT_EQ(samples[3].point, points[18]);
}

TEST(Correction, is_of_what_noise_does_not_explain)
{
  Surface_sample x; // on a horizontal plane
  x.surface.origin = Point(0., 0., 0.);
  x.surface.radius = 1.;
  x.spacing = 2.;
  Noise noise;
  noise.is_visible = true;
  x.noise = &noise;
  for (double sigma : {0., 0.08})
  {
    noise.level = sigma;
    EXPECT_TRUE(is_missed(x, Point(0.5, 0., 0.3)));
  }
  noise.level = 0.1; // 3 sigma, as one point in 400 is off
  EXPECT_FALSE(is_missed(x, Point(0.5, 0., 0.3)));
  noise.level = 0.01; // noise does not explain it, but any fit errs so much
  EXPECT_FALSE(is_missed(x, Point(0.5, 0., 0.09)));
  x.spacing = 1.1; // samples that are nearly as near to each other as the fit is wide show it
  EXPECT_TRUE(is_missed(x, Point(0.5, 0., 0.09)));
  EXPECT_FALSE(is_missed(x, Point(0.5, 0., 0.08)));
  x.spacing = 10.; // those that are far sparser than the points do not
  EXPECT_FALSE(is_missed(x, Point(0.5, 0., 0.09)));
}

// Whether a sample stays where it is if there are these points, the first the nearest
bool stays(const Surface_sample& x, const std::vector<Point>& points)
{
  std::vector<Surface_sample> samples(1, x);
  stay_near_points<Tag>(samples, {points.back()}, Neighbor_search(points, Tag()));
  EXPECT_TRUE(samples[0].point == x.point || samples[0].point == points.front());
  return samples[0].point == x.point;
}

Surface_sample sample_above_origin(double height)
{
  Surface_sample x;
  x.point = Point(0., 0., height);
  x.spacing = 1.;
  return x;
}

TEST(Samples_on_wide_fits, stay_near_points)
{
  const std::vector<Point> points = {Point(0., 0., 0.), Point(5., 0., 0.)};
  Surface_sample x = sample_above_origin(1.);
  x.surface.radius = 3.1;
  x.surface.neighbors = 37;
  EXPECT_FALSE(stays(x, points));
  Surface_sample other = x;
  other.point = Point(0., 0., 0.34);
  EXPECT_TRUE(stays(other, points));
  other.point = Point(0., 0., 0.36);
  EXPECT_FALSE(stays(other, points));
  other = x;
  other.surface.radius = 2.9; // no wider than three spacings
  EXPECT_TRUE(stays(other, points));
  other = x;
  other.surface.neighbors = 36; // not widened
  EXPECT_TRUE(stays(other, points));
  other = x;
  other.surface.is_curve = true;
  EXPECT_TRUE(stays(other, points));
  Noise noise; // which fits are wide for
  noise.is_visible = true;
  other = x;
  other.noise = &noise;
  EXPECT_TRUE(stays(other, points));
}

TEST(Samples_beyond_the_neighbors_of_points, stay_near_points)
{
  // the fourth neighbor of the nearest is 0.4 from it
  const std::vector<Point> points = {Point(0., 0., 0.),  Point(0.1, 0., 0.), Point(-0.2, 0., 0.),
                                     Point(0.3, 0., 0.), Point(0., 0.4, 0.), Point(5., 0., 0.)};
  EXPECT_TRUE(stays(sample_above_origin(0.79), points));
  EXPECT_FALSE(stays(sample_above_origin(0.81), points));
  Surface_sample dense = sample_above_origin(0.81);
  dense.spacing = 2.4; // within 0.35 of that
  EXPECT_TRUE(stays(dense, points));
}

TEST(Limited_step, is_half_of_the_spacing_at_most)
{
  const Vector step = limited_step(Vector(3., 4., 0.), 2.);
  EXPECT_NEAR(step.x(), 0.6, 1e-15);
  EXPECT_NEAR(step.y(), 0.8, 1e-15);
  EXPECT_EQ(limited_step(Vector(0.3, 0.4, 0.), 2.), Vector(0.3, 0.4, 0.));
}

} // namespace
