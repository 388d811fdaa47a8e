#pragma once

#include <algorithm>
#include <chrono>
#include <optional>

namespace lamprey::client::processes {

/// Whether and when a program that has died is started again: after 0.25 s, then after twice as long each time up to 4
/// s; no more after twelve deaths in a row, which is enough for the coordinator to find and quarantine a job that kills
/// its workers. A life of half a minute ends the row.
class RestartPolicy {
 public:
  using Duration = std::chrono::steady_clock::duration;

  static constexpr int most_restarts = 12;
  static constexpr std::chrono::milliseconds first_delay{250};
  static constexpr int most_doublings = 4;
  static constexpr std::chrono::seconds long_life{30};

  /// How long to wait after a life of that length; nothing: give up.
  std::optional<Duration> after_death(Duration life) {
    if (life >= long_life) deaths_ = 0;
    if (deaths_ == most_restarts) return std::nullopt;
    return first_delay * (1 << std::min(deaths_++, most_doublings));
  }

 private:
  int deaths_ = 0;
};

}  // namespace lamprey::client::processes
