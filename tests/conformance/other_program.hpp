#pragma once

#include "messaging/port.hpp"

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace lamprey::messaging::conformance {

/// A process of its own that reads or writes one topic (other_program_main.cpp), to be stopped or killed. Not
/// thread-safe.
class OtherProgram {
 public:
  /// `arguments`: what it is to do. It joins as `options` say, without peers.
  OtherProgram(const JoinOptions& options, const std::vector<std::string>& arguments);
  ~OtherProgram();
  OtherProgram(const OtherProgram&) = delete;
  OtherProgram& operator=(const OtherProgram&) = delete;

  void kill();  ///< ends it at once; returns when it is gone
  void stop();  ///< returns when it has stopped
  void resume();

  /// Collects what it says until `enough` says so; false if it never did.
  bool listen_until(const std::function<bool(const std::vector<std::uint64_t>&)>& enough);

  /// The numbers it has said so far: a reader's samples, a writer's last sample.
  std::vector<std::uint64_t> said;

 private:
  void listen(std::chrono::milliseconds timeout);

  pid_t process_ = -1;
  int output_ = -1;
  std::string rest_;  // of a line that has not ended yet
};

}  // namespace lamprey::messaging::conformance
