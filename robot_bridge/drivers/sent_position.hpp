#pragma once

#include "robot_bridge/calibration.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace lamprey::robot_bridge::drivers {

/// A servo's position as it is sent to a device that takes whole numbers.
struct SentPosition {
  std::int32_t device = 0;  ///< within the calibrated range
  double units = 0;         ///< what it was asked for; where that was out of range, the end of the range
  bool operator==(const SentPosition&) const = default;
};

/// Throws DriverError::Kind::refused where `units` is no finite number. `servo` is its number, for the message.
SentPosition sent_position(const Joint& joint, std::size_t servo, double units);

/// "front left vertical (channel 0)", for messages.
std::string servo_text(const Calibration& calibration, std::size_t servo);

}  // namespace lamprey::robot_bridge::drivers
