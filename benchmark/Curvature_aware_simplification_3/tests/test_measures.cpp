// The measures on surfaces and point sets where the answer is known

#include <comparison/analytic_surfaces.h>
#include <comparison/degradations.h>
#include <comparison/measures.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace {

using namespace comparison;

TEST(Analytic_surfaces, points_lie_on_them_and_distances_are_exact)
{
  CGAL::Random random(1);
  for (const std::string& name : analytic_surface_names())
  {
    const Analytic_surface surface = analytic_surface(name);
    const Points points = sample(surface, 20000, 2);
    for (const Point& p : points)
      ASSERT_NEAR(surface.distance(p), 0., 1e-9) << name;

    // The nearest of many points is a bit farther than the surface; none is nearer.
    const double unit = diagonal(points);
    for (int i = 0; i < 50; ++i)
    {
      const Point q =
          points[static_cast<std::size_t>(i)] + 0.05 * unit * surfaces::random_direction(random);
      double nearest = 1e300;
      for (const Point& p : points)
        nearest = std::min(nearest, std::sqrt(CGAL::squared_distance(p, q)));
      EXPECT_LE(surface.distance(q), nearest + 1e-9) << name;
      EXPECT_GE(surface.distance(q), nearest - 0.01 * unit) << name;
    }
  }
}

TEST(Analytic_surfaces, are_sampled_uniformly_per_area)
{
  // shares of area in closed form: the half of the torus outside of its center line has
  // 1/2 + r / (pi R), and the caps of the box have 2 (4 - (4 - pi) 0.16) of the total
  const Points torus_points = sample(torus(), 100000, 3);
  const auto outside = std::count_if(torus_points.begin(), torus_points.end(),
                                     [](const Point& p) { return std::hypot(p.x(), p.y()) > 3.; });
  EXPECT_NEAR(static_cast<double>(outside) / 1e5, 0.5 + 1. / (3. * CGAL_PI), 0.01);

  const Points box_points = sample(rounded_box(), 100000, 3);
  const auto caps = std::count_if(box_points.begin(), box_points.end(),
                                  [](const Point& p) { return std::abs(p.z()) == 0.5; });
  const double cap_area = 2. * (4. - (4. - CGAL_PI) * 0.16), side_area = 4.8 + 0.8 * CGAL_PI;
  EXPECT_NEAR(static_cast<double>(caps) / 1e5, cap_area / (cap_area + side_area), 0.01);

  const Tube tube{Point(0., 0., 0.), Point(0., 0., 1.), 0.25};
  const Points tube_points =
      surfaces::sample(100000, 3, [&](CGAL::Random& random) { return tube.random_point(random); });
  const auto ends = std::count_if(tube_points.begin(), tube_points.end(),
                                  [](const Point& p) { return p.z() < 0. || p.z() > 1.; });
  EXPECT_NEAR(static_cast<double>(ends) / 1e5, 0.5 / 1.5, 0.01);
}

TEST(Degradations, do_what_they_say)
{
  const Points points = sample(sphere(), 20000, 4);
  const double unit = diagonal(points);
  EXPECT_EQ(degraded(points, "clean", 1), points);
  EXPECT_EQ(degraded(points, "noise:0.2", 1), degraded(points, "noise:0.2", 1));
  EXPECT_NE(degraded(points, "noise:0.2", 1), degraded(points, "noise:0.2", 2));

  const Points noisy = degraded(points, "noise:0.2", 1);
  double squares = 0.;
  for (std::size_t i = 0; i < points.size(); ++i)
    squares += CGAL::squared_distance(points[i], noisy[i]) / 3. / 20000.;
  EXPECT_NEAR(std::sqrt(squares) / (0.002 * unit), 1., 0.02);

  // on a sphere, x is uniform: so is the noise between 0.2 and 1.8 times the middle
  const Points uneven = degraded(points, "uneven_noise:0.2", 1);
  double left = 0., right = 0.;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const double square = CGAL::squared_distance(points[i], uneven[i]) / 3. / 2000.;
    left += points[i].x() < -0.8 ? square : 0.;
    right += points[i].x() > 0.8 ? square : 0.;
  }
  EXPECT_NEAR(std::sqrt(left) / (0.002 * unit), 0.2 + 1.6 * 0.05, 0.05);
  EXPECT_NEAR(std::sqrt(right) / (0.002 * unit), 0.2 + 1.6 * 0.95, 0.08);

  EXPECT_EQ(degraded(points, "outliers:5", 1).size(), 21000u);
  const Points clusters = degraded(points, "clusters:5", 1);
  EXPECT_GE(clusters.size(), 21000u);
  EXPECT_LT(clusters.size(), 21060u);
  std::size_t alone = 0;
  for (std::size_t i = 20002; i + 2 < clusters.size(); ++i)
  {
    const auto is_near = [&](std::size_t j) {
      return std::sqrt(CGAL::squared_distance(clusters[i], clusters[j])) < 0.05 * unit;
    };
    alone += is_near(i - 1) || is_near(i + 1) ? 0u : 1u;
  }
  EXPECT_EQ(alone, 0u);
  EXPECT_EQ(degraded(points, "duplicates:50", 1).size(), 30000u);

  const Points falling = degraded(points, "density:10", 1);
  // on a sphere, x is uniform: (1 - 1/10) / ln 10 of the points are left
  EXPECT_NEAR(static_cast<double>(falling.size()) / 20000., 0.9 / std::log(10.), 0.01);

  const Points with_a_hole = degraded(points, "hole:10", 1);
  // a cap within r of its pole has the area pi r^2 of 4 pi
  EXPECT_NEAR(1. - static_cast<double>(with_a_hole.size()) / 20000., 0.01 * unit * unit / 4.,
              0.003);

  // a tenth of the points, on planes that are 2 % of the diagonal apart
  const Points lines = degraded(points, "lines:2", 1);
  EXPECT_NEAR(static_cast<double>(lines.size()) / 20000., 0.1, 0.01);
  for (const Point& p : lines)
  {
    const double line = (p.x() + 2. * p.y() + 3. * p.z()) / std::sqrt(14.) / (0.02 * unit);
    EXPECT_LT(std::abs(line - std::round(line)), 0.0501);
  }
  const Points rounded = degraded({Point(0., 0., 0.), Point(2., 3., 6.)}, "rounding:10", 1);
  EXPECT_LT(CGAL::squared_distance(rounded[1], Point(2.1, 2.8, 6.3)), 1e-28); // the diagonal is 7
  // steps of a tenth of the diagonal 7 along (1, 2, 3) / sqrt(14), along which the second point is
  // 26 / sqrt(14) = 6.95 away: 10 steps are 0.05 more
  const Points steps = degraded({Point(0., 0., 0.), Point(2., 3., 6.)}, "depth:10", 1);
  EXPECT_EQ(steps[0], Point(0., 0., 0.));
  EXPECT_NEAR(steps[1].x(), 2. + (7. - 26. / std::sqrt(14.)) / std::sqrt(14.), 1e-12);
  EXPECT_NEAR(steps[1].z(), 6. + 3. * (7. - 26. / std::sqrt(14.)) / std::sqrt(14.), 1e-12);
  // the same along one of three directions
  const Points cameras = degraded(points, "cameras:10", 1);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_LE(std::sqrt(CGAL::squared_distance(cameras[i], points[i])), 0.05 * unit * (1. + 1e-12));
  std::array<std::size_t, 3> on_steps = {0, 0, 0};
  const std::array<Vector, 3> axes = {Vector(1., 2., 3.) / std::sqrt(14.),
                                      Vector(-4., 1., 1.) / std::sqrt(18.),
                                      Vector(2., -3., -2.) / std::sqrt(17.)};
  for (const Point& p : cameras)
    for (std::size_t camera = 0; camera < 3; ++camera)
    {
      const double depth = axes[camera] * (p - CGAL::ORIGIN) / (0.1 * unit);
      on_steps[camera] += std::abs(depth - std::round(depth)) < 1e-9 ? 1 : 0;
    }
  EXPECT_EQ(on_steps[0] + on_steps[1] + on_steps[2], points.size());
  EXPECT_GT(*std::min_element(on_steps.begin(), on_steps.end()), points.size() / 5);
  // ten times the same, but along (1, 2, 3)
  const Points frames = degraded({Point(0., 0., 0.), Point(2., 3., 6.)}, "frames:10", 1);
  ASSERT_EQ(frames.size(), 20u);
  EXPECT_NE(frames[0], frames[2]);
  EXPECT_NEAR(CGAL::cross_product(frames[0] - frames[2], Vector(1., 2., 3.)).squared_length(), 0.,
              1e-12);
  const Points shifted = degraded(points, "shift:1", 1);
  EXPECT_EQ(shifted[0], points[0]);
  EXPECT_NEAR(std::sqrt(CGAL::squared_distance(shifted[1], points[1])) / unit, 0.01, 1e-12);
  EXPECT_EQ(degraded(points, "density:10+noise:0.2", 1), degraded(falling, "noise:0.2", 2));
  EXPECT_THROW(degraded(points, "rust", 1), std::invalid_argument);
  EXPECT_THROW(degraded(points, "clean+rust", 1), std::invalid_argument);
}

TEST(Statistics, by_hand)
{
  std::vector<double> values;
  for (int i = 1; i <= 200; ++i)
    values.push_back(i);
  const Distance_statistics s = statistics(values);
  EXPECT_DOUBLE_EQ(s.mean, 100.5);
  EXPECT_DOUBLE_EQ(s.percentile_99, 198.);
  EXPECT_DOUBLE_EQ(s.maximum, 200.);
  EXPECT_NEAR(s.root_mean_square, std::sqrt(201. * 401. / 6.), 1e-9);
}

TEST(Mls_projection, recovers_a_sphere_and_a_known_offset)
{
  const Points points = sample(sphere(), 50000, 5);
  const Mls_projection projection(points);
  for (int i = 0; i < 200; ++i)
  {
    const Vector direction = points[static_cast<std::size_t>(i)] - CGAL::ORIGIN;
    for (double offset : {0., 0.003, -0.003})
    {
      const Point p = CGAL::ORIGIN + (1. + offset) * direction;
      EXPECT_NEAR(std::sqrt(CGAL::squared_distance(p, projection(p))), std::abs(offset), 2e-6);
    }
  }
}

Mesh octahedron()
{
  return {{Point(1, 0, 0), Point(-1, 0, 0), Point(0, 1, 0), Point(0, -1, 0), Point(0, 0, 1),
           Point(0, 0, -1)},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

TEST(Reference, of_an_octahedron)
{
  const Reference reference = reference_of(octahedron(), 1000, 1);
  EXPECT_TRUE(reference.border.empty());
  EXPECT_NEAR(reference.distance(Point(0, 0, 0)), 1. / std::sqrt(3.), 1e-12);
  EXPECT_NEAR(reference.distance(Point(0, 0, 3)), 2., 1e-12);
  for (const Point& p : reference.samples)
    EXPECT_NEAR(std::abs(p.x()) + std::abs(p.y()) + std::abs(p.z()), 1., 1e-12);

  Mesh open = octahedron();
  open.triangles.pop_back();
  const Points line = border(open, 0.01);
  EXPECT_NEAR(static_cast<double>(line.size()) * 0.01, 3. * std::sqrt(2.), 0.1);
}

TEST(Reconstruction_error, of_the_sphere_by_the_octahedron)
{
  const Mesh mesh_of_faces = octahedron();
  const Points samples = sample(sphere(), 20000, 6);
  double sum = 0.;
  for (const Point& p : samples)
  {
    double nearest = 1e300;
    for (const Triangle& t : mesh_of_faces.triangles)
      nearest = std::min(nearest,
                         CGAL::squared_distance(p, Kernel::Triangle_3(mesh_of_faces.points[t[0]],
                                                                      mesh_of_faces.points[t[1]],
                                                                      mesh_of_faces.points[t[2]])));
    sum += std::sqrt(nearest);
  }
  const Distance_statistics error = reconstruction_error(mesh_of_faces, samples);
  EXPECT_NEAR(error.mean, sum / 20000., 1e-9);
  EXPECT_NEAR(error.maximum, 1. - 1. / std::sqrt(3.), 0.001); // over the middle of a face

  // the mesh of many points on the sphere: s^2 / (8 R) times a factor near 1
  const Mesh mesh = reconstruct(sample(sphere(), 5000, 7));
  EXPECT_NEAR(static_cast<double>(mesh.triangles.size()), 10000., 100.);
  EXPECT_LT(reconstruction_error(mesh, sample(sphere(), 20000, 8)).mean, 0.002);
}

TEST(Curvature_bin, has_twenty_bins_up_to_two_and_twenty_above)
{
  EXPECT_EQ(curvature_bin(0.), 0u);
  EXPECT_EQ(curvature_bin(0.15), 1u);
  EXPECT_EQ(curvature_bin(1.99), 19u);
  EXPECT_EQ(curvature_bin(2.), 20u);
  EXPECT_EQ(curvature_bin(2.95), 21u);
  EXPECT_EQ(curvature_bin(20.), 39u);
}

// Poisson disks by dart throwing: candidates at random, kept where no other is within `radius`
Points blue_noise(const Points& candidates, double radius, std::size_t n)
{
  Points result;
  for (const Point& p : candidates)
    if (result.size() < n && std::none_of(result.begin(), result.end(), [&](const Point& q) {
          return CGAL::squared_distance(p, q) < radius * radius;
        }))
      result.push_back(p);
  return result;
}

TEST(Regularity, ranks_blue_noise_jittered_and_random_points)
{
  // 30 x 30 points on the unit square and on a torus with 4 pi^2 3 of area, all with kappa = 0 or
  // of the outer, middle and inner side
  CGAL::Random random(9);
  const std::size_t n = 900;
  const auto plane = [](double u, double v) { return Point(u, v, 0.); };
  const auto torus_map = [](double u, double v) {
    // equal area: v is the angle for which v + sin(v) / 3 is uniform, by fixed point iteration
    double angle = 2. * CGAL_PI * v;
    for (int i = 0; i < 50; ++i)
      angle = 2. * CGAL_PI * v - std::sin(angle) / 3.;
    const double r = 3. + std::cos(angle);
    return Point(r * std::cos(2. * CGAL_PI * u), r * std::sin(2. * CGAL_PI * u), std::sin(angle));
  };
  const auto test = [&](const auto& map, double area) {
    Points candidates, jittered, uniform;
    for (int i = 0; i < 100000; ++i)
    {
      const double u = random.uniform_real(0., 1.);
      candidates.push_back(map(u, random.uniform_real(0., 1.)));
    }
    for (std::size_t i = 0; i < n; ++i)
    {
      const double u = random.uniform_real(0., 1.) + static_cast<double>(i % 30);
      const double v = random.uniform_real(0., 1.) + static_cast<double>(i / 30);
      jittered.push_back(map(u / 30., v / 30.));
    }
    uniform.assign(candidates.end() - static_cast<std::ptrdiff_t>(n), candidates.end());
    const Points blue = blue_noise(candidates, 0.75 * std::sqrt(area / static_cast<double>(n)), n);
    ASSERT_GT(blue.size(), 800u);

    std::vector<double> m, variation;
    for (const Points* points : std::vector<const Points*>{&blue, &jittered, &uniform})
    {
      std::vector<double> curvature;
      for (const Point& p : *points)
        curvature.push_back(p.z() == 0. ? 0. : 4. - std::floor(std::hypot(p.x(), p.y())));
      m.push_back(regularity(*points, curvature, diagonal(*points)).m);
      variation.push_back(spacing_variation(*points));
    }
    EXPECT_LT(2. * m[0], m[1]);
    EXPECT_LT(1.3 * m[1], m[2]);
    EXPECT_LT(1.5 * variation[0], variation[1]);
    EXPECT_LT(1.2 * variation[1], variation[2]);
    EXPECT_NEAR(variation[2], 0.52, 0.08); // sqrt(4 / pi - 1) for random points in the plane
  };
  test(plane, 1.);
  test(torus_map, 12. * CGAL_PI * CGAL_PI);
}

TEST(Regularity, is_not_governed_by_a_few_points_of_high_curvature)
{
  // a square lattice, four points of which have a curvature of their own
  Points points;
  std::vector<double> curvature;
  for (int i = 0; i < 900; ++i)
  {
    points.emplace_back(i % 30, i / 30, 0.);
    curvature.push_back(i == 17 || i == 19 || i == 450 || i == 700 ? 15. : 0.);
  }
  const Regularity r = regularity(points, curvature, 1.);
  EXPECT_NEAR(r.m, 0., 1e-12);
  EXPECT_GT(r.as_stated, 0.1);
}

TEST(Border_distance, in_output_spacings)
{
  // a lattice of spacing 0.1 in the unit square that stays 0.1 away from the border
  Points lattice, border;
  for (int i = 1; i < 10; ++i)
    for (int j = 1; j < 10; ++j)
      lattice.emplace_back(0.1 * i, 0.1 * j, 0.);
  for (int i = 0; i <= 1000; ++i)
    border.emplace_back(i / 1000., 0., 0.);
  const Distance_statistics s = border_distance(lattice, border, 0.1);
  EXPECT_NEAR(s.maximum, std::sqrt(2.), 1e-9);
  EXPECT_GT(s.mean, 1.);
  EXPECT_LT(s.mean, 1.15);
}

TEST(Measure, of_a_perfect_and_of_a_shifted_result)
{
  Input input = make_input("sphere", 30000, "clean", 10);
  const Points output(input.clean.begin(), input.clean.begin() + 2000);
  const nlohmann::json perfect = measure(output, reconstruct(output), input, 0.1);
  EXPECT_LT(perfect["distance_max"], 1e-12);
  EXPECT_EQ(perfect["far_share"], 0.);
  EXPECT_EQ(perfect["points"], 2000);

  Points shifted;
  for (const Point& p : output)
    shifted.push_back(CGAL::ORIGIN + 1.1 * (p - CGAL::ORIGIN));
  const nlohmann::json bad = measure(shifted, reconstruct(shifted), input, 0.1);
  const double unit = diagonal(input.clean);
  EXPECT_NEAR(bad["distance_mean"].get<double>(), 0.1 / unit, 1e-9);
  EXPECT_NEAR(bad["delta_mls"].get<double>(), 0.1 / unit, 1e-3);
  EXPECT_EQ(bad["far_share"], 1.);
  EXPECT_NEAR(bad["recon_mean"].get<double>(), 0.1 / unit, 0.002);
}

} // namespace
