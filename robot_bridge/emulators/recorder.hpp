#pragma once

#include "robot_bridge/emulators/time.hpp"

#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <ostream>
#include <string>

namespace lamprey::robot_bridge::emulators {

/// Remembers what a controller was told, for whoever wants to know afterwards whether anything unsafe ever arrived.
/// Values are in the controller's unit: pulse widths in µs, or ticks.
class Recorder {
 public:
  /// Accepted commands are written to `log`, if there is one, which outlives the recorder: a CSV with a row each,
  /// `time_ns,servo,value,duration_ms`; no value where a servo is turned off.
  explicit Recorder(std::ostream* log = nullptr);

  /// A servo's target, to be reached in `duration`; zero where the command does not say. Of a servo that is on, change
  /// and speed since the command before are counted.
  void target(unsigned servo, int value, Time duration, Time time);

  /// A servo that was off got its pulse or torque: it stands at `position`, and will go to `value` as fast as it can.
  void turned_on(unsigned servo, double position, int value, Time time);
  void turned_off(unsigned servo, Time time);

  /// Something arrived that was dropped or refused.
  void refused(const std::string& reason) { ++refused_[reason]; }
  std::uint64_t refusals() const;

  /// "servos": per servo, by its name; "refused": a count per reason; "refusals": their sum.
  nlohmann::json report() const;

 private:
  struct Servo {
    std::uint64_t moves = 0;
    std::uint64_t times_turned_on = 0;
    std::uint64_t times_turned_off = 0;
    std::optional<int> lowest;
    std::optional<int> highest;
    int largest_change = 0;
    double largest_speed = 0;   ///< units per second
    double largest_jump = 0;    ///< from the position at which a servo was turned on to where it was sent then
    std::optional<int> target;  ///< of a servo that is on
    Time commanded{};
  };
  void log(unsigned servo, std::optional<int> value, Time duration, Time time);

  std::ostream* log_;
  std::map<unsigned, Servo> servos_;
  std::map<std::string, std::uint64_t> refused_;
};

}  // namespace lamprey::robot_bridge::emulators
