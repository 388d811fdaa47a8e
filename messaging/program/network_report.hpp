#pragma once

#include "messaging/port.hpp"

#include <chrono>
#include <memory>
#include <set>
#include <string>

namespace lamprey::messaging::program {

/// What a program that stays has to do with its network besides its work: each second it tells whoever looks (`lamprey
/// net`) how much it has exchanged, and it warns once of each program of its isolation that it can never meet, because
/// that is of another version. One thread; must not outlive the participant.
class NetworkReport {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds traffic_interval{1};
  static constexpr std::chrono::seconds look_interval{5};
  /// Further programs of other versions are not told of: they name themselves as they like.
  static constexpr std::size_t most_warnings = 256;

  /// `own`: as in the options that the participant joined with.
  NetworkReport(Participant& participant, const JoinOptions& own);

  /// Does what is due by `now`; call it often.
  void step(Clock::time_point now);

 private:
  void look();

  Participant& participant_;
  discovery::Introduction own_;
  std::unique_ptr<Writer<Traffic>> traffic_;
  Clock::time_point traffic_due_{};
  Clock::time_point look_due_{};
  std::set<std::string> told_;
};

}  // namespace lamprey::messaging::program
