#pragma once

#include "messaging/port.hpp"
#include "messaging/robot/robot_asker.hpp"

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

namespace lamprey::worker {

/// A worker's side of a robot's bridge: the claim, and steps under it. One thread.
class RobotConnection {
 public:
  using Clock = std::chrono::steady_clock;

  /// `asker` isn't 0; it names this worker to the bridge.
  RobotConnection(messaging::Participant& participant, const std::string& robot, std::uint64_t asker);

  /// Claims the robot, or renews the claim when that is due; false if it isn't ours now: why_not() says why.
  bool keep_claim(const std::stop_token& stop);
  const std::string& why_not() const { return why_not_; }
  bool claimed() const { return token_ != 0; }
  std::uint64_t token() const { return token_; }
  const std::string& robot() const { return robot_; }

  void release(const std::stop_token& stop);

  /// Brings the robot to the positions; the reason if it can't be.
  std::optional<std::string> place(const messaging::ServoPositions& positions, const std::stop_token& stop);

  /// Orders a step and waits for its state; one that is void for a reason of ours (no answer) has that reason.
  messaging::ServoState step(const messaging::ServoCommand& command, const std::stop_token& stop);

  /// Waits for news, or so long.
  void wait(std::chrono::milliseconds time) { signal_->wait_for(time); }

 private:
  std::optional<messaging::RobotReply> ask(messaging::RobotRequest request, Clock::duration timeout,
                                           const std::stop_token& stop);
  bool lost(const std::string& reason);

  std::string robot_;
  std::uint64_t number_;
  std::shared_ptr<messaging::Signal> signal_ = std::make_shared<messaging::Signal>();
  messaging::RobotAsker asker_;
  std::unique_ptr<messaging::Reader<messaging::ServoState>> states_;
  std::unique_ptr<messaging::Writer<messaging::ServoCommand>> commands_;
  std::uint64_t token_ = 0;
  std::chrono::milliseconds lease_{0};
  Clock::time_point renewal_due_{};
  std::string why_not_ = "its bridge has not answered";
};

}  // namespace lamprey::worker
