#include "robot_bridge/emulators/dynamixel/profile.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace lamprey::robot_bridge::emulators::dynamixel {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

int ticks_to_goal(Motion& motion, int most = 100'000) {
  int ticks = 0;
  for (; !motion.at_goal() && ticks < most; ++ticks) motion.follow();
  return ticks;
}

TEST(MotionTest, WithoutLimitsItIsThereAtOnce) {
  Motion motion(0);
  motion.go_to(1000, {unlimited, unlimited});
  motion.follow();
  EXPECT_EQ(motion.position(), 1000);
  EXPECT_TRUE(motion.at_goal());
}

TEST(MotionTest, ASpeedLimitMakesAnEvenMove) {
  Motion motion(2000);
  motion.go_to(1000, {5000, unlimited});
  for (int i = 0; i < 100; ++i) motion.follow();
  EXPECT_NEAR(motion.position(), 1500, 1e-9);
  EXPECT_EQ(motion.velocity(), -5000);
  EXPECT_EQ(ticks_to_goal(motion), 100);
  EXPECT_EQ(motion.velocity(), 0);
}

TEST(MotionTest, AnAccelerationLimitMakesATrapeziumThatDoesNotOvershoot) {
  Motion motion(0);
  const Profile profile{1000, 10'000};
  motion.go_to(500, profile);
  double fastest = 0;
  double before = 0;
  for (int i = 0; i < 2000 && !motion.at_goal(); ++i) {
    motion.follow();
    EXPECT_LE(std::abs(motion.velocity() - before), 10 + 1e-9 + (motion.at_goal() ? 60 : 0));
    before = motion.velocity();
    fastest = std::max(fastest, motion.velocity());
    EXPECT_LE(motion.position(), 500);
  }
  EXPECT_TRUE(motion.at_goal());
  EXPECT_NEAR(fastest, 1000, 1e-9);
}

TEST(MotionTest, ATrapeziumTakesDistanceBySpeedAndTheTimeOfSpeedingUp) {
  Motion motion(0);
  motion.go_to(500, {1000, 10'000});
  EXPECT_NEAR(ticks_to_goal(motion), 600, 12);  // 0.5 s + 0.1 s; slowing down in steps of a tick is a bit slower
}

TEST(MotionTest, WhoeverIsTooFastForANewGoalComesBackToIt) {
  Motion motion(0);
  motion.go_to(10'000, {5000, 20'000});
  for (int i = 0; i < 300; ++i) motion.follow();
  const double there = motion.position();
  motion.go_to(there + 10, {5000, 20'000});
  double farthest = 0;
  for (int i = 0; i < 5000 && !motion.at_goal(); ++i) {
    motion.follow();
    farthest = std::max(farthest, motion.position());
  }
  EXPECT_TRUE(motion.at_goal());
  EXPECT_GT(farthest, there + 100);
}

// As a bridge does: the same goal once more, with a time of its own, when a move has just ended or is about to.
TEST(MotionTest, ArrivesAtAGoalThatItIsToldAgainAtTheEnd) {
  for (int distance = 1; distance <= 300; ++distance) {
    for (int ticks = 1; ticks <= 50; ++ticks) {
      Motion motion(2048 + distance);
      for (int time = 0; time < 3; ++time) {
        motion.go_to(2048, {std::abs(2048 - motion.position()) * 1000 / ticks, unlimited});
        for (int i = 0; i < ticks; ++i) motion.follow();
      }
      ASSERT_EQ(motion.position(), 2048) << distance << " ticks of position in " << ticks << " of time";
      ASSERT_TRUE(motion.at_goal());
    }
  }
}

TEST(MotionTest, AlwaysArrives) {
  for (double distance = -3000; distance <= 3000; distance += 37.3) {
    for (const double acceleration : {250.0, 4000.0, unlimited}) {
      for (const double speed : {16.0, 1500.0, 5257.0}) {
        Motion motion(2048);
        motion.go_to(2048 + distance, {speed, acceleration});
        EXPECT_LT(ticks_to_goal(motion, 1'000'000), 1'000'000) << distance << ' ' << acceleration << ' ' << speed;
      }
    }
  }
}

}  // namespace
}  // namespace lamprey::robot_bridge::emulators::dynamixel
