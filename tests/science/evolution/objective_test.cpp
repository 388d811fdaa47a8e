#include "science/evolution/objective.hpp"

#include <gtest/gtest.h>

namespace lamprey::science::evolution {
namespace {

constexpr fitness::Fitness expected{.stability = 80, .distance = 60, .fuel = 83};
constexpr fitness::Weights weights{.stability = 0.25, .distance = 0.5, .fuel = 1};

TEST(Target, ErrorIsTheWeightedDistanceOnEitherSide) {
  const Errors below = errors(Objective::target, weights, expected, {.stability = 60, .distance = 50, .fuel = 80});
  EXPECT_EQ(below.stability, 5);
  EXPECT_EQ(below.distance, 5);
  EXPECT_EQ(below.fuel, 3);
  EXPECT_EQ(total(below), 13);
  const Errors above = errors(Objective::target, weights, expected, {.stability = 100, .distance = 70, .fuel = 86});
  EXPECT_EQ(total(above), 13);
}

TEST(Target, ErrorOfTheExpectedFitnessIsZero) {
  EXPECT_EQ(total(errors(Objective::target, weights, expected, expected)), 0);
}

TEST(Maximise, ErrorIsTheNegativeWeightedFitnessWhateverIsExpected) {
  const Errors error = errors(Objective::maximise, weights, expected, {.stability = 60, .distance = -50, .fuel = 80});
  EXPECT_EQ(error.stability, -15);
  EXPECT_EQ(error.distance, 25);
  EXPECT_EQ(error.fuel, -80);
  EXPECT_EQ(total(error), -70);
}

}  // namespace
}  // namespace lamprey::science::evolution
