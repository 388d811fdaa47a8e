#include "messaging/cyclonedds/wire.hpp"
#include "messaging/wire_enums.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <string>
#include <type_traits>
#include <vector>

namespace lamprey::messaging::cyclonedds {
namespace {

/// The generated structs have pointers to non-const, but dds_write only reads through them.
char* lend(const std::string& text) {
  return const_cast<char*>(text.c_str());
}

template <class Sequence>
void set(Sequence& sequence, decltype(Sequence::_buffer) buffer, std::size_t length) {
  sequence._buffer = buffer;
  sequence._length = static_cast<std::uint32_t>(length);
  sequence._maximum = sequence._length;
  sequence._release = false;
}

void lend(dds_sequence_octet& sequence, const std::vector<std::uint8_t>& octets) {
  set(sequence, const_cast<std::uint8_t*>(octets.data()), octets.size());
}

/// An array of `length` elements in the arena, yet to be filled.
template <class Sequence>
auto* set_aside(Sequence& sequence, std::size_t length, Arena& arena) {
  using Target = std::remove_pointer_t<decltype(Sequence::_buffer)>;
  set(sequence, static_cast<Target*>(arena.allocate(length * sizeof(Target), alignof(Target))), length);
  return sequence._buffer;
}

/// `convert(element)` of each element, in the arena; made in place, since a result is large.
template <class Sequence, class Element, class Convert>
void convert_all(Sequence& sequence, const std::vector<Element>& elements, Arena& arena, Convert convert) {
  auto* target = set_aside(sequence, elements.size(), arena);
  for (const auto& element : elements) new (target++) std::remove_pointer_t<decltype(target)>(convert(element));
}

lamprey_wire_Origin convert(const Origin& origin) {
  return {.database_high = origin.database.high,
          .database_low = origin.database.low,
          .epoch = origin.epoch,
          .science_version = origin.science_version};
}

lamprey_wire_JobRange convert(const JobRange& range) {
  return {.first = range.first, .count = range.count};
}

lamprey_wire_RunningJob convert(const RunningJob& running) {
  return {.sweep_high = running.sweep.high,
          .sweep_low = running.sweep.low,
          .job = running.job,
          .cycle = running.cycle,
          .seconds = running.seconds};
}

lamprey_wire_Counter convert(const Counter& counter) {
  return {.name = lend(counter.name), .value = counter.value};
}

lamprey_wire_TopicTraffic convert(const TopicTraffic& topic) {
  return {.topic = lend(topic.topic), .written = topic.written, .refused = topic.refused, .read = topic.read};
}

lamprey_wire_Score convert(const experiment::Score& score) {
  return {.stability = score.stability, .distance = score.distance, .fuel = score.fuel, .total = score.total};
}

lamprey_wire_Measure convert(const experiment::Measure& measure) {
  return {.name = lend(measure.name), .index = measure.index, .value = measure.value};
}

lamprey_wire_HeldLease convert(const HeldLease& lease, Arena& arena) {
  lamprey_wire_HeldLease wire{};
  wire.database_high = lease.database.high;
  wire.database_low = lease.database.low;
  wire.epoch = lease.epoch;
  wire.lease = lease.lease;
  wire.sweep_high = lease.sweep.high;
  wire.sweep_low = lease.sweep.low;
  convert_all(wire.remaining, lease.remaining, arena, [](const JobRange& range) { return convert(range); });
  return wire;
}

void convert(const std::vector<experiment::AcceptedChange>& trace, lamprey_wire_Trace& wire, Arena& arena) {
  const std::size_t rows = trace.size();
  auto* const cycles = set_aside(wire.cycles, rows, arena);
  auto* const stability = set_aside(wire.stability, rows, arena);
  auto* const distance = set_aside(wire.distance, rows, arena);
  auto* const fuel = set_aside(wire.fuel, rows, arena);
  auto* const total = set_aside(wire.total, rows, arena);
  for (std::size_t row = 0; row < rows; ++row) {
    cycles[row] = trace[row].cycle;
    stability[row] = trace[row].score.stability;
    distance[row] = trace[row].score.distance;
    fuel[row] = trace[row].score.fuel;
    total[row] = trace[row].score.total;
  }
}

void convert(const experiment::Outcome& outcome, lamprey_wire_Outcome& wire, Arena& arena) {
  wire.expected = convert(outcome.expected);
  wire.initial = convert(outcome.initial);
  wire.evolved = convert(outcome.evolved);
  wire.highest = convert(outcome.highest);
  wire.last = convert(outcome.final);
  wire.cycles = outcome.cycles;
  wire.accepted = outcome.accepted;
  wire.successes = outcome.successes;
  wire.success_rate = outcome.success_rate;
  convert(outcome.trace, wire.trace, arena);
  convert_all(wire.measures, outcome.measures, arena,
              [](const experiment::Measure& measure) { return convert(measure); });
}

lamprey_wire_JobResult convert(const JobResult& result, Arena& arena) {
  lamprey_wire_JobResult wire{};
  wire.job = result.job;
  wire.kind = to_enumerator<lamprey_wire_ResultKind>(result.kind);
  wire.lease = result.lease;
  wire.fragment = result.fragment;
  wire.fragments = result.fragments;
  std::copy(result.identity.begin(), result.identity.end(), wire.identity);
  std::copy(result.digest.begin(), result.digest.end(), wire.digest);
  convert(result.outcome, wire.outcome, arena);
  wire.seconds = result.seconds;
  wire.waited = result.waited;
  wire.reason = lend(result.reason);
  lend(wire.recording, result.recording);
  return wire;
}

lamprey_wire_Acknowledgement convert(const Acknowledgement& acknowledgement) {
  lamprey_wire_Acknowledgement wire{};
  wire.sweep_high = acknowledgement.sweep.high;
  wire.sweep_low = acknowledgement.sweep.low;
  wire.job = acknowledgement.job;
  std::copy(acknowledgement.digest.begin(), acknowledgement.digest.end(), wire.digest);
  wire.verdict = to_enumerator<lamprey_wire_Verdict>(acknowledgement.verdict);
  wire.reason = lend(acknowledgement.reason);
  return wire;
}

}  // namespace

lamprey_wire_WorkerStatus to_wire(const WorkerStatus& sample, Arena& arena) {
  lamprey_wire_WorkerStatus wire{};
  wire.worker = sample.origin.worker;
  wire.origin = convert(sample.origin);
  wire.heartbeat = sample.heartbeat;
  wire.state = to_enumerator<lamprey_wire_WorkerState>(sample.state);
  wire.threads = sample.threads;
  wire.window = sample.window;
  wire.last_lease_sequence = sample.last_lease_sequence;
  wire.jobs_done = sample.jobs_done;
  wire.results_held = sample.results_held;
  convert_all(wire.leases, sample.leases, arena, [&](const HeldLease& lease) { return convert(lease, arena); });
  convert_all(wire.running, sample.running, arena, [](const RunningJob& running) { return convert(running); });
  wire.host = lend(sample.host);
  wire.process = sample.process;
  wire.build = lend(sample.build);
  wire.flags = lend(sample.flags);
  wire.processor = lend(sample.processor);
  wire.instruction_set = lend(sample.instruction_set);
  wire.dds = lend(sample.dds);
  convert_all(wire.labels, sample.labels, arena, [](const std::string& label) { return lend(label); });
  convert_all(wire.counters, sample.counters, arena, [](const Counter& counter) { return convert(counter); });
  return wire;
}

lamprey_wire_SweepSpecification to_wire(const SweepSpecification& sample, Arena&) {
  lamprey_wire_SweepSpecification wire{};
  wire.sweep_high = sample.sweep.high;
  wire.sweep_low = sample.sweep.low;
  wire.worker = sample.origin.worker;
  wire.origin = convert(sample.origin);
  wire.name = lend(sample.name);
  wire.open = sample.open;
  lend(wire.specification, sample.specification);
  return wire;
}

lamprey_wire_Lease to_wire(const Lease& sample, Arena& arena) {
  lamprey_wire_Lease wire{};
  wire.worker = sample.origin.worker;
  wire.origin = convert(sample.origin);
  wire.kind = to_enumerator<lamprey_wire_LeaseKind>(sample.kind);
  wire.lease_sequence = sample.sequence;
  wire.lease = sample.lease;
  wire.sweep_high = sample.sweep.high;
  wire.sweep_low = sample.sweep.low;
  convert_all(wire.ranges, sample.ranges, arena, [](const JobRange& range) { return convert(range); });
  wire.duration_milliseconds = sample.duration_milliseconds;
  wire.time_limit = sample.time_limit;
  wire.interrupt = sample.interrupt;
  lend(wire.checkpoint, sample.checkpoint);
  wire.reason = lend(sample.reason);
  return wire;
}

lamprey_wire_ResultBatch to_wire(const ResultBatch& sample, Arena& arena) {
  lamprey_wire_ResultBatch wire{};
  wire.worker = sample.origin.worker;
  wire.origin = convert(sample.origin);
  wire.batch_sequence = sample.sequence;
  wire.sweep_high = sample.sweep.high;
  wire.sweep_low = sample.sweep.low;
  convert_all(wire.results, sample.results, arena, [&](const JobResult& result) { return convert(result, arena); });
  return wire;
}

lamprey_wire_ResultAcknowledgement to_wire(const ResultAcknowledgement& sample, Arena& arena) {
  lamprey_wire_ResultAcknowledgement wire{};
  wire.worker = sample.origin.worker;
  wire.origin = convert(sample.origin);
  convert_all(wire.results, sample.results, arena, [](const Acknowledgement& result) { return convert(result); });
  return wire;
}

lamprey_wire_Checkpoint to_wire(const Checkpoint& sample, Arena&) {
  lamprey_wire_Checkpoint wire{};
  wire.worker = sample.origin.worker;
  wire.origin = convert(sample.origin);
  wire.sweep_high = sample.sweep.high;
  wire.sweep_low = sample.sweep.low;
  wire.job = sample.job;
  wire.lease = sample.lease;
  wire.cycle = sample.cycle;
  wire.seconds = sample.seconds;
  std::copy(sample.identity.begin(), sample.identity.end(), wire.identity);
  lend(wire.state, sample.state);
  return wire;
}

lamprey_wire_Request to_wire(const Request& sample, Arena&) {
  lamprey_wire_Request wire{};
  wire.worker = sample.origin.worker;
  wire.origin = convert(sample.origin);
  wire.client = sample.client;
  wire.correlation = sample.correlation;
  lend(wire.payload, sample.payload);
  return wire;
}

lamprey_wire_Reply to_wire(const Reply& sample, Arena&) {
  lamprey_wire_Reply wire{};
  wire.worker = sample.origin.worker;
  wire.origin = convert(sample.origin);
  wire.client = sample.client;
  wire.correlation = sample.correlation;
  lend(wire.payload, sample.payload);
  return wire;
}

lamprey_wire_SweepProgress to_wire(const SweepProgress& sample, Arena&) {
  lamprey_wire_SweepProgress wire{};
  wire.sweep_high = sample.sweep.high;
  wire.sweep_low = sample.sweep.low;
  wire.worker = sample.origin.worker;
  wire.origin = convert(sample.origin);
  wire.name = lend(sample.name);
  wire.state = lend(sample.state);
  wire.jobs = sample.jobs;
  wire.pending = sample.pending;
  wire.leased = sample.leased;
  wire.done = sample.done;
  wire.failed = sample.failed;
  wire.quarantined = sample.quarantined;
  wire.cancelled = sample.cancelled;
  wire.divergences = sample.divergences;
  wire.jobs_per_second = sample.jobs_per_second;
  wire.seconds_left = sample.seconds_left;
  wire.workers = sample.workers;
  return wire;
}

lamprey_wire_Traffic to_wire(const Traffic& sample, Arena& arena) {
  lamprey_wire_Traffic wire{};
  std::ranges::copy(sample.participant, std::begin(wire.participant));
  wire.seconds = sample.seconds;
  wire.malformed = sample.malformed;
  convert_all(wire.topics, sample.topics, arena, [](const TopicTraffic& topic) { return convert(topic); });
  return wire;
}

}  // namespace lamprey::messaging::cyclonedds
