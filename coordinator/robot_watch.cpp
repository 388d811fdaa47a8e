#include "coordinator/robot_watch.hpp"

#include "experiment/problem.hpp"
#include "messaging/robot/robot_state.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

namespace lamprey::coordinator {
namespace {

using messaging::RobotState;
using messaging::RobotStatus;

/// A robot that trips over each evaluation, or two bridges of one name, would fill the log.
constexpr std::chrono::seconds voids_interval{10};
constexpr std::chrono::seconds window{10};
constexpr std::size_t most_in_window = 20;

std::string kind_of(RobotState state) {
  return state == RobotState::finalized ? "robot_left" : "robot_" + std::string(to_text(state));
}

std::uint64_t counted(const RobotStatus& status, std::string_view name) {
  const auto found = std::ranges::find(status.counters, name, &messaging::RobotCounter::name);
  return found == status.counters.end() ? 0 : found->value;
}

std::string told(const RobotStatus& status, const std::string& why) {
  return experiment::printable(status.name) + (why.empty() ? "" : ": " + experiment::printable(why));
}

std::vector<RobotEvent> first_events(const RobotStatus& status) {
  std::vector<RobotEvent> events{{"robot_joined", told(status, status.driver + " on " + status.host)},
                                 {kind_of(status.state), told(status, status.stopped ? "" : status.reason)}};
  if (status.stopped) events.push_back({"robot_stopped", told(status, status.reason)});
  return events;
}

}  // namespace

std::vector<RobotEvent> RobotWatch::heard(const RobotStatus& status, Clock::time_point now) {
  const std::uint64_t voids = counted(status, "evaluations_voided");
  const auto found = robots_.find(status.robot);
  if (found == robots_.end()) {
    if (status.state == RobotState::finalized || robots_.size() >= most_robots) return {};
    robots_.emplace(status.robot, Seen{.status = status,
                                       .at = now,
                                       .voids_told = now - voids_interval,
                                       .voids = voids,
                                       .window_began = now,
                                       .in_window = 0});
    return first_events(status);
  }
  Seen& seen = found->second;
  auto events = changes(seen, status, voids, now);
  seen.status = status;
  seen.at = now;
  if (status.state == RobotState::finalized) robots_.erase(found);
  return events;
}

std::vector<RobotEvent> RobotWatch::changes(Seen& seen, const RobotStatus& status, std::uint64_t voids,
                                            Clock::time_point now) {
  std::vector<RobotEvent> events;
  if (seen.status.incarnation != status.incarnation) {
    events.push_back({"robot_joined", told(status, status.driver + " on " + status.host + ", again")});
    seen.voids = 0;
  }
  if (seen.status.stopped != status.stopped) {
    events.push_back({status.stopped ? "robot_stopped" : "robot_reset", told(status, status.reason)});
  }
  if (seen.status.state != status.state) events.push_back({kind_of(status.state), told(status, status.reason)});
  if (voids > seen.voids && now - seen.voids_told >= voids_interval) {
    events.push_back({"robot_evaluations_voided", told(status, std::to_string(voids - seen.voids))});
    seen.voids_told = now;
    seen.voids = voids;
  }
  if (now - seen.window_began >= window) {
    seen.window_began = now;
    seen.in_window = 0;
  }
  seen.in_window += events.size();
  if (seen.in_window <= most_in_window) return events;
  if (seen.in_window - events.size() > most_in_window) return {};
  return {{"robot_unsteady", told(status, "changes more often than is told; are there two bridges of this name?")}};
}

std::vector<RobotEvent> RobotWatch::fallen_silent(Clock::time_point now) {
  std::vector<RobotEvent> events;
  std::erase_if(robots_, [&](const auto& robot) {
    if (now - robot.second.at < longest_silence) return false;
    events.push_back({"robot_lost", told(robot.second.status, "")});
    return true;
  });
  return events;
}

}  // namespace lamprey::coordinator
