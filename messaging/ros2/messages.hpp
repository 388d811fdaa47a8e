#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

/// The messages of ROS 2 that a robot's bridge speaks, as neutral value types; idl/ros2.idl has them for the wire.
/// Everything in them that came from the network is unchecked input.
namespace lamprey::messaging::ros2 {

/// Of the system clock, since its epoch.
struct Stamp {
  std::int32_t seconds = 0;
  std::uint32_t nanoseconds = 0;
  bool operator==(const Stamp&) const = default;
};

/// sensor_msgs/msg/JointState. Positions, velocities and efforts have a number per name, or none at all.
struct JointState {
  Stamp stamp;
  std::string frame;
  std::vector<std::string> names;
  std::vector<double> positions;   ///< rad
  std::vector<double> velocities;  ///< rad/s
  std::vector<double> efforts;     ///< N m
  bool operator==(const JointState&) const = default;
};

enum class DiagnosticLevel : std::uint8_t { ok = 0, warn = 1, error = 2, stale = 3 };

/// diagnostic_msgs/msg/DiagnosticStatus.
struct DiagnosticStatus {
  DiagnosticLevel level = DiagnosticLevel::ok;
  std::string name;
  std::string message;
  std::string hardware;
  std::vector<std::pair<std::string, std::string>> values;  ///< keys with their values
  bool operator==(const DiagnosticStatus&) const = default;
};

/// diagnostic_msgs/msg/DiagnosticArray.
struct Diagnostics {
  Stamp stamp;
  std::string frame;
  std::vector<DiagnosticStatus> statuses;
  bool operator==(const Diagnostics&) const = default;
};

/// std_msgs/msg/Float64MultiArray, of one dimension: an angle per joint. Names of dimensions aren't kept.
struct JointCommand {
  std::uint32_t offset = 0;       ///< numbers before the first angle
  std::vector<double> positions;  ///< rad
  bool operator==(const JointCommand&) const = default;
};

}  // namespace lamprey::messaging::ros2
