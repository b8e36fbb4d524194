// Rounded depth: found, and undone

#include "inputs.h"

#include <CGAL/Curvature_aware_simplification_3/internal/depth/Depth_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/depth/find_depth_levels.h>
#include <CGAL/Curvature_aware_simplification_3/internal/depth/undo_rounding.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Cloud.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace {

using namespace inputs;

Depth_levels depth_levels_of(const std::vector<Point>& points)
{
  const Searchable_points cloud = searchable(points);
  const std::vector<Facet> facets = some_facets<Tag>(cloud);
  return find_depth_levels<Tag>(cloud, facets, thickness_of_flat_facets(facets, 0.));
}

TEST(Depth_levels, have_heights_and_gaps)
{
  // 20 levels of 10 points, 0.5 apart, with a jump of 5 after the tenth
  std::vector<Point> points;
  for (int level = 0; level < 20; ++level)
    for (int i = 0; i < 10; ++i)
      points.emplace_back(0.5 * level + (level >= 10 ? 4.5 : 0.), i, 3 * i * level);
  const std::size_t on_levels = points.size();
  const Vector x(1., 0., 0.);
  const Depth_levels levels = levels_along<Tag>(x, 0.01, points);
  ASSERT_EQ(levels.heights.size(), 20u);
  EXPECT_EQ(levels.heights.front(), 0.);
  EXPECT_EQ(levels.heights.back(), 14.);
  EXPECT_EQ(levels.gap_above[8], 0.5);
  EXPECT_EQ(levels.gap_above[9], 0.);
  EXPECT_EQ(levels.gap_above[19], 0.);
  EXPECT_EQ(levels.gap_below(0), 0.);
  EXPECT_EQ(levels.gap_below(10), 0.);
  EXPECT_EQ(levels.gap_below(11), 0.5);
  EXPECT_EQ(levels.level_of(0.509), 1u);
  EXPECT_EQ(levels.level_of(0.491), 1u);
  EXPECT_EQ(levels.level_of(0.511), 20u);
  EXPECT_EQ(levels.level_of(100.), 20u);
  EXPECT_EQ(levels.step_at(9.), 0.5); // in the jump, as for level 9
  EXPECT_EQ(levels.step_at(-1.), 0.5);
  EXPECT_EQ(levels.number_of_points, 200u);
  EXPECT_TRUE(are_many(levels));
  EXPECT_EQ(typical_step<Tag>(points, {levels}), 0.5);
  EXPECT_EQ(typical_step<Tag>(points, {}), 0.);

  // outliers between the levels are no levels
  for (int i = 0; i < 22; ++i)
    points.emplace_back(0.1 + 0.0713 * i, 0., 0.);
  EXPECT_EQ(levels_along<Tag>(x, 0.001, points).heights, levels.heights);
  EXPECT_EQ(levels_along<Tag>(x, 0.001, points).number_of_points, 200u);
  points.resize(on_levels - 110); // 9 levels
  EXPECT_FALSE(are_many(levels_along<Tag>(x, 0.01, points)));
}

TEST(Depth_levels, hold_nine_tenths_of_the_points)
{
  EXPECT_TRUE(are_most(90, 100));
  EXPECT_FALSE(are_most(89, 100));
}

// The squares of distances below 1e-162 are 0, and so is the step of a level between two jumps.
TEST(Depth_levels, are_no_steps_without_a_size)
{
  Depth_levels levels;
  levels.direction = Vector(0., 0., 1.);
  levels.heights = {-10., 0., 10.};
  levels.gap_above = {0., 0., 0.};
  std::vector<Point> oblique;
  for (int i = 0; i < 100; ++i)
    oblique.emplace_back(i % 10, i / 10, i % 10 - 4.5);
  Facet facet;
  facet.point = Point(0., 0., 0.);
  facet.spacing = 0.;
  EXPECT_FALSE(is_on_steps(facet, levels, Neighbor_search(oblique, Tag())));
  facet.spacing = 1.;
  EXPECT_FALSE(is_on_steps(facet, levels, Neighbor_search(oblique, Tag())));
  levels.gap_above = {2., 2., 0.};
  EXPECT_TRUE(is_on_steps(facet, levels, Neighbor_search(oblique, Tag())));
}

TEST(Depth_levels, are_found_in_frames_of_a_depth_camera)
{
  for (double step : {2., 3., 5., 8.})
  {
    const std::vector<Point> frame = depth_frame(200, step, waves);
    const Depth_levels levels = depth_levels_of(frame);
    ASSERT_FALSE(levels.heights.empty()) << step;
    EXPECT_NEAR(std::abs(levels.direction.z()), 1., 1e-14);
    EXPECT_NEAR(typical_step<Tag>(frame, {levels}), step, 1e-12);

    const Depth_levels of_turned = depth_levels_of(each(frame, turned));
    EXPECT_EQ(of_turned.heights.size(), levels.heights.size());
    EXPECT_NEAR(typical_step<Tag>(each(frame, turned), {of_turned}), step, 1e-12);

    // coordinates in single precision
    const Depth_levels rounded = depth_levels_of(each(each(frame, turned), [](const Point& p) {
      return Point(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()));
    }));
    EXPECT_EQ(rounded.heights.size(), levels.heights.size());
    EXPECT_NEAR(typical_step<Tag>(each(frame, turned), {rounded}), step, 1e-4);
  }
}

// What else has many points in few planes, or looks flat
TEST(Depth_levels, are_not_found_elsewhere)
{
  CGAL::Random random(61);
  const auto anywhere = [&](double a) { return random.uniform_real(0., a); };
  std::vector<std::pair<const char*, std::vector<Point>>> inputs;
  inputs.emplace_back("clean", depth_frame(200, 1e-9, waves));
  inputs.emplace_back("steps smaller than the spacing", depth_frame(200, 0.5, waves));
  inputs.emplace_back("a wall", depth_frame(200, 3., [](double, double) { return 0.; }));
  inputs.emplace_back("dense", surfaces::torus(300000, 3., 1., 62));
  inputs.emplace_back("faces of a cube", cube(40000, 63));

  std::vector<Point> plate, stairs, low_stairs, bare_stairs, lattice, voxels, slices;
  for (int i = 0; i < 40000; ++i)
    plate.emplace_back(anywhere(200.), anywhere(200.), i % 2 == 0 ? 0. : 3.);
  inputs.emplace_back("two sides of a plate", plate);
  for (int i = 0; i < 40000; ++i)
  {
    const int stair = i % 20;
    const double along = anywhere(200.), across = anywhere(10.);
    if (anywhere(13.) < 10.)
      stairs.emplace_back(along, 10. * stair + across, 3. * stair);
    else
      stairs.emplace_back(along, 10. * stair, 3. * stair - anywhere(3.));
    bare_stairs.emplace_back(along, 60. * stair + 6. * across, 3. * stair);
  }
  for (int i = 0; i < 5600; ++i)
  {
    const int stair = i % 20;
    const double over_edge = anywhere(14.) - 12.;
    low_stairs.emplace_back(anywhere(20.), 12. * stair + (std::min)(over_edge, 0.),
                            2. * stair - (std::max)(over_edge, 0.));
  }
  inputs.emplace_back("stairs", stairs);
  inputs.emplace_back("low stairs", low_stairs);
  inputs.emplace_back("wide stairs without fronts", bare_stairs);
  for (int i = 0; i <= 60; ++i)
    for (int j = 0; j <= 60; ++j)
      for (int side = 0; side <= 60; side += 60)
      {
        lattice.emplace_back(i, j, side);
        lattice.emplace_back(side, i, j);
        lattice.emplace_back(j, side, i);
      }
  inputs.emplace_back("a cube whose points are a lattice", lattice);
  for (const Point& p : surfaces::sphere(200000, 64))
    voxels.emplace_back(std::round(40. * p.x()), std::round(40. * p.y()), std::round(40. * p.z()));
  std::sort(voxels.begin(), voxels.end());
  voxels.erase(std::unique(voxels.begin(), voxels.end()), voxels.end());
  inputs.emplace_back("voxels", voxels);
  for (int i = 1; i < 40; ++i)
    for (int j = 0; j < 1000; ++j)
    {
      const double z = -1. + i / 20., angle = anywhere(2. * CGAL_PI), r = std::sqrt(1. - z * z);
      slices.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
    }
  inputs.emplace_back("slices of a sphere", slices);

  std::vector<Point> fins, rings, cards;
  for (int i = 0; i < 40000; ++i)
  {
    fins.emplace_back(5. * (i % 16), anywhere(100.), anywhere(30.));
    cards.emplace_back(3. * (i % 20) + anywhere(30.), 2. * (i % 20) + anywhere(50.), 3. * (i % 20));
    const double angle = anywhere(2. * CGAL_PI), r = std::sqrt(100. + anywhere(800.));
    rings.emplace_back(r * std::cos(angle), r * std::sin(angle), 6. * (i % 14));
  }
  inputs.emplace_back("fins", fins);
  inputs.emplace_back("fanned out cards", cards);
  inputs.emplace_back("rings of an insulator", rings);
  for (const auto& [name, points] : inputs)
  {
    EXPECT_TRUE(depth_levels_of(points).heights.empty()) << name;
    EXPECT_TRUE(depth_levels_of(each(points, turned)).heights.empty()) << name;
  }
}

TEST(Rounding_of_depth, is_undone_between_the_borders_of_the_steps)
{
  // z = x / 2 in steps of 3: each is six points wide
  const double step = 3.;
  Depth_levels levels;
  levels.direction = Vector(0., 0., 1.);
  levels.tolerance = 1e-9;
  for (int i = 0; i <= 20; ++i)
    levels.heights.push_back(step * i);
  levels.gap_above.assign(20, step);
  levels.gap_above.push_back(0.);
  const std::vector<Point> slope =
      depth_frame(100, step, [](double x, double) { return (x + 0.5) / 2.; });
  const Neighbor_search search(slope, Tag());
  // x = 9 to 14 are at z = 6: the first of them is one from the step below, and six from the one
  // above, which are farther than the sqrt(2) 3 that count
  const double reach = 3. * std::sqrt(2.);
  const auto away = [&](std::size_t x) {
    return rounded_away(slope[100 * x + 50], levels, search);
  };
  ASSERT_EQ(slope[100 * 9 + 50].z(), 6.);
  ASSERT_EQ(slope[100 * 14 + 50].z(), 6.);
  EXPECT_NEAR(away(9), step * (1. / (1. + reach) - 0.5), 1e-12);
  EXPECT_NEAR(away(10), step * (2. / (2. + reach) - 0.5), 1e-12);
  EXPECT_NEAR(away(11), step * (3. / 7. - 0.5), 1e-12);
  EXPECT_NEAR(away(12), step * (4. / 7. - 0.5), 1e-12);
  EXPECT_NEAR(away(14), step * (reach / (1. + reach) - 0.5), 1e-12);
  // of steps whose borders overlap, as if they were half as wide as high
  const std::vector<Point> steep = {Point(0., 0., 3.), Point(0.3, 0., 6.), Point(0.4, 0., 9.)};
  EXPECT_NEAR(rounded_away(steep[1], levels, Neighbor_search(steep, Tag())),
              step * (0.3 - 0.1) / (2. * 1.5), 1e-12);
  // no level is below the first one, and none above the last: they end at a jump
  levels.gap_above[1] = levels.gap_above[2] = 0.;
  EXPECT_EQ(away(11), 0.);
  levels.gap_above[2] = step;
  EXPECT_EQ(away(9), 0.);
  EXPECT_NEAR(away(14), step * (reach / (1. + reach) - 0.5), 1e-12);
  // on no level
  EXPECT_EQ(rounded_away(Point(50., 50., 7.), levels, search), 0.);

  // far from all borders, nothing is known, whatever the steps
  const std::vector<Point> wall = depth_frame(50, step, [](double, double) { return 0.; });
  levels.heights = {-1., 0., 3.};
  for (const std::vector<double>& gaps : {std::vector<double>{3., 3., 0.}, {1., 3., 0.}})
  {
    levels.gap_above = gaps;
    EXPECT_EQ(rounded_away(wall[50 * 25 + 25], levels, Neighbor_search(wall, Tag())), 0.);
  }
}

// A border that is not seen is as far as the larger one of the two steps lets see.
TEST(Rounding_of_depth, takes_borders_that_are_not_seen_for_equally_far)
{
  Depth_levels levels;
  levels.direction = Vector(0., 0., 1.);
  levels.tolerance = 1e-9;
  levels.heights = {0., 1., 4.};
  levels.gap_above = {1., 3., 0.};
  // x = 0 and less at height 1, more at height 4: the nearest of these are at 1, 3 and 5
  std::vector<Point> points;
  for (int x = -20; x <= 20; ++x)
    for (int y = -20; y <= 20; ++y)
      points.emplace_back(x, y, x <= 0 ? 1. : 4.);
  const Neighbor_search search(points, Tag());
  const double reach = 3. * std::sqrt(2.);
  const auto away = [&](double x) { return rounded_away(Point(x, 0., 1.), levels, search); };
  EXPECT_NEAR(away(0.), 3. * (reach - 1.) / (2. * (reach + 1.)), 1e-12);
  EXPECT_NEAR(away(-2.), 3. * (reach - 3.) / (2. * (reach + 3.)), 1e-12);
  EXPECT_EQ(away(-4.), 0.);
}

// Points of two levels at the same place in their plane met halfway between these.
TEST(Rounding_of_depth, brings_no_two_points_together)
{
  const double step = 3.;
  Depth_levels levels;
  levels.direction = Vector(0., 0., 1.);
  levels.tolerance = 1e-9;
  levels.heights = {0., step};
  levels.gap_above = {step, 0.};
  std::vector<Point> points;
  for (int x = 0; x < 20; ++x)
    for (int y = 0; y < 20; ++y)
      for (double z : {0., step})
        points.emplace_back(x, y, z);
  const Neighbor_search search(points, Tag());
  EXPECT_NEAR(rounded_away(Point(10., 10., 0.), levels, search), 0.49 * step, 1e-12);
  EXPECT_NEAR(rounded_away(Point(10., 10., step), levels, search), -0.49 * step, 1e-12);
}

TEST(Rounding_of_depth, leaves_a_tenth_of_a_step)
{
  for (double step : {2., 3., 5., 8.})
  {
    Cloud cloud = cloud_of(depth_frame(200, step, waves), 0.);
    const auto error = [&] {
      double sum = 0.;
      for (const Point& p : cloud.points)
      {
        const Point q = cloud.frame.from_frame(p);
        sum += std::pow(q.z() - waves(q.x(), q.y()), 2.);
      }
      return std::sqrt(sum / static_cast<double>(cloud.size())) / step;
    };
    EXPECT_NEAR(error(), std::sqrt(1. / 12.), 0.02);
    const std::vector<Depth_levels> levels = undo_rounding<Tag>(cloud, default_settings);
    ASSERT_EQ(levels.size(), 1u);
    EXPECT_LT(error(), 0.15) << step; // borders of steps are known to half a spacing
    // the search knows where the points are now
    cloud.search->for_each_nearest(cloud.points[5], 1, [&](std::size_t i, const Point& p, double) {
      EXPECT_EQ(i, 5u);
      EXPECT_EQ(p, cloud.points[5]);
    });

    Noise_levels noise = uniform_noise(0., cloud.size());
    allow_for_rounding<Tag>(noise, cloud.points, levels);
    EXPECT_NEAR(noise.of_range[0].level, 0.1 * typical_step<Tag>(cloud.points, levels), 1e-12);
    EXPECT_EQ(noise.of_range[0].independent_level, noise.of_range[0].level);
    noise = uniform_noise(step, cloud.size());
    allow_for_rounding<Tag>(noise, cloud.points, levels);
    EXPECT_EQ(noise.of_range[0].level, step);
  }
}

} // namespace
