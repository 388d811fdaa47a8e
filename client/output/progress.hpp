#pragma once

#include "client/output/console.hpp"
#include "messaging/samples.hpp"

#include <chrono>
#include <optional>
#include <string>

namespace lamprey::client::output {

/// "mutate-all  12,345 / 18,432  67 %  done 12,340  failed 0  leased 350  612 jobs/s  10 s left". The percentage is
/// rounded down: 100 % means all.
std::string progress_line(const messaging::SweepProgress& progress);

/// "66 %": the share of jobs that have ended, rounded down.
std::string percentage(const messaging::SweepProgress& progress);

/// Shows how a sweep goes on, on the console's `err`: on a terminal one line that is rewritten, else a line now and
/// then. One thread.
class ProgressDisplay {
 public:
  using Clock = std::chrono::steady_clock;

  ProgressDisplay(const Console& console, bool quiet) : console_(console), quiet_(quiet) {}
  ~ProgressDisplay() { clear(); }
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  /// What to show from now on. Without a terminal it is written if it is the first one, if it differs and enough time
  /// has passed since the last one, or if `important`.
  void show(const std::string& line, Clock::time_point now, bool important = false);

  /// A message that stays, also with `quiet`.
  void say(const std::string& line);

  /// Removes the rewritten line: what comes next has the screen to itself.
  void clear();

 private:
  void draw();

  const Console& console_;
  bool quiet_;
  std::string shown_;
  bool drawn_ = false;
  std::optional<Clock::time_point> last_;
};

}  // namespace lamprey::client::output
