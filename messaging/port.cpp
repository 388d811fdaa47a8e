#include "messaging/port.hpp"

#include "messaging/qos.hpp"

#include <utility>

namespace lamprey::messaging {

void Signal::notify() {
  {
    const std::lock_guard lock(mutex_);
    if (std::exchange(notified_, true)) return;  // whoever waits is being woken
  }
  condition_.notify_one();
}

bool Signal::wait_for(std::chrono::milliseconds timeout) {
  std::unique_lock lock(mutex_);
  const bool notified = condition_.wait_for(lock, timeout, [this] { return notified_; });
  notified_ = false;
  return notified;
}

discovery::Introduction introduction_of(const JoinOptions& options) {
  auto introduction = options.introduction;
  introduction.isolation = options.isolation;
  introduction.wire = wire_version;
  return introduction;
}

std::string user_data_of(const JoinOptions& options) {
  return discovery::user_data_of(introduction_of(options));
}

}  // namespace lamprey::messaging
