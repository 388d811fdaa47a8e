#include "science/robots/quadruped.hpp"

#include <gtest/gtest.h>

namespace lamprey::science::robots {
namespace {

constexpr unsigned all_feet = 0b1111;

ServoCommands command(std::size_t servo, int move) {
  ServoCommands commands{};
  commands[servo] = static_cast<std::int16_t>(move);
  return commands;
}

TEST(Quadruped, ServosAreNumberedFrontVerticalFrontHorizontalBackVerticalBackHorizontal) {
  EXPECT_EQ(vertical_servo(front_left), 0U);
  EXPECT_EQ(vertical_servo(front_right), 1U);
  EXPECT_EQ(horizontal_servo(front_left), 2U);
  EXPECT_EQ(horizontal_servo(front_right), 3U);
  EXPECT_EQ(vertical_servo(back_left), 4U);
  EXPECT_EQ(vertical_servo(back_right), 5U);
  EXPECT_EQ(horizontal_servo(back_left), 6U);
  EXPECT_EQ(horizontal_servo(back_right), 7U);
}

TEST(Quadruped, StandsStillOnFourLevelFeetWithoutCommands) {
  Quadruped robot = standing();
  const QuadrupedStep expected{.feet_on_ground = all_feet};
  EXPECT_EQ(step(robot, {}), expected);
  EXPECT_EQ(robot, standing());
}

TEST(Quadruped, EachServoMovesByItsOwnCommand) {
  Quadruped robot = standing();
  step(robot, {1, -1, 0, 1, -1, 0, 1, -1});
  EXPECT_EQ(robot.position, (std::array<std::int16_t, servos>{11, 9, 10, 11, 9, 10, 11, 9}));
}

TEST(Contact, NeedsTheFootDownBeforeAndAfterTheStep) {
  EXPECT_TRUE(touches(10, 10, flat_ground_level));
  EXPECT_TRUE(touches(0, 9, flat_ground_level));
  EXPECT_FALSE(touches(10, 11, flat_ground_level));
  EXPECT_FALSE(touches(11, 10, flat_ground_level));
  EXPECT_FALSE(touches(11, 12, flat_ground_level));
  EXPECT_TRUE(touches(11, 12, 12));
}

TEST(Contact, AFootThatLiftsOrLandsInTheStepIsInTheAir) {
  for (std::size_t leg = 0; leg < legs; ++leg) {
    const unsigned others = all_feet & ~(1U << leg);
    Quadruped robot = standing();
    EXPECT_EQ(step(robot, command(vertical_servo(leg), 1)).feet_on_ground, others) << leg;
    EXPECT_EQ(step(robot, {}).feet_on_ground, others) << leg;
    EXPECT_EQ(step(robot, command(vertical_servo(leg), -1)).feet_on_ground, others) << leg;
    EXPECT_EQ(step(robot, {}).feet_on_ground, all_feet) << leg;
  }
}

TEST(Contact, AFootPressedDownStaysOnTheGround) {
  Quadruped robot = standing();
  EXPECT_EQ(step(robot, command(vertical_servo(back_left), -1)).feet_on_ground, all_feet);
  EXPECT_EQ(step(robot, command(vertical_servo(back_left), 1)).feet_on_ground, all_feet);
}

TEST(Contact, EachLegHasAGroundLevelOfItsOwn) {
  const GroundLevels ground{9, 10, 11, 30};
  Quadruped robot = standing();
  EXPECT_EQ(step(robot, {}, ground).feet_on_ground, 0b1110U) << "there is a hole under the front left leg";
  step(robot, {-1, 1, 0, 0, 1, 1, 0, 0}, ground);
  EXPECT_EQ(step(robot, {}, ground).feet_on_ground, 0b1101U) << "which now reaches its bottom; front right is lifted";
}

TEST(Contact, WithoutAGroundThatIsGivenItIsFlat) {
  Quadruped given = standing();
  Quadruped not_given = standing();
  const ServoCommands commands{1, 0, -1, -1, 0, 0, 1, -1};
  EXPECT_EQ(step(given, commands, flat_ground), step(not_given, commands));
  EXPECT_EQ(flat_ground, (GroundLevels{10, 10, 10, 10}));
}

TEST(Inclination, CountsTouchingFeetThatEndAtDifferentHeights) {
  Quadruped robot = standing();
  EXPECT_TRUE(step(robot, command(vertical_servo(front_left), -1)).inclined);
  EXPECT_TRUE(step(robot, {}).inclined) << "as long as the posture lasts";
  EXPECT_FALSE(step(robot, {0, -1, 0, 0, -1, -1, 0, 0}).inclined) << "level again, one lower";
}

TEST(Inclination, IgnoresFeetInTheAir) {
  Quadruped robot = standing();
  EXPECT_FALSE(step(robot, command(vertical_servo(front_left), 1)).inclined);
  // The foot comes down to 10 while the others go to 9: it lands in this step and does not count yet.
  EXPECT_FALSE(step(robot, {-1, -1, 0, 0, -1, -1, 0, 0}).inclined);
  EXPECT_TRUE(step(robot, {}).inclined);
}

TEST(Inclination, NeedsTwoFeet) {
  Quadruped robot = standing();
  robot.position = {5, 12, 10, 10, 12, 12, 10, 10};
  const QuadrupedStep one_foot = step(robot, {});
  EXPECT_EQ(one_foot.feet_on_ground, 1U << front_left);
  EXPECT_FALSE(one_foot.inclined);
}

TEST(Pushes, TouchingLegsThatMoveBackPushAndThoseThatMoveForwardDrag) {
  for (std::size_t leg = 0; leg < legs; ++leg) {
    Quadruped robot = standing();
    const QuadrupedStep back = step(robot, command(horizontal_servo(leg), -1));
    EXPECT_EQ(back.front_pushes, is_front(leg) ? 1 : 0);
    EXPECT_EQ(back.back_pushes, is_front(leg) ? 0 : 1);
    EXPECT_EQ(back.drags, 0);
    const QuadrupedStep forward = step(robot, command(horizontal_servo(leg), 1));
    EXPECT_EQ(forward.front_pushes + forward.back_pushes, 0);
    EXPECT_EQ(forward.drags, 1);
  }
}

TEST(Pushes, LegsInTheAirNeitherPushNorDrag) {
  Quadruped robot = standing();
  robot.position[vertical_servo(front_left)] = 11;
  robot.position[vertical_servo(back_left)] = 11;
  const QuadrupedStep result = step(robot, {0, 0, -1, 0, 0, 0, 1, 0});
  EXPECT_EQ(result.front_pushes, 0);
  EXPECT_EQ(result.drags, 0);
  EXPECT_TRUE(result.moved);
}

TEST(Pushes, ThereIsNoWindowOfPositions) {
  Quadruped robot = standing();
  robot.position[horizontal_servo(front_left)] = 25;
  EXPECT_EQ(step(robot, command(horizontal_servo(front_left), -1)).front_pushes, 1);
  robot.position[horizontal_servo(front_left)] = 1;
  EXPECT_EQ(step(robot, command(horizontal_servo(front_left), -1)).front_pushes, 1);
}

TEST(Limits, AServoStaysAtItsLimitAndTheStepSaysSo) {
  for (std::size_t servo = 0; servo < servos; ++servo) {
    Quadruped robot = standing();
    robot.position[servo] = highest_position;
    QuadrupedStep result = step(robot, command(servo, 1));
    EXPECT_EQ(robot.position[servo], highest_position);
    EXPECT_TRUE(result.limit_pushed);
    EXPECT_FALSE(result.moved) << "a clamped command alone changes nothing";

    robot.position[servo] = lowest_position;
    result = step(robot, command(servo, -1));
    EXPECT_EQ(robot.position[servo], lowest_position);
    EXPECT_TRUE(result.limit_pushed);
    EXPECT_FALSE(result.moved);
    EXPECT_EQ(result.front_pushes + result.back_pushes + result.drags, 0);
  }
}

TEST(Limits, ReachingOneIsNotPushingAgainstIt) {
  Quadruped robot = standing();
  robot.position[0] = 29;
  const QuadrupedStep result = step(robot, command(0, 1));
  EXPECT_FALSE(result.limit_pushed);
  EXPECT_TRUE(result.moved);
}

TEST(Supports, EverySetOfFeetHasItsKind) {
  using enum Support;
  constexpr unsigned fl = 1U << front_left;
  constexpr unsigned fr = 1U << front_right;
  constexpr unsigned bl = 1U << back_left;
  constexpr unsigned br = 1U << back_right;
  EXPECT_EQ(support(0), none);
  for (const unsigned foot : {fl, fr, bl, br}) {
    EXPECT_EQ(support(foot), one);
    EXPECT_EQ(support(all_feet & ~foot), three);
  }
  EXPECT_EQ(support(fl | fr), front_or_back_pair);
  EXPECT_EQ(support(bl | br), front_or_back_pair);
  EXPECT_EQ(support(fl | bl), side_pair);
  EXPECT_EQ(support(fr | br), side_pair);
  EXPECT_EQ(support(fl | br), diagonal_pair);
  EXPECT_EQ(support(fr | bl), diagonal_pair);
  EXPECT_EQ(support(all_feet), four);
}

}  // namespace
}  // namespace lamprey::science::robots
