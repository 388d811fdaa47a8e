#pragma once

#include "messaging/port.hpp"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

namespace lamprey::messaging {

/// Every bridge hears an emergency stop over this vendor too, whatever its own: it makes a program that has just
/// started known within milliseconds, which takes Fast DDS up to five seconds.
inline constexpr std::string_view emergency_vendor = "cyclonedds";

/// Asks a robot's bridge: one request at a time, sent again under the same correlation until its reply has come. The
/// bridge may thus get a request twice and answers it the same. One thread.
class RobotAsker {
 public:
  using Clock = std::chrono::steady_clock;
  /// At first often, since whoever has just joined may not be known to the bridge yet, and may be in a hurry.
  static constexpr std::chrono::milliseconds first_resend_interval{20};
  static constexpr std::chrono::milliseconds resend_interval{200};
  static constexpr int first_sends = 50;

  /// `asker` names the partition of the replies; `robot` is the robot's number. `signal` is notified of replies.
  RobotAsker(Participant& participant, std::shared_ptr<Signal> signal, std::uint64_t robot, std::uint64_t asker);

  /// Sends the request, whose robot, asker and correlation it fills in; one that was waiting is forgotten.
  void begin(RobotRequest request, Clock::time_point now);
  bool waiting() const { return pending_.has_value(); }

  /// The reply, if it has come; sends the request again when that is due.
  std::optional<RobotReply> poll(Clock::time_point now);

  /// begin() and poll() until there is a reply, `timeout` has passed or `stop` is true; no reply then. Waits for the
  /// signal, which may belong to others, too.
  std::optional<RobotReply> ask(const RobotRequest& request, Clock::duration timeout,
                                const std::function<bool()>& stop) {
    return ask(std::span(this, 1), request, timeout, stop);
  }
  /// The same of several at once, which share a signal: the first reply counts.
  static std::optional<RobotReply> ask(std::span<RobotAsker> askers, const RobotRequest& request,
                                       Clock::duration timeout, const std::function<bool()>& stop);

 private:
  void send(Clock::time_point now);

  struct Pending {
    RobotRequest sample;
    Clock::time_point due;
    int sends = 0;
  };
  std::shared_ptr<Signal> signal_;
  std::uint64_t robot_;
  std::uint64_t asker_;
  // The reader is made before the writer, so that no reply can come before there is somebody to get it.
  std::unique_ptr<Reader<RobotReply>> replies_;
  std::unique_ptr<Writer<RobotRequest>> requests_;
  std::uint64_t correlation_ = 0;
  std::optional<Pending> pending_;
};

}  // namespace lamprey::messaging
