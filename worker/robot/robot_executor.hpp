#pragma once

#include "worker/job_executor.hpp"

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

namespace lamprey::worker {

struct RobotExecutorOptions {
  std::string robot;                           ///< its name
  std::uint64_t asker = 0;                     ///< names this worker to the bridge; not 0
  std::chrono::milliseconds patience{30'000};  ///< a job waits so long for a robot that is away
};

/// One thread that keeps a robot's claim and runs jobs on the robot, one at a time; what is simulated in the same sweep
/// it computes as any worker does. It offers the labels "bridge" and "bridge=NAME" while the claim is its own.
std::unique_ptr<JobExecutor> make_robot_executor(messaging::Participant& participant,
                                                 std::shared_ptr<messaging::Signal> signal,
                                                 const RobotExecutorOptions& options);

}  // namespace lamprey::worker
