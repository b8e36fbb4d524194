// Loops, and the indices, sums and random numbers that they hand out

#include "inputs.h"

#include <CGAL/Curvature_aware_simplification_3/internal/input/Cloud.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Counter_based_random.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/Curve_ranges.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/index_selection.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/loops.h>
#include <CGAL/Curvature_aware_simplification_3/internal/tools/sum_up.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <type_traits>
#include <vector>

namespace {

using namespace inputs;

TEST(Random, is_uniform_and_independent_of_index_seed_and_stream)
{
  const Counter_based_random random(7, 0), other_seed(8, 0), other_stream(7, 1);
  double sum = 0., product = 0., product_seed = 0., product_stream = 0.;
  std::vector<int> histogram(16, 0);
  const int n = 100000;
  for (int i = 0; i < n; ++i)
  {
    const std::uint64_t index = static_cast<std::uint64_t>(i);
    const double u = random.uniform(index);
    ASSERT_GE(u, 0.);
    ASSERT_LT(u, 1.);
    sum += u;
    product += (u - 0.5) * (random.uniform(index + 1) - 0.5);
    product_seed += (u - 0.5) * (other_seed.uniform(index) - 0.5);
    product_stream += (u - 0.5) * (other_stream.uniform(index) - 0.5);
    ++histogram[static_cast<std::size_t>(16. * u)];
  }
  // five standard deviations: of the mean sqrt(1/12/n), of the correlations 1/12/sqrt(n)
  EXPECT_NEAR(sum / n, 0.5, 5. * std::sqrt(1. / 12. / n));
  for (double p : {product, product_seed, product_stream})
    EXPECT_NEAR(p / n, 0., 5. / 12. / std::sqrt(n));
  for (int count : histogram)
    EXPECT_NEAR(count, n / 16., 5. * std::sqrt(n / 16.));
}

TEST(Curve_ranges, are_even_for_any_number_of_points)
{
  const auto expect_even = [](const Curve_ranges& ranges) {
    const std::size_t n = ranges.number_of_points;
    EXPECT_EQ(ranges.first_point(0), 0u);
    EXPECT_EQ(ranges.first_point(ranges.number), n);
    for (std::size_t i : {std::size_t(0), n / 7, n / 2, n - 2, n - 1})
    {
      const std::size_t range = ranges.range_of(i);
      EXPECT_LE(ranges.first_point(range), i);
      EXPECT_LT(i, ranges.first_point(range + 1));
      EXPECT_LE(ranges.size(range), n / ranges.number + 1);
    }
  };
  for (std::size_t number : {1u, 3u, 10u, 19u})
    expect_even({number, 10});
  for (std::size_t number :
       {7u, 1000003u, 2147483649u}) // the number of points times that of ranges has 71 bits
    expect_even({number, std::size_t(1) << 40});
  EXPECT_EQ((Curve_ranges{3, 10}.range_of(3)), 0u); // points 0 to 3, 4 to 6, 7 to 9
  EXPECT_EQ((Curve_ranges{3, 10}.range_of(4)), 1u);
  EXPECT_EQ((Curve_ranges{3, 10}.range_of(7)), 2u);
}

// sizes around those where a call of a loop takes one, two and at most 64 indices
TEST(Loops, visit_each_index_once)
{
  for (std::size_t size : {0u, 1u, 1023u, 1024u, 1025u, 2049u, 65535u, 65536u, 100001u})
  {
    const std::size_t begin = 7;
    std::vector<int> visits(begin + size + 100, 0), expected = visits;
    std::fill_n(expected.begin() + 7, size, 1);
    for_each_index<Tag>(begin, begin + size, [&](std::size_t i) { ++visits[i]; });
    EXPECT_EQ(visits, expected) << size;
  }
}

TEST(Loops, report_progress_after_blocks_that_threads_can_share)
{
  const auto reports = [](std::size_t size) {
    std::vector<double> result;
    const std::function<bool(double)> record = [&](double share) {
      result.push_back(share);
      return true;
    };
    std::vector<int> visits(size);
    for_each_index<Tag>(size, Progress(record), [&](std::size_t i) { ++visits[i]; });
    EXPECT_EQ(visits, std::vector<int>(size, 1));
    return result;
  };
  EXPECT_EQ(reports(20), std::vector<double>({1.}));
  EXPECT_EQ(reports(127), std::vector<double>({64. / 127., 1.}));
  EXPECT_EQ(reports(1000).size(), 16u);
  EXPECT_EQ(reports(100000).size(), 20u);
}

// Beyond 2^32, without as many points: loops hand out the indices they are given, counts and random
// numbers tell apart what is equal in 32 bits, and whatever stores an index has room for it.
TEST(Loops, count_in_64_bits)
{
  const std::size_t across = (std::size_t(1) << 32) - 500;
  std::vector<int> visits(1000, 0);
  for_each_index<Tag>(across, across + visits.size(), [&](std::size_t i) { ++visits[i - across]; });
  EXPECT_EQ(visits, std::vector<int>(1000, 1));

  EXPECT_EQ(percentage_of(50., std::size_t(1) << 36), std::size_t(1) << 35);
  const std::size_t five_billions = 5000000000u;
  EXPECT_EQ(checked_count("n", five_billions, 1, (std::numeric_limits<std::size_t>::max)(), ""),
            five_billions);

  const Counter_based_random random(0, 0);
  EXPECT_NE(random.bits(7), random.bits((std::uint64_t(1) << 32) + 7));

  static_assert(sizeof(decltype(Cloud::input_index)::value_type) == 8, "indices of input points");
  static_assert(sizeof(Duplicate::index) == 8 && sizeof(Duplicate::first) == 8, "of duplicates");
  static_assert(sizeof(decltype(select_along_curve<Tag>({1, 1}, {}, 0, 0))::value_type) == 8,
                "of samples");
}

// sizes around that of a block, in which the rounds meet
TEST(Indices, finds_indices_in_order)
{
  for (std::size_t size : {0u, 1u, 4095u, 4096u, 4097u, 100003u})
  {
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < size; ++i)
      if (i % 7 == 3 || i / 4096 == 2)
        expected.push_back(i);
    const auto predicate = [](std::size_t i) { return i % 7 == 3 || i / 4096 == 2; };
    EXPECT_EQ(indices_where<Tag>(size, predicate), expected);
    EXPECT_EQ(indices_where<CGAL::Sequential_tag>(size, predicate), expected);
  }
  EXPECT_EQ(elements_at<Tag>({2, 0}, std::vector<int>{7, 8, 9}), (std::vector<int>{9, 7}));
  Flags flags(5, 0);
  set_flags<Tag>(flags, {1, 4, 2}, 1);
  set_flags<Tag>(flags, {2}, 0);
  EXPECT_EQ(flags, (Flags{0, 1, 0, 0, 1}));
  EXPECT_EQ(flagged_indices<Tag>(flags), (std::vector<std::size_t>{1, 4}));
  const auto is_odd = [](std::size_t i) { return i % 2 == 1; };
  EXPECT_EQ(those_where<Tag>({7, 4, 3}, is_odd), (std::vector<std::size_t>{7, 3}));
}

TEST(Indices, keeps_elements_in_place)
{
  for (std::size_t size : {0u, 1u, 4097u, 900001u})
  {
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < size; ++i)
      if (i % 7 != 3 && i / 4096 != 2)
        kept.push_back(i);
    std::vector<std::size_t> elements(size), sequential(size);
    for (std::size_t i = 0; i < size; ++i)
      elements[i] = sequential[i] = 3 * i + 1;
    const std::size_t* memory = elements.data();
    keep_elements<Tag>(kept, elements);
    keep_elements<CGAL::Sequential_tag>(kept, sequential);
    EXPECT_EQ(elements.data(), memory);
    ASSERT_EQ(elements.size(), kept.size());
    for (std::size_t i = 0; i < kept.size(); ++i)
      ASSERT_EQ(elements[i], 3 * kept[i] + 1);
    EXPECT_EQ(sequential, elements);
  }
}

TEST(Indices, sums_up)
{
  for (std::size_t size : {0u, 1u, 4096u, 4097u, 100003u})
  {
    std::vector<double> values(size), expected(size);
    double sum = 0.;
    for (std::size_t i = 0; i < size; ++i)
      expected[i] = sum += values[i] = static_cast<double>(i % 11); // exact: integers
    sum_up<Tag>(values);
    EXPECT_EQ(values, expected);
  }
  std::vector<double> parallel(100003, 0.1), sequential(100003, 0.1);
  sum_up<Tag>(parallel);
  sum_up<CGAL::Sequential_tag>(sequential);
  EXPECT_EQ(parallel, sequential);
  EXPECT_TRUE(std::is_sorted(parallel.begin(), parallel.end()));
}

TEST(Loops, sums_do_not_depend_on_the_tag)
{
  const auto value = [](std::size_t i) { return 1. / (1. + static_cast<double>(i)); };
  const double sequential = mean<CGAL::Sequential_tag>(100003, value);
  EXPECT_EQ(sequential, mean<Tag>(100003, value));
  EXPECT_NEAR(sequential * 100003., std::log(100003.) + 0.5772156649, 1e-5);
}

} // namespace
