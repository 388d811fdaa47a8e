#include "experiment/axis_sample.hpp"

#include "experiment/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace lamprey::experiment {
namespace {

const Parameter& whole() {
  return *find_parameter("cycles");
}
const Parameter& real() {
  return *find_parameter("temperature");
}

std::vector<Value> whole_sample(std::uint64_t seed, std::uint64_t count, std::int64_t from, std::int64_t to) {
  return axis_sample(whole(), seed, count, from, to).value();
}

TEST(AxisSample, HasDifferentValuesWithinItsRangeInOrder) {
  for (const std::uint64_t seed : {0U, 1U, 2006U}) {
    const auto values = whole_sample(seed, 100, 50, 300);
    ASSERT_EQ(values.size(), 100U);
    EXPECT_TRUE(std::ranges::is_sorted(values));
    EXPECT_EQ(std::set<Value>(values.begin(), values.end()).size(), 100U);
    EXPECT_GE(std::get<std::int64_t>(values.front()), 50);
    EXPECT_LE(std::get<std::int64_t>(values.back()), 300);
  }
}

TEST(AxisSample, OfAsManyAsThereAreIsAllOfThem) {
  const std::vector<Value> all = {Value(std::int64_t{3}), Value(std::int64_t{4}), Value(std::int64_t{5})};
  EXPECT_EQ(whole_sample(1, 3, 3, 5), all);
  EXPECT_EQ(axis_sample(whole(), 1, 4, Value(std::int64_t{3}), Value(std::int64_t{5})), std::nullopt);
  EXPECT_EQ(axis_sample(real(), 1, 1, Value(2.5), Value(2.5)), std::vector<Value>{Value(2.5)});
  EXPECT_EQ(axis_sample(real(), 1, 2, Value(2.5), Value(2.5)), std::nullopt);
}

TEST(AxisSample, FollowsFromSeedAndParameterAlone) {
  const auto values = whole_sample(1, 20, 1, 1'000'000);
  EXPECT_EQ(values, whole_sample(1, 20, 1, 1'000'000));
  EXPECT_NE(values, whole_sample(2, 20, 1, 1'000'000));
  const auto other =
      axis_sample(*find_parameter("time_steps"), 1, 20, Value(std::int64_t{1}), Value(std::int64_t{1'000'000}));
  EXPECT_NE(values, other.value());
}

// Each value is in a sample of k of n with probability k / n. Over 4000 samples the share of one value has a standard
// deviation of at most sqrt(0.25 / 4000) = 0.008; five of them are allowed.
TEST(AxisSample, HasEachWholeNumberEquallyOften) {
  constexpr int samples = 4000;
  std::vector<int> count(10);
  for (std::uint64_t seed = 0; seed < samples; ++seed) {
    for (const auto& value : whole_sample(seed, 3, 0, 9))
      ++count[static_cast<std::size_t>(std::get<std::int64_t>(value))];
  }
  for (const int times : count) EXPECT_NEAR(static_cast<double>(times) / samples, 0.3, 0.04);
}

// The mean of n even shares of 1 has a standard deviation of sqrt(1 / 12 / n).
TEST(AxisSample, IsEvenlyDistributedOverRealNumbers) {
  constexpr std::uint64_t count = 10'000;
  const auto values = axis_sample(real(), 1, count, Value(0.0), Value(1.0)).value();
  double sum = 0;
  for (const auto& value : values) sum += std::get<double>(value);
  EXPECT_NEAR(sum / count, 0.5, 5 * std::sqrt(1.0 / 12 / count));
}

TEST(AxisSample, InASweepFileDoesNotDependOnWhereTheSeedStands) {
  const auto id = [](const std::string& yaml) { return sweep_id(parse_sweep(yaml, "a").specification); };
  const std::string grid = "grids: [{mutation_size: {sample: 3, from: 1, to: 100}}]\n";
  EXPECT_EQ(id("name: a\nseed: 5\n" + grid), id("name: a\n" + grid + "seed: 5\n"));
  const SweepGrid sweep(parse_sweep("name: a\nseed: 5\n" + grid, "a").specification);
  ASSERT_EQ(sweep.jobs(), 3U);
  EXPECT_EQ(sweep.grids().at(0).axes.at(0).values,
            axis_sample(*find_parameter("mutation_size"), 5, 3, Value(std::int64_t{1}), Value(std::int64_t{100})));
}

}  // namespace
}  // namespace lamprey::experiment
