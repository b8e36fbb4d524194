#include <comparison/baselines/classical_lop.h>
#include <comparison/baselines/farthest_points.h>
#include <comparison/baselines/grid.h>
#include <comparison/baselines/hierarchy.h>
#include <comparison/baselines/mean_shift_clustering.h>
#include <comparison/baselines/mls_particle_simulation.h>
#include <comparison/baselines/stochastic_sampling.h>
#include <comparison/baselines/voxel_centroids.h>

#include "surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <ostream>
#include <string>
#include <vector>

namespace {

using namespace comparison;

const double major = 3., minor = 1.;

// 20000 points in an area of 4 pi^2 R r: a spacing of about 0.08
const Points& torus_points()
{
  static const Points points = surfaces::torus(20000, major, minor, 7);
  return points;
}

double largest_distance_to_torus(const Points& points)
{
  double largest = 0.;
  for (const Point& p : points)
    largest = std::max(largest, surfaces::distance_to_torus(p, major, minor));
  return largest;
}

double largest_distance_to_sphere(const Points& points)
{
  double largest = 0.;
  for (const Point& p : points)
    largest = std::max(largest, std::abs(std::sqrt((p - CGAL::ORIGIN).squared_length()) - 1.));
  return largest;
}

// by comparison of all pairs
double smallest_distance(const Points& points)
{
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      smallest = std::min(smallest, CGAL::squared_distance(points[i], points[j]));
  return std::sqrt(smallest);
}

bool is_subset(Points subset, Points points)
{
  std::sort(subset.begin(), subset.end());
  std::sort(points.begin(), points.end());
  return std::includes(points.begin(), points.end(), subset.begin(), subset.end());
}

std::size_t difference(std::size_t a, std::size_t b)
{
  return a < b ? b - a : a - b;
}

// O(N M), by definition
Points farthest_points_by_brute_force(const Points& points, std::size_t n)
{
  const Point centroid = CGAL::centroid(points.begin(), points.end(), CGAL::Dimension_tag<0>());
  std::vector<double> distance;
  for (const Point& p : points)
    distance.push_back(CGAL::squared_distance(p, centroid));
  Points result;
  while (result.size() < n)
  {
    const auto farthest = std::max_element(distance.begin(), distance.end());
    const Point next = points[static_cast<std::size_t>(farthest - distance.begin())];
    if (result.empty())
      std::fill(distance.begin(), distance.end(), std::numeric_limits<double>::infinity());
    result.push_back(next);
    for (std::size_t i = 0; i < points.size(); ++i)
      distance[i] = std::min(distance[i], CGAL::squared_distance(points[i], next));
  }
  return result;
}

TEST(FarthestPoints, EqualBruteForce)
{
  for (const Points& points : {surfaces::sphere(700, 1), surfaces::torus(1000, major, minor, 2)})
    EXPECT_EQ(farthest_points(points, 250), farthest_points_by_brute_force(points, 250));
}

TEST(FarthestPoints, AreAllPointsOnceWhenAllAreAskedFor)
{
  Points points = surfaces::sphere(100, 3);
  Points result = farthest_points(points, 1000);
  std::sort(points.begin(), points.end());
  std::sort(result.begin(), result.end());
  EXPECT_EQ(result, points);
}

TEST(FarthestPoints, TakeDuplicatesLast)
{
  Points points(50, Point(0., 0., 0.));
  points.push_back(Point(1., 0., 0.));
  points.push_back(Point(0., 2., 0.));
  const Points result = farthest_points(points, 5);
  EXPECT_EQ(result, (Points{Point(0., 2., 0.), Point(1., 0., 0.), Point(0., 0., 0.),
                            Point(0., 0., 0.), Point(0., 0., 0.)}));
}

TEST(FarthestPoints, OfNothing)
{
  EXPECT_TRUE(farthest_points({}, 3).empty());
  EXPECT_TRUE(farthest_points({Point(1., 2., 3.)}, 0).empty());
}

TEST(VoxelCentroids, ByHand)
{
  // cells of 1 from (0, 0, 0): two, one and two points
  const Points points = {Point(0., 0., 0.), Point(0.5, 0.25, 0.), Point(1.5, 0., 0.),
                         Point(0.25, 3., 1.), Point(0.75, 3.5, 1.5)};
  EXPECT_EQ(voxel_centroids(points, 1.),
            (Points{Point(0.25, 0.125, 0.), Point(0.5, 3.25, 1.25), Point(1.5, 0., 0.)}));
}

TEST(VoxelCentroids, RefuseCellsThatKeysCannotTell)
{
  EXPECT_THROW(voxel_centroids({Point(0., 0., 0.), Point(1., 0., 0.)}, 1e-7),
               std::invalid_argument);
}

TEST(VoxelCentroids, OfCoincidingPoints)
{
  EXPECT_EQ(voxel_centroids_to_count(Points(5, Point(1., 1., 1.)), 3).size(), 1u);
}

TEST(Grid, KeepsOnePointPerCell)
{
  const Points points = grid_points(torus_points(), 0.5);
  EXPECT_TRUE(is_subset(points, torus_points()));
  std::vector<std::vector<double>> cells;
  for (const Point& p : points)
    cells.push_back({std::floor(p.x() / 0.5), std::floor(p.y() / 0.5), std::floor(p.z() / 0.5)});
  std::sort(cells.begin(), cells.end());
  EXPECT_EQ(std::adjacent_find(cells.begin(), cells.end()), cells.end());
}

TEST(Hierarchy, OfVariationComesAsNearAsTheSizeAllows)
{
  const std::size_t n = 2000;
  const std::size_t count = hierarchy_points_of_variation(torus_points(), n, 0.05).size();
  // n / (2 M), with M above |P| / n
  EXPECT_NEAR(static_cast<double>(count), 2000., 2000. / (2. * 10.));
}

TEST(Hierarchy, KeepsMoreWhereTheSizeForcesIt)
{
  // clusters of at most 4 points are at least 5000
  EXPECT_GE(hierarchy_points_of_size(torus_points(), 2000, 4).size(), 5000u);
}

TEST(StochasticSampling, PrefersCurvature)
{
  // the poles of the ellipsoid, above half of its height, bend more than its waist
  const Points ellipsoid = surfaces::ellipsoid(20000, 3., 5);
  const auto share_at_poles = [](const Points& points) {
    const auto count = std::count_if(points.begin(), points.end(),
                                     [](const Point& p) { return std::abs(p.z()) > 2.5; });
    return static_cast<double>(count) / static_cast<double>(points.size());
  };
  EXPECT_GT(share_at_poles(stochastic_sampling(ellipsoid, 4000)), 1.5 * share_at_poles(ellipsoid));
}

TEST(RandomSubset, FollowsTheWeights)
{
  Points points;
  std::vector<double> weights;
  for (int i = 0; i < 30000; ++i)
  {
    points.emplace_back(i, 0., 0.);
    weights.push_back(i % 3); // 0, 1, 2
  }
  const Points subset = random_subset(points, weights, 1000, 1);
  ASSERT_EQ(subset.size(), 1000u);
  std::vector<int> count(3, 0);
  for (const Point& p : subset)
    ++count[static_cast<std::size_t>(p.x()) % 3];
  EXPECT_EQ(count[0], 0);
  EXPECT_NEAR(count[1], 333, 60); // four standard deviations
}

// Two particles at (-+1, 0, 0), points at (-+1, -+1, 0). By symmetry the first iteration changes
// nothing but the distance to the other pair, whose weight is theta(sqrt 5) / theta(1).
TEST(ClassicalLop, SymmetricConfigurationByHand)
{
  const Points points = {Point(-1., -1., 0.), Point(-1., 1., 0.), Point(1., -1., 0.),
                         Point(1., 1., 0.)};
  const Points particles = {Point(-1., 0., 0.), Point(1., 0., 0.)};
  const double h = 8., mu = 0.3;
  const auto theta = [=](double squared) { return std::exp(-16. * squared / (h * h)); };
  const Locally_optimal_projection projection(points, h, mu);

  // weighted mean of x = -1 and x = 1
  const double mean = (theta(5.) - theta(1.)) / (theta(5.) + theta(1.));
  const Points first = projection.first_iteration(particles);
  EXPECT_NEAR(first[0].x(), mean, 1e-12);
  EXPECT_NEAR(first[0].y(), 0., 1e-12);
  EXPECT_NEAR(first[1].x(), -mean, 1e-12);

  // local median, and repulsion by mu times the vector from the only other particle
  const double near = theta(1.), far = theta(5.) / std::sqrt(5.);
  const double median = (far - near) / (far + near);
  const Points second = projection.iteration(particles);
  EXPECT_NEAR(second[0].x(), median - 2. * mu, 1e-9);
  EXPECT_NEAR(second[1].x(), -median + 2. * mu, 1e-9);
  EXPECT_NEAR(second[1].y(), 0., 1e-9);
}

// Of two other particles at the distances 1 and 2 on the same line, the weights of the repulsion
// are theta(1) and theta(2) / 2^5.
TEST(ClassicalLop, RepulsionFallsWithTheFifthPowerOfTheDistance)
{
  const double h = 8., mu = 0.45;
  const Locally_optimal_projection projection({Point(0., 0., 0.)}, h, mu);
  const Points particles = {Point(0., 0., 0.), Point(1., 0., 0.), Point(-2., 0., 0.)};
  const double near = std::exp(-16. / 64.), far = std::exp(-64. / 64.) / 32.;
  EXPECT_NEAR(projection.iteration(particles)[0].x(), mu * (2. * far - near) / (near + far), 1e-9);
}

TEST(ClassicalLop, ToleratesParticlesOnPointsAndOnEachOther)
{
  const Points points(3, Point(0., 0., 0.));
  for (const Point& p : classical_lop(points, 3, 1., 5))
    EXPECT_EQ(p, Point(0., 0., 0.));
}

TEST(MeanShift, ClustersRespectSizeAndVariation)
{
  const Points points = surfaces::torus(4000, major, minor, 11);
  const Mean_shift_clustering clustering(points, 30);
  std::vector<bool> seen(points.size(), false);
  for (const auto& cluster : clustering.clusters(0.01))
  {
    EXPECT_LE(cluster.size(), 30u);
    Moments moments(points[cluster.front()]);
    for (std::size_t i : cluster)
    {
      EXPECT_FALSE(seen[i]);
      seen[i] = true;
      moments.add(1., points[i]);
    }
    EXPECT_LE(moments.principal_axes().variation(), 0.01);
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), true), 4000);
}

// groups of 10 points in balls of radius 0.1 around the integer points of a line
TEST(MeanShift, ModesAreTheDenseSpots)
{
  CGAL::Random random(1);
  Points points;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 10; ++j)
      points.push_back(Point(i, 0., 0.) +
                       random.uniform_real(0., 0.1) * surfaces::random_direction(random));
  for (const auto& cluster : Mean_shift_clustering(points, 10).clusters(1. / 3.))
  {
    ASSERT_LE(cluster.size(), 10u);
    for (std::size_t i : cluster)
      EXPECT_EQ(i / 10, cluster.front() / 10);
  }
}

TEST(MeanShift, OfCoincidingPoints)
{
  const Points points(8, Point(1., 2., 3.));
  EXPECT_EQ(mean_shift_points(points, 4, 0.01), Points(2, Point(1., 2., 3.)));
}

TEST(PointSetSurface, ProjectsOntoSphereAndPlane)
{
  const Points sphere_points = surfaces::sphere(5000, 1), plane_points = surfaces::square(2000, 1);
  const Point_set_surface sphere(sphere_points, 24), plane(plane_points, 24);
  CGAL::Random random(3);
  for (int i = 0; i < 100; ++i)
  {
    const Vector direction = surfaces::random_direction(random);
    const Point p = sphere.project(CGAL::ORIGIN + random.uniform_real(0.97, 1.03) * direction);
    // spacing 0.05: a plane would be off by 1e-3, the polynomial is exact to the fourth order
    EXPECT_NEAR(std::sqrt((p - CGAL::ORIGIN).squared_length()), 1., 1e-4);
    const Point q(random.uniform_real(0.1, 0.9), random.uniform_real(0.1, 0.9), 0.01);
    EXPECT_NEAR(plane.project(q).z(), 0., 1e-12);
  }
}

TEST(ParticleSimulation, StaysOnThePlaneAndRepels)
{
  const Points square = surfaces::square(5000, 1);
  Particle_simulation_parameters parameters;
  parameters.iterations = 0;
  const Points before = mls_particle_simulation(square, 500, parameters);
  parameters.iterations = 40;
  const Points after = mls_particle_simulation(square, 500, parameters);
  ASSERT_EQ(after.size(), 500u);
  for (const Point& p : after)
    EXPECT_NEAR(p.z(), 0., 1e-12);
  // 500 on a square of side 1 are 0.048 apart on a hexagonal lattice
  EXPECT_LT(smallest_distance(before), 0.01);
  EXPECT_GT(smallest_distance(after), 0.02);
}

// F = k (r - d) d / r pushes two particles apart by twice that, in the plane
TEST(ParticleSimulation, ForceByHand)
{
  const Points square = surfaces::square(5000, 1);
  const Particle_simulation_parameters parameters;
  const Particle_simulation simulation(square, parameters);
  const double r = 0.1, d = 0.04;
  const Points moved = simulation.iteration({Point(0.5, 0.5, 0.), Point(0.5 + d, 0.5, 0.)}, r);
  EXPECT_NEAR(moved[1].x() - moved[0].x(), d + 2. * parameters.force_constant * (r - d) * d / r,
              1e-12);
  EXPECT_NEAR(moved[0].y(), 0.5, 1e-12);
  EXPECT_NEAR(moved[0].z(), 0., 1e-12);
}

TEST(ParticleSimulation, IsDenserWhereTheSurfaceBends)
{
  const Points ellipsoid = surfaces::ellipsoid(20000, 3., 5);
  const auto at_poles = [&](double scale) {
    Particle_simulation_parameters parameters;
    parameters.scale = scale;
    const Points points = mls_particle_simulation(ellipsoid, 2000, parameters);
    return std::count_if(points.begin(), points.end(),
                         [](const Point& p) { return std::abs(p.z()) > 2.5; });
  };
  EXPECT_GT(at_poles(0.003), 1.25 * static_cast<double>(at_poles(1e9)));
}

// what holds for all methods
struct Baseline
{
  std::string name;
  std::function<Points(const Points&, std::size_t)> run;
  bool is_subset;
  std::size_t count_tolerance;
  double torus_error, sphere_error; // bounds of the distance to the surface
};

// for the messages of GoogleTest, which print the bytes of an object otherwise
void PrintTo(const Baseline& baseline, std::ostream* stream)
{
  *stream << baseline.name;
}

// 2000 of 20000 points: the torus has an output spacing h of 0.26 and the sphere of 0.085.
// Centroids of a cell of that size, and medians, are off by up to h^2 / 2 with a curvature of 1.
class All_baselines : public testing::TestWithParam<Baseline>
{};

TEST_P(All_baselines, ReachTheCountOnTheSurfaceAndAreDeterministic)
{
  const std::size_t n = 2000;
  const Points torus = GetParam().run(torus_points(), n);
  EXPECT_LE(difference(torus.size(), n), GetParam().count_tolerance);
  EXPECT_LE(largest_distance_to_torus(torus), GetParam().torus_error);
  EXPECT_EQ(torus, GetParam().run(torus_points(), n));
  if (GetParam().is_subset)
  {
    EXPECT_TRUE(is_subset(torus, torus_points()));
  }

  const Points points = surfaces::sphere(20000, 5);
  const Points sphere = GetParam().run(points, n);
  EXPECT_LE(difference(sphere.size(), n), GetParam().count_tolerance);
  EXPECT_LE(largest_distance_to_sphere(sphere), GetParam().sphere_error);
}

INSTANTIATE_TEST_SUITE_P(
    Baselines, All_baselines,
    testing::Values(Baseline{"farthest_points", farthest_points, true, 0, 1e-12, 1e-12},
                    Baseline{"voxel_centroids", voxel_centroids_to_count, false, 0, 0.04, 0.004},
                    Baseline{"grid", grid_points_to_count, true, 0, 1e-12, 1e-12},
                    Baseline{"hierarchy",
                             [](const Points& points, std::size_t n) {
                               return hierarchy_points_of_size(points, n, 30);
                             },
                             true, 2, 1e-12, 1e-12},
                    Baseline{"stochastic_sampling",
                             [](const Points& points, std::size_t n) {
                               return stochastic_sampling(points, n);
                             },
                             true, 0, 1e-12, 1e-12},
                    Baseline{"classical_lop",
                             [](const Points& points, std::size_t n) {
                               return classical_lop(points, n, 2.5 * diagonal(points) / 100., 10);
                             },
                             false, 0, 0.04, 0.004},
                    Baseline{"mean_shift",
                             [](const Points& points, std::size_t n) {
                               return mean_shift_points_of_size(points, n, 30);
                             },
                             false, 2, 0.004, 4e-4},
                    Baseline{"particle_simulation",
                             [](const Points& points, std::size_t n) {
                               return mls_particle_simulation(points, n);
                             },
                             false, 0, 0.004, 4e-4}),
    [](const auto& info) { return info.param.name; });

} // namespace
