#include "science/evolution/step_size.hpp"

#include <gtest/gtest.h>

namespace lamprey::science::evolution {
namespace {

/// The standard deviation after one window with that many successes, starting at 5.
double after_window(const OneFifthRule& rule, std::uint32_t successes, double start = 5) {
  OneFifthState state{.standard_deviation = start};
  for (std::uint32_t cycle = 0; cycle < rule.window; ++cycle) record(rule, state, cycle < successes);
  EXPECT_EQ(state.tried, 0U);
  EXPECT_EQ(state.successes, 0U);
  return state.standard_deviation;
}

TEST(SizeOfPercent, DropsFractions) {
  EXPECT_EQ(size_of_percent(0), 0);
  EXPECT_EQ(size_of_percent(9), 0);
  EXPECT_EQ(size_of_percent(25), 2);  // 8.2.1
  EXPECT_EQ(size_of_percent(50), 5);
  EXPECT_EQ(size_of_percent(75), 7);
  EXPECT_EQ(size_of_percent(100), 10);
}

TEST(OneFifthRule, StartsAtItsFirstStandardDeviation) {
  EXPECT_EQ(first_state({}).standard_deviation, 5);
  EXPECT_EQ(first_state({.first_standard_deviation = 2}).standard_deviation, 2);
}

TEST(OneFifthRule, ShrinksBelowAFifthKeepsAtAFifthAndGrowsAboveIt) {
  EXPECT_EQ(after_window({}, 0), 5 * 0.85);
  EXPECT_EQ(after_window({}, 3), 5 * 0.85);
  EXPECT_EQ(after_window({}, 4), 5);
  EXPECT_EQ(after_window({}, 5), 5 / 0.85);
  EXPECT_EQ(after_window({}, 20), 5 / 0.85);
}

TEST(OneFifthRule, AWindowNotDivisibleByFiveHasNoExactFifth) {
  EXPECT_EQ(after_window({.window = 7}, 1), 5 * 0.85);
  EXPECT_EQ(after_window({.window = 7}, 2), 5 / 0.85);
  EXPECT_EQ(after_window({.window = 1}, 0), 5 * 0.85);
  EXPECT_EQ(after_window({.window = 1}, 1), 5 / 0.85);
}

TEST(OneFifthRule, ChangesNothingWithinAWindow) {
  OneFifthState state = first_state({});
  for (int cycle = 0; cycle < 19; ++cycle) {
    record({}, state, true);
    EXPECT_EQ(state.standard_deviation, 5);
  }
  record({}, state, true);
  EXPECT_EQ(state.standard_deviation, 5 / 0.85);
}

TEST(OneFifthRule, CountsEachWindowAnew) {
  OneFifthState state = first_state({});
  for (int cycle = 0; cycle < 20; ++cycle) record({}, state, cycle < 4);
  for (int cycle = 0; cycle < 20; ++cycle) record({}, state, cycle < 3);
  EXPECT_EQ(state.standard_deviation, 5 * 0.85);
}

TEST(OneFifthRule, StaysWithinItsBounds) {
  EXPECT_EQ(after_window({}, 0, 0.31), 0.3);
  EXPECT_EQ(after_window({}, 20, 9.9), 10);
  EXPECT_EQ(after_window({}, 4, 20), 10) << "also where nothing else changes";
}

TEST(RootError, VarianceIsMultipliedByTheRootOfTheError) {
  EXPECT_EQ(root_error_standard_deviation(2.5, 16), 5);  // 2.5²·√16 = 25
  EXPECT_EQ(root_error_standard_deviation(2.5, 1), 2.5);
  EXPECT_EQ(root_error_standard_deviation(2.5, 0), 0);
}

}  // namespace
}  // namespace lamprey::science::evolution
