#include "worker/robot/robot_connection.hpp"

#include "messaging/robot/robot_name.hpp"

#include <spdlog/spdlog.h>
#include <utility>

namespace lamprey::worker {
namespace {

constexpr std::chrono::milliseconds claim_answer{500};
/// Homing across the whole range at a cautious slew rate.
constexpr std::chrono::seconds placing_answer{70};
/// A bridge tells of a step that is missing sooner; after this its telling has been lost.
constexpr std::chrono::milliseconds step_answer{1000};

}  // namespace

RobotConnection::RobotConnection(messaging::Participant& participant, const std::string& robot, std::uint64_t asker)
    : robot_(robot),
      number_(messaging::robot_number(robot)),
      asker_(participant, signal_, number_, asker),
      states_(participant.reader<messaging::ServoState>(signal_, messaging::Partition::of(number_))),
      commands_(participant.writer<messaging::ServoCommand>(messaging::Partition::of(number_))) {}

std::optional<messaging::RobotReply> RobotConnection::ask(messaging::RobotRequest request, Clock::duration timeout,
                                                          const std::stop_token& stop) {
  request.token = token_;
  return asker_.ask(request, timeout, [&] { return stop.stop_requested(); });
}

bool RobotConnection::lost(const std::string& reason) {
  if (token_ != 0) spdlog::warn("robot {}: claim {} is lost: {}", robot_, token_, reason);
  token_ = 0;
  why_not_ = reason;
  return false;
}

bool RobotConnection::keep_claim(const std::stop_token& stop) {
  const auto now = Clock::now();
  if (token_ != 0 && now < renewal_due_) return true;
  messaging::RobotRequest request;
  request.kind = messaging::RobotRequestKind::claim;
  const auto reply = ask(request, claim_answer, stop);
  if (!reply) {
    // The claim lasts longer than one answer that is lost.
    if (token_ != 0 && now < renewal_due_ + lease_) return true;
    return lost("its bridge does not answer");
  }
  if (!reply->granted) return lost(reply->reason);
  if (token_ == 0) spdlog::info("robot {}: claim {} is ours", robot_, reply->token);
  token_ = reply->token;
  lease_ = std::chrono::milliseconds(reply->lease_milliseconds);
  renewal_due_ = now + lease_ / 4;
  return true;
}

void RobotConnection::release(const std::stop_token& stop) {
  if (token_ == 0) return;
  messaging::RobotRequest request;
  request.kind = messaging::RobotRequestKind::release;
  ask(request, claim_answer, stop);
  token_ = 0;
}

std::optional<std::string> RobotConnection::place(const messaging::ServoPositions& positions,
                                                  const std::stop_token& stop) {
  messaging::RobotRequest request;
  request.kind = messaging::RobotRequestKind::place;
  request.position = positions;
  const auto reply = ask(request, placing_answer, stop);
  if (!reply) return "its bridge has not placed it";
  if (!reply->granted) return reply->reason;
  renewal_due_ = Clock::now() + lease_ / 4;
  return std::nullopt;
}

messaging::ServoState RobotConnection::step(const messaging::ServoCommand& given, const std::stop_token& stop) {
  messaging::ServoCommand command = given;
  command.robot = number_;
  command.token = token_;
  messaging::ServoState failed;
  failed.outcome = messaging::StepOutcome::voided;
  if (const auto written = commands_->write(command); !written) {
    failed.reason = "the command could not be sent: " + written.error;
    return failed;
  }
  const auto until = Clock::now() + step_answer;
  while (Clock::now() < until && !stop.stop_requested()) {
    for (auto& state : states_->take()) {
      if (state.robot != number_ || state.token != token_ || state.evaluation != command.evaluation) continue;
      const bool is_void = state.outcome == messaging::StepOutcome::voided;
      if (!is_void && state.time_step != command.time_step) continue;
      renewal_due_ = Clock::now() + lease_ / 4;  // a command renews the claim
      return std::move(state);
    }
    signal_->wait_for(std::chrono::milliseconds(20));
  }
  failed.reason =
      stop.stop_requested() ? "the worker stops" : "nothing was heard of step " + std::to_string(command.time_step);
  return failed;
}

}  // namespace lamprey::worker
