#pragma once

#include "robot_bridge/calibration.hpp"
#include "robot_bridge/pose.hpp"

#include <array>
#include <cstdint>

namespace lamprey::robot_bridge {

/// Keeps setpoints where a robot can't hurt itself: within each servo's calibrated range, and no further from the last
/// setpoint than the servo may move meanwhile. Works in the robot's units. Not thread-safe.
class SetpointLimiter {
 public:
  explicit SetpointLimiter(const Calibration& calibration);

  /// The servos stand there now, whatever was set before.
  void start_at(const Pose& pose);

  /// Whether a servo that stands outside its range would be brought back into it within `seconds` at its slew rate: the
  /// first setpoint within the range is sent whatever the slew rate.
  bool can_start_at(const Pose& pose, double seconds) const;

  /// The nearest allowed setpoint to `wanted`, `seconds` after the last one; it is the last one from now on. All values
  /// must be finite.
  Pose limit(const Pose& wanted, double seconds);

  /// The same range, with nothing moved.
  Pose within_range(const Pose& wanted) const;

  const Pose& setpoint() const { return setpoint_; }

  /// Setpoints, one per servo and call, that were out of range, and that were too far away.
  std::uint64_t clamped() const { return clamped_; }
  std::uint64_t slowed() const { return slowed_; }

 private:
  struct Limit {
    double lowest, highest, units_per_second, device_unit;
  };
  std::array<Limit, servos> limits_{};
  Pose setpoint_ = standing_pose();
  std::uint64_t clamped_ = 0;
  std::uint64_t slowed_ = 0;
};

}  // namespace lamprey::robot_bridge
