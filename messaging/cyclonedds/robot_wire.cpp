#include "messaging/cyclonedds/wire.hpp"
#include "messaging/wire_enums.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>

/// The samples of robots (idl/robot.idl).
namespace lamprey::messaging::cyclonedds {
namespace {

/// The generated structs have pointers to non-const, but dds_write only reads through them.
char* lend(const std::string& text) {
  return const_cast<char*>(text.c_str());
}

std::string text(const char* characters) {
  return characters == nullptr ? std::string() : std::string(characters);
}

void copy(const ServoPositions& from, double (&to)[servos]) {
  std::ranges::copy(from, std::begin(to));
}
void copy(const double (&from)[servos], ServoPositions& to) {
  std::ranges::copy(from, to.begin());
}

}  // namespace

lamprey_wire_RobotStatus to_wire(const RobotStatus& sample, Arena& arena) {
  lamprey_wire_RobotStatus wire{};
  wire.robot = sample.robot;
  wire.name = lend(sample.name);
  wire.state = to_enumerator<lamprey_wire_RobotState>(sample.state);
  wire.stopped = sample.stopped;
  wire.reason = lend(sample.reason);
  wire.incarnation = sample.incarnation;
  wire.heartbeat = sample.heartbeat;
  wire.token = sample.token;
  wire.holder = sample.holder;
  wire.rate = sample.rate;
  wire.driver = lend(sample.driver);
  wire.device = lend(sample.device);
  wire.scheduling = lend(sample.scheduling);
  wire.host = lend(sample.host);
  wire.process = sample.process;
  wire.build = lend(sample.build);
  wire.dds = lend(sample.dds);
  auto* const counters = static_cast<lamprey_wire_RobotCounter*>(
      arena.allocate(sample.counters.size() * sizeof(lamprey_wire_RobotCounter), alignof(lamprey_wire_RobotCounter)));
  std::ranges::transform(sample.counters, counters, [](const RobotCounter& counter) {
    return lamprey_wire_RobotCounter{.name = lend(counter.name), .value = counter.value};
  });
  wire.counters._buffer = counters;
  wire.counters._length = wire.counters._maximum = static_cast<std::uint32_t>(sample.counters.size());
  wire.counters._release = false;
  return wire;
}

lamprey_wire_RobotRequest to_wire(const RobotRequest& sample, Arena&) {
  lamprey_wire_RobotRequest wire{};
  wire.robot = sample.robot;
  wire.asker = sample.asker;
  wire.correlation = sample.correlation;
  wire.kind = to_enumerator<lamprey_wire_RobotRequestKind>(sample.kind);
  wire.token = sample.token;
  wire.confirmed = sample.confirmed;
  copy(sample.position, wire.position);
  wire.reason = lend(sample.reason);
  return wire;
}

lamprey_wire_RobotReply to_wire(const RobotReply& sample, Arena&) {
  lamprey_wire_RobotReply wire{};
  wire.robot = sample.robot;
  wire.asker = sample.asker;
  wire.correlation = sample.correlation;
  wire.granted = sample.granted;
  wire.reason = lend(sample.reason);
  wire.token = sample.token;
  wire.lease_milliseconds = sample.lease_milliseconds;
  wire.state = to_enumerator<lamprey_wire_RobotState>(sample.state);
  wire.stopped = sample.stopped;
  return wire;
}

lamprey_wire_ServoCommand to_wire(const ServoCommand& sample, Arena&) {
  lamprey_wire_ServoCommand wire{};
  wire.robot = sample.robot;
  wire.token = sample.token;
  wire.evaluation = sample.evaluation;
  wire.time_step = sample.time_step;
  wire.last = sample.last;
  copy(sample.position, wire.position);
  return wire;
}

lamprey_wire_ServoState to_wire(const ServoState& sample, Arena&) {
  lamprey_wire_ServoState wire{};
  wire.robot = sample.robot;
  wire.token = sample.token;
  wire.evaluation = sample.evaluation;
  wire.time_step = sample.time_step;
  wire.outcome = to_enumerator<lamprey_wire_StepOutcome>(sample.outcome);
  wire.reason = lend(sample.reason);
  copy(sample.commanded, wire.commanded);
  copy(sample.reported, wire.reported);
  wire.measured = sample.measured;
  wire.feet_down = sample.feet_down;
  wire.command_to_line_nanoseconds = sample.command_to_line_nanoseconds;
  wire.line_to_state_nanoseconds = sample.line_to_state_nanoseconds;
  return wire;
}

bool from_wire(const lamprey_wire_RobotStatus& wire, RobotStatus& sample) {
  sample.robot = wire.robot;
  sample.name = text(wire.name);
  sample.stopped = wire.stopped;
  sample.reason = text(wire.reason);
  sample.incarnation = wire.incarnation;
  sample.heartbeat = wire.heartbeat;
  sample.token = wire.token;
  sample.holder = wire.holder;
  sample.rate = wire.rate;
  sample.driver = text(wire.driver);
  sample.device = text(wire.device);
  sample.scheduling = text(wire.scheduling);
  sample.host = text(wire.host);
  sample.process = wire.process;
  sample.build = text(wire.build);
  sample.dds = text(wire.dds);
  for (std::uint32_t i = 0; i < wire.counters._length; ++i) {
    sample.counters.push_back({.name = text(wire.counters._buffer[i].name), .value = wire.counters._buffer[i].value});
  }
  return set_enumerator(sample.state, wire.state);
}

bool from_wire(const lamprey_wire_RobotRequest& wire, RobotRequest& sample) {
  sample.robot = wire.robot;
  sample.asker = wire.asker;
  sample.correlation = wire.correlation;
  sample.token = wire.token;
  sample.confirmed = wire.confirmed;
  copy(wire.position, sample.position);
  sample.reason = text(wire.reason);
  return set_enumerator(sample.kind, wire.kind);
}

bool from_wire(const lamprey_wire_RobotReply& wire, RobotReply& sample) {
  sample.robot = wire.robot;
  sample.asker = wire.asker;
  sample.correlation = wire.correlation;
  sample.granted = wire.granted;
  sample.reason = text(wire.reason);
  sample.token = wire.token;
  sample.lease_milliseconds = wire.lease_milliseconds;
  sample.stopped = wire.stopped;
  return set_enumerator(sample.state, wire.state);
}

bool from_wire(const lamprey_wire_ServoCommand& wire, ServoCommand& sample) {
  sample.robot = wire.robot;
  sample.token = wire.token;
  sample.evaluation = wire.evaluation;
  sample.time_step = wire.time_step;
  sample.last = wire.last;
  copy(wire.position, sample.position);
  return true;
}

bool from_wire(const lamprey_wire_ServoState& wire, ServoState& sample) {
  sample.robot = wire.robot;
  sample.token = wire.token;
  sample.evaluation = wire.evaluation;
  sample.time_step = wire.time_step;
  sample.reason = text(wire.reason);
  copy(wire.commanded, sample.commanded);
  copy(wire.reported, sample.reported);
  sample.measured = wire.measured;
  sample.feet_down = wire.feet_down;
  sample.command_to_line_nanoseconds = wire.command_to_line_nanoseconds;
  sample.line_to_state_nanoseconds = wire.line_to_state_nanoseconds;
  return set_enumerator(sample.outcome, wire.outcome);
}

}  // namespace lamprey::messaging::cyclonedds
