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
  running = {.sweep = {from.sweep_high(), from.sweep_low()},
             .job = from.job(),
             .cycle = from.cycle(),
             .seconds = from.seconds()};
  return true;
}

bool convert(wire::Counter& from, Counter& counter) {
  counter = {.name = std::move(from.name()), .value = from.value()};
  return true;
}

bool convert(wire::TopicTraffic& from, TopicTraffic& topic) {
  topic = {.topic = std::move(from.topic()), .written = from.written(), .refused = from.refused(), .read = from.read()};
  return true;
}

bool convert(wire::HeldLease& from, HeldLease& lease);
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
  sample.flags = std::move(from.flags());
  sample.processor = std::move(from.processor());
  sample.instruction_set = std::move(from.instruction_set());
  sample.dds = std::move(from.dds());
  sample.labels = std::move(from.labels());
  return set_enumerator(sample.state, from.state()) && convert_all(from.leases(), sample.leases) &&
         convert_all(from.running(), sample.running) && convert_all(from.counters(), sample.counters);
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
  sample.time_limit = from.time_limit();
  sample.interrupt = from.interrupt();
  sample.checkpoint = std::move(from.checkpoint());
  sample.reason = std::move(from.reason());
  return set_enumerator(sample.kind, from.kind()) && convert_all(from.ranges(), sample.ranges);
}

bool from_wire(wire::ResultAcknowledgement& from, ResultAcknowledgement& sample) {
  sample.origin = origin(from.origin(), from.worker());
  return convert_all(from.results(), sample.results);
}

bool from_wire(wire::Checkpoint& from, Checkpoint& sample) {
  sample.origin = origin(from.origin(), from.worker());
  sample.sweep = {from.sweep_high(), from.sweep_low()};
  sample.job = from.job();
  sample.lease = from.lease();
  sample.cycle = from.cycle();
  sample.seconds = from.seconds();
  sample.identity = from.identity();
  sample.state = std::move(from.state());
  return true;
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

bool from_wire(wire::Traffic& from, Traffic& sample) {
  sample.participant = from.participant();
  sample.seconds = from.seconds();
  sample.malformed = from.malformed();
  return convert_all(from.topics(), sample.topics);
}

}  // namespace lamprey::messaging::fastdds
