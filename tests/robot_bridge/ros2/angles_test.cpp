#include "robot_bridge/ros2/angles.hpp"

#include <cstddef>
#include <gtest/gtest.h>
#include <numbers>
#include <span>

namespace lamprey::robot_bridge::ros2 {
namespace {

constexpr double degree = std::numbers::pi / 180;

Calibration calibration(DeviceFamily family, double per_unit, int direction) {
  Calibration result = mock_calibration();
  result.family = family;
  for (auto& joint : result.joints) {
    joint.per_unit = per_unit;
    joint.direction = direction;
    joint.offset = 7;
  }
  return result;
}

TEST(Angles, AreZeroWhereTheRobotStands) {
  for (const double angle : to_radians(mock_calibration(), standing_pose())) EXPECT_EQ(angle, 0);
}

TEST(Angles, OfADynamixelAreThoseOfItsTicks) {
  Pose pose = standing_pose();
  pose[3] = 30;
  const auto angles = to_radians(calibration(DeviceFamily::dynamixel, 4096.0 / 360, 1), pose);
  ASSERT_EQ(angles.size(), servos);
  EXPECT_NEAR(angles[3], 20 * degree, 1e-12);
  EXPECT_EQ(angles[0], 0);
}

TEST(Angles, OfAnSsc32AreThoseOfServosWithTheUsualTravel) {
  Pose pose = standing_pose();
  pose[0] = 0;
  EXPECT_NEAR(to_radians(calibration(DeviceFamily::ssc32, 50, 1), pose)[0], -45 * degree, 1e-12);
}

TEST(Angles, GoWithTheRobotsUnitsWhicheverWayRoundAServoIsMounted) {
  Pose pose = standing_pose();
  pose[0] = 20;
  EXPECT_EQ(to_radians(calibration(DeviceFamily::ssc32, 50, 1), pose),
            to_radians(calibration(DeviceFamily::ssc32, 50, -1), pose));
}

TEST(Angles, ThereAndBackIsTheSamePose) {
  const Pose pose{0, 3.25, 10, 12, 17.5, 20, 29, 30};
  for (const auto family : {DeviceFamily::mock, DeviceFamily::ssc32, DeviceFamily::dynamixel}) {
    const auto with = calibration(family, 37, 1);
    const auto angles = to_radians(with, pose);
    const Pose back = to_pose(with, std::span<const double, servos>(angles));
    for (std::size_t servo = 0; servo < servos; ++servo) EXPECT_NEAR(back[servo], pose[servo], 1e-12);
  }
}

}  // namespace
}  // namespace lamprey::robot_bridge::ros2
