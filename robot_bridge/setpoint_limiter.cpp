#include "robot_bridge/setpoint_limiter.hpp"

#include <algorithm>
#include <cstddef>

namespace lamprey::robot_bridge {

SetpointLimiter::SetpointLimiter(const Calibration& calibration) {
  for (std::size_t servo = 0; servo < servos; ++servo) {
    const Joint& joint = calibration.joints[servo];
    // The list form gives values; the other would refer to these temporaries.
    const auto [low, high] = std::minmax({joint.to_units(joint.minimum), joint.to_units(joint.maximum)});
    limits_[servo] = {.lowest = std::max(low, lowest_position),
                      .highest = std::min(high, highest_position),
                      .units_per_second = slew_in_units(joint),
                      .device_unit = 1 / joint.per_unit};
  }
}

void SetpointLimiter::start_at(const Pose& pose) {
  setpoint_ = pose;
}

bool SetpointLimiter::can_start_at(const Pose& pose, double seconds) const {
  const Pose inside = within_range(pose);
  for (std::size_t servo = 0; servo < servos; ++servo) {
    if (std::abs(inside[servo] - pose[servo]) > limits_[servo].units_per_second * seconds) return false;
  }
  return true;
}

Pose SetpointLimiter::within_range(const Pose& wanted) const {
  Pose pose{};
  for (std::size_t servo = 0; servo < servos; ++servo) {
    pose[servo] = std::clamp(wanted[servo], limits_[servo].lowest, limits_[servo].highest);
  }
  return pose;
}

Pose SetpointLimiter::limit(const Pose& wanted, double seconds) {
  const Pose reachable = within_range(wanted);
  for (std::size_t servo = 0; servo < servos; ++servo) {
    clamped_ += std::uint64_t{reachable[servo] != wanted[servo]};
    // A device rounds each setpoint to whole pulses or ticks: two roundings must not exceed the rate together.
    const double by_rate = limits_[servo].units_per_second * seconds;
    const double furthest = std::max(by_rate - limits_[servo].device_unit, by_rate / 2);
    const double next = std::clamp(reachable[servo], setpoint_[servo] - furthest, setpoint_[servo] + furthest);
    slowed_ += std::uint64_t{next != reachable[servo]};
    setpoint_[servo] = next;
  }
  return setpoint_;
}

}  // namespace lamprey::robot_bridge
