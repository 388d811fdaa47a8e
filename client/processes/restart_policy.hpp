#pragma once

#include <chrono>
#include <optional>

namespace lamprey::client::processes {

/// Whether and when a program that has died is started again: after 0.25 s, then after twice as long each time; no more
/// after five deaths in a row. A life of half a minute ends the row.
class RestartPolicy {
 public:
  using Duration = std::chrono::steady_clock::duration;

  static constexpr int most_restarts = 5;
  static constexpr std::chrono::milliseconds first_delay{250};
  static constexpr std::chrono::seconds long_life{30};

  /// How long to wait after a life of that length; nothing: give up.
  std::optional<Duration> after_death(Duration life) {
    if (life >= long_life) deaths_ = 0;
    if (deaths_ == most_restarts) return std::nullopt;
    return first_delay * (1 << deaths_++);
  }

 private:
  int deaths_ = 0;
};

}  // namespace lamprey::client::processes
