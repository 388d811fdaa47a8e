#include "robot_bridge/command_gate.hpp"

#include <algorithm>
#include <cmath>

namespace lamprey::robot_bridge {

CommandGate::Decision CommandGate::look(const messaging::ServoCommand& command, const Claims& claims,
                                        Clock::time_point now) {
  if (!claims.holds(command.token, now)) {
    ++counters_.under_no_claim;
    return {};
  }
  if (command.token != token_) {
    token_ = command.token;
    evaluation_ = 0;
    running_ = moving_ = false;
  }
  if (command.evaluation > evaluation_) {
    if (running_) ++counters_.voided;
    evaluation_ = command.evaluation;
    next_step_ = 0;
    running_ = true;
    moving_ = false;
    if (command.time_step != 0) {
      return voided("it begins with step " + std::to_string(command.time_step) + ": those before have not come");
    }
  } else if (command.evaluation < evaluation_ || !running_) {
    const bool repeated = command.evaluation == evaluation_ && command.time_step < next_step_;
    ++(repeated ? counters_.repeated : counters_.of_void);
    return {};
  }
  return next(command);
}

CommandGate::Decision CommandGate::next(const messaging::ServoCommand& command) {
  if (command.time_step < next_step_) {
    ++counters_.repeated;
    return {};
  }
  if (command.time_step > next_step_) return voided("step " + std::to_string(next_step_) + " has not come");
  if (moving_) return voided("step " + std::to_string(next_step_) + " has come before the one before it was over");
  if (!std::ranges::all_of(command.position, [](double position) { return std::isfinite(position); })) {
    ++counters_.not_numbers;
    return voided("a position of step " + std::to_string(next_step_) + " is no number");
  }
  ++counters_.accepted;
  ++next_step_;
  moving_ = true;
  if (command.last) running_ = false;
  return {.accepted = true, .voided = {}};
}

CommandGate::Decision CommandGate::voided(const std::string& reason) {
  running_ = moving_ = false;
  ++counters_.voided;
  return {.voided = reason};
}

void CommandGate::step_done(Clock::time_point now) {
  moving_ = false;
  deadline_ = now + grace_;
}

bool CommandGate::abandon() {
  const bool going_on = running_ || moving_;
  running_ = moving_ = false;
  counters_.voided += std::uint64_t{going_on};
  return going_on;
}

std::optional<std::string> CommandGate::overdue(Clock::time_point now) {
  if (!running_ || moving_ || now < deadline_) return std::nullopt;
  const auto milliseconds = std::chrono::duration_cast<std::chrono::milliseconds>(grace_).count();
  return voided("step " + std::to_string(next_step_) + " has not come within " + std::to_string(milliseconds) + " ms")
      .voided;
}

}  // namespace lamprey::robot_bridge
