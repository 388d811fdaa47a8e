#include "robot_bridge/ros2/face.hpp"

#include "messaging/robot/robot_state.hpp"
#include "robot_bridge/ros2/angles.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <spdlog/spdlog.h>
#include <string_view>
#include <utility>

namespace lamprey::robot_bridge::ros2 {
namespace {

using wire::DiagnosticLevel;
using WallTime = std::chrono::system_clock::time_point;

constexpr std::chrono::seconds diagnostics_interval{1};
/// Two readings further apart than this tell nothing of how fast a joint moves now.
constexpr std::chrono::milliseconds longest_motion{500};
/// The robot's body, after REP 105.
const std::string_view frame = "base_link";

constexpr std::array<std::string_view, refusals> refusal_names{"wrong_size", "not_numbers", "claimed", "not_active",
                                                               "busy"};

wire::Stamp stamp_of(WallTime time) {
  const auto whole = std::chrono::floor<std::chrono::seconds>(time);
  const auto rest = std::chrono::duration_cast<std::chrono::nanoseconds>(time - whole);
  return {.seconds = static_cast<std::int32_t>(whole.time_since_epoch().count()),
          .nanoseconds = static_cast<std::uint32_t>(rest.count())};
}

DiagnosticLevel level_of(RobotState state, bool stopped) {
  switch (state) {
    case RobotState::fault:
      return DiagnosticLevel::error;
    case RobotState::unconfigured:
    case RobotState::finalized:
      return DiagnosticLevel::warn;
    case RobotState::inactive:
    case RobotState::active:
      break;
  }
  return stopped ? DiagnosticLevel::warn : DiagnosticLevel::ok;
}

/// rad/s between two readings.
std::vector<double> velocities(const std::vector<double>& before, const std::vector<double>& after,
                               std::chrono::nanoseconds between) {
  const double seconds = std::chrono::duration<double>(between).count();
  std::vector<double> result(after.size());
  std::ranges::transform(after, before, result.begin(), [&](double to, double from) { return (to - from) / seconds; });
  return result;
}

}  // namespace

Face::Face(wire::Node& node, const std::shared_ptr<messaging::Signal>& signal, const Bridge& bridge,
           ControlLoop& control, const Calibration& calibration, std::string robot)
    : bridge_(bridge),
      control_(control),
      calibration_(calibration),
      range_(calibration),
      robot_(std::move(robot)),
      node_(node),
      commands_(node.reader<wire::JointCommand>(signal)),
      joints_(node.writer<wire::JointState>()),
      diagnostics_(node.writer<wire::Diagnostics>()) {}

void Face::step(Clock::time_point now, WallTime wall) {
  take_commands(now);
  publish_joints(now, wall);
  auto present = condition(now);
  if (present == told_ && now < diagnostics_due_) return;
  diagnostics_due_ = now + diagnostics_interval;
  publish_diagnostics(present, wall);
  told_ = std::move(present);
}

void Face::finish(WallTime wall) {
  auto present = condition(Clock::now());
  present.state = RobotState::finalized;
  present.claimed = false;
  publish_diagnostics(present, wall);
}

std::optional<Refusal> Face::fault_of(const wire::JointCommand& command) {
  if (command.positions.size() != servos || command.offset != 0) return Refusal::wrong_size;
  const bool numbers = std::ranges::all_of(command.positions, [](double angle) { return std::isfinite(angle); });
  return numbers ? std::nullopt : std::optional(Refusal::not_numbers);
}

void Face::take_commands(Clock::time_point now) {
  std::optional<Pose> wanted;
  for (const auto& command : commands_->take()) {
    if (const auto fault = fault_of(command)) {
      refuse(*fault, *fault == Refusal::wrong_size ? "it has " + std::to_string(command.positions.size()) +
                                                         " angles from number " + std::to_string(command.offset) +
                                                         " on, not " + std::to_string(servos) + " from number 0 on"
                                                   : "an angle is no number");
      continue;
    }
    if (bridge_.claimed(now)) {
      refuse(Refusal::claimed, "a job has the robot");
      continue;
    }
    if (const auto hindrance = bridge_.hindrance(); !hindrance.empty()) {
      refuse(Refusal::not_active, hindrance);
      continue;
    }
    superseded_ += std::uint64_t{wanted.has_value()};
    wanted = to_pose(calibration_, std::span<const double, servos>(command.positions));
  }
  if (!wanted) return;
  const Pose reachable = range_.within_range(*wanted);
  if (!control_.place_if_free(reachable)) return refuse(Refusal::busy, "the robot is told something else just now");
  ++obeyed_;
  out_of_range_ += std::uint64_t{reachable != *wanted};
}

/// Each kind is logged once, or whoever sends many commands would fill the log.
void Face::refuse(Refusal refusal, const std::string& reason) {
  const auto kind = static_cast<std::size_t>(refusal);
  if (refused_[kind]++ > 0) return;
  spdlog::warn("a command of ROS 2 is refused: {}; further ones refused for such a reason are only counted", reason);
}

void Face::publish_joints(Clock::time_point now, WallTime wall) {
  const auto reading = control_.reading();
  if (!reading || (last_reading_ && reading->number == last_reading_->number)) return;
  wire::JointState state;
  state.stamp = stamp_of(wall - std::chrono::duration_cast<WallTime::duration>(now - reading->at));
  state.frame = frame;
  state.names.assign(joint_names.begin(), joint_names.end());
  state.positions = to_radians(calibration_, reading->position);
  if (last_reading_ && last_reading_->measured && reading->measured && reading->at > last_reading_->at &&
      reading->at - last_reading_->at <= longest_motion) {
    state.velocities =
        velocities(to_radians(calibration_, last_reading_->position), state.positions, reading->at - last_reading_->at);
  }
  last_reading_ = reading;
  // The next one follows soon.
  static_cast<void>(joints_->write(state));
}

Face::Condition Face::condition(Clock::time_point now) const {
  const auto status = control_.status();
  const bool stopped = bridge_.stopped();
  return {.state = status.state,
          .stopped = stopped,
          .claimed = bridge_.claimed(now),
          .reason = stopped ? bridge_.hindrance() : status.reason,
          .device = status.device};
}

void Face::publish_diagnostics(const Condition& condition, WallTime wall) {
  wire::DiagnosticStatus status;
  status.level = level_of(condition.state, condition.stopped);
  status.name = "lamprey-bridge: " + robot_;
  status.message = std::string(to_text(condition.state)) + (condition.reason.empty() ? "" : ": ") + condition.reason;
  status.hardware = condition.device;
  const auto yes_or_no = [](bool value) { return std::string(value ? "yes" : "no"); };
  status.values = {{"state", std::string(to_text(condition.state))},
                   {"stopped", yes_or_no(condition.stopped)},
                   {"claimed", yes_or_no(condition.claimed)},
                   {"reason", condition.reason}};
  for (const auto& counter : bridge_.counters())
    status.values.emplace_back(counter.name, std::to_string(counter.value));
  for (const auto& counter : counters()) status.values.emplace_back(counter.name, std::to_string(counter.value));
  static_cast<void>(diagnostics_->write({.stamp = stamp_of(wall), .frame = {}, .statuses = {std::move(status)}}));
}

std::vector<messaging::RobotCounter> Face::counters() const {
  std::vector<messaging::RobotCounter> all{{"ros2_commands_obeyed", obeyed_},
                                           {"ros2_commands_superseded", superseded_},
                                           {"ros2_commands_out_of_range", out_of_range_}};
  for (std::size_t kind = 0; kind < refusals; ++kind) {
    all.push_back({"ros2_commands_refused_" + std::string(refusal_names[kind]), refused_[kind]});
  }
  all.push_back({"ros2_samples_malformed", node_.malformed_samples()});
  return all;
}

}  // namespace lamprey::robot_bridge::ros2
