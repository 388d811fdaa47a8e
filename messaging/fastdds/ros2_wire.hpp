#pragma once

#include "messaging/fastdds/wire.hpp"
#include "messaging/ros2/messages.hpp"

#include <ros2PubSubTypes.h>

/// As wire.hpp, for the messages of ROS 2.
namespace lamprey::messaging::fastdds {

template <>
struct Wire<ros2::JointState> {
  using Type = sensor_msgs::msg::dds_::JointState_;
  using TypeSupport = sensor_msgs::msg::dds_::JointState_PubSubType;
};
template <>
struct Wire<ros2::Diagnostics> {
  using Type = diagnostic_msgs::msg::dds_::DiagnosticArray_;
  using TypeSupport = diagnostic_msgs::msg::dds_::DiagnosticArray_PubSubType;
};
template <>
struct Wire<ros2::JointCommand> {
  using Type = std_msgs::msg::dds_::Float64MultiArray_;
  using TypeSupport = std_msgs::msg::dds_::Float64MultiArray_PubSubType;
};

void to_wire(const ros2::JointState& message, sensor_msgs::msg::dds_::JointState_& to);
void to_wire(const ros2::Diagnostics& message, diagnostic_msgs::msg::dds_::DiagnosticArray_& to);
void to_wire(const ros2::JointCommand& message, std_msgs::msg::dds_::Float64MultiArray_& to);

bool from_wire(sensor_msgs::msg::dds_::JointState_& from, ros2::JointState& message);
bool from_wire(diagnostic_msgs::msg::dds_::DiagnosticArray_& from, ros2::Diagnostics& message);
bool from_wire(std_msgs::msg::dds_::Float64MultiArray_& from, ros2::JointCommand& message);

}  // namespace lamprey::messaging::fastdds
