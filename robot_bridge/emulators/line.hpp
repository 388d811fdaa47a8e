#pragma once

#include "robot_bridge/emulators/controller.hpp"
#include "robot_bridge/emulators/faults.hpp"
#include "robot_bridge/emulators/traffic.hpp"
#include "robot_bridge/emulators/wire.hpp"

#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <vector>

namespace lamprey::robot_bridge::emulators {

/// A controller at the end of its two wires, with the faults in between. Knows no clock and no file: times come in.
class Line {
 public:
  /// `controller` outlives the line.
  Line(Controller& controller, unsigned baud, std::uint64_t seed)
      : controller_(&controller), faults_(seed), to_controller_(baud), from_controller_(baud) {}

  /// Octets were written to the line at `now`.
  void sent(std::span<const std::uint8_t> octets, Time now) { to_controller_.send(octets, now); }
  /// Octets were written at another speed than the controller's: it makes nothing of them.
  void sent_at_another_speed(std::size_t octets) { at_another_speed_ += octets; }
  /// Octets of answers found no room at the reader's end.
  void overrun(std::size_t octets) { overrun_ += octets; }

  /// Lets the controller act on all that has arrived by `now`, and returns the answers' octets that have come through.
  std::vector<std::uint8_t> run(Time now);

  /// When there will be something to run next; nothing while both wires are empty.
  std::optional<Time> next() const;

  /// Octets on their way to the controller.
  std::size_t waiting() const { return to_controller_.waiting(); }

  /// Pulls the plug: what is on the way is lost.
  void cut();

  Controller& controller() { return *controller_; }
  Faults& faults() { return faults_; }
  /// Octets in both directions and what became of them.
  nlohmann::json report() const;

 private:
  Controller* controller_;
  Faults faults_;
  Wire to_controller_;
  Wire from_controller_;
  Traffic received_;
  Traffic answered_;
  std::uint64_t at_another_speed_ = 0;
  std::uint64_t overrun_ = 0;
};

}  // namespace lamprey::robot_bridge::emulators
