#include "messaging/fastdds/wire.hpp"
#include "messaging/wire_enums.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace lamprey::messaging::fastdds {
namespace {

bool convert(wire::JobRange& from, JobRange& range) {
  range = {.first = from.first(), .count = from.count()};
  return true;
}

bool convert(wire::RunningJob& from, RunningJob& running) {
  running = {.sweep = {from.sweep_high(), from.sweep_low()}, .job = from.job()};
  return true;
}

bool convert(wire::HeldLease& from, HeldLease& lease);
bool convert(wire::Measure& from, experiment::Measure& measure);
bool convert(wire::JobResult& from, JobResult& result);
bool convert(wire::Acknowledgement& from, Acknowledgement& acknowledgement);

/// False as soon as one element is.
template <class Source, class Element>
bool convert_all(std::vector<Source>& from, std::vector<Element>& elements) {
  elements.resize(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (!convert(from[i], elements[i])) return false;
  }
  return true;
}

Origin origin(const wire::Origin& from, std::uint64_t worker) {
  return {.database = {from.database_high(), from.database_low()},
          .epoch = from.epoch(),
          .worker = worker,
          .science_version = from.science_version()};
}

bool convert(wire::HeldLease& from, HeldLease& lease) {
  lease.database = {from.database_high(), from.database_low()};
  lease.epoch = from.epoch();
  lease.lease = from.lease();
  lease.sweep = {from.sweep_high(), from.sweep_low()};
  return convert_all(from.remaining(), lease.remaining);
}

experiment::Score score(const wire::Score& from) {
  return {.stability = from.stability(), .distance = from.distance(), .fuel = from.fuel(), .total = from.total()};
}

bool convert(const wire::Trace& from, std::vector<experiment::AcceptedChange>& trace) {
  const std::size_t rows = from.cycles().size();
  if (from.stability().size() != rows || from.distance().size() != rows || from.fuel().size() != rows ||
      from.total().size() != rows) {
    return false;
  }
  trace.resize(rows);
  for (std::size_t row = 0; row < rows; ++row) {
    trace[row] = {.cycle = from.cycles()[row],
                  .score = {.stability = from.stability()[row],
                            .distance = from.distance()[row],
                            .fuel = from.fuel()[row],
                            .total = from.total()[row]}};
  }
  return true;
}

bool convert(wire::Measure& from, experiment::Measure& measure) {
  measure = {.name = std::move(from.name()), .index = from.index(), .value = from.value()};
  return true;
}

bool convert(wire::Outcome& from, experiment::Outcome& outcome) {
  outcome.expected = score(from.expected());
  outcome.initial = score(from.initial());
  outcome.evolved = score(from.evolved());
  outcome.highest = score(from.highest());
  outcome.final = score(from.last());
  outcome.cycles = from.cycles();
  outcome.accepted = from.accepted();
  outcome.successes = from.successes();
  outcome.success_rate = from.success_rate();
  return convert(from.trace(), outcome.trace) && convert_all(from.measures(), outcome.measures);
}

bool convert(wire::JobResult& from, JobResult& result) {
  result.job = from.job();
  result.lease = from.lease();
  result.fragment = from.fragment();
  result.fragments = from.fragments();
  result.identity = from.identity();
  result.digest = from.digest();
  result.seconds = from.seconds();
  result.reason = std::move(from.reason());
  return set_enumerator(result.kind, from.kind()) && convert(from.outcome(), result.outcome);
}

bool convert(wire::Acknowledgement& from, Acknowledgement& acknowledgement) {
  acknowledgement.sweep = {from.sweep_high(), from.sweep_low()};
  acknowledgement.job = from.job();
  acknowledgement.digest = from.digest();
  acknowledgement.reason = std::move(from.reason());
  return set_enumerator(acknowledgement.verdict, from.verdict());
}

}  // namespace

bool from_wire(wire::WorkerStatus& from, WorkerStatus& sample) {
  sample.origin = origin(from.origin(), from.worker());
  sample.heartbeat = from.heartbeat();
  sample.threads = from.threads();
  sample.window = from.window();
  sample.last_lease_sequence = from.last_lease_sequence();
  sample.jobs_done = from.jobs_done();
  sample.results_held = from.results_held();
  sample.host = std::move(from.host());
  sample.process = from.process();
  sample.build = std::move(from.build());
  sample.dds = std::move(from.dds());
  return set_enumerator(sample.state, from.state()) && convert_all(from.leases(), sample.leases) &&
         convert_all(from.running(), sample.running);
}

bool from_wire(wire::SweepSpecification& from, SweepSpecification& sample) {
  sample.origin = origin(from.origin(), from.worker());
  sample.sweep = {from.sweep_high(), from.sweep_low()};
  sample.name = std::move(from.name());
  sample.open = from.open();
  sample.specification = std::move(from.specification());
  return true;
}

bool from_wire(wire::Lease& from, Lease& sample) {
  sample.origin = origin(from.origin(), from.worker());
  sample.sequence = from.lease_sequence();
  sample.lease = from.lease();
  sample.sweep = {from.sweep_high(), from.sweep_low()};
  sample.duration_milliseconds = from.duration_milliseconds();
  sample.reason = std::move(from.reason());
  return set_enumerator(sample.kind, from.kind()) && convert_all(from.ranges(), sample.ranges);
}

bool from_wire(wire::ResultBatch& from, ResultBatch& sample) {
  sample.origin = origin(from.origin(), from.worker());
  sample.sequence = from.batch_sequence();
  sample.sweep = {from.sweep_high(), from.sweep_low()};
  return convert_all(from.results(), sample.results);
}

bool from_wire(wire::ResultAcknowledgement& from, ResultAcknowledgement& sample) {
  sample.origin = origin(from.origin(), from.worker());
  return convert_all(from.results(), sample.results);
}

bool from_wire(wire::Request& from, Request& sample) {
  sample.origin = origin(from.origin(), from.worker());
  sample.client = from.client();
  sample.correlation = from.correlation();
  sample.payload = std::move(from.payload());
  return true;
}

bool from_wire(wire::Reply& from, Reply& sample) {
  sample.origin = origin(from.origin(), from.worker());
  sample.client = from.client();
  sample.correlation = from.correlation();
  sample.payload = std::move(from.payload());
  return true;
}

bool from_wire(wire::SweepProgress& from, SweepProgress& sample) {
  sample.origin = origin(from.origin(), from.worker());
  sample.sweep = {from.sweep_high(), from.sweep_low()};
  sample.name = std::move(from.name());
  sample.state = std::move(from.state());
  sample.jobs = from.jobs();
  sample.pending = from.pending();
  sample.leased = from.leased();
  sample.done = from.done();
  sample.failed = from.failed();
  sample.quarantined = from.quarantined();
  sample.cancelled = from.cancelled();
  sample.divergences = from.divergences();
  sample.jobs_per_second = from.jobs_per_second();
  sample.seconds_left = from.seconds_left();
  sample.workers = from.workers();
  return true;
}

}  // namespace lamprey::messaging::fastdds
