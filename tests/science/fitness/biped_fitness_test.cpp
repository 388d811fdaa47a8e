#include "science/fitness/biped_fitness.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace lamprey::science::fitness {
namespace {

TEST(BipedFitness, IsEquation64InComponents) {
  const Fitness fitness = score(BipedCounts{.distance = 30, .leg_error = 6}, 40);
  EXPECT_EQ(fitness, (Fitness{.stability = -15, .distance = 75, .fuel = 0}));
  EXPECT_EQ(total(fitness, {}), 60);
  EXPECT_FALSE(std::signbit(score(BipedCounts{}, 40).stability));
}

TEST(BipedFitness, PerfectAntiphaseOfTenStepsIsExactlyAHundred) {
  robots::Biped robot;
  BipedCounts counts;
  for (int t = 0; t < 40; ++t) {
    const std::int16_t first = t % 20 < 10 ? 1 : -1;
    count(counts, robots::step(robot, {first, static_cast<std::int16_t>(-first)}));
  }
  EXPECT_EQ(counts, (BipedCounts{.distance = 40, .leg_error = 0}));
  EXPECT_EQ(score(counts, 40), perfect_antiphase);
  EXPECT_EQ(total(perfect_antiphase, {}), 100);
}

TEST(BipedFitness, CountsBothLegs) {
  BipedCounts counts;
  count(counts, {.feet_on_ground = 3, .advance = 2, .leg_error = 1});
  count(counts, {.feet_on_ground = 0, .advance = 0, .leg_error = 2});
  EXPECT_EQ(counts, (BipedCounts{.distance = 2, .leg_error = 3}));
}

}  // namespace
}  // namespace lamprey::science::fitness
