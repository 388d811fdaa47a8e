#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <thread>

namespace lamprey::messaging::program {

/// Ends a program whose loop has stood still, so that whoever watches over it (`lamprey run`, systemd) starts it again:
/// a call into a DDS implementation that never returns would else keep everybody waiting for ever. Nothing that was
/// acknowledged is lost by that, as by any other end. Time in which the process as a whole did not run does not count.
class StallGuard {
 public:
  static constexpr std::chrono::seconds usual_limit{60};

  /// `end`: what ends the program; says why and aborts by default.
  explicit StallGuard(std::chrono::milliseconds limit = usual_limit, std::function<void()> end = abort_program);
  StallGuard(const StallGuard&) = delete;
  StallGuard& operator=(const StallGuard&) = delete;

  /// The loop goes round. Any thread.
  void alive() noexcept { turns_.fetch_add(1, std::memory_order_relaxed); }

 private:
  static void abort_program();
  void watch(const std::stop_token& stop);

  std::chrono::milliseconds limit_;
  std::function<void()> end_;
  std::atomic<std::uint64_t> turns_ = 0;
  std::jthread thread_;  ///< last: it uses all of the above
};

}  // namespace lamprey::messaging::program
