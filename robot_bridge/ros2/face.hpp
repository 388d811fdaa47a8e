#pragma once

#include "messaging/ros2/node.hpp"
#include "robot_bridge/bridge.hpp"
#include "robot_bridge/calibration.hpp"
#include "robot_bridge/control_loop.hpp"
#include "robot_bridge/setpoint_limiter.hpp"

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace lamprey::robot_bridge::ros2 {

namespace wire = messaging::ros2;

/// Why a command is not obeyed; names of counters.
enum class Refusal : std::uint8_t { wrong_size, not_numbers, claimed, not_active, busy };
inline constexpr std::size_t refusals = 5;

/// The robot as ROS 2's tools see it, beside the bridge and after it: where its joints are, how it is, and a way to
/// move it while no job has it. Commands go through the control loop, at the slew rate and within the limits of
/// everything else; a claim, the lifecycle and the emergency stop come first. One thread, the bridge's; times are those
/// given.
class Face {
 public:
  /// All of them must outlive it. `robot`: its name.
  Face(wire::Node& node, const std::shared_ptr<messaging::Signal>& signal, const Bridge& bridge, ControlLoop& control,
       const Calibration& calibration, std::string robot);

  /// After each step of the bridge. Never waits for the device.
  void step(Clock::time_point now, std::chrono::system_clock::time_point wall);

  /// Tells everybody that the robot is gone.
  void finish(std::chrono::system_clock::time_point wall);

  /// Commands, by what has become of them.
  std::vector<messaging::RobotCounter> counters() const;

 private:
  /// What diagnostics tell of, but for the counters.
  struct Condition {
    RobotState state = RobotState::unconfigured;
    bool stopped = false;
    bool claimed = false;
    std::string reason;
    std::string device;
    bool operator==(const Condition&) const = default;
  };

  void take_commands(Clock::time_point now);
  void publish_joints(Clock::time_point now, std::chrono::system_clock::time_point wall);
  void publish_diagnostics(const Condition& condition, std::chrono::system_clock::time_point wall);
  /// What is wrong with the command itself, whatever the robot does.
  static std::optional<Refusal> fault_of(const wire::JointCommand& command);
  void refuse(Refusal refusal, const std::string& reason);
  Condition condition(Clock::time_point now) const;

  const Bridge& bridge_;
  ControlLoop& control_;
  Calibration calibration_;
  SetpointLimiter range_;
  std::string robot_;
  wire::Node& node_;
  std::unique_ptr<messaging::Reader<wire::JointCommand>> commands_;
  std::unique_ptr<messaging::Writer<wire::JointState>> joints_;
  std::unique_ptr<messaging::Writer<wire::Diagnostics>> diagnostics_;

  std::optional<PoseReading> last_reading_;
  std::optional<Condition> told_;
  Clock::time_point diagnostics_due_{};
  std::uint64_t obeyed_ = 0;
  std::uint64_t superseded_ = 0;
  std::uint64_t out_of_range_ = 0;
  std::array<std::uint64_t, refusals> refused_{};
};

}  // namespace lamprey::robot_bridge::ros2
