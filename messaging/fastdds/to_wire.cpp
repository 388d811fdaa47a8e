#include "messaging/fastdds/wire.hpp"
#include "messaging/wire_enums.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace lamprey::messaging::fastdds {
namespace {

wire::Origin convert(const Origin& origin) {
  wire::Origin to;
  to.database_high(origin.database.high);
  to.database_low(origin.database.low);
  to.epoch(origin.epoch);
  to.science_version(origin.science_version);
  return to;
}

wire::JobRange convert(const JobRange& range) {
  wire::JobRange to;
  to.first(range.first);
  to.count(range.count);
  return to;
}

wire::RunningJob convert(const RunningJob& running) {
  wire::RunningJob to;
  to.sweep_high(running.sweep.high);
  to.sweep_low(running.sweep.low);
  to.job(running.job);
  return to;
}

wire::Score convert(const experiment::Score& score) {
  wire::Score to;
  to.stability(score.stability);
  to.distance(score.distance);
  to.fuel(score.fuel);
  to.total(score.total);
  return to;
}

wire::HeldLease convert(const HeldLease& lease);
wire::Measure convert(const experiment::Measure& measure);
wire::JobResult convert(const JobResult& result);
wire::Acknowledgement convert(const Acknowledgement& acknowledgement);

template <class Target, class Element>
void convert_all(const std::vector<Element>& elements, std::vector<Target>& to) {
  to.reserve(elements.size());
  for (const auto& element : elements) to.push_back(convert(element));
}

wire::HeldLease convert(const HeldLease& lease) {
  wire::HeldLease to;
  to.database_high(lease.database.high);
  to.database_low(lease.database.low);
  to.epoch(lease.epoch);
  to.lease(lease.lease);
  to.sweep_high(lease.sweep.high);
  to.sweep_low(lease.sweep.low);
  convert_all(lease.remaining, to.remaining());
  return to;
}

wire::Trace convert(const std::vector<experiment::AcceptedChange>& trace) {
  wire::Trace to;
  const auto fill = [&](auto& column, auto field) {
    column.reserve(trace.size());
    std::transform(trace.begin(), trace.end(), std::back_inserter(column), field);
  };
  fill(to.cycles(), [](const experiment::AcceptedChange& change) { return change.cycle; });
  fill(to.stability(), [](const experiment::AcceptedChange& change) { return change.score.stability; });
  fill(to.distance(), [](const experiment::AcceptedChange& change) { return change.score.distance; });
  fill(to.fuel(), [](const experiment::AcceptedChange& change) { return change.score.fuel; });
  fill(to.total(), [](const experiment::AcceptedChange& change) { return change.score.total; });
  return to;
}

wire::Measure convert(const experiment::Measure& measure) {
  wire::Measure to;
  to.name(measure.name);
  to.index(measure.index);
  to.value(measure.value);
  return to;
}

wire::Outcome convert(const experiment::Outcome& outcome) {
  wire::Outcome to;
  to.expected(convert(outcome.expected));
  to.initial(convert(outcome.initial));
  to.evolved(convert(outcome.evolved));
  to.highest(convert(outcome.highest));
  to.last(convert(outcome.final));
  to.cycles(outcome.cycles);
  to.accepted(outcome.accepted);
  to.successes(outcome.successes);
  to.success_rate(outcome.success_rate);
  to.trace(convert(outcome.trace));
  convert_all(outcome.measures, to.measures());
  return to;
}

wire::JobResult convert(const JobResult& result) {
  wire::JobResult to;
  to.job(result.job);
  to.kind(to_enumerator<wire::ResultKind>(result.kind));
  to.lease(result.lease);
  to.fragment(result.fragment);
  to.fragments(result.fragments);
  to.identity(result.identity);
  to.digest(result.digest);
  to.outcome(convert(result.outcome));
  to.seconds(result.seconds);
  to.reason(result.reason);
  return to;
}

wire::Acknowledgement convert(const Acknowledgement& acknowledgement) {
  wire::Acknowledgement to;
  to.sweep_high(acknowledgement.sweep.high);
  to.sweep_low(acknowledgement.sweep.low);
  to.job(acknowledgement.job);
  to.digest(acknowledgement.digest);
  to.verdict(to_enumerator<wire::Verdict>(acknowledgement.verdict));
  to.reason(acknowledgement.reason);
  return to;
}

}  // namespace

wire::WorkerStatus to_wire(const WorkerStatus& sample) {
  wire::WorkerStatus to;
  to.worker(sample.origin.worker);
  to.origin(convert(sample.origin));
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
  to.dds(sample.dds);
  return to;
}

wire::SweepSpecification to_wire(const SweepSpecification& sample) {
  wire::SweepSpecification to;
  to.sweep_high(sample.sweep.high);
  to.sweep_low(sample.sweep.low);
  to.worker(sample.origin.worker);
  to.origin(convert(sample.origin));
  to.name(sample.name);
  to.open(sample.open);
  to.specification(sample.specification);
  return to;
}

wire::Lease to_wire(const Lease& sample) {
  wire::Lease to;
  to.worker(sample.origin.worker);
  to.origin(convert(sample.origin));
  to.kind(to_enumerator<wire::LeaseKind>(sample.kind));
  to.lease_sequence(sample.sequence);
  to.lease(sample.lease);
  to.sweep_high(sample.sweep.high);
  to.sweep_low(sample.sweep.low);
  convert_all(sample.ranges, to.ranges());
  to.duration_milliseconds(sample.duration_milliseconds);
  to.reason(sample.reason);
  return to;
}

wire::ResultBatch to_wire(const ResultBatch& sample) {
  wire::ResultBatch to;
  to.worker(sample.origin.worker);
  to.origin(convert(sample.origin));
  to.batch_sequence(sample.sequence);
  to.sweep_high(sample.sweep.high);
  to.sweep_low(sample.sweep.low);
  convert_all(sample.results, to.results());
  return to;
}

wire::ResultAcknowledgement to_wire(const ResultAcknowledgement& sample) {
  wire::ResultAcknowledgement to;
  to.worker(sample.origin.worker);
  to.origin(convert(sample.origin));
  convert_all(sample.results, to.results());
  return to;
}

wire::Request to_wire(const Request& sample) {
  wire::Request to;
  to.worker(sample.origin.worker);
  to.origin(convert(sample.origin));
  to.client(sample.client);
  to.correlation(sample.correlation);
  to.payload(sample.payload);
  return to;
}

wire::Reply to_wire(const Reply& sample) {
  wire::Reply to;
  to.worker(sample.origin.worker);
  to.origin(convert(sample.origin));
  to.client(sample.client);
  to.correlation(sample.correlation);
  to.payload(sample.payload);
  return to;
}

wire::SweepProgress to_wire(const SweepProgress& sample) {
  wire::SweepProgress to;
  to.sweep_high(sample.sweep.high);
  to.sweep_low(sample.sweep.low);
  to.worker(sample.origin.worker);
  to.origin(convert(sample.origin));
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
  return to;
}

}  // namespace lamprey::messaging::fastdds
