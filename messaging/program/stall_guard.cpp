#include "messaging/program/stall_guard.hpp"

#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <spdlog/spdlog.h>
#include <utility>

namespace lamprey::messaging::program {

StallGuard::StallGuard(std::chrono::milliseconds limit, std::function<void()> end)
    : limit_(limit), end_(std::move(end)), thread_([this](const std::stop_token& stop) { watch(stop); }) {}

/// Counts its own looks instead of reading a clock: a process that was stopped, or a machine that slept, did not stall.
void StallGuard::watch(const std::stop_token& stop) {
  constexpr int looks_in_limit = 20;
  std::mutex mutex;
  std::condition_variable_any wake;
  std::uint64_t turns = turns_;
  int looks = 0;
  while (!stop.stop_requested()) {
    std::unique_lock lock(mutex);
    wake.wait_for(lock, stop, limit_ / looks_in_limit, [] { return false; });
    const std::uint64_t now = turns_;
    looks = std::exchange(turns, now) == now ? looks + 1 : 0;
    if (looks <= looks_in_limit || stop.stop_requested()) continue;
    end_();
    looks = 0;
  }
}

void StallGuard::abort_program() {
  spdlog::critical(
      "the program has stood still for {} s within a call that does not return; it ends, to be started again",
      usual_limit.count());
  spdlog::default_logger()->flush();
  std::abort();
}

}  // namespace lamprey::messaging::program
