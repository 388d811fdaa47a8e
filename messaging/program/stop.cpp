#include "messaging/program/stop.hpp"

#include "messaging/program/exit_codes.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <sys/eventfd.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace lamprey::messaging::program {
namespace {

// A signal handler has no other way to its data than globals. Lock-free atomics are safe in it.
std::atomic<int> handler_event = -1;
std::atomic<int> interrupts = 0;
static_assert(std::atomic<int>::is_always_lock_free);

constexpr std::array stopping_signals{SIGINT, SIGTERM, SIGHUP};
std::array<struct sigaction, stopping_signals.size()> previous_actions{};

void add_one(int event) {
  const std::uint64_t one = 1;
  [[maybe_unused]] const auto written = write(event, &one, sizeof one);
}

/// Calls nothing but what POSIX calls async-signal-safe.
void on_signal(int number) {
  const int saved = errno;
  if (number == SIGINT && interrupts.fetch_add(1) > 0) _exit(exit_interrupted);
  add_one(handler_event.load());
  errno = saved;
}

}  // namespace

StopOnSignal::StopOnSignal(std::shared_ptr<Signal> wake) : wake_(std::move(wake)), event_(eventfd(0, EFD_CLOEXEC)) {
  if (event_ < 0) throw std::system_error(errno, std::generic_category(), "eventfd");
  int none = -1;
  if (!handler_event.compare_exchange_strong(none, event_)) {
    close(event_);
    throw std::logic_error("there is a StopOnSignal already");
  }
  interrupts = 0;
  thread_ = std::thread([this] { watch(); });
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < stopping_signals.size(); ++i) {
    sigaction(stopping_signals[i], &action, &previous_actions[i]);
    // Started with nohup: it is to go on when its terminal has gone.
    const bool ignored = stopping_signals[i] == SIGHUP && previous_actions[i].sa_handler == SIG_IGN;
    if (ignored) sigaction(SIGHUP, &previous_actions[i], nullptr);
  }
}

StopOnSignal::~StopOnSignal() {
  for (std::size_t i = 0; i < stopping_signals.size(); ++i) {
    sigaction(stopping_signals[i], &previous_actions[i], nullptr);
  }
  closing_ = true;
  add_one(event_);
  thread_.join();
  handler_event = -1;
  close(event_);
}

void StopOnSignal::watch() {
  for (;;) {
    std::uint64_t count = 0;
    if (read(event_, &count, sizeof count) < 0) {
      if (errno == EINTR) continue;
      return;
    }
    if (closing_) return;
    source_.request_stop();
    if (wake_) wake_->notify();
  }
}

}  // namespace lamprey::messaging::program
