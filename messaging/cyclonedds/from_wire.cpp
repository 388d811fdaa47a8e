#include "messaging/cyclonedds/wire.hpp"
#include "messaging/wire_enums.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <vector>

namespace lamprey::messaging::cyclonedds {
namespace {

std::string text(const char* characters) {
  return characters == nullptr ? std::string() : std::string(characters);
}

std::vector<std::uint8_t> octets(const dds_sequence_octet& sequence) {
  return {sequence._buffer, sequence._buffer + sequence._length};
}

/// `convert(wire, element)` of each; false as soon as one is.
template <class Sequence, class Element, class Convert>
bool convert_all(const Sequence& sequence, std::vector<Element>& elements, Convert convert) {
  elements.resize(sequence._length);
  for (std::uint32_t i = 0; i < sequence._length; ++i) {
    if (!convert(sequence._buffer[i], elements[i])) return false;
  }
  return true;
}

bool convert(const lamprey_wire_Origin& wire, std::uint64_t worker, Origin& origin) {
  origin = {.database = {wire.database_high, wire.database_low},
            .epoch = wire.epoch,
            .worker = worker,
            .science_version = wire.science_version};
  return true;
}

bool convert(const lamprey_wire_JobRange& wire, JobRange& range) {
  range = {.first = wire.first, .count = wire.count};
  return true;
}

bool convert(const lamprey_wire_RunningJob& wire, RunningJob& running) {
  running = {.sweep = {wire.sweep_high, wire.sweep_low}, .job = wire.job, .cycle = wire.cycle, .seconds = wire.seconds};
  return true;
}

bool convert(const lamprey_wire_Counter& wire, Counter& counter) {
  counter = {.name = text(wire.name), .value = wire.value};
  return true;
}

bool convert(const lamprey_wire_TopicTraffic& wire, TopicTraffic& topic) {
  topic = {.topic = text(wire.topic), .written = wire.written, .refused = wire.refused, .read = wire.read};
  return true;
}

bool convert(const lamprey_wire_HeldLease& wire, HeldLease& lease) {
  lease.database = {wire.database_high, wire.database_low};
  lease.epoch = wire.epoch;
  lease.lease = wire.lease;
  lease.sweep = {wire.sweep_high, wire.sweep_low};
  return convert_all(wire.remaining, lease.remaining, [](const auto& from, JobRange& to) { return convert(from, to); });
}

experiment::Score score(const lamprey_wire_Score& wire) {
  return {.stability = wire.stability, .distance = wire.distance, .fuel = wire.fuel, .total = wire.total};
}

bool convert(const lamprey_wire_Trace& wire, std::vector<experiment::AcceptedChange>& trace) {
  const std::uint32_t rows = wire.cycles._length;
  if (wire.stability._length != rows || wire.distance._length != rows || wire.fuel._length != rows ||
      wire.total._length != rows) {
    return false;
  }
  trace.resize(rows);
  for (std::uint32_t row = 0; row < rows; ++row) {
    trace[row] = {.cycle = wire.cycles._buffer[row],
                  .score = {.stability = wire.stability._buffer[row],
                            .distance = wire.distance._buffer[row],
                            .fuel = wire.fuel._buffer[row],
                            .total = wire.total._buffer[row]}};
  }
  return true;
}

bool convert(const lamprey_wire_Measure& wire, experiment::Measure& measure) {
  measure = {.name = text(wire.name), .index = wire.index, .value = wire.value};
  return true;
}

bool convert(const lamprey_wire_Outcome& wire, experiment::Outcome& outcome) {
  outcome.expected = score(wire.expected);
  outcome.initial = score(wire.initial);
  outcome.evolved = score(wire.evolved);
  outcome.highest = score(wire.highest);
  outcome.final = score(wire.last);
  outcome.cycles = wire.cycles;
  outcome.accepted = wire.accepted;
  outcome.successes = wire.successes;
  outcome.success_rate = wire.success_rate;
  return convert(wire.trace, outcome.trace) &&
         convert_all(wire.measures, outcome.measures,
                     [](const auto& from, experiment::Measure& to) { return convert(from, to); });
}

bool convert(const lamprey_wire_JobResult& wire, JobResult& result) {
  result.job = wire.job;
  result.lease = wire.lease;
  result.fragment = wire.fragment;
  result.fragments = wire.fragments;
  std::copy(std::begin(wire.identity), std::end(wire.identity), result.identity.begin());
  std::copy(std::begin(wire.digest), std::end(wire.digest), result.digest.begin());
  result.seconds = wire.seconds;
  result.waited = wire.waited;
  result.reason = text(wire.reason);
  result.recording = octets(wire.recording);
  return set_enumerator(result.kind, wire.kind) && convert(wire.outcome, result.outcome);
}

bool convert(const lamprey_wire_Acknowledgement& wire, Acknowledgement& acknowledgement) {
  acknowledgement.sweep = {wire.sweep_high, wire.sweep_low};
  acknowledgement.job = wire.job;
  std::copy(std::begin(wire.digest), std::end(wire.digest), acknowledgement.digest.begin());
  acknowledgement.reason = text(wire.reason);
  return set_enumerator(acknowledgement.verdict, wire.verdict);
}

}  // namespace

bool from_wire(const lamprey_wire_WorkerStatus& wire, WorkerStatus& sample) {
  sample.heartbeat = wire.heartbeat;
  sample.threads = wire.threads;
  sample.window = wire.window;
  sample.last_lease_sequence = wire.last_lease_sequence;
  sample.jobs_done = wire.jobs_done;
  sample.results_held = wire.results_held;
  sample.host = text(wire.host);
  sample.process = wire.process;
  sample.build = text(wire.build);
  sample.flags = text(wire.flags);
  sample.processor = text(wire.processor);
  sample.instruction_set = text(wire.instruction_set);
  sample.dds = text(wire.dds);
  for (std::uint32_t i = 0; i < wire.labels._length; ++i) sample.labels.push_back(text(wire.labels._buffer[i]));
  return convert(wire.origin, wire.worker, sample.origin) && set_enumerator(sample.state, wire.state) &&
         convert_all(wire.leases, sample.leases, [](const auto& from, HeldLease& to) { return convert(from, to); }) &&
         convert_all(wire.running, sample.running,
                     [](const auto& from, RunningJob& to) { return convert(from, to); }) &&
         convert_all(wire.counters, sample.counters, [](const auto& from, Counter& to) { return convert(from, to); });
}

bool from_wire(const lamprey_wire_SweepSpecification& wire, SweepSpecification& sample) {
  sample.sweep = {wire.sweep_high, wire.sweep_low};
  sample.name = text(wire.name);
  sample.open = wire.open;
  sample.specification = octets(wire.specification);
  return convert(wire.origin, wire.worker, sample.origin);
}

bool from_wire(const lamprey_wire_Lease& wire, Lease& sample) {
  sample.sequence = wire.lease_sequence;
  sample.lease = wire.lease;
  sample.sweep = {wire.sweep_high, wire.sweep_low};
  sample.duration_milliseconds = wire.duration_milliseconds;
  sample.time_limit = wire.time_limit;
  sample.interrupt = wire.interrupt;
  sample.checkpoint = octets(wire.checkpoint);
  sample.reason = text(wire.reason);
  return convert(wire.origin, wire.worker, sample.origin) && set_enumerator(sample.kind, wire.kind) &&
         convert_all(wire.ranges, sample.ranges, [](const auto& from, JobRange& to) { return convert(from, to); });
}

bool from_wire(const lamprey_wire_ResultBatch& wire, ResultBatch& sample) {
  sample.sequence = wire.batch_sequence;
  sample.sweep = {wire.sweep_high, wire.sweep_low};
  return convert(wire.origin, wire.worker, sample.origin) &&
         convert_all(wire.results, sample.results, [](const auto& from, JobResult& to) { return convert(from, to); });
}

bool from_wire(const lamprey_wire_ResultAcknowledgement& wire, ResultAcknowledgement& sample) {
  return convert(wire.origin, wire.worker, sample.origin) &&
         convert_all(wire.results, sample.results,
                     [](const auto& from, Acknowledgement& to) { return convert(from, to); });
}

bool from_wire(const lamprey_wire_Checkpoint& wire, Checkpoint& sample) {
  sample.sweep = {wire.sweep_high, wire.sweep_low};
  sample.job = wire.job;
  sample.lease = wire.lease;
  sample.cycle = wire.cycle;
  sample.seconds = wire.seconds;
  std::copy(std::begin(wire.identity), std::end(wire.identity), sample.identity.begin());
  sample.state = octets(wire.state);
  return convert(wire.origin, wire.worker, sample.origin);
}

bool from_wire(const lamprey_wire_Request& wire, Request& sample) {
  sample.client = wire.client;
  sample.correlation = wire.correlation;
  sample.payload = octets(wire.payload);
  return convert(wire.origin, wire.worker, sample.origin);
}

bool from_wire(const lamprey_wire_Reply& wire, Reply& sample) {
  sample.client = wire.client;
  sample.correlation = wire.correlation;
  sample.payload = octets(wire.payload);
  return convert(wire.origin, wire.worker, sample.origin);
}

bool from_wire(const lamprey_wire_SweepProgress& wire, SweepProgress& sample) {
  sample.sweep = {wire.sweep_high, wire.sweep_low};
  sample.name = text(wire.name);
  sample.state = text(wire.state);
  sample.jobs = wire.jobs;
  sample.pending = wire.pending;
  sample.leased = wire.leased;
  sample.done = wire.done;
  sample.failed = wire.failed;
  sample.quarantined = wire.quarantined;
  sample.cancelled = wire.cancelled;
  sample.divergences = wire.divergences;
  sample.jobs_per_second = wire.jobs_per_second;
  sample.seconds_left = wire.seconds_left;
  sample.workers = wire.workers;
  return convert(wire.origin, wire.worker, sample.origin);
}

bool from_wire(const lamprey_wire_Traffic& wire, Traffic& sample) {
  std::ranges::copy(wire.participant, sample.participant.begin());
  sample.seconds = wire.seconds;
  sample.malformed = wire.malformed;
  return convert_all(wire.topics, sample.topics, [](const auto& from, TopicTraffic& to) { return convert(from, to); });
}

}  // namespace lamprey::messaging::cyclonedds
