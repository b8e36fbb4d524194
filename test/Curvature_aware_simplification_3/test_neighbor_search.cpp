// The search for neighbors, against brute force

#include "inputs.h"

#include <CGAL/Curvature_aware_simplification_3/internal/tools/Neighbor_search.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <set>
#include <vector>

namespace {

using namespace inputs;

// Distributions that trouble search structures
std::vector<std::vector<Point>> distributions()
{
  CGAL::Random random(5);
  std::vector<Point> cube, lattice, line, clusters;
  for (int i = 0; i < 500; ++i)
  {
    const double x = random.uniform_real(0., 1.), y = random.uniform_real(0., 1.);
    cube.emplace_back(x, y, random.uniform_real(0., 1.));
    lattice.emplace_back(i % 8, (i / 8) % 8, i / 64);
    line.emplace_back(x, 2. * x, -x);
    clusters.emplace_back(x * 1e-8 + i % 2, y * 1e-8, 0.);
  }
  return {cube, lattice, line, clusters, {Point(1, 2, 3)}};
}

// without the points that are hidden
void expect_neighbors_as_by_brute_force(const Neighbor_search& search,
                                        const std::vector<Point>& points,
                                        const std::vector<std::uint8_t>& is_hidden)
{
  for (std::size_t q = 0; q < points.size(); q += 17)
  {
    const Point query = points[q] + Vector(1e-3, 0., 0.);
    std::vector<double> all, sorted;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      all.push_back(CGAL::squared_distance(query, points[i]));
      if (is_hidden[i] == 0)
        sorted.push_back(all[i]);
    }
    std::sort(sorted.begin(), sorted.end());

    const std::size_t k = 17; // or as many as there are
    std::vector<double> nearest;
    search.for_each_nearest(query, k, [&](std::size_t i, const Point& p, double squared_distance) {
      EXPECT_EQ(is_hidden[i], 0);
      EXPECT_EQ(p, points[i]);
      EXPECT_DOUBLE_EQ(squared_distance, all[i]);
      nearest.push_back(all[i]);
    });
    std::sort(nearest.begin(), nearest.end());
    sorted.resize((std::min)(k, sorted.size()));
    EXPECT_EQ(nearest, sorted); // distances and not indices: ties have no order

    const double radius = 1.001 * std::sqrt(sorted.back());
    std::set<std::size_t> expected, found;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (is_hidden[i] == 0 && all[i] <= radius * radius)
        expected.insert(i);
    search.for_each_within(query, radius,
                           [&](std::size_t i, const Point&, double) { found.insert(i); });
    EXPECT_EQ(found, expected);
    for (std::size_t most : {std::size_t(0), std::size_t(3), expected.size(), points.size()})
    {
      found.clear();
      search.for_each_within(
          query, radius, [&](std::size_t i, const Point&, double) { found.insert(i); }, most);
      EXPECT_EQ(found.size(), (std::min)(most + 1, expected.size()));
      EXPECT_TRUE(std::includes(expected.begin(), expected.end(), found.begin(), found.end()));
    }
    std::size_t asked = 0, even = 0;
    const auto is_even = [&](std::size_t i, const Point&, double) {
      ++asked;
      even += i % 2 == 0 ? 1 : 0;
      return i % 2 == 0;
    };
    const auto expected_even = static_cast<std::size_t>(
        std::count_if(expected.begin(), expected.end(), [](std::size_t i) { return i % 2 == 0; }));
    EXPECT_FALSE(search.are_more_within(query, radius, expected_even, is_even));
    EXPECT_EQ(asked, expected.size());
    EXPECT_EQ(even, expected_even);
    if (expected_even > 0)
    {
      even = 0;
      EXPECT_TRUE(search.are_more_within(query, radius, expected_even / 2, is_even));
      EXPECT_EQ(even, expected_even / 2 + 1); // and it stops
    }
  }
}

TEST(Neighbor_search, agrees_with_brute_force)
{
  for (const std::vector<Point>& points : distributions())
  {
    Neighbor_search search(points, Tag());
    const std::size_t n = points.size();
    std::vector<std::uint8_t> is_hidden(n, 0);
    expect_neighbors_as_by_brute_force(search, points, is_hidden);
    // every third; all near one; all but one
    for (std::size_t i = 1; i < n; i += 3)
      is_hidden[i] = 1;
    search.hide(is_hidden);
    expect_neighbors_as_by_brute_force(search, points, is_hidden);
    std::vector<std::size_t> by_distance(n);
    std::iota(by_distance.begin(), by_distance.end(), std::size_t(0));
    std::sort(by_distance.begin(), by_distance.end(), [&](std::size_t i, std::size_t j) {
      return CGAL::has_smaller_distance_to_point(points[0], points[i], points[j]);
    });
    for (std::size_t hidden : {n / 2, n - 1})
    {
      std::fill(is_hidden.begin(), is_hidden.end(), std::uint8_t(0));
      for (std::size_t i = 0; i < hidden; ++i)
        is_hidden[by_distance[i]] = 1;
      search.hide(is_hidden);
      EXPECT_EQ(search.size(), n - hidden);
      expect_neighbors_as_by_brute_force(search, points, is_hidden);
    }
    std::size_t found = 0;
    search.for_each_nearest(points[0], n + 1, [&](std::size_t, const Point&, double) { ++found; });
    EXPECT_EQ(found, 1u); // all that are left
  }
}

TEST(Neighbor_search, of_equal_points_is_not_as_deep_as_they_are_many)
{
  // with one point less at each level, the stack would overflow
  std::vector<Point> points(300000, Point(1., 2., 3.));
  const auto number_at = [](const std::vector<Point>& at, const Point& x, std::size_t k) {
    const Neighbor_search search(at, Tag());
    std::size_t number = 0;
    search.for_each_nearest(x, k, [&](std::size_t, const Point&, double squared_distance) {
      number += squared_distance == 0. ? 1 : 0;
    });
    return number;
  };
  EXPECT_EQ(number_at(points, points.front(), 20), 20u);
  EXPECT_EQ(number_at(points, points.front(), points.size()), points.size());

  // nor if they are at two places with no number in between
  const Point other(std::nextafter(1., 2.), 2., 3.);
  std::fill_n(points.begin(), 100000, other);
  EXPECT_EQ(number_at(points, other, 200000), 100000u);
  EXPECT_EQ(number_at(points, points.back(), points.size()), 200000u);
}

TEST(Neighbor_search, tells_how_far_the_nearest_are)
{
  const std::vector<Point> points = {Point(0., 0., 0.), Point(3., 0., 0.), Point(0., 1., 0.)};
  const Neighbor_search search(points, Tag());
  EXPECT_EQ(search.squared_distance_of_nearest(points[0], 1), 0.);
  EXPECT_EQ(search.squared_distance_of_nearest(points[0], 2), 1.);
  EXPECT_EQ(search.squared_distance_of_nearest(points[0], 3), 9.);
  EXPECT_EQ(search.squared_distance_of_nearest(points[0], 4), 9.);
}

} // namespace
