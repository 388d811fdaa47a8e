#include "messaging/fastdds/wire.hpp"
#include "messaging/wire_enums.hpp"

#include <cstddef>
#include <utility>

/// The samples of robots (idl/robot.idl).
namespace lamprey::messaging::fastdds {

void to_wire(const RobotStatus& sample, wire::RobotStatus& to) {
  to.robot(sample.robot);
  to.name(sample.name);
  to.state(to_enumerator<wire::RobotState>(sample.state));
  to.stopped(sample.stopped);
  to.reason(sample.reason);
  to.incarnation(sample.incarnation);
  to.heartbeat(sample.heartbeat);
  to.token(sample.token);
  to.holder(sample.holder);
  to.rate(sample.rate);
  to.driver(sample.driver);
  to.device(sample.device);
  to.scheduling(sample.scheduling);
  to.host(sample.host);
  to.process(sample.process);
  to.build(sample.build);
  to.dds(sample.dds);
  to.counters().resize(sample.counters.size());
  for (std::size_t i = 0; i < sample.counters.size(); ++i) {
    to.counters()[i].name(sample.counters[i].name);
    to.counters()[i].value(sample.counters[i].value);
  }
}

void to_wire(const RobotRequest& sample, wire::RobotRequest& to) {
  to.robot(sample.robot);
  to.asker(sample.asker);
  to.correlation(sample.correlation);
  to.kind(to_enumerator<wire::RobotRequestKind>(sample.kind));
  to.token(sample.token);
  to.confirmed(sample.confirmed);
  to.position(sample.position);
  to.reason(sample.reason);
}

void to_wire(const RobotReply& sample, wire::RobotReply& to) {
  to.robot(sample.robot);
  to.asker(sample.asker);
  to.correlation(sample.correlation);
  to.granted(sample.granted);
  to.reason(sample.reason);
  to.token(sample.token);
  to.lease_milliseconds(sample.lease_milliseconds);
  to.state(to_enumerator<wire::RobotState>(sample.state));
  to.stopped(sample.stopped);
}

void to_wire(const ServoCommand& sample, wire::ServoCommand& to) {
  to.robot(sample.robot);
  to.token(sample.token);
  to.evaluation(sample.evaluation);
  to.time_step(sample.time_step);
  to.last(sample.last);
  to.position(sample.position);
}

void to_wire(const ServoState& sample, wire::ServoState& to) {
  to.robot(sample.robot);
  to.token(sample.token);
  to.evaluation(sample.evaluation);
  to.time_step(sample.time_step);
  to.outcome(to_enumerator<wire::StepOutcome>(sample.outcome));
  to.reason(sample.reason);
  to.commanded(sample.commanded);
  to.reported(sample.reported);
  to.measured(sample.measured);
  to.feet_down(sample.feet_down);
  to.command_to_line_nanoseconds(sample.command_to_line_nanoseconds);
  to.line_to_state_nanoseconds(sample.line_to_state_nanoseconds);
}

bool from_wire(wire::RobotStatus& from, RobotStatus& sample) {
  sample.robot = from.robot();
  sample.name = std::move(from.name());
  sample.stopped = from.stopped();
  sample.reason = std::move(from.reason());
  sample.incarnation = from.incarnation();
  sample.heartbeat = from.heartbeat();
  sample.token = from.token();
  sample.holder = from.holder();
  sample.rate = from.rate();
  sample.driver = std::move(from.driver());
  sample.device = std::move(from.device());
  sample.scheduling = std::move(from.scheduling());
  sample.host = std::move(from.host());
  sample.process = from.process();
  sample.build = std::move(from.build());
  sample.dds = std::move(from.dds());
  for (auto& counter : from.counters()) {
    sample.counters.push_back({.name = std::move(counter.name()), .value = counter.value()});
  }
  return set_enumerator(sample.state, from.state());
}

bool from_wire(wire::RobotRequest& from, RobotRequest& sample) {
  sample.robot = from.robot();
  sample.asker = from.asker();
  sample.correlation = from.correlation();
  sample.token = from.token();
  sample.confirmed = from.confirmed();
  sample.position = from.position();
  sample.reason = std::move(from.reason());
  return set_enumerator(sample.kind, from.kind());
}

bool from_wire(wire::RobotReply& from, RobotReply& sample) {
  sample.robot = from.robot();
  sample.asker = from.asker();
  sample.correlation = from.correlation();
  sample.granted = from.granted();
  sample.reason = std::move(from.reason());
  sample.token = from.token();
  sample.lease_milliseconds = from.lease_milliseconds();
  sample.stopped = from.stopped();
  return set_enumerator(sample.state, from.state());
}

bool from_wire(wire::ServoCommand& from, ServoCommand& sample) {
  sample.robot = from.robot();
  sample.token = from.token();
  sample.evaluation = from.evaluation();
  sample.time_step = from.time_step();
  sample.last = from.last();
  sample.position = from.position();
  return true;
}

bool from_wire(wire::ServoState& from, ServoState& sample) {
  sample.robot = from.robot();
  sample.token = from.token();
  sample.evaluation = from.evaluation();
  sample.time_step = from.time_step();
  sample.reason = std::move(from.reason());
  sample.commanded = from.commanded();
  sample.reported = from.reported();
  sample.measured = from.measured();
  sample.feet_down = from.feet_down();
  sample.command_to_line_nanoseconds = from.command_to_line_nanoseconds();
  sample.line_to_state_nanoseconds = from.line_to_state_nanoseconds();
  return set_enumerator(sample.outcome, from.outcome());
}

}  // namespace lamprey::messaging::fastdds
