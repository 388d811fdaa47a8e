#include "messaging/fastdds/ros2_wire.hpp"

#include <cstdint>
#include <string>
#include <utility>

namespace lamprey::messaging::fastdds {
namespace {

void convert(const ros2::Stamp& stamp, const std::string& frame, std_msgs::msg::dds_::Header_& to) {
  to.stamp().sec(stamp.seconds);
  to.stamp().nanosec(stamp.nanoseconds);
  to.frame_id(frame);
}

ros2::Stamp stamp(const std_msgs::msg::dds_::Header_& header) {
  return {.seconds = header.stamp().sec(), .nanoseconds = header.stamp().nanosec()};
}

/// False if there is no such level.
bool convert(diagnostic_msgs::msg::dds_::DiagnosticStatus_& from, ros2::DiagnosticStatus& status) {
  if (from.level() > static_cast<std::uint8_t>(ros2::DiagnosticLevel::stale)) return false;
  status = {.level = static_cast<ros2::DiagnosticLevel>(from.level()),
            .name = std::move(from.name()),
            .message = std::move(from.message()),
            .hardware = std::move(from.hardware_id()),
            .values = {}};
  for (auto& value : from.values()) status.values.emplace_back(std::move(value.key()), std::move(value.value()));
  return true;
}

}  // namespace

void to_wire(const ros2::JointState& message, sensor_msgs::msg::dds_::JointState_& to) {
  convert(message.stamp, message.frame, to.header());
  to.name(message.names);
  to.position(message.positions);
  to.velocity(message.velocities);
  to.effort(message.efforts);
}

void to_wire(const ros2::Diagnostics& message, diagnostic_msgs::msg::dds_::DiagnosticArray_& to) {
  to.status().clear();
  convert(message.stamp, message.frame, to.header());
  for (const auto& status : message.statuses) {
    auto& one = to.status().emplace_back();
    one.level(static_cast<std::uint8_t>(status.level));
    one.name(status.name);
    one.message(status.message);
    one.hardware_id(status.hardware);
    for (const auto& [key, value] : status.values) {
      auto& pair = one.values().emplace_back();
      pair.key(key);
      pair.value(value);
    }
  }
}

void to_wire(const ros2::JointCommand& message, std_msgs::msg::dds_::Float64MultiArray_& to) {
  to.layout().dim().clear();
  to.layout().data_offset(message.offset);
  to.data(message.positions);
}

bool from_wire(sensor_msgs::msg::dds_::JointState_& from, ros2::JointState& message) {
  message.stamp = stamp(from.header());
  message.frame = std::move(from.header().frame_id());
  message.names = std::move(from.name());
  message.positions = std::move(from.position());
  message.velocities = std::move(from.velocity());
  message.efforts = std::move(from.effort());
  return true;
}

bool from_wire(diagnostic_msgs::msg::dds_::DiagnosticArray_& from, ros2::Diagnostics& message) {
  message.stamp = stamp(from.header());
  message.frame = std::move(from.header().frame_id());
  for (auto& status : from.status()) {
    if (!convert(status, message.statuses.emplace_back())) return false;
  }
  return true;
}

bool from_wire(std_msgs::msg::dds_::Float64MultiArray_& from, ros2::JointCommand& message) {
  message.offset = from.layout().data_offset();
  message.positions = std::move(from.data());
  return true;
}

}  // namespace lamprey::messaging::fastdds
