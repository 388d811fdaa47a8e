#include "messaging/robot/robot_asker.hpp"

#include <algorithm>
#include <utility>

namespace lamprey::messaging {

RobotAsker::RobotAsker(Participant& participant, std::shared_ptr<Signal> signal, std::uint64_t robot,
                       std::uint64_t asker)
    : signal_(std::move(signal)),
      robot_(robot),
      asker_(asker),
      replies_(participant.reader<RobotReply>(signal_, Partition::of(asker))),
      requests_(participant.writer<RobotRequest>(Partition::of(robot))) {}

void RobotAsker::begin(RobotRequest request, Clock::time_point now) {
  request.robot = robot_;
  request.asker = asker_;
  request.correlation = ++correlation_;
  pending_ = Pending{std::move(request), now, 0};
  send(now);
}

void RobotAsker::send(Clock::time_point now) {
  pending_->due = now + (++pending_->sends < first_sends ? first_resend_interval : resend_interval);
  // One that could not be written is sent again like one that was lost.
  static_cast<void>(requests_->write(pending_->sample));
}

std::optional<RobotReply> RobotAsker::poll(Clock::time_point now) {
  for (auto& reply : replies_->take()) {
    const bool mine =
        pending_ && reply.robot == robot_ && reply.asker == asker_ && reply.correlation == pending_->sample.correlation;
    if (!mine) continue;
    pending_.reset();
    return std::move(reply);
  }
  if (pending_ && now >= pending_->due) send(now);
  return std::nullopt;
}

std::optional<RobotReply> RobotAsker::ask(std::span<RobotAsker> askers, const RobotRequest& request,
                                          Clock::duration timeout, const std::function<bool()>& stop) {
  constexpr std::chrono::milliseconds look_interval{10};
  const auto until = Clock::now() + timeout;
  std::optional<RobotReply> reply;
  for (auto& asker : askers) asker.begin(request, Clock::now());
  while (true) {
    const auto now = Clock::now();
    for (auto& asker : askers) {
      if (!reply) reply = asker.poll(now);
    }
    if (reply || now >= until || stop()) break;
    askers.front().signal_->wait_for(
        std::min(look_interval, std::chrono::ceil<std::chrono::milliseconds>(until - now)));
  }
  for (auto& asker : askers) asker.pending_.reset();
  return reply;
}

}  // namespace lamprey::messaging
