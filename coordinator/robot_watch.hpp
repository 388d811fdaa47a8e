#pragma once

#include "messaging/robot_samples.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace lamprey::coordinator {

/// What has happened to a robot, for the event log.
struct RobotEvent {
  std::string kind;  ///< robot_joined, robot_active, robot_evaluations_voided and the like
  std::string text;  ///< the robot's name, and why
  bool operator==(const RobotEvent&) const = default;
};

/// Follows robots by what their bridges say of themselves, and tells what has changed. It decides nothing: who may move
/// a robot is between its bridge and who asks. One thread; times are those given.
class RobotWatch {
 public:
  using Clock = std::chrono::steady_clock;
  /// Of bridges on one domain; what more say is not followed.
  static constexpr std::size_t most_robots = 256;
  /// Bridges speak twice a second.
  static constexpr std::chrono::seconds longest_silence{5};

  /// Texts of `status` may be anything that came from the network.
  std::vector<RobotEvent> heard(const messaging::RobotStatus& status, Clock::time_point now);
  /// Robots that have fallen silent since the last call.
  std::vector<RobotEvent> fallen_silent(Clock::time_point now);

 private:
  struct Seen {
    messaging::RobotStatus status;
    Clock::time_point at;
    Clock::time_point voids_told;
    std::uint64_t voids = 0;  ///< that have been told
    Clock::time_point window_began;
    std::size_t in_window = 0;  ///< events since then
  };

  static std::vector<RobotEvent> changes(Seen& seen, const messaging::RobotStatus& status, std::uint64_t voids,
                                         Clock::time_point now);

  std::map<std::uint64_t, Seen> robots_;  ///< by their number on the wire
};

}  // namespace lamprey::coordinator
