#include "messaging/cyclonedds/ros2_wire.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace lamprey::messaging::cyclonedds {
namespace {

/// The generated structs have pointers to non-const, but dds_write only reads through them.
char* lend(const std::string& text) {
  return const_cast<char*>(text.c_str());
}

std::string text(const char* characters) {
  return characters == nullptr ? std::string() : std::string(characters);
}

template <class Sequence>
void set(Sequence& sequence, decltype(Sequence::_buffer) buffer, std::size_t length) {
  sequence._buffer = buffer;
  sequence._length = static_cast<std::uint32_t>(length);
  sequence._maximum = sequence._length;
  sequence._release = false;
}

void lend(dds_sequence_double& sequence, const std::vector<double>& numbers) {
  set(sequence, const_cast<double*>(numbers.data()), numbers.size());
}

std::vector<double> numbers(const dds_sequence_double& sequence) {
  return {sequence._buffer, sequence._buffer + sequence._length};
}

/// `convert(element)` of each element, in the arena.
template <class Sequence, class Element, class Convert>
void convert_all(Sequence& sequence, const std::vector<Element>& elements, Arena& arena, Convert convert) {
  using Target = std::remove_pointer_t<decltype(Sequence::_buffer)>;
  auto* const buffer = static_cast<Target*>(arena.allocate(elements.size() * sizeof(Target), alignof(Target)));
  std::ranges::transform(elements, buffer, convert);
  set(sequence, buffer, elements.size());
}

std_msgs_msg_dds__Header_ header(const ros2::Stamp& stamp, const std::string& frame) {
  return {.stamp = {.sec = stamp.seconds, .nanosec = stamp.nanoseconds}, .frame_id = lend(frame)};
}

ros2::Stamp stamp(const std_msgs_msg_dds__Header_& header) {
  return {.seconds = header.stamp.sec, .nanoseconds = header.stamp.nanosec};
}

diagnostic_msgs_msg_dds__DiagnosticStatus_ convert(const ros2::DiagnosticStatus& status, Arena& arena) {
  diagnostic_msgs_msg_dds__DiagnosticStatus_ wire{};
  wire.level = static_cast<std::uint8_t>(status.level);
  wire.name = lend(status.name);
  wire.message = lend(status.message);
  wire.hardware_id = lend(status.hardware);
  convert_all(wire.values, status.values, arena, [](const auto& value) {
    return diagnostic_msgs_msg_dds__KeyValue_{.key = lend(value.first), .value = lend(value.second)};
  });
  return wire;
}

/// False if there is no such level.
bool convert(const diagnostic_msgs_msg_dds__DiagnosticStatus_& wire, ros2::DiagnosticStatus& status) {
  if (wire.level > static_cast<std::uint8_t>(ros2::DiagnosticLevel::stale)) return false;
  status = {.level = static_cast<ros2::DiagnosticLevel>(wire.level),
            .name = text(wire.name),
            .message = text(wire.message),
            .hardware = text(wire.hardware_id),
            .values = {}};
  for (std::uint32_t i = 0; i < wire.values._length; ++i) {
    status.values.emplace_back(text(wire.values._buffer[i].key), text(wire.values._buffer[i].value));
  }
  return true;
}

}  // namespace

sensor_msgs_msg_dds__JointState_ to_wire(const ros2::JointState& message, Arena& arena) {
  sensor_msgs_msg_dds__JointState_ wire{};
  wire.header = header(message.stamp, message.frame);
  convert_all(wire.name, message.names, arena, [](const std::string& name) { return lend(name); });
  lend(wire.position, message.positions);
  lend(wire.velocity, message.velocities);
  lend(wire.effort, message.efforts);
  return wire;
}

diagnostic_msgs_msg_dds__DiagnosticArray_ to_wire(const ros2::Diagnostics& message, Arena& arena) {
  diagnostic_msgs_msg_dds__DiagnosticArray_ wire{};
  wire.header = header(message.stamp, message.frame);
  convert_all(wire.status, message.statuses, arena,
              [&](const ros2::DiagnosticStatus& status) { return convert(status, arena); });
  return wire;
}

std_msgs_msg_dds__Float64MultiArray_ to_wire(const ros2::JointCommand& message, Arena&) {
  std_msgs_msg_dds__Float64MultiArray_ wire{};
  wire.layout.data_offset = message.offset;
  lend(wire.data, message.positions);
  return wire;
}

bool from_wire(const sensor_msgs_msg_dds__JointState_& wire, ros2::JointState& message) {
  message.stamp = stamp(wire.header);
  message.frame = text(wire.header.frame_id);
  for (std::uint32_t i = 0; i < wire.name._length; ++i) message.names.push_back(text(wire.name._buffer[i]));
  message.positions = numbers(wire.position);
  message.velocities = numbers(wire.velocity);
  message.efforts = numbers(wire.effort);
  return true;
}

bool from_wire(const diagnostic_msgs_msg_dds__DiagnosticArray_& wire, ros2::Diagnostics& message) {
  message.stamp = stamp(wire.header);
  message.frame = text(wire.header.frame_id);
  message.statuses.resize(wire.status._length);
  for (std::uint32_t i = 0; i < wire.status._length; ++i) {
    if (!convert(wire.status._buffer[i], message.statuses[i])) return false;
  }
  return true;
}

bool from_wire(const std_msgs_msg_dds__Float64MultiArray_& wire, ros2::JointCommand& message) {
  message.offset = wire.layout.data_offset;
  message.positions = numbers(wire.data);
  return true;
}

}  // namespace lamprey::messaging::cyclonedds
