// Depth that several cameras have rounded, each along its own axis

#include "inputs.h"

#include <CGAL/Curvature_aware_simplification_3/internal/depth/Crossings.h>
#include <CGAL/Curvature_aware_simplification_3/internal/depth/find_depth_views.h>
#include <CGAL/Curvature_aware_simplification_3/internal/depth/levels_of_cameras.h>
#include <CGAL/Curvature_aware_simplification_3/internal/depth/undo_rounding.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Cloud.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace inputs;

std::vector<Depth_view> depth_views_of(const std::vector<Point>& points)
{
  const Searchable_points cloud = searchable(points);
  const std::vector<Facet> facets = some_facets<Tag>(cloud);
  return find_depth_views<Tag>(cloud, facets, thickness_of_flat_facets(facets, 0.));
}

TEST(Facets, have_common_normals)
{
  std::vector<Facet> facets;
  const auto add = [&](std::size_t number, const Vector& normal, double thickness) {
    for (std::size_t i = 0; i < number; ++i)
    {
      Facet facet;
      facet.normal = i % 2 == 0 ? normal : -normal;
      facet.radius = facet.spacing = 1.;
      facet.thickness = thickness;
      facet.is_broad = true;
      facets.push_back(facet);
    }
  };
  add(4, axes_of_cameras[1], 0.);
  add(3, axes_of_cameras[0], 0.);
  // these are not quite parallel, not flat, or too few
  add(2, unit_vector(1.01, 2., 4.), 0.005);
  add(9, axes_of_cameras[2], 0.02);
  add(2, unit_vector(0., 0., 1.), 0.);
  const std::vector<Vector> normals = common_normals(facets, 0.01, 3);
  ASSERT_EQ(normals.size(), 2u);
  EXPECT_EQ(std::abs(normals[0] * axes_of_cameras[0]), 1.) << "the flattest half tells it";
  EXPECT_NEAR(std::abs(normals[1] * axes_of_cameras[1]), 1., 1e-15);
}

TEST(Depth_views, are_those_of_the_nearest_level)
{
  Depth_levels x, y;
  x.direction = Vector(1., 0., 0.);
  y.direction = Vector(0., 1., 0.);
  x.tolerance = y.tolerance = 0.1;
  x.heights = {0., 1.};
  y.heights = {0., 1.};
  const std::vector<Point> points = {Point(1.05, 0.02, 0.), Point(1.05, 0.3, 0.),
                                     Point(0.4, 0.05, 0.), Point(0.5, 0.5, 0.)};
  EXPECT_EQ(views_of_points<Tag>(points, {x, y}), (Flags{1, 0, 1, in_no_view}));
}

TEST(Depth_views, of_one_camera_have_all_its_levels)
{
  Depth_levels first, second, more;
  first.direction = Vector(0., 0., 1.);
  first.heights = {0., 2.};
  second.direction = Vector(1., 0., 0.);
  more.direction = Vector(0., 1e-9, -1.);
  more.heights = {-1.};
  std::vector<Depth_levels> cameras;
  add_camera(cameras, first);
  add_camera(cameras, second);
  add_camera(cameras, more);
  ASSERT_EQ(cameras.size(), 2u);
  EXPECT_EQ(cameras[0].heights, (std::vector<double>{0., 1., 2.}));
  EXPECT_EQ(cameras[0].gap_above, (std::vector<double>{1., 1., 0.}));
}

// Around a facet in the plane z = 0, levels of another camera are planes of constant x.
TEST(Depth_views, cross_where_cameras_see_the_same)
{
  std::vector<Depth_levels> levels(2);
  levels[0].direction = Vector(0., 0., 1.);
  levels[1].direction = Vector(1., 0., 0.);
  for (Depth_levels& of_camera : levels)
  {
    of_camera.tolerance = 1e-9;
    of_camera.heights = {-1., -0.5, 0., 0.5, 1.};
    of_camera.gap_above = {0.5, 0.5, 0.5, 0.5, 0.};
  }
  levels[0].gap_above.assign(5, 1.);
  Facet facet;
  facet.point = Point(0., 0., 0.);
  const auto crossings_with = [&](const std::vector<Point>& others) {
    std::vector<Point> points(20, facet.point);
    points.insert(points.end(), others.begin(), others.end());
    Flags view_of_point(20, 0);
    view_of_point.resize(points.size(), 1);
    const Crossings crossings =
        crossings_at(facet, 0, levels, view_of_point, Neighbor_search(points, Tag()));
    return std::make_pair(crossings.possible, crossings.found);
  };
  using Pair = std::pair<std::size_t, std::size_t>;
  EXPECT_EQ(crossings_with({}), Pair(0, 0));
  // a front that begins at the plane, one that ends there, and both: as of stairs
  const std::vector<Point> above = {Point(0.5, 0., 0.1), Point(0.5, 0., 0.3), Point(0.5, 0., 0.5),
                                    Point(0.5, 0., 0.7)};
  const std::vector<Point> below = {Point(-0.5, 0., -0.1), Point(-0.5, 0., -0.3),
                                    Point(-0.5, 0., -0.5), Point(-0.5, 0., -0.7)};
  EXPECT_EQ(crossings_with(above), Pair(1, 0));
  EXPECT_EQ(crossings_with(below), Pair(1, 0));
  std::vector<Point> both = above;
  both.insert(both.end(), below.begin(), below.end());
  EXPECT_EQ(crossings_with(both), Pair(1, 0));
  // a level of another camera, on both sides
  EXPECT_EQ(crossings_with({Point(0., 0.2, 0.4), Point(0., 0.2, 0.2), Point(0., 0.2, -0.2),
                            Point(0., 0.2, -0.4)}),
            Pair(1, 1));
  // beyond a step
  EXPECT_EQ(crossings_with({Point(0., 1.1, 0.4), Point(0., 1.1, 0.2), Point(0., 1.1, -0.2),
                            Point(0., 1.1, -0.4)}),
            Pair(0, 0));

  EXPECT_TRUE((Crossings{9, 6, 1}.are_of_cameras()));
  EXPECT_FALSE((Crossings{9, 7, 1}.are_of_cameras()));
  EXPECT_FALSE((Crossings{4, 1, 0}.are_of_cameras()));
  EXPECT_TRUE((Crossings{5, 1, 0}.are_of_cameras())); // they see different parts
}

// Pixels in rows: the points of one camera are in rows for another, too, which took each for a
// level where these were on no level yet, and steps were 1/12 of their size.
TEST(Depth_views, have_no_levels_between_steps)
{
  constexpr double step = 3.;
  const Vector axes[2] = {unit_vector(0., 0., 1.), unit_vector(0.5, 0., 0.9)};
  std::vector<Point> points;
  for (const Vector& axis : axes)
    for (int i = 0; i < 150; ++i)
      for (int j = 0; j < 150; ++j)
      {
        const double x = i, y = j;
        points.push_back(
            rounded_along(axis, Point(x, y, 0.5 * x + 0.3 * y + 15. * std::sin(x / 25.)), step));
      }
  const std::vector<Depth_view> views = depth_views_of(points);
  ASSERT_EQ(views.size(), 2u);
  for (const Depth_view& view : views)
    EXPECT_NEAR(typical_step<Tag>(view.points, {view.levels}), step, 1e-9);
}

TEST(Depth_views, are_found_in_merged_frames)
{
  const auto any = [](const Point& p) {
    return static_cast<std::size_t>(std::fmod(1000. * p.y(), 1.) * 3.);
  };
  for (double step : {2., 3., 5., 8., 8.1})
  {
    // flat facets need wide steps where three cameras see all
    const std::vector<Point> points =
        step > 8. ? seen_by_cameras(step, any) : seen_by_cameras(step, camera_of_strip);
    for (bool is_turned : {false, true})
    {
      const std::vector<Depth_view> views =
          depth_views_of(is_turned ? each(points, turned) : points);
      ASSERT_EQ(views.size(), 3u) << step;
      std::size_t in_views = 0;
      for (const Depth_view& view : views)
      {
        EXPECT_NEAR(typical_step<Tag>(view.points, {view.levels}), step, 1e-9);
        EXPECT_EQ(view.points.size(), view.indices.size());
        in_views += view.indices.size();
        const auto is_axis = [&](const Vector& axis) {
          return std::abs(axis * view.levels.direction) > 1. - 1e-12;
        };
        EXPECT_TRUE(is_turned ||
                    std::any_of(axes_of_cameras.begin(), axes_of_cameras.end(), is_axis))
            << step;
      }
      EXPECT_GT(in_views, 29900u) << step;
    }
  }
}

TEST(Depth_views, are_not_found_elsewhere)
{
  CGAL::Random random(72);
  const auto anywhere = [&](double a) { return random.uniform_real(0., a); };
  std::vector<std::pair<std::string, std::vector<Point>>> inputs;
  inputs.emplace_back("clean", seen_by_cameras(1e-9, camera_of_strip));
  inputs.emplace_back("steps smaller than the spacing", seen_by_cameras(0.5, camera_of_strip));
  inputs.emplace_back("one camera", depth_frame(170, 3., waves));
  inputs.emplace_back("faces of a cube", cube(40000, 73));
  // treads and fronts, folded sheets, pyramids of steps
  for (const auto& [width, height] :
       {std::make_pair(3., 3.), {3., 8.}, {5., 3.}, {8., 5.}, {8., 8.}, {12., 3.}})
  {
    std::vector<Point> stairs, pyramid;
    for (int i = 0; i < 20000; ++i)
    {
      const int stair = i % 20;
      const double along = anywhere(20000. / 20. / (width + height));
      const bool on_tread = anywhere(width + height) < width;
      stairs.emplace_back(along, width * (stair + (on_tread ? anywhere(1.) : 1.)),
                          height * (stair + (on_tread ? 0. : anywhere(1.))));
    }
    for (int i = 0; i < 30000; ++i)
    {
      // squares of 2 to 15 widths around the axis
      const double half = width * (2. + std::floor(14. * std::sqrt(anywhere(1.))));
      const bool on_tread = anywhere(width + height) < width;
      const double out = on_tread ? half - anywhere(width) : half;
      const double along = (anywhere(2.) - 1.) * out;
      const double z = height * (15. - half / width) - (on_tread ? 0. : anywhere(height));
      const int side = i % 4;
      pyramid.emplace_back(side == 0   ? out
                           : side == 1 ? -out
                                       : along,
                           side == 2   ? out
                           : side == 3 ? -out
                                       : along,
                           z);
    }
    const std::string size = std::to_string(width) + " x " + std::to_string(height);
    inputs.emplace_back("stairs " + size, stairs);
    inputs.emplace_back("pyramid " + size, pyramid);
  }
  for (double width : {4., 8.})
    for (double slope : {0.4, 1., 1.7})
    {
      std::vector<Point> sheet;
      for (int i = 0; i < 20000; ++i)
      {
        const double x = anywhere(40. * width), across = std::fmod(x, 2. * width);
        sheet.emplace_back(x, anywhere(20000. / (40. * width) / std::sqrt(1. + slope * slope)),
                           slope * (std::min)(across, 2. * width - across));
      }
      inputs.emplace_back("folded sheet " + std::to_string(width) + ' ' + std::to_string(slope),
                          sheet);
    }
  for (const auto& [name, points] : inputs)
  {
    EXPECT_TRUE(depth_views_of(points).empty()) << name;
    EXPECT_TRUE(depth_views_of(each(points, turned)).empty()) << name;
  }
}

TEST(Rounding_of_depth, is_undone_for_each_camera)
{
  for (double step : {2., 3., 5., 8.})
  {
    const std::vector<Point> points = seen_by_cameras(step, camera_of_strip);
    const auto error = [&](const Cloud& cloud) {
      double sum = 0.;
      for (const Point& p : cloud.points)
      {
        const Point q = cloud.frame.from_frame(p);
        sum += std::pow(q.z() - waves(q.x(), q.y()), 2.);
      }
      return std::sqrt(sum / static_cast<double>(cloud.size())) / step;
    };
    Cloud cloud = cloud_of(points, 0.), as_it_is = cloud_of(points, 0.);
    const std::vector<Depth_levels> levels = undo_rounding<Tag>(cloud, default_settings);
    EXPECT_EQ(levels.size(), 3u);
    EXPECT_LT(error(cloud), 0.7 * error(as_it_is)) << step;

    // by place, the largest step of a camera there
    Noise_levels noise = uniform_noise(0., cloud.size());
    allow_for_rounding<Tag>(noise, cloud.points, levels);
    EXPECT_NEAR(noise.of_range[0].level, 0.1 * typical_step<Tag>(cloud.points, levels), 1e-12);
    std::vector<Depth_levels> with_larger_steps = levels;
    for (double& gap : with_larger_steps[1].gap_above)
      gap *= 2.;
    allow_for_rounding<Tag>(noise, cloud.points, with_larger_steps);
    EXPECT_NEAR(noise.of_range[0].level, 0.2 * typical_step<Tag>(cloud.points, levels), 1e-12);

    Adaptive_settings settings;
    settings.tell_cameras = false;
    EXPECT_TRUE(undo_rounding<Tag>(as_it_is, settings).empty());
  }
}

} // namespace
