#pragma once

#include "messaging/port.hpp"

#include <atomic>
#include <memory>
#include <stop_token>
#include <thread>

namespace lamprey::messaging::program {

/// While it lives, SIGINT, SIGTERM and SIGHUP (unless that is ignored, as under nohup) ask the program to stop in good
/// order: the token is stopped and `wake` notified, by a thread of its own, so that callbacks of the token may do
/// anything. A second SIGINT ends the process at once with exit_interrupted (a second SIGTERM does not: a parent may
/// send one to a child that has had the terminal's SIGINT). One object at a time; throws std::logic_error otherwise,
/// std::system_error if the system refuses.
class StopOnSignal {
 public:
  explicit StopOnSignal(std::shared_ptr<Signal> wake);
  /// Puts back the handlers that were there before.
  ~StopOnSignal();
  StopOnSignal(const StopOnSignal&) = delete;
  StopOnSignal& operator=(const StopOnSignal&) = delete;

  bool requested() const { return source_.stop_requested(); }
  std::stop_token token() const { return source_.get_token(); }

 private:
  void watch();

  std::shared_ptr<Signal> wake_;
  std::stop_source source_;
  int event_;
  std::atomic<bool> closing_ = false;
  std::thread thread_;
};

}  // namespace lamprey::messaging::program
