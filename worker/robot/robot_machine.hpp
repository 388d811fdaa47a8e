#pragma once

#include "science/robots/machine.hpp"
#include "worker/robot/recorder.hpp"
#include "worker/robot/robot_connection.hpp"

#include <chrono>
#include <cstdint>
#include <exception>
#include <stop_token>

namespace lamprey::worker {

/// The job can't go on now, through no fault of its own: the robot is away, or the worker stops. It goes back to the
/// coordinator and begins anew some time.
class JobGivenBack : public std::exception {
 public:
  const char* what() const noexcept override { return "the robot is away"; }
};

/// The robot behind a bridge, under the claim that the connection holds. One thread.
class RobotMachine final : public science::robots::Machine {
 public:
  /// Evaluations that are void so often in a row end the job's attempt.
  static constexpr std::uint32_t most_tries = 20;

  /// All must outlive it. A robot that can't be moved is waited for, up to `patience`.
  RobotMachine(RobotConnection& connection, Recorder& recorder, std::uint64_t& evaluations, std::stop_token stop,
               std::chrono::milliseconds patience);

  /// Throws std::runtime_error after most_tries, JobGivenBack.
  science::robots::MachineReport begin(const std::array<std::int16_t, science::robots::servos>& posture,
                                       std::int32_t time_steps) override;
  science::robots::MachineReport step(const std::array<std::int16_t, science::robots::servos>& target) override;

 private:
  science::robots::MachineReport order(const std::array<std::int16_t, science::robots::servos>& target, bool last);
  void place(const messaging::ServoPositions& posture);

  RobotConnection& connection_;
  Recorder& recorder_;
  std::uint64_t& evaluations_;  ///< of the claim: counts up with each try, over all jobs
  std::stop_token stop_;
  std::chrono::milliseconds patience_;
  bool placed_ = false;  ///< the robot stands where the last evaluation ended
  messaging::ServoPositions standing_{};
  std::uint32_t next_step_ = 0;
  std::uint32_t last_step_ = 0;
};

}  // namespace lamprey::worker
