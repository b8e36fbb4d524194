// Which points are outliers, and which are not

#include "inputs.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Curvature_aware_simplification_3/internal/features/shared_features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/outliers/find_outliers.h>
#include <CGAL/Curvature_aware_simplification_3/internal/outliers/leave_out_outliers.h>
#include <CGAL/Curvature_aware_simplification_3/internal/outliers/sparse_surfaces.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace {

using namespace inputs;

std::vector<std::uint8_t> outliers_of(const Cloud& cloud, std::size_t k = 16)
{
  return find_outliers<Tag>(cloud, shared_features_of(cloud, k), Adaptive_settings(),
                            Progress(no_callback));
}

bool are_far_points_dense_in(const Cloud& cloud)
{
  const Features features = shared_features_of(cloud).features;
  return are_far_points_dense<Tag>(features, sparseness_of(features.inverse_density));
}

// n points, uniform in a box, put behind the others
void add_outliers_in(const CGAL::Bbox_3& box, std::size_t n, unsigned int seed,
                     std::vector<Point>& points)
{
  CGAL::Random random(seed);
  for (std::size_t i = 0; i < n; ++i)
  {
    const double x = random.get_double(box.xmin(), box.xmax());
    const double y = random.get_double(box.ymin(), box.ymax());
    points.emplace_back(x, y, random.get_double(box.zmin(), box.zmax()));
  }
}

// of four square posts of a certain thickness and length 1, with a density that falls by a factor
// to their upper ends
std::vector<Point> sparse_posts(int number, double thickness, double factor, unsigned int seed)
{
  CGAL::Random random(seed);
  std::vector<Point> result;
  for (int i = 0; i < number; ++i)
  {
    const double z = random.get_double();
    const int post = random.get_int(0, 4);
    const double around = random.get_double(0., 4.);
    const int side = static_cast<int>(around);
    const double along = around - side;
    const double x = side == 0 ? along : side == 1 ? 1. : side == 2 ? 1. - along : 0.;
    const double y = side == 0 ? 0. : side == 1 ? along : side == 2 ? 1. : 1. - along;
    if (random.get_double() < std::pow(factor, -z))
      result.emplace_back(post % 2 + thickness * x, post / 2 + thickness * y, z);
  }
  return result;
}

// of a cube, with a density that falls to a hundredth along an axis
std::vector<Point> cube_far_from_a_scanner(std::size_t n, unsigned int seed)
{
  CGAL::Random random(seed + 1);
  std::vector<Point> result;
  for (const Point& p : cube(n, seed))
    if (random.get_double() < std::pow(100., -p.x()))
      result.push_back(p);
  return result;
}

// A point beyond the corner of a square has few votes, if any. In the plane it is what a sparse
// corner looks like, unless it is so far that it is no neighbor of any point, or one of many.
TEST(Outliers, are_not_lone_points_of_a_border)
{
  const auto is_outlier_at = [](double x, double y, double z, std::size_t others) {
    std::vector<Point> points = surfaces::square(3000, 3);
    add_outliers_in(CGAL::Bbox_3(0., 0., 0.05, 1., 1., 0.15), others, 4, points);
    points.emplace_back(x, y, z);
    const Cloud cloud = cloud_of(points, 0.);
    const std::vector<std::uint8_t> is_outlier = outliers_of(cloud);
    for (std::size_t i = 0; i < cloud.size(); ++i)
      if (cloud.input_index[i] + 1 == points.size())
        return is_outlier[i] != 0;
    return false;
  };
  // two of the points at the corner have it among their 16 nearest
  EXPECT_FALSE(is_outlier_at(1.03, 1.03, 0., 0));
  EXPECT_FALSE(is_outlier_at(1.03, 1.03, 0., 5));
  EXPECT_TRUE(is_outlier_at(1.03, 1.03, 0., 100));
  EXPECT_TRUE(is_outlier_at(1.2, 1.2, 0., 0));
  EXPECT_TRUE(is_outlier_at(1., 1., 0.06, 0));
  EXPECT_TRUE(is_outlier_at(0.5, 0.5, 0.05, 0));
}

TEST(Outliers, are_not_on_sparse_parts_of_a_surface)
{
  for (double sigma : {0., 0.0005})
    for (unsigned int seed : {131u, 132u, 133u})
    {
      const Cloud cloud =
          cloud_of(with_noise(cube_far_from_a_scanner(100000, seed), sigma, seed + 10));
      const std::vector<std::uint8_t> is_outlier = outliers_of(cloud);
      EXPECT_LE(std::count(is_outlier.begin(), is_outlier.end(), 1), 2) << sigma << ' ' << seed;
    }
}

// of a square plate, with a density that falls to a hundredth along it, and a rod at that end, as
// sparse
std::vector<Point> plate_with_sparse_rod(double radius, unsigned int seed)
{
  CGAL::Random random(seed);
  std::vector<Point> result;
  for (std::size_t i = 0; i < 100000; ++i)
  {
    const double x = random.get_double(), y = random.get_double();
    if (random.get_double() < std::pow(100., -x))
      result.emplace_back(x, y, 0.);
  }
  const double length = 0.6, density = 1000.;
  for (std::size_t i = 0; i < static_cast<std::size_t>(2. * CGAL_PI * radius * length * density);
       ++i)
  {
    const double angle = random.get_double(0., 2. * CGAL_PI);
    result.emplace_back(random.get_double(1., 1. + length), 0.5 + radius * std::cos(angle),
                        radius * std::sin(angle));
  }
  return result;
}

TEST(Outliers, are_not_on_thin_sparse_parts_of_a_surface)
{
  for (double radius : {0.02, 0.04}) // a spacing of 0.03: as thick as wide
    for (unsigned int seed : {141u, 142u, 143u})
    {
      const Cloud cloud = cloud_of(plate_with_sparse_rod(radius, seed));
      const std::vector<std::uint8_t> is_outlier = outliers_of(cloud);
      EXPECT_LE(std::count(is_outlier.begin(), is_outlier.end(), 1), 5) << radius << ' ' << seed;
    }
}

// of a helix of six turns, a tube with a radius of 0.1, with a density that falls by a factor along
// x, to where points are as far from each other as the tube is wide
std::vector<Point> sparse_helix(double factor, unsigned int seed)
{
  CGAL::Random random(seed);
  std::vector<Point> result;
  for (std::size_t i = 0; i < 30000; ++i)
  {
    const double t = random.get_double(0., 12. * CGAL_PI),
                 angle = random.get_double(0., 2. * CGAL_PI);
    const double r = 1. + 0.1 * std::cos(angle);
    const Point p(r * std::cos(t), r * std::sin(t), 0.056 * t + 0.1 * std::sin(angle));
    if (random.get_double() < std::pow(factor, -(p.x() + 1.1) / 2.2))
      result.push_back(p);
  }
  return result;
}

TEST(Outliers, are_not_on_thin_parts_that_become_sparse)
{
  for (unsigned int seed : {151u, 152u, 153u})
  {
    std::vector<Point> points = sparse_helix(10., seed);
    const std::size_t surface = points.size();
    const std::vector<std::uint8_t> is_outlier = outliers_of(cloud_of(points));
    // 107 to 143 where only flat points tell of a surface
    EXPECT_LE(std::count(is_outlier.begin(), is_outlier.end(), 1), 3) << seed;

    add_outliers(points, surface / 20, 2., seed + 10);
    const Cloud cloud = cloud_of(points);
    const std::vector<std::uint8_t> among_others = outliers_of(cloud);
    std::size_t lost = 0, found = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i)
      if (among_others[i] != 0)
        ++(cloud.input_index[i] < surface ? lost : found);
    EXPECT_LT(lost, surface / 200) << seed;
    EXPECT_GT(found, (points.size() - surface) * 8 / 10) << seed; // others are near the surface
  }
}

TEST(Outliers, around_a_sparse_thin_part_do_not_take_it_with_them)
{
  for (unsigned int seed : {151u, 152u, 153u})
  {
    std::vector<Point> points = sparse_helix(30., seed);
    const std::size_t surface = points.size();
    add_outliers_in(CGAL::Bbox_3(-1.3, -1.3, -0.2, 1.3, 1.3, 2.4), surface / 20, seed + 10, points);
    const Cloud cloud = cloud_of(points);
    const std::vector<std::uint8_t> is_outlier = outliers_of(cloud);
    std::size_t lost = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i)
      lost += cloud.input_index[i] < surface ? is_outlier[i] : 0;
    EXPECT_LT(lost, 250u)
        << seed; // 600 to 740 if all that lose a third of their votes are outliers
  }
}

// Points taken for outliers since they are thick, and what is told of them
struct Far_outliers
{
  template <typename Is_far>
  Far_outliers(const std::vector<Point>& points, const Is_far& is_far)
    : cloud(cloud_of(points)), shared(shared_features_of(cloud)), is_outlier(cloud.size())
  {
    for (std::size_t i = 0; i < cloud.size(); ++i)
      if (shared.features.surface_variation[i] > least_variation_of_volumes &&
          is_far(cloud.input_index[i]))
      {
        is_outlier[i] = 1;
        far_ones.push_back(i);
      }
  }

  template <typename ConcurrencyTag>
  std::vector<std::uint8_t> with_support(double needed_share,
                                         const std::vector<std::size_t>& asked) const
  {
    std::vector<std::uint8_t> result = is_outlier;
    const double sparse = sparseness_of(shared.features.inverse_density).of_outliers;
    unmark_sparse_surfaces<ConcurrencyTag>({cloud, shared.features, {sparse, sparse}, result},
                                           needed_share, asked);
    return result;
  }

  template <typename ConcurrencyTag>
  std::vector<std::uint8_t> after_connecting(bool are_likely,
                                             const std::vector<std::size_t>& asked) const
  {
    std::vector<std::uint8_t> result = is_outlier;
    constexpr double any = std::numeric_limits<double>::infinity(); // may be of a surface
    unmark_connected<ConcurrencyTag>({cloud, shared.features, {any, any}, result}, are_likely,
                                     asked);
    return result;
  }

  double needed_share(std::size_t number_with_few_votes) const
  {
    return needed_share_of_support(
        are_outliers_likely<Tag>(cloud, 16, number_with_few_votes, far_ones));
  }

  Cloud cloud;
  Shared_features shared;
  std::vector<std::uint8_t> is_outlier;
  std::vector<std::size_t> far_ones;
};

// by brute force: those nearer than the 17th nearest point, itself the first, of both
template <typename Counts>
std::ptrdiff_t number_of_mutual_neighbors(const Far_outliers& cloud, std::size_t i,
                                          const Counts& counts)
{
  const std::vector<Point>& points = cloud.cloud.points;
  std::vector<std::pair<double, std::size_t>> by_distance;
  for (std::size_t j = 0; j < points.size(); ++j)
    by_distance.emplace_back(CGAL::squared_distance(points[i], points[j]), j);
  std::nth_element(by_distance.begin(), by_distance.begin() + 16, by_distance.end());
  return std::count_if(by_distance.begin(), by_distance.begin() + 17,
                       [&](const std::pair<double, std::size_t>& neighbor) {
                         return neighbor.second != i && counts(neighbor.second) &&
                                neighbor.first <=
                                    16. * cloud.shared.features.inverse_density[neighbor.second];
                       });
}

// 1/rho is rounded: for k = 3, 5, 6 or 7, the k-th neighbor was often not inside of its radius, and
// which ones, and so the outliers, depended on the unit.
TEST(Outliers, do_not_depend_on_the_unit_for_any_number_of_neighbors)
{
  std::vector<Point> points = with_noise(surfaces::sphere(20000, 185), 0.02, 186);
  add_outliers(points, 2000, 2.4, 187);
  for (std::size_t k : {3u, 5u, 6u, 7u, 10u})
  {
    const auto number_of_outliers = [&](double unit) {
      std::vector<Point> scaled;
      for (const Point& p : points)
        scaled.push_back(CGAL::ORIGIN + unit * (p - CGAL::ORIGIN));
      const Cloud cloud = cloud_of(scaled);
      const std::vector<std::uint8_t> is_outlier = find_outliers<Tag>(
          cloud, shared_features_of(cloud, k), Adaptive_settings(), Progress(no_callback));
      return std::count(is_outlier.begin(), is_outlier.end(), 1);
    };
    const auto expected = number_of_outliers(1.);
    for (double unit : {3., 7., 1e-3, 1.1})
      EXPECT_EQ(number_of_outliers(unit), expected) << k << ' ' << unit;
  }
}

// n points of a unit square, and m of one beside it with a noise of so many of the spacings there,
// as a wall far behind what a camera looks at
std::vector<Point> near_and_far_wall(std::size_t n, std::size_t m, double noise_in_spacings,
                                     unsigned int seed)
{
  std::vector<Point> points = surfaces::square(n, seed);
  const double sigma = noise_in_spacings / std::sqrt(static_cast<double>(m));
  for (const Point& p : with_noise(surfaces::square(m, seed + 1), sigma, seed + 2))
    points.push_back(p + Vector(2., 0., 0.5));
  return points;
}

// The far wall was taken for outliers as a whole: its points are as thick as wide for 16 and for 64
// neighbors, and none of them is flat.
TEST(Outliers, are_not_walls_whose_noise_is_as_large_as_the_distances_of_their_points)
{
  for (const auto& [m, noise] : {std::make_pair(5000u, 1.2), std::make_pair(5000u, 2.),
                                 std::make_pair(5000u, 3.), std::make_pair(600u, 1.5)})
    for (unsigned int seed : {181u, 182u})
    {
      const Cloud cloud = cloud_of(near_and_far_wall(60000, m, noise, seed));
      const std::vector<std::uint8_t> is_outlier = outliers_of(cloud);
      std::size_t lost = 0;
      for (std::size_t i = 0; i < cloud.size(); ++i)
        lost += cloud.input_index[i] >= 60000 && is_outlier[i] != 0 ? 1 : 0;
      EXPECT_LT(lost, m / 7) << m << ' ' << noise << ' ' << seed;
    }
}

// What fills a flat box around a surface is a layer as well, but has the surface in its midst.
TEST(Outliers, in_a_flat_box_are_found)
{
  for (double height : {0.05, 0.1, 0.3})
    for (unsigned int seed : {183u, 184u})
    {
      std::vector<Point> points = surfaces::square(30000, seed);
      CGAL::Random random(seed + 10);
      std::size_t are_far = 0;
      for (std::size_t i = 0; i < 3000; ++i)
      {
        const Point p(random.get_double(), random.get_double(),
                      random.get_double(-height / 2., height / 2.));
        are_far += std::abs(p.z()) > 0.02 ? 1 : 0; // 3.5 spacings
        points.push_back(p);
      }
      const Cloud cloud = cloud_of(points);
      const std::vector<std::uint8_t> is_outlier = outliers_of(cloud);
      std::size_t found = 0;
      for (std::size_t i = 0; i < cloud.size(); ++i)
        if (is_outlier[i] != 0 && std::abs(points[cloud.input_index[i]].z()) > 0.02)
          ++found;
      EXPECT_GT(found, are_far * 97 / 100) << height << ' ' << seed;
    }
}

TEST(Outliers, in_space_do_not_lead_to_a_surface)
{
  std::vector<Point> points = surfaces::sphere(100000, 134);
  const std::size_t surface = points.size();
  add_outliers(points, 30000, 2., 135);
  const Far_outliers outliers(points, [&](std::size_t i) { return i >= surface; });
  EXPECT_GT(outliers.far_ones.size(), 28000u);
  for (double share : {1. / 4., 1. / 16.})
  {
    const std::vector<std::uint8_t> after = outliers.with_support<Tag>(share, outliers.far_ones);
    EXPECT_GE(std::count(after.begin(), after.end(), 1) * 1000,
              static_cast<std::ptrdiff_t>(outliers.far_ones.size()) * 995);
  }
  const std::vector<std::uint8_t> after = outliers.after_connecting<Tag>(true, outliers.far_ones);
  EXPECT_GE(std::count(after.begin(), after.end(), 1) * 1000,
            static_cast<std::ptrdiff_t>(outliers.far_ones.size()) * 995);
  EXPECT_EQ(outliers.needed_share(0), 1. / 4.); // they look like space
}

TEST(Outliers, that_are_far_may_be_connected_to_a_surface)
{
  const std::vector<Point> points = sparse_helix(10., 154);
  const Far_outliers tube(points, [&](std::size_t i) { return points[i].x() > 0.7; });
  ASSERT_GT(tube.far_ones.size(), 400u);
  const std::vector<std::uint8_t> after = tube.after_connecting<Tag>(false, tube.far_ones);
  EXPECT_EQ(std::count(after.begin(), after.end(), 1), 0);
  EXPECT_EQ(after, tube.after_connecting<CGAL::Sequential_tag>(false, tube.far_ones));
  // others are outliers for another reason
  const std::vector<std::uint8_t> asked_one = tube.after_connecting<Tag>(false, {tube.far_ones[0]});
  EXPECT_GE(std::count(asked_one.begin(), asked_one.end(), 1),
            static_cast<std::ptrdiff_t>(tube.far_ones.size()) - 1);
}

TEST(Outliers,
     that_are_connected_have_half_of_their_neighbors_on_the_surface_and_do_not_look_like_space)
{
  std::vector<Point> points = sparse_helix(10., 155);
  const std::size_t surface = points.size();
  add_outliers(points, 2000, 2., 156);
  const Far_outliers outliers(
      points, [&](std::size_t i) { return i >= surface || (points[i].x() > 0.7 && i % 2 == 0); });
  std::vector<std::uint8_t> expected = outliers.is_outlier;
  bool are_some_space = false;
  for (bool is_any_new = true; is_any_new;)
  {
    is_any_new = false;
    for (std::size_t i : outliers.far_ones)
      if (expected[i] != 0 && number_of_mutual_neighbors(outliers, i, [&](std::size_t j) {
                                return expected[j] == 0;
                              }) >= 8)
      {
        const bool is_space =
            variation_of_twice_the_radius(outliers.cloud, 16, i) > largest_variation_of_parts;
        are_some_space |= is_space;
        is_any_new |= !is_space;
        expected[i] = is_space ? 1 : 0;
      }
  }
  EXPECT_EQ(outliers.after_connecting<Tag>(true, outliers.far_ones), expected);
  EXPECT_TRUE(are_some_space);
  const std::ptrdiff_t left = std::count(expected.begin(), expected.end(), 1);
  EXPECT_GT(left, 500);
  EXPECT_LT(left + 100, static_cast<std::ptrdiff_t>(outliers.far_ones.size()));
}

// Around a part that is small in the box of the outliers, few of them are near it, and the nearest 64
// are a large part of all: nothing else tells of outliers. Those that are flat by chance are no
// surface that others could be connected to.
TEST(Outliers, are_found_around_a_part_that_is_small_in_their_box)
{
  for (unsigned int seed = 0; seed < 24; ++seed)
  {
    std::vector<Point> points = surfaces::torus(13688, 1., 0.02, seed);
    add_outliers(points, 451, 1.5, seed + 100);
    const std::vector<std::uint8_t> is_outlier = outliers_of(cloud_of(points));
    const auto found = std::count(is_outlier.begin(), is_outlier.end(), 1);
    EXPECT_GE(found, 361) << seed; // 8 in ten
    EXPECT_LE(found, 470) << seed;
  }
}

TEST(Outliers, that_are_far_need_the_support_of_flat_points)
{
  const std::vector<Point> points = plate_with_sparse_rod(0.02, 144);
  const Far_outliers rod(points, [&](std::size_t i) { return points[i].x() > 1.; });
  ASSERT_GT(rod.far_ones.size(), 40u);
  EXPECT_EQ(rod.needed_share(3), 1. / 16.);
  EXPECT_EQ(rod.needed_share(4 + rod.far_ones.size() / 30), 1. / 4.);

  const std::vector<std::uint8_t> after = rod.with_support<Tag>(1. / 16., rod.far_ones);
  EXPECT_LE(std::count(after.begin(), after.end(), 1), 2);
  EXPECT_EQ(after, rod.with_support<CGAL::Sequential_tag>(1. / 16., rod.far_ones));

  // others are outliers for another reason
  std::vector<std::size_t> asked;
  for (std::size_t i = 0; i < rod.far_ones.size(); i += 2)
    asked.push_back(rod.far_ones[i]);
  const std::vector<std::uint8_t> after_half = rod.with_support<Tag>(1. / 16., asked);
  for (std::size_t i = 1; i < rod.far_ones.size(); i += 2)
    EXPECT_EQ(after_half[rod.far_ones[i]], 1);
  EXPECT_LT(std::count(after_half.begin(), after_half.end(), 1),
            static_cast<std::ptrdiff_t>(rod.far_ones.size()));
}

TEST(Outliers, are_found)
{
  for (double noise : {0., 0.005})
  {
    std::vector<Point> points = with_noise(surfaces::sphere(20000, 12), noise, 13);
    add_outliers(points, 1500, 1.2, 14);
    const Cloud cloud = cloud_of(points);
    const std::vector<std::uint8_t> is_outlier = outliers_of(cloud);
    int found = 0, false_alarms = 0, there = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
      const std::size_t input = cloud.input_index[i];
      // nearer than the spacing, they are as good as any point
      const bool is_true = input >= 20000 && distance_to_sphere(points[input]) > 0.05;
      there += is_true ? 1 : 0;
      found += is_true && is_outlier[i] ? 1 : 0;
      false_alarms += input < 20000 && is_outlier[i] ? 1 : 0;
    }
    EXPECT_GT(found, 0.99 * there) << noise;
    EXPECT_LT(false_alarms, 0.01 * 20000) << noise;
  }
}

TEST(Outliers, are_dense_where_far_points_are_hardly_farther_than_what_is_far)
{
  const auto are_dense = [](std::size_t number) {
    std::vector<Point> points = surfaces::sphere(20000, 190);
    add_outliers(points, number, 1.2, 191);
    const Cloud cloud = cloud_of(points);
    return are_far_points_dense_in(cloud);
  };
  EXPECT_FALSE(are_dense(0));
  EXPECT_FALSE(are_dense(1000));
  EXPECT_FALSE(are_dense(2000));
  EXPECT_TRUE(are_dense(6000));
}

// The thin ends of posts with noise are far from others, too, and hardly farther than that; but few
// neighborhoods there are round.
TEST(Outliers, are_not_dense_where_thin_parts_with_noise_become_sparse)
{
  for (unsigned int seed : {1u, 2u, 3u})
  {
    const Cloud cloud = cloud_of(with_noise(sparse_posts(30000, 0.1, 30., seed), 0.01, seed + 5));
    EXPECT_FALSE(are_far_points_dense_in(cloud)) << seed;
    const std::vector<std::uint8_t> is_outlier = outliers_of(cloud);
    // 522 to 586 if they were
    EXPECT_LT(std::count(is_outlier.begin(), is_outlier.end(), 1), 470) << seed;
  }
}

// The neighborhoods of the box of outliers are 2.4 times as wide as those of the square below.
// Far points are so few that they tell nothing of their density.
TEST(Outliers, are_not_dense_where_few_points_are_far)
{
  std::vector<Point> points = surfaces::sphere(20000, 190);
  const auto are_dense = [&] {
    const Cloud cloud = cloud_of(points);
    return are_far_points_dense_in(cloud);
  };
  // as sparse as what is far, and round
  add_outliers_in({3., 0., 0., 3.3, 0.3, 0.3}, 20, 192, points);
  EXPECT_FALSE(are_dense());
  for (int x = 4; x < 10; ++x)
    add_outliers_in({1. * x, 0., 0., x + 0.3, 0.3, 0.3}, 20, 193, points);
  EXPECT_TRUE(are_dense());
}

// Flat roofs on the ground, and walls between them whose points are three times as far apart: most
// neighbors of these are on roofs and on the ground, and not the other way round. A second look,
// which is for outliers that hide, took 38 % of the walls in all.
TEST(Outliers, are_found_in_few_points_of_sparse_walls_between_dense_roofs_and_the_ground)
{
  constexpr double pitch = 40., side = 20., height = 10.;
  for (unsigned int seed : {1u, 2u, 3u})
  {
    CGAL::Random random(seed);
    std::vector<Point> points;
    for (int i = 0; i < 40000; ++i)
    {
      const double x = random.get_double(0., 200.), y = random.get_double(0., 200.);
      const bool is_roof = std::fmod(x, pitch) < side && std::fmod(y, pitch) < side;
      points.emplace_back(x, y, is_roof ? height : 0.);
    }
    for (int i = 0; i < 2200; ++i)
    {
      const double along = random.get_double(0., side), z = random.get_double(0., height);
      const double x = pitch * random.get_int(0, 5), y = pitch * random.get_int(0, 5);
      switch (random.get_int(0, 4))
      {
      case 0:
        points.emplace_back(x + along, y, z);
        break;
      case 1:
        points.emplace_back(x + along, y + side, z);
        break;
      case 2:
        points.emplace_back(x, y + along, z);
        break;
      default:
        points.emplace_back(x + side, y + along, z);
      }
    }
    const std::vector<std::uint8_t> is_outlier = outliers_of(cloud_of(points));
    EXPECT_LE(std::count(is_outlier.begin(), is_outlier.end(), 1), 0.15 * 2200) << seed;
  }
}

TEST(Outliers, in_a_volume_hardly_sparser_than_the_surface_are_found)
{
  std::vector<Point> points = with_noise(surfaces::square(20000, 46), 0.002, 47);
  const auto point_of_box = [](CGAL::Random& random) {
    const double x = random.uniform_real(0.25, 0.75), y = random.uniform_real(0.25, 0.75);
    return Point(x, y, random.uniform_real(0.2, 0.7));
  };
  for (const Point& p : surfaces::sample(7500, 48, point_of_box))
    points.push_back(p);
  const Cloud cloud = cloud_of(points);
  const std::vector<std::uint8_t> is_outlier = outliers_of(cloud);
  int found = 0, lost = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    (cloud.input_index[i] < 20000 ? lost : found) += is_outlier[i];
  EXPECT_GT(found, 0.985 * 7500);
  // 47 where the border of the square is asked for half of the votes, and 40 more are found
  EXPECT_LE(lost, 10);
}

TEST(Outliers, are_no_neighbors_once_they_are_removed)
{
  for (std::size_t number : {5u, 2000u}) // hidden in the search, and a new one
  {
    std::vector<Point> points = surfaces::sphere(20000, 12);
    add_outliers(points, number, 3., 14);
    Cloud cloud = cloud_of(points);
    const std::vector<Point> all = cloud.points;
    Shared_features shared = shared_features_of(cloud);
    leave_out_outliers<Tag>(cloud, shared, 100, Adaptive_settings(), Progress(no_callback));
    EXPECT_LT(cloud.size(), all.size());
    EXPECT_GT(cloud.size(), 19900u);
    EXPECT_EQ(shared.features.surface_variation.size(), cloud.size());
    EXPECT_EQ(shared.features.inverse_density.size(), cloud.size());
    const std::set<Point> kept(cloud.points.begin(), cloud.points.end());
    for (const Point& query : all)
      cloud.search->for_each_nearest(query, 1,
                                     [&](std::size_t, const Point& p, double squared_distance) {
                                       EXPECT_EQ(kept.count(p), 1u);
                                       EXPECT_EQ(squared_distance == 0., kept.count(query) == 1u);
                                     });
  }
}

// Asking for half of the votes again and again eats an open surface from its border.
TEST(Outliers, among_others_leave_the_border_of_an_open_surface)
{
  std::vector<Point> points = with_noise(surfaces::square(20000, 43), 0.003, 44);
  add_outliers(points, 2000, 1.2, 45);
  const Cloud cloud = cloud_of(points);
  const std::vector<std::uint8_t> is_outlier = outliers_of(cloud);
  int near_border = 0, lost = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i)
  {
    const Point& p = points[cloud.input_index[i]];
    const double from_border =
        (std::min)((std::min)(p.x(), 1. - p.x()), (std::min)(p.y(), 1. - p.y()));
    if (cloud.input_index[i] < 20000 && from_border < 0.01) // 1.4 spacings
    {
      ++near_border;
      lost += is_outlier[i] ? 1 : 0;
    }
  }
  // 0.17 when asked again and again, 0.08 once, 0.025 those off the surface
  EXPECT_LT(lost, 0.04 * near_border);
}

TEST(Outliers, far_from_a_surface_leave_its_border)
{
  std::vector<Point> points;
  add_outliers(points, 400, 1., 46);
  for (Point& p : points)
    p = p + Vector(6., 0., 0.);
  const std::size_t outliers = points.size();
  for (const Point& p : surfaces::square(20000, 47))
    points.push_back(p);
  const Cloud cloud = cloud_of(points);
  const std::vector<std::uint8_t> is_outlier = outliers_of(cloud);
  std::size_t found = 0, lost = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (is_outlier[i])
      ++(cloud.input_index[i] < outliers ? found : lost);
  EXPECT_EQ(found, outliers);
  EXPECT_LE(lost, 10u); // 49 where the border is asked for half of the votes
}

TEST(Outliers, are_not_found_in_borders_thin_parts_and_sparse_regions)
{
  const auto number_of_outliers = [](const std::vector<Point>& points) {
    const std::vector<std::uint8_t> is_outlier = outliers_of(cloud_of(points));
    return std::count(is_outlier.begin(), is_outlier.end(), 1);
  };
  EXPECT_LT(number_of_outliers(surfaces::square(20000, 15)), 20);
  // a wire: a cylinder of radius 0.01
  std::vector<Point> wire;
  for (const Point& p : surfaces::square(20000, 16))
    wire.emplace_back(0.01 * std::cos(2. * CGAL_PI * p.y()), 0.01 * std::sin(2. * CGAL_PI * p.y()),
                      p.x());
  EXPECT_LT(number_of_outliers(wire), 20);
  // density falling 100 : 1 along x
  std::vector<Point> uneven;
  CGAL::Random random(17);
  for (const Point& p : surfaces::torus(100000, 3., 1., 17))
    if (random.uniform_real(0., 1.) < std::pow(100., -(p.x() + 4.) / 8.))
      uneven.push_back(p);
  EXPECT_LT(number_of_outliers(uneven), 0.005 * static_cast<double>(uneven.size()));
}

TEST(Outliers, are_not_found_by_chance_in_few_points)
{
  for (std::size_t n : {100u, 500u, 999u})
  {
    std::ptrdiff_t found = 0;
    for (unsigned int seed = 0; seed < 100; ++seed)
    {
      const std::vector<std::uint8_t> is_outlier = outliers_of(cloud_of(surfaces::square(n, seed)));
      found += std::count(is_outlier.begin(), is_outlier.end(), 1);
    }
    EXPECT_LT(found, 30) << n;
  }
}

// n points around `center`, normally distributed
std::vector<Point> cluster(std::size_t n, const Point& center, double sigma, unsigned int seed)
{
  return with_noise(std::vector<Point>(n, center), sigma, seed);
}

void append(std::vector<Point>& points, const std::vector<Point>& more)
{
  points.insert(points.end(), more.begin(), more.end());
}

TEST(Outliers, in_isolated_clusters_are_found)
{
  for (double noise : {0., 0.02}) // the 16 nearest are within 0.06
  {
    std::vector<Point> points = with_noise(surfaces::sphere(20000, 12), noise, 13);
    append(points, cluster(8, Point(0., 0., 0.), 0.02, 31)); // fewer than the neighbors of a point
    append(points, cluster(17, Point(1.5, 0., 0.), 0.02, 32));
    append(points, cluster(40, Point(0., 1.5, 0.), 0.02, 33));
    append(points, cluster(40, Point(0., 1.9, 0.3), 0.002, 34)); // ten times as dense
    append(points, cluster(100, Point(0., 0., 1.5), 0.05, 35));
    append(points, cluster(400, Point(0., -1.6, 0.), 0.05, 36));
    const Cloud cloud = cloud_of(points);
    const std::vector<std::uint8_t> is_outlier = outliers_of(cloud);
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
      const bool is_in_cluster = cloud.input_index[i] >= 20000;
      EXPECT_TRUE(!is_in_cluster || is_outlier[i] != 0) << noise << " " << cloud.input_index[i];
    }
    EXPECT_LT(std::count(is_outlier.begin(), is_outlier.end(), 1), 605 + 20 + 600 * (noise > 0.));
  }
}

// As the manual says: up to 32 k points, and farther from all else than k neighbors reach
TEST(Outliers, in_larger_clusters_are_found_with_more_neighbors)
{
  const auto share_found = [](std::size_t size, double gap, std::size_t k) {
    std::vector<Point> points = surfaces::sphere(20000, 41);
    append(points, cluster(size, Point(1.04 + gap, 0., 0.), 0.02, 42));
    const Cloud cloud = cloud_of(points);
    const std::vector<std::uint8_t> is_outlier = outliers_of(cloud, k);
    double found = 0.;
    for (std::size_t i = 0; i < cloud.size(); ++i)
      found += cloud.input_index[i] >= 20000 ? is_outlier[i] : 0;
    return found / static_cast<double>(size);
  };
  EXPECT_LT(share_found(600, 0.2, 16), 0.1);
  EXPECT_EQ(share_found(600, 0.2, 64), 1.);
  EXPECT_EQ(share_found(300, 0.2, 16), 1.);
  EXPECT_EQ(share_found(300, 0.2, 64), 1.);
  EXPECT_EQ(share_found(300, 0.2, 128), 1.);  // of the sphere, 128 neighbors reach 0.16
  EXPECT_LT(share_found(300, 0.2, 512), 0.1); // and 512 reach 0.32
  EXPECT_EQ(share_found(100, 0.1, 16), 1.);
  EXPECT_LT(share_found(100, 0.1, 128), 0.1);
}

// Of specks with less points than a neighborhood, 16 points are a few specks, often in a plane, and
// one speck led to the next: with 8 points, a third of them was found.
TEST(Outliers, in_specks_are_found)
{
  for (const auto& [size, share] : {std::make_pair(5u, 0.7), std::make_pair(8u, 0.85)})
    for (unsigned int seed : {188u, 189u})
    {
      std::vector<Point> points = surfaces::square(50000, seed);
      CGAL::Random random(seed + 10);
      const double sigma = 0.0045; // a spacing
      std::size_t in_specks = 0;
      for (int speck = 0; speck < 100; ++speck, in_specks += size)
      {
        const Point center(random.get_double(), random.get_double(), random.get_double(0.15, 1.));
        for (unsigned int i = 0; i < size; ++i)
          points.push_back(center + sigma * Vector(surfaces::normal_deviate(random),
                                                   surfaces::normal_deviate(random),
                                                   surfaces::normal_deviate(random)));
      }
      const Cloud cloud = cloud_of(points);
      const std::vector<std::uint8_t> is_outlier = outliers_of(cloud);
      std::size_t found = 0, lost = 0;
      for (std::size_t i = 0; i < cloud.size(); ++i)
        if (is_outlier[i] != 0)
          ++(cloud.input_index[i] >= 50000 ? found : lost);
      EXPECT_GT(static_cast<double>(found), share * static_cast<double>(in_specks))
          << size << ' ' << seed;
      EXPECT_LE(lost, 10u) << size << ' ' << seed;
    }
}

// At the ends, a few points are far from others. Nothing else tells of outliers, and up to 10 were
// taken for a speck, which leaves an end without samples.
TEST(Outliers, are_not_found_in_specks_where_thin_parts_become_sparse)
{
  for (const auto& [number, seed] : {std::make_pair(6000, 4u), std::make_pair(6000, 6u),
                                     std::make_pair(12000, 1u), std::make_pair(12000, 6u)})
  {
    const std::vector<std::uint8_t> is_outlier =
        outliers_of(cloud_of(sparse_posts(number, 0.02, 30., seed)));
    EXPECT_EQ(std::count(is_outlier.begin(), is_outlier.end(), 1), 0) << number << ' ' << seed;
  }
}

// Where all outliers are far, points that lose some votes to them are no outliers as well.
TEST(Outliers, that_are_far_leave_thin_parts_that_become_sparse)
{
  for (unsigned int seed : {1u, 2u})
  {
    std::vector<Point> points = sparse_posts(30000, 0.03, 10., seed);
    const std::size_t surface = points.size();
    add_outliers_in(CGAL::Bbox_3(-0.1, -0.1, -0.1, 1.2, 1.2, 1.1), surface / 20, seed + 200,
                    points);
    const Cloud cloud = cloud_of(points);
    const std::vector<std::uint8_t> is_outlier = outliers_of(cloud);
    std::size_t found = 0, lost = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i)
      if (is_outlier[i] != 0)
        ++(cloud.input_index[i] >= surface ? found : lost);
    EXPECT_LE(lost, 15u) << seed; // 33 and 46 if they were
    EXPECT_GT(found, surface / 20 * 98 / 100) << seed;
  }
}

TEST(Outliers, are_not_found_in_small_parts)
{
  const auto outliers_with = [](const std::vector<Point>& part) {
    std::vector<Point> points = surfaces::sphere(20000, 12);
    append(points, part);
    const Cloud cloud = cloud_of(points);
    const std::vector<std::uint8_t> is_outlier = outliers_of(cloud);
    std::size_t found = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i)
      found += cloud.input_index[i] >= 20000 && is_outlier[i] != 0 ? 1U : 0U;
    return found;
  };
  const auto moved = [](std::vector<Point> points, double scale) {
    for (Point& p : points)
      p = Point(2., 0., 0.) + scale * (p - CGAL::ORIGIN);
    return points;
  };
  EXPECT_LT(outliers_with(moved(with_noise(surfaces::square(60, 31), 0.02, 32), 0.2)), 6u);
  for (std::size_t n : {60u, 80u}) // thick as a whole, but not around each point
    EXPECT_EQ(outliers_with(moved(surfaces::sphere(n, 33), 0.1)), 0u);
  std::vector<Point> line; // of a scan: noise is as large as five points are apart
  for (int i = 0; i < 100; ++i)
    line.emplace_back(0.001 * i, 0., 0.);
  EXPECT_LT(outliers_with(moved(with_noise(line, 0.005, 34), 1.)), 5u);
  // Each place measured 20 times: those that have another near are no clusters.
  std::vector<Point> repeated;
  unsigned int seed = 100;
  for (const Point& p : surfaces::square(100, 35))
    append(repeated, cluster(20, p, 0.01, seed++));
  EXPECT_LT(outliers_with(moved(repeated, 0.5)), 1000u);
  // as large as a part that shows a shape
  EXPECT_LT(outliers_with(cluster(600, Point(2., 0., 0.), 0.02, 37)), 20u);
  EXPECT_EQ(outliers_with(cluster(200, Point(2., 0., 0.), 0.02, 37)), 200u);
  for (double noise : {0., 0.1, 0.18}) // a ball that shows a shape, with up to 0.7 spacings
    EXPECT_LT(outliers_with(moved(with_noise(surfaces::sphere(200, 38), noise, 39), 0.05)), 5u);
}

// What most points are is no outlier, and each sample needs a point to start from.
TEST(Outliers, are_left_in_where_fewer_points_than_samples_would_remain)
{
  std::vector<Point> points = surfaces::sphere(2000, 12);
  add_outliers(points, 400, 20., 14);
  const auto number_left_out = [&](std::size_t number_of_samples) {
    Cloud cloud = cloud_of(points);
    Shared_features shared = shared_features_of(cloud);
    const std::size_t before = cloud.size();
    leave_out_outliers<Tag>(cloud, shared, number_of_samples, Adaptive_settings(),
                            Progress(no_callback));
    return before - cloud.size();
  };
  const std::size_t found = number_left_out(100);
  ASSERT_GT(found, 100u);
  EXPECT_EQ(number_left_out(2400 - found), found);
  EXPECT_EQ(number_left_out(2401 - found), 0u);
}

TEST(Outliers, are_more_than_a_few_from_a_thousandth_on)
{
  EXPECT_FALSE(is_more_than_a_few(3, 999));
  EXPECT_TRUE(is_more_than_a_few(4, 999));
  EXPECT_FALSE(is_more_than_a_few(5, 2000));
  EXPECT_TRUE(is_more_than_a_few(6, 2000));
}

} // namespace
