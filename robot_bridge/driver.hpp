#pragma once

#include "robot_bridge/pose.hpp"

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace lamprey::robot_bridge {

/// What a device tells of the robot.
struct Feedback {
  Pose position = standing_pose();
  /// Whether sensors have measured `position`; else the device interpolates it from what it was commanded.
  bool measured = false;
  /// A bit per leg, 1 << science::robots::Leg: feet whose contact is closed.
  std::uint32_t feet_down = 0;
  /// Whether the device tells of all servos that they are exactly where the last move was to take them.
  bool arrived = true;
  bool operator==(const Feedback&) const = default;
};

/// Why a device did not do what it was asked.
class DriverError : public std::runtime_error {
 public:
  enum class Kind : std::uint8_t {
    silent,        ///< no answer within the deadline
    garbled,       ///< an answer that is none: noise, a wrong checksum, a part
    refused,       ///< the device says that it can't, or reports an alert (overload, voltage, heat)
    disconnected,  ///< the line is gone, or can't be opened
    cancelled,     ///< by Driver::cancel
  };
  DriverError(Kind kind, const std::string& what) : std::runtime_error(what), kind_(kind) {}
  Kind kind() const { return kind_; }

 private:
  Kind kind_;
};

/// A servo controller. Positions are in the robot's units; what a servo's pulse or angle is, is its calibration's
/// business, and none outside the calibrated range is ever sent, whatever is asked for. All calls but `cancel` come
/// from one thread, throw DriverError, and end by a deadline of their own, silent line or not. After an error the
/// device is as if it had never been connected: `connect` begins anew.
class Driver {
 public:
  virtual ~Driver() = default;

  /// Opens the line and makes sure that the expected device answers. Moves nothing, changes no servo's torque.
  virtual void connect() = 0;

  /// Where the servos are; nothing where the device can't know, as it has no sensors and its servos are off.
  virtual std::optional<Pose> present_position() = 0;

  /// Turns the servos on, to stand at `start`: the present position, or where there is none, the pose that somebody has
  /// made sure of. A servo that is on is not moved.
  virtual void enable(const Pose& start) = 0;

  /// Begins a move of all servos that ends together after `duration`; it replaces the one before. Does not wait.
  virtual void move(const Pose& target, std::chrono::microseconds duration) = 0;

  virtual Feedback read() = 0;

  /// Whether the device is still carrying out its last move. A servo that its load keeps from its goal is not moving.
  virtual bool moving() = 0;

  /// Stops where it is, and stays there with torque.
  virtual void hold() = 0;

  /// Takes pulses or torque off all servos, and makes sure of it.
  virtual void release() = 0;

  /// For a device that gives no answer, but may still hear: sends what takes pulses or torque off all servos, over a
  /// line opened anew, and waits for nothing. Whether that could be sent. Throws nothing; as after an error then.
  virtual bool let_go() noexcept = 0;

  /// Ends a call that is going on, with DriverError::Kind::cancelled; from any thread.
  virtual void cancel() noexcept = 0;

  /// "SSC-32 at /dev/ttyUSB0, 115200 baud, version SSC32-V2.50USB": what `connect` has found.
  virtual std::string description() const = 0;

  /// The highest rate, in steps per second, at which a move and a read fit this device and line.
  virtual double highest_rate() const = 0;
};

}  // namespace lamprey::robot_bridge
