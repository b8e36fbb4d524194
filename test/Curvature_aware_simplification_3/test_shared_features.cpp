// Features that points share with others near them

#include "inputs.h"

#include <CGAL/Curvature_aware_simplification_3/internal/features/features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/features/shared_features.h>
#include <CGAL/Curvature_aware_simplification_3/internal/input/Cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace {

using namespace inputs;

Local_features own_features(const Cloud& cloud, std::size_t i)
{
  return local_features<CGAL::Default_diagonalize_traits<double, 3>>(*cloud.search, cloud.points[i],
                                                                     17, cloud.coordinate_error);
}

TEST(Shared_features, are_those_of_a_point_in_whose_inner_half_one_is)
{
  const Cloud cloud = cloud_of(surfaces::torus(20000, 3., 1., 80));
  const Shared_features shared = shared_features_of(cloud);
  std::size_t number_of_votes = 0, number_represented = 0, representatives = 0;
  std::size_t votes_for_representatives = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i)
  {
    number_of_votes += shared.votes[i];
    number_represented += shared.represented[i];
    const Local_features own = own_features(cloud, i);
    if (shared.represented[i] > 0)
    {
      ++representatives;
      votes_for_representatives += shared.votes[i];
      EXPECT_EQ(shared.features.surface_variation[i], own.surface_variation);
      EXPECT_EQ(shared.features.inverse_density[i], own.inverse_density);
      continue;
    }
    // the representative: a flat neighborhood with the same values
    bool found = false;
    for (std::size_t j = 0; j < cloud.size() && !found; ++j)
      found = shared.represented[j] > 1 &&
              shared.features.inverse_density[j] == shared.features.inverse_density[i] &&
              shared.features.surface_variation[j] == shared.features.surface_variation[i] &&
              CGAL::squared_distance(cloud.points[i], cloud.points[j]) <=
                  8. * shared.features.inverse_density[j];
    EXPECT_TRUE(found) << i;
    EXPECT_LE(shared.features.surface_variation[i], 0.02);
    // two neighborhoods of random points
    EXPECT_LT(shared.features.inverse_density[i], 4. * own.inverse_density);
    EXPECT_GT(shared.features.inverse_density[i], 0.25 * own.inverse_density);
  }
  EXPECT_EQ(number_represented, cloud.size());
  EXPECT_EQ(number_of_votes, 16 * cloud.size());
  // as all points; those that they cast for others are no votes of their own
  EXPECT_NEAR(static_cast<double>(votes_for_representatives) / static_cast<double>(representatives),
              16., 0.5);
  EXPECT_LT(representatives, cloud.size() / 3);
}

TEST(Shared_features, are_own_ones_next_to_edges_and_amid_noise)
{
  // a roof of 90 degrees with a ridge at x = 0, and noise as wide as the spacing elsewhere
  std::vector<Point> roof;
  for (const Point& p : surfaces::square(20000, 81))
    roof.emplace_back(p.x() - 0.5, p.y(), -std::abs(p.x() - 0.5));
  for (const Point& p : with_noise(surfaces::square(20000, 82), 0.007, 83))
    roof.emplace_back(p.x() + 10., p.y(), p.z());
  const Cloud cloud = cloud_of(roof);
  const Shared_features shared = shared_features_of(cloud);
  std::size_t next_to_ridge = 0, own_next_to_ridge = 0, noisy = 0, own_noisy = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i)
  {
    const Point& p = roof[cloud.input_index[i]];
    const std::size_t own = shared.represented[i] > 0 ? 1 : 0;
    if (std::abs(p.x()) < 0.002) // a third of the spacing
    {
      ++next_to_ridge;
      own_next_to_ridge += own;
    }
    if (p.x() > 5.)
    {
      ++noisy;
      own_noisy += own;
    }
  }
  EXPECT_GT(own_next_to_ridge, 0.9 * static_cast<double>(next_to_ridge));
  EXPECT_GT(own_noisy, 0.95 * static_cast<double>(noisy));
}

// Of thousands of outliers, some few happen to be on a plane. Were all of them taken for as flat as
// the one in their middle, they would stay, and vote for each other.
TEST(Shared_features, are_own_ones_far_from_most_points)
{
  std::vector<Point> points = surfaces::square(20000, 87);
  CGAL::Random random(88);
  for (int i = 0; i < 20; ++i)
  {
    const Vector center(random.uniform_real(0., 1.), random.uniform_real(0., 1.), 1. + i);
    for (const Point& p : surfaces::sphere(30, 89 + static_cast<unsigned int>(i)))
      points.push_back(Point(0.1 * p.x(), 0.1 * p.y(), 0.) + center);
  }
  const Cloud cloud = cloud_of(points);
  const Shared_features shared = shared_features_of(cloud);
  int shared_votes = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (cloud.input_index[i] >= 20000)
    {
      shared_votes += shared.represented[i] > 1 ? 1 : 0;
      EXPECT_EQ(shared.features.inverse_density[i], own_features(cloud, i).inverse_density);
    }
  EXPECT_GT(shared_votes, 20);
}

TEST(Shared_features, are_the_same_for_every_tag)
{
  std::vector<Point> points = with_noise(surfaces::sphere(20000, 84), 0.002, 85);
  add_outliers(points, 1000, 1.2, 86);
  const Cloud cloud = cloud_of(points);
  const Shared_features parallel = shared_features_of(cloud);
  const Shared_features sequential =
      compute_shared_features<CGAL::Sequential_tag, CGAL::Default_diagonalize_traits<double, 3>>(
          cloud, 16, Progress(no_callback));
  EXPECT_EQ(parallel.features.surface_variation, sequential.features.surface_variation);
  EXPECT_EQ(parallel.features.inverse_density, sequential.features.inverse_density);
  EXPECT_EQ(parallel.represented, sequential.represented);
  EXPECT_EQ(parallel.votes, sequential.votes);
}

} // namespace
