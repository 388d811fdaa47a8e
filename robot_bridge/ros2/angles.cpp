#include "robot_bridge/ros2/angles.hpp"

#include <cstddef>
#include <numbers>

namespace lamprey::robot_bridge::ros2 {
namespace {

constexpr double radians_per_tick = 2 * std::numbers::pi / 4096;
constexpr double radians_per_microsecond = std::numbers::pi / 2000;
constexpr double radians_per_mock_unit = 50 * radians_per_microsecond;

constexpr double origin = science::robots::standing_position;

double radians_per_device_unit(DeviceFamily family) {
  switch (family) {
    case DeviceFamily::ssc32:
      return radians_per_microsecond;
    case DeviceFamily::dynamixel:
      return radians_per_tick;
    case DeviceFamily::mock:
      break;
  }
  return radians_per_mock_unit;
}

}  // namespace

double radians_per_unit(DeviceFamily family, const Joint& joint) {
  return joint.per_unit * radians_per_device_unit(family);
}

std::vector<double> to_radians(const Calibration& calibration, const Pose& pose) {
  std::vector<double> angles(servos);
  for (std::size_t servo = 0; servo < servos; ++servo) {
    angles[servo] = (pose[servo] - origin) * radians_per_unit(calibration.family, calibration.joints[servo]);
  }
  return angles;
}

Pose to_pose(const Calibration& calibration, std::span<const double, servos> angles) {
  Pose pose{};
  for (std::size_t servo = 0; servo < servos; ++servo) {
    pose[servo] = origin + angles[servo] / radians_per_unit(calibration.family, calibration.joints[servo]);
  }
  return pose;
}

}  // namespace lamprey::robot_bridge::ros2
