#pragma once

#include "messaging/robot_samples.hpp"
#include "robot_bridge/calibration.hpp"
#include "robot_bridge/recording/mcap_writer.hpp"

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace lamprey::robot_bridge::recording {

/// Records time steps as tools of ROS 2's world read them (Foxglove, PlotJuggler), in an MCAP file:
///   /joint_states          sensor_msgs/msg/JointState   what the device reported
///   /commanded_joint_states                              what was sent to it, after all limits
///   /robot_step            lamprey_msgs/msg/RobotStep    claim, evaluation, step, feet, and why it is void
/// Angles are those of ros2/angles.hpp. A thread of its own writes: a disk that stalls or is full keeps nobody waiting,
/// and costs the recording alone, which the log then tells.
class StepRecorder {
 public:
  /// Throws std::runtime_error where the file can't be written.
  StepRecorder(const std::string& path, const Calibration& calibration);
  /// Writes what is left, and the file's end.
  ~StepRecorder();
  StepRecorder(const StepRecorder&) = delete;
  StepRecorder& operator=(const StepRecorder&) = delete;

  /// Returns at once. Any thread.
  void add(const messaging::ServoState& state, std::chrono::system_clock::time_point time);

 private:
  struct Step {
    messaging::ServoState state;
    std::uint64_t nanoseconds = 0;  ///< since 1970
  };

  void run(const std::stop_token& stop);
  void write(const Step& step);

  Calibration calibration_;
  McapWriter writer_;

  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::vector<Step> steps_;
  bool broken_ = false;

  std::jthread thread_;  ///< last: it uses all of the above
};

}  // namespace lamprey::robot_bridge::recording
