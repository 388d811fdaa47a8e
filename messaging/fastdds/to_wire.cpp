#include "messaging/fastdds/wire.hpp"
#include "messaging/wire_enums.hpp"

#include <cstddef>
#include <vector>

namespace lamprey::messaging::fastdds {
namespace {

void convert(const Origin& origin, wire::Origin& to) {
  to.database_high(origin.database.high);
  to.database_low(origin.database.low);
  to.epoch(origin.epoch);
  to.science_version(origin.science_version);
}

void convert(const JobRange& range, wire::JobRange& to) {
  to.first(range.first);
  to.count(range.count);
}

void convert(const RunningJob& running, wire::RunningJob& to) {
  to.sweep_high(running.sweep.high);
  to.sweep_low(running.sweep.low);
  to.job(running.job);
  to.cycle(running.cycle);
  to.seconds(running.seconds);
}

void convert(const Counter& counter, wire::Counter& to) {
  to.name(counter.name);
  to.value(counter.value);
}

void convert(const TopicTraffic& topic, wire::TopicTraffic& to) {
  to.topic(topic.topic);
  to.written(topic.written);
  to.refused(topic.refused);
  to.read(topic.read);
}

void convert(const HeldLease& lease, wire::HeldLease& to);
void convert(const Acknowledgement& acknowledgement, wire::Acknowledgement& to);

template <class Target, class Element>
void convert_all(const std::vector<Element>& elements, std::vector<Target>& to) {
  to.resize(elements.size());
  for (std::size_t i = 0; i < elements.size(); ++i) convert(elements[i], to[i]);
}

void convert(const HeldLease& lease, wire::HeldLease& to) {
  to.database_high(lease.database.high);
  to.database_low(lease.database.low);
  to.epoch(lease.epoch);
  to.lease(lease.lease);
  to.sweep_high(lease.sweep.high);
  to.sweep_low(lease.sweep.low);
  convert_all(lease.remaining, to.remaining());
}

void convert(const Acknowledgement& acknowledgement, wire::Acknowledgement& to) {
  to.sweep_high(acknowledgement.sweep.high);
  to.sweep_low(acknowledgement.sweep.low);
  to.job(acknowledgement.job);
  to.digest(acknowledgement.digest);
  to.verdict(to_enumerator<wire::Verdict>(acknowledgement.verdict));
  to.reason(acknowledgement.reason);
}

}  // namespace

void to_wire(const WorkerStatus& sample, wire::WorkerStatus& to) {
  to.worker(sample.origin.worker);
  convert(sample.origin, to.origin());
  to.heartbeat(sample.heartbeat);
  to.state(to_enumerator<wire::WorkerState>(sample.state));
  to.threads(sample.threads);
  to.window(sample.window);
  to.last_lease_sequence(sample.last_lease_sequence);
  to.jobs_done(sample.jobs_done);
  to.results_held(sample.results_held);
  convert_all(sample.leases, to.leases());
  convert_all(sample.running, to.running());
  to.host(sample.host);
  to.process(sample.process);
  to.build(sample.build);
  to.flags(sample.flags);
  to.processor(sample.processor);
  to.instruction_set(sample.instruction_set);
  to.dds(sample.dds);
  to.labels(sample.labels);
  convert_all(sample.counters, to.counters());
}

void to_wire(const SweepSpecification& sample, wire::SweepSpecification& to) {
  to.sweep_high(sample.sweep.high);
  to.sweep_low(sample.sweep.low);
  to.worker(sample.origin.worker);
  convert(sample.origin, to.origin());
  to.name(sample.name);
  to.open(sample.open);
  to.specification(sample.specification);
}

void to_wire(const Lease& sample, wire::Lease& to) {
  to.worker(sample.origin.worker);
  convert(sample.origin, to.origin());
  to.kind(to_enumerator<wire::LeaseKind>(sample.kind));
  to.lease_sequence(sample.sequence);
  to.lease(sample.lease);
  to.sweep_high(sample.sweep.high);
  to.sweep_low(sample.sweep.low);
  convert_all(sample.ranges, to.ranges());
  to.duration_milliseconds(sample.duration_milliseconds);
  to.time_limit(sample.time_limit);
  to.interrupt(sample.interrupt);
  to.checkpoint(sample.checkpoint);
  to.reason(sample.reason);
}

void to_wire(const ResultAcknowledgement& sample, wire::ResultAcknowledgement& to) {
  to.worker(sample.origin.worker);
  convert(sample.origin, to.origin());
  convert_all(sample.results, to.results());
}

void to_wire(const Checkpoint& sample, wire::Checkpoint& to) {
  to.worker(sample.origin.worker);
  convert(sample.origin, to.origin());
  to.sweep_high(sample.sweep.high);
  to.sweep_low(sample.sweep.low);
  to.job(sample.job);
  to.lease(sample.lease);
  to.cycle(sample.cycle);
  to.seconds(sample.seconds);
  to.identity(sample.identity);
  to.state(sample.state);
}

void to_wire(const Request& sample, wire::Request& to) {
  to.worker(sample.origin.worker);
  convert(sample.origin, to.origin());
  to.client(sample.client);
  to.correlation(sample.correlation);
  to.payload(sample.payload);
}

void to_wire(const Reply& sample, wire::Reply& to) {
  to.worker(sample.origin.worker);
  convert(sample.origin, to.origin());
  to.client(sample.client);
  to.correlation(sample.correlation);
  to.payload(sample.payload);
}

void to_wire(const SweepProgress& sample, wire::SweepProgress& to) {
  to.sweep_high(sample.sweep.high);
  to.sweep_low(sample.sweep.low);
  to.worker(sample.origin.worker);
  convert(sample.origin, to.origin());
  to.name(sample.name);
  to.state(sample.state);
  to.jobs(sample.jobs);
  to.pending(sample.pending);
  to.leased(sample.leased);
  to.done(sample.done);
  to.failed(sample.failed);
  to.quarantined(sample.quarantined);
  to.cancelled(sample.cancelled);
  to.divergences(sample.divergences);
  to.jobs_per_second(sample.jobs_per_second);
  to.seconds_left(sample.seconds_left);
  to.workers(sample.workers);
}

void to_wire(const Traffic& sample, wire::Traffic& to) {
  to.participant(sample.participant);
  to.seconds(sample.seconds);
  to.malformed(sample.malformed);
  convert_all(sample.topics, to.topics());
}

}  // namespace lamprey::messaging::fastdds
