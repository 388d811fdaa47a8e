#pragma once

#include "messaging/robot_samples.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace lamprey::idl {
class RobotRecording;
}

namespace lamprey::worker {

/// Collects what a robot did in one attempt of a job (idl/recording.proto). Not thread-safe.
class Recorder {
 public:
  Recorder(const std::string& robot, std::uint64_t token);
  ~Recorder();

  /// A try of the evaluation that is due begins.
  void begin();
  void add(const messaging::ServoState& state);
  /// The try counts; the next one is of the next evaluation.
  void accept();
  /// The try is worth nothing; the next one is of the same evaluation.
  void reject(const std::string& reason);

  /// Tries in a row of the evaluation that is due that were worth nothing.
  std::uint32_t rejected() const { return attempt_; }

  std::vector<std::uint8_t> octets() const;

 private:
  std::unique_ptr<idl::RobotRecording> recording_;
  std::uint32_t evaluation_ = 0;
  std::uint32_t attempt_ = 0;
};

}  // namespace lamprey::worker
