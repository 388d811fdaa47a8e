#pragma once

#include "robot_bridge/calibration.hpp"
#include "robot_bridge/pose.hpp"

#include <array>
#include <span>
#include <string_view>
#include <vector>

/// Poses as ROS 2 has them: an angle per joint [rad], 0 where the leg stands, and more where the position in the
/// robot's units is more, whichever way round the servo is mounted.
namespace lamprey::robot_bridge::ros2 {

/// By servo.
inline constexpr std::array<std::string_view, servos> joint_names = {
    "front_left_vertical", "front_right_vertical", "front_left_horizontal", "front_right_horizontal",
    "back_left_vertical",  "back_right_vertical",  "back_left_horizontal",  "back_right_horizontal"};

/// What a unit of the robot is, by the joint's calibration. A Dynamixel has 4096 ticks per turn; behind an SSC-32 are
/// servos that go through 180° in 2000 µs, as most do; the mock's unit is that of a servo with 50 µs per unit, 4.5°.
double radians_per_unit(DeviceFamily family, const Joint& joint);

std::vector<double> to_radians(const Calibration& calibration, const Pose& pose);

/// `angles`: one per joint, of any size.
Pose to_pose(const Calibration& calibration, std::span<const double, servos> angles);

}  // namespace lamprey::robot_bridge::ros2
