#include "robot_bridge/drivers/sent_position.hpp"

#include "robot_bridge/driver.hpp"
#include "science/problems/controlled_quadruped.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lamprey::robot_bridge::drivers {

SentPosition sent_position(const Joint& joint, std::size_t servo, double units) {
  if (!std::isfinite(units)) {
    throw DriverError(DriverError::Kind::refused, science::problems::servo_names()[servo] + " can't go to " +
                                                      std::to_string(units) + ", which is no position");
  }
  Joint without_limits = joint;
  without_limits.minimum = -std::numeric_limits<double>::infinity();
  without_limits.maximum = std::numeric_limits<double>::infinity();
  const double device = joint.to_device(units);
  const double whole = std::max(std::ceil(joint.minimum), std::min(std::floor(joint.maximum), std::round(device)));
  return {.device = static_cast<std::int32_t>(whole),
          .units = device == without_limits.to_device(units) ? units : joint.to_units(device)};
}

std::string servo_text(const Calibration& calibration, std::size_t servo) {
  const char* address = calibration.family == DeviceFamily::dynamixel ? " (id " : " (channel ";
  return science::problems::servo_names()[servo] + address + std::to_string(calibration.joints[servo].channel) + ")";
}

}  // namespace lamprey::robot_bridge::drivers
