#pragma once

#include "messaging/samples.hpp"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

/// Samples for round trips: `example` fills every field with a value of its own, `extreme` with the largest.
namespace lamprey::messaging::testing {

/// Different values, one after the other.
class Values {
 public:
  explicit Values(std::uint64_t seed) : next_(seed * 1000 + 1) {}

  std::uint64_t u64() { return (std::uint64_t{0xa5a5} << 48) + next_++; }
  std::uint32_t u32() { return static_cast<std::uint32_t>(0x80000000u + next_++); }
  std::uint8_t u8() { return static_cast<std::uint8_t>(next_++); }
  double real() { return -1.0 / 3.0 * static_cast<double>(next_++); }
  std::string text() { return "größe " + std::to_string(next_++); }
  Id128 id() { return {u64(), u64()}; }
  std::vector<std::uint8_t> octets(std::size_t size) {
    std::vector<std::uint8_t> all(size);
    for (auto& octet : all) octet = u8();
    return all;
  }
  Digest digest() {
    Digest all{};
    for (auto& octet : all) octet = u8();
    return all;
  }
  experiment::Score score() { return {.stability = real(), .distance = real(), .fuel = real(), .total = real()}; }
  Origin origin() { return {.database = id(), .epoch = u64(), .worker = u64(), .science_version = u32()}; }
  std::vector<JobRange> ranges(std::size_t size) {
    std::vector<JobRange> all(size);
    for (auto& range : all) range = {.first = u64(), .count = u64()};
    return all;
  }
  std::vector<experiment::AcceptedChange> trace(std::size_t rows) {
    std::vector<experiment::AcceptedChange> all(rows);
    for (auto& change : all) change = {.cycle = u32(), .score = score()};
    return all;
  }
  std::vector<experiment::Measure> measures(std::size_t size) {
    std::vector<experiment::Measure> all(size);
    for (auto& measure : all) measure = {.name = text(), .index = u32(), .value = real()};
    return all;
  }

 private:
  std::uint64_t next_;
};

inline void fill(WorkerStatus& sample, Values& values) {
  sample.origin = values.origin();
  sample.heartbeat = values.u64();
  sample.state = WorkerState::draining;
  sample.threads = values.u32();
  sample.window = values.u32();
  sample.last_lease_sequence = values.u64();
  sample.jobs_done = values.u64();
  sample.results_held = values.u64();
  sample.leases = {{values.id(), values.u64(), values.u64(), values.id(), values.ranges(3)},
                   {values.id(), values.u64(), values.u64(), values.id(), {}}};
  sample.running = {{values.id(), values.u64(), values.u32(), values.real()},
                    {values.id(), values.u64(), values.u32(), values.real()}};
  sample.host = values.text();
  sample.process = values.u32();
  sample.build = values.text();
  sample.flags = values.text();
  sample.processor = values.text();
  sample.instruction_set = values.text();
  sample.dds = values.text();
  sample.labels = {values.text(), values.text()};
  sample.counters = {{values.text(), values.u64()}, {values.text(), values.u64()}};
}

inline void fill(SweepSpecification& sample, Values& values) {
  sample.origin = values.origin();
  sample.sweep = values.id();
  sample.name = values.text();
  sample.open = false;
  sample.specification = values.octets(1000);
}

inline void fill(Lease& sample, Values& values) {
  sample.origin = values.origin();
  sample.kind = LeaseKind::revoke;
  sample.sequence = values.u64();
  sample.lease = values.u64();
  sample.sweep = values.id();
  sample.ranges = values.ranges(5);
  sample.duration_milliseconds = values.u32();
  sample.time_limit = values.real();
  sample.interrupt = true;
  sample.checkpoint = values.octets(700);
  sample.reason = values.text();
}

inline JobResult example_result(Values& values, std::size_t rows, std::size_t measures = 0) {
  JobResult result;
  result.job = values.u64();
  result.kind = ResultKind::failed;
  result.lease = values.u64();
  result.fragment = values.u32();
  result.fragments = values.u32();
  result.identity = values.digest();
  result.digest = values.digest();
  result.outcome.expected = values.score();
  result.outcome.initial = values.score();
  result.outcome.evolved = values.score();
  result.outcome.highest = values.score();
  result.outcome.final = values.score();
  result.outcome.cycles = values.u32();
  result.outcome.accepted = values.u32();
  result.outcome.successes = values.u32();
  result.outcome.success_rate = values.real();
  result.outcome.trace = values.trace(rows);
  result.outcome.measures = values.measures(measures);
  result.seconds = values.real();
  result.waited = values.real();
  result.reason = values.text();
  result.recording = values.octets(17 * measures);
  return result;
}

inline void fill(ResultBatch& sample, Values& values) {
  sample.origin = values.origin();
  sample.sequence = values.u64();
  sample.sweep = values.id();
  sample.results = {example_result(values, 0), example_result(values, 1, 3), example_result(values, 300, 100)};
  sample.results[1].reason.clear();
}

inline void fill(ResultAcknowledgement& sample, Values& values) {
  sample.origin = values.origin();
  for (const auto verdict : {Verdict::committed, Verdict::duplicate, Verdict::divergent, Verdict::refused}) {
    sample.results.push_back({values.id(), values.u64(), values.digest(), verdict, values.text()});
  }
}

inline void fill(Checkpoint& sample, Values& values) {
  sample.origin = values.origin();
  sample.sweep = values.id();
  sample.job = values.u64();
  sample.lease = values.u64();
  sample.cycle = values.u32();
  sample.seconds = values.real();
  sample.identity = values.digest();
  sample.state = values.octets(300);
}

inline void fill(Request& sample, Values& values) {
  sample.origin = values.origin();
  sample.client = values.u64();
  sample.correlation = values.u64();
  sample.payload = values.octets(257);
}

inline void fill(Reply& sample, Values& values) {
  sample.origin = values.origin();
  sample.client = values.u64();
  sample.correlation = values.u64();
  sample.payload = values.octets(513);
}

inline void fill(SweepProgress& sample, Values& values) {
  sample.origin = values.origin();
  sample.sweep = values.id();
  sample.name = values.text();
  sample.state = values.text();
  sample.jobs = values.u64();
  sample.pending = values.u64();
  sample.leased = values.u64();
  sample.done = values.u64();
  sample.failed = values.u64();
  sample.quarantined = values.u64();
  sample.cancelled = values.u64();
  sample.divergences = values.u64();
  sample.jobs_per_second = values.real();
  sample.seconds_left = values.real();
  sample.workers = values.u32();
}

inline ServoPositions positions(Values& values) {
  ServoPositions all{};
  for (auto& position : all) position = values.real();
  return all;
}

inline void fill(RobotStatus& sample, Values& values) {
  sample.robot = values.u64();
  sample.name = values.text();
  sample.state = RobotState::active;
  sample.stopped = true;
  sample.reason = values.text();
  sample.incarnation = values.u64();
  sample.heartbeat = values.u64();
  sample.token = values.u64();
  sample.holder = values.u64();
  sample.rate = values.real();
  sample.driver = values.text();
  sample.device = values.text();
  sample.scheduling = values.text();
  sample.host = values.text();
  sample.process = values.u32();
  sample.build = values.text();
  sample.dds = values.text();
  sample.counters = {{values.text(), values.u64()}, {values.text(), values.u64()}};
}

inline void fill(Traffic& sample, Values& values) {
  for (auto& octet : sample.participant) octet = values.u8();
  sample.seconds = values.real();
  sample.malformed = values.u64();
  sample.topics = {{values.text(), values.u64(), values.u64(), values.u64()},
                   {values.text(), values.u64(), values.u64(), values.u64()}};
}

inline void fill(RobotRequest& sample, Values& values) {
  sample.robot = values.u64();
  sample.asker = values.u64();
  sample.correlation = values.u64();
  sample.kind = RobotRequestKind::reset;
  sample.token = values.u64();
  sample.confirmed = true;
  sample.position = positions(values);
  sample.reason = values.text();
}

inline void fill(RobotReply& sample, Values& values) {
  sample.robot = values.u64();
  sample.asker = values.u64();
  sample.correlation = values.u64();
  sample.granted = true;
  sample.reason = values.text();
  sample.token = values.u64();
  sample.lease_milliseconds = values.u32();
  sample.state = RobotState::fault;
  sample.stopped = true;
}

inline void fill(ServoCommand& sample, Values& values) {
  sample.robot = values.u64();
  sample.token = values.u64();
  sample.evaluation = values.u64();
  sample.time_step = values.u32();
  sample.last = true;
  sample.position = positions(values);
}

inline void fill(ServoState& sample, Values& values) {
  sample.robot = values.u64();
  sample.token = values.u64();
  sample.evaluation = values.u64();
  sample.time_step = values.u32();
  sample.outcome = StepOutcome::voided;
  sample.reason = values.text();
  sample.commanded = positions(values);
  sample.reported = positions(values);
  sample.measured = true;
  sample.feet_down = values.u32();
  sample.command_to_line_nanoseconds = values.u64();
  sample.line_to_state_nanoseconds = values.u64();
}

template <class Sample>
Sample example(std::uint64_t seed = 1) {
  Sample sample;
  Values values(seed);
  fill(sample, values);
  return sample;
}

inline constexpr auto most = std::numeric_limits<std::uint64_t>::max();
inline constexpr auto most32 = std::numeric_limits<std::uint32_t>::max();
inline const Origin extreme_origin{.database = {most, most}, .epoch = most, .worker = most, .science_version = most32};
inline const std::string long_text(20'000, 'x');

inline void maximise(WorkerStatus& sample) {
  sample.heartbeat = sample.last_lease_sequence = sample.jobs_done = sample.results_held = most;
  sample.state = WorkerState::leaving;
  sample.threads = sample.window = sample.process = most32;
  sample.leases.resize(200, {{most, most}, most, most, {most, most}, std::vector<JobRange>(20, {most, most})});
  sample.running.resize(1000, {{most, most}, most, most32, 1e300});
  sample.host = sample.build = sample.dds = sample.flags = sample.processor = sample.instruction_set = long_text;
  sample.labels.assign(64, "label");
  sample.counters.assign(256, {"counter", most});
}
inline void maximise(Checkpoint& sample) {
  sample.sweep = {most, most};
  sample.job = sample.lease = most;
  sample.cycle = most32;
  sample.seconds = 1e300;
  sample.identity.fill(0xff);
  sample.state.assign(1'000'000, 0xff);
}
inline void maximise(SweepSpecification& sample) {
  sample.sweep = {most, most};
  sample.name = long_text;
  sample.specification.assign(1'000'000, 0xff);
}
inline void maximise(Lease& sample) {
  sample.kind = LeaseKind::refuse;
  sample.sequence = sample.lease = most;
  sample.sweep = {most, most};
  sample.ranges.assign(3000, {most, most});
  sample.time_limit = 1e300;
  sample.checkpoint.assign(100'000, 0xff);
  sample.duration_milliseconds = most32;
  sample.reason = long_text;
}
inline void maximise(ResultBatch& sample) {
  Values values(9);
  sample.sequence = most;
  sample.sweep = {most, most};
  for (int i = 0; i < 100; ++i) sample.results.push_back(example_result(values, 4, 1));  // together about 60 KB
  auto& outcome = sample.results[0].outcome;
  constexpr double largest = std::numeric_limits<double>::max();
  outcome.expected = {largest, -largest, std::numeric_limits<double>::denorm_min(), -0.0};
  outcome.success_rate = std::numeric_limits<double>::infinity();
  outcome.measures = {{std::string(1000, 'n'), most32, largest}, {"", 0, -0.0}};
  sample.results[0].recording.assign(2000, 0xff);
}
inline void maximise(ResultAcknowledgement& sample) {
  Digest digest;
  digest.fill(0xff);
  sample.results.assign(1000, {{most, most}, most, digest, Verdict::refused, "reason"});
  sample.results.back().reason = long_text;
}
inline void maximise(Request& sample) {
  sample.client = sample.correlation = most;
  sample.payload.assign(300'000, 0xff);
}
inline void maximise(Reply& sample) {
  sample.client = sample.correlation = most;
  sample.payload.assign(300'000, 0xff);
}
inline void maximise(SweepProgress& sample) {
  sample.sweep = {most, most};
  sample.name = sample.state = long_text;
  sample.jobs = sample.pending = sample.leased = sample.done = most;
  sample.failed = sample.quarantined = sample.cancelled = sample.divergences = most;
  sample.jobs_per_second = std::numeric_limits<double>::max();
  sample.seconds_left = std::numeric_limits<double>::lowest();
  sample.workers = most32;
}

inline void maximise(RobotStatus& sample) {
  sample.robot = sample.incarnation = sample.heartbeat = sample.token = sample.holder = most;
  sample.state = RobotState::finalized;
  sample.name = sample.reason = sample.driver = sample.device = sample.scheduling = long_text;
  sample.host = sample.build = sample.dds = long_text;
  sample.process = most32;
  sample.rate = std::numeric_limits<double>::max();
  sample.counters.assign(256, {"counter", most});
}
inline void maximise(Traffic& sample) {
  sample.participant.fill(0xff);
  sample.seconds = std::numeric_limits<double>::max();
  sample.malformed = most;
  sample.topics.assign(256, {"topic", most, most, most});
}
inline void maximise(RobotRequest& sample) {
  sample.robot = sample.asker = sample.correlation = sample.token = most;
  sample.kind = RobotRequestKind::place;
  sample.position.fill(std::numeric_limits<double>::infinity());
  sample.reason = long_text;
}
inline void maximise(RobotReply& sample) {
  sample.robot = sample.asker = sample.correlation = sample.token = most;
  sample.lease_milliseconds = most32;
  sample.state = RobotState::finalized;
  sample.reason = long_text;
}
inline void maximise(ServoCommand& sample) {
  sample.robot = sample.token = sample.evaluation = most;
  sample.time_step = most32;
  sample.position.fill(std::numeric_limits<double>::lowest());
}
inline void maximise(ServoState& sample) {
  sample.robot = sample.token = sample.evaluation = most;
  sample.time_step = sample.feet_down = most32;
  sample.outcome = StepOutcome::voided;
  sample.reason = long_text;
  sample.commanded.fill(std::numeric_limits<double>::max());
  sample.reported.fill(-0.0);
  sample.command_to_line_nanoseconds = sample.line_to_state_nanoseconds = most;
}

template <class Sample>
Sample extreme() {
  Sample sample;
  if constexpr (requires { sample.origin; }) sample.origin = extreme_origin;
  maximise(sample);
  return sample;
}

}  // namespace lamprey::messaging::testing
