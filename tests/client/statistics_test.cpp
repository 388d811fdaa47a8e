#include "client/statistics/intervals.hpp"

#include <array>
#include <gtest/gtest.h>

namespace lamprey::client::statistics {
namespace {

/// Hours of sleep gained by ten patients under two drugs: Student, "The probable error of a mean", Biometrika 6 (1908),
/// whose intervals every package prints.
constexpr std::array first_drug = {0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0};
constexpr std::array second_drug = {1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4};

TEST(StatisticsTest, StudentsQuantilesAreThoseOfTheTables) {
  EXPECT_NEAR(student_quantile(0.975, 1), 12.7062, 5e-5);
  EXPECT_NEAR(student_quantile(0.975, 9), 2.2622, 5e-5);
  EXPECT_NEAR(student_quantile(0.95, 30), 1.6973, 5e-5);
}

TEST(StatisticsTest, APairedIntervalIsThatOfTheDifferences) {
  std::array<double, first_drug.size()> differences{};
  for (std::size_t i = 0; i < differences.size(); ++i) differences[i] = first_drug[i] - second_drug[i];
  const auto interval = mean_interval(sample_of(differences), 0.95);
  ASSERT_TRUE(interval);
  EXPECT_NEAR(interval->estimate, -1.58, 1e-12);
  EXPECT_NEAR(interval->low, -2.4598858, 5e-8);
  EXPECT_NEAR(interval->high, -0.7001142, 5e-8);
  EXPECT_EQ(interval->size, 10U);
}

TEST(StatisticsTest, WelchsIntervalIsThatOfStudentsSleepData) {
  const auto interval = welch_interval(sample_of(first_drug), sample_of(second_drug), 0.95);
  ASSERT_TRUE(interval);
  EXPECT_NEAR(interval->low, -3.3654832, 5e-8);
  EXPECT_NEAR(interval->high, 0.2054832, 5e-8);
}

TEST(StatisticsTest, WelchsIntervalOfConstantsHasNoWidth) {
  const auto interval = welch_interval({.size = 3, .mean = 5}, {.size = 4, .mean = 2}, 0.95);
  ASSERT_TRUE(interval);
  EXPECT_EQ(interval->low, 3);
  EXPECT_EQ(interval->high, 3);
}

TEST(StatisticsTest, OneValueHasNoInterval) {
  EXPECT_FALSE(mean_interval({.size = 1, .mean = 5}, 0.95));
  EXPECT_FALSE(welch_interval({.size = 1, .mean = 5}, sample_of(first_drug), 0.95));
  EXPECT_FALSE(wilson_interval(0, 0, 0.95));
}

TEST(StatisticsTest, MomentsGiveTheSampleThatTheValuesGive) {
  double mean = 0;
  double squares = 0;
  for (const double value : second_drug) {
    mean += value / second_drug.size();
    squares += value * value / second_drug.size();
  }
  const auto direct = sample_of(second_drug);
  const auto from_moments = sample_of_moments(second_drug.size(), mean, squares);
  EXPECT_NEAR(from_moments.mean, direct.mean, 1e-12);
  EXPECT_NEAR(from_moments.variance, direct.variance, 1e-12);
}

/// Newcombe, Statistics in Medicine 17 (1998), table I, method 3.
TEST(StatisticsTest, WilsonsIntervalsAreNewcombesExamples) {
  struct Example {
    std::uint64_t successes;
    std::uint64_t trials;
    double low;
    double high;
  };
  for (const auto& example : {Example{81, 263, 0.2553, 0.3662}, Example{15, 148, 0.0624, 0.1605},
                              Example{0, 20, 0.0000, 0.1611}, Example{1, 29, 0.0061, 0.1718}}) {
    const auto interval = wilson_interval(example.successes, example.trials, 0.95);
    ASSERT_TRUE(interval);
    EXPECT_NEAR(interval->low, example.low, 5e-5) << example.successes << " of " << example.trials;
    EXPECT_NEAR(interval->high, example.high, 5e-5) << example.successes << " of " << example.trials;
  }
}

/// By hand: the plane 3 + x + 1.5 y leaves rests of 0.5, so that s² = 1 with one degree of freedom, and each slope has
/// the standard error √(1/4).
TEST(StatisticsTest, ThePlaneThroughFourPointsIsTheOneWorkedByHand) {
  const std::array cells = {Cell{-1, -1, {1, 1}}, Cell{1, -1, {1, 2}}, Cell{-1, 1, {1, 3}}, Cell{1, 1, {1, 6}}};
  const auto slopes = plane_slopes(cells, 0.95);
  ASSERT_TRUE(slopes);
  EXPECT_NEAR(slopes->x.estimate, 1, 1e-12);
  EXPECT_NEAR(slopes->y.estimate, 1.5, 1e-12);
  EXPECT_NEAR(slopes->x.high, 1 + 12.7062 * 0.5, 5e-5);
  EXPECT_NEAR(slopes->y.low, 1.5 - 12.7062 * 0.5, 5e-5);
}

TEST(StatisticsTest, APlaneThroughCellsIsThePlaneThroughTheirValues) {
  const std::array<double, 3> low = {1, 2, 6};
  const std::array<double, 2> high = {4, 7};
  const std::array cells = {Cell{0, 0, sample_of(low)}, Cell{1, 0, sample_of(high)}, Cell{0, 1, {1, 9}}};
  const std::array values = {Cell{0, 0, {1, 1}}, Cell{0, 0, {1, 2}}, Cell{0, 0, {1, 6}},
                             Cell{1, 0, {1, 4}}, Cell{1, 0, {1, 7}}, Cell{0, 1, {1, 9}}};
  const auto grouped = plane_slopes(cells, 0.95);
  const auto single = plane_slopes(values, 0.95);
  ASSERT_TRUE(grouped && single);
  EXPECT_NEAR(grouped->x.low, single->x.low, 1e-9);
  EXPECT_NEAR(grouped->y.high, single->y.high, 1e-9);
}

TEST(StatisticsTest, PointsOnALineHaveNoPlane) {
  const std::array cells = {Cell{0, 0, {1, 1}}, Cell{1, 1, {1, 2}}, Cell{2, 2, {1, 4}}, Cell{3, 3, {1, 4}}};
  EXPECT_FALSE(plane_slopes(cells, 0.95));
}

TEST(StatisticsTest, EquivalenceNeedsTheWholeIntervalWithinTheMargin) {
  EXPECT_TRUE(equivalent({.estimate = 1, .low = -2, .high = 4}, 5));
  EXPECT_FALSE(equivalent({.estimate = 1, .low = -6, .high = 4}, 5));
  EXPECT_FALSE(equivalent({.estimate = 4, .low = 3, .high = 5}, 5)) << "the margin itself is too far";
  EXPECT_TRUE(equivalent({.estimate = 0, .low = 0, .high = 0}, 0)) << "two rates of zero are no difference";
}

}  // namespace
}  // namespace lamprey::client::statistics
