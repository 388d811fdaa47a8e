#include "client/output/progress.hpp"

#include "client/output/formatting.hpp"

#include <algorithm>
#include <cstdint>

namespace lamprey::client::output {

namespace {

constexpr auto between_lines = std::chrono::seconds{5};

std::uint64_t jobs_ended(const messaging::SweepProgress& progress) {
  return progress.done + progress.failed + progress.quarantined + progress.cancelled;
}

}  // namespace

std::string percentage(const messaging::SweepProgress& progress) {
  const std::uint64_t ended = jobs_ended(progress);
  if (ended >= progress.jobs) return "100 %";
  const double share = static_cast<double>(ended) / static_cast<double>(progress.jobs);
  return std::to_string(std::min<std::uint64_t>(static_cast<std::uint64_t>(100 * share), 99)) + " %";
}

std::string progress_line(const messaging::SweepProgress& progress) {
  const std::uint64_t ended = jobs_ended(progress);
  std::string line = progress.name + "  " + with_thousands(ended) + " / " + with_thousands(progress.jobs) + "  " +
                     percentage(progress);
  line += "  done " + with_thousands(progress.done) + "  failed " + with_thousands(progress.failed);
  if (progress.quarantined > 0) line += "  quarantined " + with_thousands(progress.quarantined);
  if (progress.cancelled > 0) line += "  cancelled " + with_thousands(progress.cancelled);
  if (progress.divergences > 0) line += "  divergent " + with_thousands(progress.divergences);
  if (ended >= progress.jobs) return line;
  if (progress.state == "cancelling" || progress.state == "paused" || progress.state == "deleting") {
    return line + "  " + progress.state;
  }
  line += "  leased " + with_thousands(progress.leased);
  if (progress.workers == 0) return line + "  waiting for workers";
  if (progress.jobs_per_second > 0) line += "  " + rate(progress.jobs_per_second);
  if (progress.seconds_left >= 0) line += "  " + duration(progress.seconds_left) + " left";
  return line;
}

void ProgressDisplay::show(const std::string& line, Clock::time_point now, bool important) {
  if (quiet_) return;
  if (console_.err_is_terminal) {
    if (line == shown_ && drawn_) return;
    shown_ = line;
    draw();
    return;
  }
  const bool due = !last_ || (line != shown_ && now - *last_ >= between_lines);
  if (!due && !(important && line != shown_)) return;
  last_ = now;
  shown_ = line;
  console_.err << line << std::endl;
}

void ProgressDisplay::say(const std::string& line) {
  const bool was_drawn = drawn_;
  clear();
  console_.err << line << std::endl;
  if (was_drawn) draw();
}

void ProgressDisplay::clear() {
  if (!drawn_) return;
  console_.err << "\r\x1b[K" << std::flush;
  drawn_ = false;
}

void ProgressDisplay::draw() {
  // The last column stays free: some terminals wrap as soon as it is written.
  console_.err << '\r' << cut(shown_, console_.columns - 1, console_.ellipsis()) << "\x1b[K" << std::flush;
  drawn_ = true;
}

}  // namespace lamprey::client::output
