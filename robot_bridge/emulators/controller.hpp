#pragma once

#include "robot_bridge/emulators/time.hpp"

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <vector>

namespace lamprey::robot_bridge::emulators {

/// What a device sends. It begins `delay` after `asked`, or `delay` after the line has become free of answers before.
struct Answer {
  std::vector<std::uint8_t> octets;
  Time asked;
  Time delay = Time::zero();
  Time gap = Time::zero();  ///< between octets
};

/// An emulated servo controller: octets in, answers out, servos that move in time. Times that it is handed never
/// decrease. Servos are named by channel or id. For one thread.
class Controller {
 public:
  virtual ~Controller() = default;

  /// Acts on an octet whose stop bit has come at `time`.
  virtual void receive(std::uint8_t octet, Time time) = 0;

  /// The answers since the last call, in order.
  virtual std::vector<Answer> take_answers() = 0;

  /// The line was cut: half a command is forgotten.
  virtual void disconnected() = 0;

  /// A load that a servo can't move sets in or ends. Throws std::invalid_argument for a servo that is not there.
  virtual void overload(unsigned servo, bool on, Time time) = 0;

  /// Moves a servo that is off, as by hand. Throws std::invalid_argument if it is on, not there, or can't get there.
  virtual void place(unsigned servo, double position, Time time) = 0;

  /// Power off and on again: servos stay where they are, without torque. Loads end.
  virtual void reset(Time time) = 0;

  /// "servos": an object per servo with position, target, on and overloaded; "contacts": the feet that touch the
  /// ground.
  virtual nlohmann::json state(Time time) = 0;
};

}  // namespace lamprey::robot_bridge::emulators
