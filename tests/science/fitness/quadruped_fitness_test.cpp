#include "science/fitness/quadruped_fitness.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <initializer_list>

namespace lamprey::science::fitness {
namespace {

using robots::QuadrupedStep;

constexpr unsigned front_left = 1;
constexpr unsigned front_right = 2;
constexpr unsigned back_left = 4;
constexpr unsigned back_right = 8;
constexpr unsigned all_feet = 15;

QuadrupedCounts counts_of(std::initializer_list<QuadrupedStep> steps) {
  QuadrupedCounts counts;
  for (const auto& step : steps) count(counts, step);
  return counts;
}

TEST(Fuel, StandingOnFourFeetCostsNothing) {
  EXPECT_EQ(fuel_used(counts_of({{.feet_on_ground = all_feet}})), 0);
}

TEST(Fuel, Row1ALimitPushedAgainstCostsTenAndAClampedCommandAloneNothingElse) {
  EXPECT_EQ(fuel_used(counts_of({{.feet_on_ground = all_feet, .limit_pushed = true}})), 10);
}

TEST(Fuel, Row2AllFeetOffTheGroundCostEight) {
  EXPECT_EQ(fuel_used(counts_of({{.feet_on_ground = 0}})), 8);
}

TEST(Fuel, Row3OneFootCostsSix) {
  for (const unsigned foot : {front_left, front_right, back_left, back_right}) {
    EXPECT_EQ(fuel_used(counts_of({{.feet_on_ground = foot}})), 6);
  }
}

TEST(Fuel, Row4ASidePairCostsFive) {
  EXPECT_EQ(fuel_used(counts_of({{.feet_on_ground = front_left | back_left}})), 5);
  EXPECT_EQ(fuel_used(counts_of({{.feet_on_ground = front_right | back_right}})), 5);
}

TEST(Fuel, Row5TheFrontOrBackPairCostsThree) {
  EXPECT_EQ(fuel_used(counts_of({{.feet_on_ground = front_left | front_right}})), 3);
  EXPECT_EQ(fuel_used(counts_of({{.feet_on_ground = back_left | back_right}})), 3);
}

TEST(Fuel, Row6ADiagonalPairCostsTwoAsTheFormulaSaysAndNotFiveAsTheText) {
  EXPECT_EQ(fuel_used(counts_of({{.feet_on_ground = front_left | back_right}})), 2);
  EXPECT_EQ(fuel_used(counts_of({{.feet_on_ground = front_right | back_left}})), 2);
}

TEST(Fuel, Row7BrushingCostsTwoHoweverManyFeetBrush) {
  EXPECT_EQ(fuel_used(counts_of({{.feet_on_ground = all_feet, .drags = 1}})), 2);
  EXPECT_EQ(fuel_used(counts_of({{.feet_on_ground = all_feet, .drags = 4}})), 2);
}

TEST(Fuel, Row8ThreeFeetCostOne) {
  for (const unsigned foot : {front_left, front_right, back_left, back_right}) {
    EXPECT_EQ(fuel_used(counts_of({{.feet_on_ground = all_feet & ~foot}})), 1);
  }
}

TEST(Fuel, Row9AnyMovementCostsOne) {
  EXPECT_EQ(fuel_used(counts_of({{.feet_on_ground = all_feet, .moved = true}})), 1);
}

TEST(Fuel, RowsOfOneStepAddUp) {
  // On the front left foot alone (6), dragging it (2), one servo at its limit (10), others moving (1).
  EXPECT_EQ(fuel_used(counts_of({{.feet_on_ground = front_left, .drags = 1, .limit_pushed = true, .moved = true}})),
            19);
}

TEST(Fuel, NeverFallsBelowZero) {
  QuadrupedCounts counts;
  counts.limit_steps = 99;
  EXPECT_EQ(score(counts, 100).fuel, 1);
  counts.limit_steps = 100;
  EXPECT_EQ(score(counts, 100).fuel, 0);
  counts.limit_steps = 101;
  EXPECT_EQ(score(counts, 100).fuel, 0);
}

TEST(Stability, CountsThreeFeetAndEveryPairAndNeitherOneNorNoneNorFour) {
  for (unsigned feet = 0; feet <= all_feet; ++feet) {
    const int number = static_cast<int>(feet & 1) + static_cast<int>(feet >> 1 & 1) + static_cast<int>(feet >> 2 & 1) +
                       static_cast<int>(feet >> 3);
    EXPECT_EQ(score(counts_of({{.feet_on_ground = feet}}), 1).stability, number == 2 || number == 3 ? 100 : 0) << feet;
  }
}

TEST(Stability, EveryInclinedStepTakesOneOff) {
  const auto counts = counts_of({{.feet_on_ground = 7, .inclined = true},
                                 {.feet_on_ground = all_feet, .inclined = true},
                                 {.feet_on_ground = 7},
                                 {.feet_on_ground = all_feet, .inclined = true}});
  EXPECT_EQ(score(counts, 4).stability, -25);  // eq. 7.5: 100·2/4 − 100·3/4
}

TEST(Distance, FrontLegsAddOneBackLegsTwoAndDragsTakeOneOff) {
  const auto counts = counts_of({{.feet_on_ground = all_feet, .front_pushes = 2, .back_pushes = 1},
                                 {.feet_on_ground = all_feet, .back_pushes = 1, .drags = 3},
                                 {.feet_on_ground = all_feet, .drags = 1},
                                 {.feet_on_ground = all_feet}});
  EXPECT_EQ(score(counts, 4).distance, 50);  // eq. 7.7: 100·2/4 + 100·4/4 − 100·4/4
}

TEST(Distance, MayBeNegative) {
  EXPECT_EQ(score(counts_of({{.feet_on_ground = all_feet, .drags = 4}}), 1).distance, -400);
}

TEST(Distance, ThePushFactorScalesPushesAndNotDrags) {
  const auto counts = counts_of(
      {{.feet_on_ground = all_feet, .front_pushes = 2, .back_pushes = 1, .drags = 1}, {.feet_on_ground = all_feet}});
  EXPECT_EQ(score(counts, 2, 1).distance, 150);  // eq. 7.7: 100·(2 + 2 − 1)/2
  EXPECT_EQ(score(counts, 2, 0.25).distance, 0);
  EXPECT_EQ(score(counts, 2, 0).distance, -50);
  EXPECT_EQ(score(counts, 2, 0.5).stability, score(counts, 2).stability);
  EXPECT_EQ(score(counts, 2, 0.5).fuel, score(counts, 2).fuel);
}

TEST(Score, OfNothingIsPositiveZeroSoThatItsBitsAreOne) {
  const Fitness nothing = score(counts_of({{.feet_on_ground = all_feet}}), 1);
  EXPECT_FALSE(std::signbit(nothing.stability));
  EXPECT_FALSE(std::signbit(nothing.distance));
  EXPECT_EQ(nothing.fuel, 100);
}

TEST(Total, WeighsEachComponent) {
  EXPECT_EQ(total({.stability = 80, .distance = 60, .fuel = 83}, {1, 0.25, 0.5}), 80 + 15 + 41.5);
}

}  // namespace
}  // namespace lamprey::science::fitness
