#pragma once

#include "messaging/cyclonedds/wire.hpp"
#include "messaging/ros2/messages.hpp"
#include "ros2.h"

/// As wire.hpp, for the messages of ROS 2.
namespace lamprey::messaging::cyclonedds {

template <>
struct Wire<ros2::JointState> {
  using Type = sensor_msgs_msg_dds__JointState_;
  static const dds_topic_descriptor_t* descriptor() { return &sensor_msgs_msg_dds__JointState__desc; }
};
template <>
struct Wire<ros2::Diagnostics> {
  using Type = diagnostic_msgs_msg_dds__DiagnosticArray_;
  static const dds_topic_descriptor_t* descriptor() { return &diagnostic_msgs_msg_dds__DiagnosticArray__desc; }
};
template <>
struct Wire<ros2::JointCommand> {
  using Type = std_msgs_msg_dds__Float64MultiArray_;
  static const dds_topic_descriptor_t* descriptor() { return &std_msgs_msg_dds__Float64MultiArray__desc; }
};

sensor_msgs_msg_dds__JointState_ to_wire(const ros2::JointState& message, Arena& arena);
diagnostic_msgs_msg_dds__DiagnosticArray_ to_wire(const ros2::Diagnostics& message, Arena& arena);
std_msgs_msg_dds__Float64MultiArray_ to_wire(const ros2::JointCommand& message, Arena& arena);

bool from_wire(const sensor_msgs_msg_dds__JointState_& wire, ros2::JointState& message);
bool from_wire(const diagnostic_msgs_msg_dds__DiagnosticArray_& wire, ros2::Diagnostics& message);
bool from_wire(const std_msgs_msg_dds__Float64MultiArray_& wire, ros2::JointCommand& message);

}  // namespace lamprey::messaging::cyclonedds
