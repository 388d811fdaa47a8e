#include "robot_bridge/setpoint_limiter.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace lamprey::robot_bridge {
namespace {

/// 500 to 2000 µs, 50 µs per unit, 3000 µs per second.
Calibration ssc32() {
  Calibration calibration;
  calibration.family = DeviceFamily::ssc32;
  for (std::size_t servo = 0; servo < servos; ++servo) {
    calibration.joints[servo] = {.channel = static_cast<std::int32_t>(servo),
                                 .minimum = 600,
                                 .centre = 1000,
                                 .maximum = 1900,
                                 .per_unit = 50,
                                 .direction = servo % 2 == 0 ? 1 : -1,
                                 .offset = 0,
                                 .slew_rate = 3000};
    if (servo % 2 == 1) calibration.joints[servo].centre = 1500;
  }
  return calibration;
}

TEST(SetpointLimiter, LetsAWalkingStepThroughAsItIs) {
  SetpointLimiter limiter(ssc32());
  Pose pose = standing_pose();
  for (int step = 0; step < 8; ++step) {
    for (double& position : pose) ++position;
    EXPECT_EQ(limiter.limit(pose, 0.02), pose);
  }
  EXPECT_EQ(limiter.clamped() + limiter.slowed(), 0U);
}

TEST(SetpointLimiter, KeepsEveryServoWithinItsCalibration) {
  const Calibration calibration = ssc32();
  SetpointLimiter limiter(calibration);
  Pose wild{};
  wild.fill(1e9);
  for (int i = 0; i < 1000; ++i) limiter.limit(wild, 0.02);
  for (std::size_t servo = 0; servo < servos; ++servo) {
    EXPECT_EQ(limiter.setpoint()[servo], servo % 2 == 0 ? 28 : 28) << servo;
  }
  EXPECT_EQ(limiter.clamped(), 8000U);
  wild.fill(-1e9);
  for (int i = 0; i < 1000; ++i) limiter.limit(wild, 0.02);
  EXPECT_EQ(limiter.setpoint()[0], 2);
}

// Whatever is asked for, no two setpoints as the device gets them, in whole µs, are further apart than it may move.
TEST(SetpointLimiter, NeverExceedsTheSlewRateInTheDevicesUnits) {
  const Calibration calibration = ssc32();
  SetpointLimiter limiter(calibration);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> anywhere(-50, 80);
  Pose before = limiter.setpoint();
  for (int i = 0; i < 20'000; ++i) {
    Pose wanted{};
    for (double& position : wanted) position = anywhere(random);
    const Pose after = limiter.limit(wanted, 0.02);
    for (std::size_t servo = 0; servo < servos; ++servo) {
      const Joint& joint = calibration.joints[servo];
      const double from = std::round(joint.to_device(before[servo]));
      const double to = std::round(joint.to_device(after[servo]));
      ASSERT_LE(std::abs(to - from), joint.slew_rate * 0.02);
      ASSERT_GE(to, joint.minimum);
      ASSERT_LE(to, joint.maximum);
    }
    before = after;
  }
  EXPECT_GT(limiter.slowed(), 0U);
}

TEST(SetpointLimiter, GoesOnFromWhereTheRobotIsFound) {
  SetpointLimiter limiter(ssc32());
  Pose found{};
  found.fill(20);
  limiter.start_at(found);
  const Pose first = limiter.limit(standing_pose(), 0.02);
  for (const double position : first) {
    EXPECT_LT(position, 20);
    EXPECT_GT(position, 18);
  }
}

TEST(SetpointLimiter, DoesNotStartWhereTheWayBackIntoTheRangeIsTooFar) {
  const Calibration calibration = ssc32();
  const SetpointLimiter limiter(calibration);
  Pose found = standing_pose();
  EXPECT_TRUE(limiter.can_start_at(found, 0.02));
  const Joint& joint = calibration.joints[3];
  const double edge = joint.to_units(joint.maximum);
  const double reach = slew_in_units(joint) * 0.02;
  found[3] = edge + (joint.direction > 0 ? 0.9 : -0.9) * reach;
  EXPECT_TRUE(limiter.can_start_at(found, 0.02));
  found[3] = edge + (joint.direction > 0 ? 1.2 : -1.2) * reach;
  EXPECT_FALSE(limiter.can_start_at(found, 0.02));
}

}  // namespace
}  // namespace lamprey::robot_bridge
