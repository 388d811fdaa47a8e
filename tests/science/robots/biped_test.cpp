#include "science/robots/biped.hpp"

#include <gtest/gtest.h>

namespace lamprey::science::robots {
namespace {

Biped at(std::int16_t leg_1, std::int16_t leg_2) {
  return {{leg_1, leg_2}};
}

TEST(Biped, LegOneStartsAtTouchDownAndLegTwoAtTheKneesRelease) {
  EXPECT_EQ(Biped{}, at(10, 20));
}

TEST(Biped, ALegSentUpFromWithinTenToTwentyTakesTheBodyAlong) {
  for (std::int16_t position = 0; position < 30; ++position) {
    Biped robot = at(position, 15);
    const BipedStep done = step(robot, {1, 0});
    EXPECT_EQ(done.advance, position >= 10 && position <= 20 ? 1 : 0) << position;
    EXPECT_EQ(robot, at(static_cast<std::int16_t>(position + 1), 15));
  }
}

TEST(Biped, ALegSentDownDoesNotMoveTheBody) {
  Biped robot = at(15, 15);
  EXPECT_EQ(step(robot, {-1, -1}).advance, 0);
  EXPECT_EQ(robot, at(14, 14));
}

TEST(Biped, EachLegCountsForItself) {
  Biped robot = at(12, 17);
  EXPECT_EQ(step(robot, {1, 1}).advance, 2);
}

TEST(Biped, AtALimitTheLegStays) {
  Biped robot = at(0, 30);
  EXPECT_EQ(step(robot, {-1, 1}), (BipedStep{.feet_on_ground = 0, .advance = 0, .leg_error = 2}));
  EXPECT_EQ(robot, at(0, 30));
}

TEST(Biped, ALegIsInErrorIfItIsOutsideTenToTwentyBeforeOrAfterTheStep) {
  const auto errors = [](std::int16_t position, std::int16_t command) {
    Biped robot = at(position, 15);
    return step(robot, {command, 0}).leg_error;
  };
  EXPECT_EQ(errors(10, 1), 0);
  EXPECT_EQ(errors(20, -1), 0);
  EXPECT_EQ(errors(10, -1), 1) << "leaves";
  EXPECT_EQ(errors(20, 1), 1) << "leaves";
  EXPECT_EQ(errors(9, 1), 1) << "comes back";
  EXPECT_EQ(errors(21, -1), 1) << "comes back";
  EXPECT_EQ(errors(9, 0), 1) << "stays outside";
  EXPECT_EQ(errors(5, 1), 1) << "moves outside";
}

TEST(Biped, AFootIsOffTheGroundWhileItsKneeIsReleased) {
  Biped robot = at(15, 15);
  EXPECT_EQ(step(robot, {1, -1}).feet_on_ground, 1U);
  EXPECT_EQ(step(robot, {-1, 1}).feet_on_ground, 2U);
  EXPECT_EQ(step(robot, {0, 0}).feet_on_ground, 3U);
  Biped outside = at(9, 21);
  EXPECT_EQ(step(outside, {1, 0}).feet_on_ground, 0U);
}

}  // namespace
}  // namespace lamprey::science::robots
