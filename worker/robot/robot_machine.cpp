#include "worker/robot/robot_machine.hpp"

#include <algorithm>
#include <cmath>
#include <spdlog/spdlog.h>
#include <stdexcept>
#include <string>
#include <utility>

namespace lamprey::worker {
namespace {

using science::robots::MachineReport;
using Targets = std::array<std::int16_t, science::robots::servos>;

messaging::ServoPositions positions(const Targets& targets) {
  messaging::ServoPositions all{};
  std::ranges::copy(targets, all.begin());
  return all;
}

MachineReport report(const messaging::ServoState& state) {
  return {.position = state.reported, .feet_down = state.feet_down};
}

}  // namespace

RobotMachine::RobotMachine(RobotConnection& connection, Recorder& recorder, std::uint64_t& evaluations,
                           std::stop_token stop, std::chrono::milliseconds patience)
    : connection_(connection),
      recorder_(recorder),
      evaluations_(evaluations),
      stop_(std::move(stop)),
      patience_(patience) {}

/// Waits for a robot that can't be moved: its line may be plugged in again, its emergency stop be reset.
void RobotMachine::place(const messaging::ServoPositions& posture) {
  const auto until = RobotConnection::Clock::now() + patience_;
  std::string said;
  while (!stop_.stop_requested()) {
    const bool ours = connection_.keep_claim(stop_);
    const auto reason = ours ? connection_.place(posture, stop_) : connection_.why_not();
    if (!reason) return;
    if (std::exchange(said, *reason) != *reason) spdlog::warn("robot {}: {}", connection_.robot(), *reason);
    if (RobotConnection::Clock::now() > until) break;
    connection_.wait(std::chrono::milliseconds(200));
  }
  throw JobGivenBack();
}

MachineReport RobotMachine::begin(const Targets& posture, std::int32_t time_steps) {
  if (recorder_.rejected() >= most_tries) {
    throw std::runtime_error("an evaluation was void " + std::to_string(most_tries) + " times in a row");
  }
  const auto wanted = positions(posture);
  if (!placed_ || standing_ != wanted) place(wanted);
  placed_ = false;
  recorder_.begin();
  ++evaluations_;
  next_step_ = 0;
  last_step_ = static_cast<std::uint32_t>(time_steps);
  // A step in which it stands: what it reports then is what the first step is compared with.
  return order(posture, false);
}

MachineReport RobotMachine::step(const Targets& target) {
  const bool last = next_step_ == last_step_;
  const MachineReport after = order(target, last);
  if (last) {
    recorder_.accept();
    placed_ = true;
    standing_ = positions(target);
  }
  return after;
}

MachineReport RobotMachine::order(const Targets& target, bool last) {
  messaging::ServoCommand command;
  command.evaluation = evaluations_;
  command.time_step = next_step_++;
  command.last = last;
  command.position = positions(target);
  auto state = connection_.step(command, stop_);
  const bool numbers = std::ranges::all_of(state.reported, [](double position) { return std::isfinite(position); });
  if (state.outcome == messaging::StepOutcome::done && numbers) {
    recorder_.add(state);
    return report(state);
  }
  if (stop_.stop_requested()) throw JobGivenBack();
  const std::string reason = numbers ? state.reason : "a position that the robot reports is no number";
  recorder_.reject(reason);
  spdlog::info("robot {}: evaluation {} is void: {}", connection_.robot(), evaluations_, reason);
  throw science::robots::EvaluationVoid(reason);
}

}  // namespace lamprey::worker
