// A loop of benchmarks/messaging over our port, on either vendor.
#include "benchmarks/messaging_loop.hpp"
#include "messaging/port.hpp"

#include <chrono>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace {

using namespace lamprey;
using namespace lamprey::benchmarks;
using messaging::JobResult;
using messaging::Lease;
using messaging::ResultBatch;

messaging::Origin origin(const Stamp& stamp) {
  return {.database = {1, 2},
          .epoch = stamp.incarnation,
          .worker = 3,
          .science_version = static_cast<std::uint32_t>(stamp.phase)};
}

experiment::Score score(std::uint64_t job, std::size_t place) {
  return {.stability = figure(job, place),
          .distance = figure(job, place + 1),
          .fuel = figure(job, place + 2),
          .total = figure(job, place + 3)};
}

void fill(Lease& lease, const Stamp& stamp) {
  lease.origin = origin(stamp);
  lease.sequence = stamp.number;
  lease.lease = stamp.number;
  lease.sweep = {4, 5};
  lease.duration_milliseconds = 10'000;
  lease.ranges.resize(ranges_of_lease);
  for (std::size_t i = 0; i < ranges_of_lease; ++i) lease.ranges[i] = {.first = stamp.number + i, .count = 1};
}

void fill(JobResult& record, std::uint64_t job) {
  record.job = job;
  record.lease = job;
  for (std::size_t i = 0; i < record.identity.size(); ++i) record.identity[i] = octet(job, i);
  for (std::size_t i = 0; i < record.digest.size(); ++i) record.digest[i] = octet(job, i + 1);
  auto& outcome = record.outcome;
  outcome.expected = score(job, 0);
  outcome.initial = score(job, 1);
  outcome.evolved = score(job, 2);
  outcome.highest = score(job, 3);
  outcome.final = score(job, 4);
  outcome.cycles = 1000;
  outcome.accepted = changes_of_record;
  outcome.successes = changes_of_record;
  outcome.success_rate = figure(job, 5);
  outcome.trace.resize(changes_of_record);
  for (std::size_t i = 0; i < changes_of_record; ++i) {
    outcome.trace[i] = {.cycle = static_cast<std::uint32_t>(i), .score = score(job, i)};
  }
  record.seconds = figure(job, 6);
  record.waited = figure(job, 7);
}

void fill(ResultBatch& batch, const Stamp& stamp) {
  batch.origin = origin(stamp);
  batch.sequence = stamp.number;
  batch.sweep = {4, 5};
  batch.results.resize(records_of_batch);
  for (std::size_t i = 0; i < records_of_batch; ++i) fill(batch.results[i], job_of(stamp.number, i));
}

bool is_intact(const Lease& lease) {
  return lease.ranges.size() == ranges_of_lease && lease.ranges.back().first == lease.sequence + ranges_of_lease - 1;
}

bool is_intact(const JobResult& record, std::uint64_t job) {
  const auto& trace = record.outcome.trace;
  return record.job == job && record.digest.back() == octet(job, record.digest.size()) &&
         trace.size() == changes_of_record && trace.back().score.total == figure(job, changes_of_record + 2) &&
         record.waited == figure(job, 7);
}

bool is_intact(const ResultBatch& batch) {
  bool intact = batch.results.size() == records_of_batch;
  for (std::size_t i = 0; intact && i < records_of_batch; ++i) {
    intact = is_intact(batch.results[i], job_of(batch.sequence, i));
  }
  return intact;
}

template <class Sample>
struct Link {
  std::unique_ptr<messaging::Writer<Sample>> writer;
  std::unique_ptr<messaging::Reader<Sample>> reader;
  Sample outgoing;

  bool write(const Sample& sample) {
    const auto result = writer->write(sample);
    if (result.kind == messaging::WriteResult::Kind::failed) throw std::runtime_error(result.error);
    return static_cast<bool>(result);
  }
};

/// Each way has a partition of its own, as a worker's leases have.
class PortEnd {
 public:
  PortEnd(const messaging::JoinOptions& options, bool sender) : participant_(messaging::join(options)) {
    const auto there = messaging::Partition::of(1);
    const auto back = messaging::Partition::of(2);
    open<Lease>(sender ? there : back, sender ? back : there);
    open<ResultBatch>(sender ? there : back, sender ? back : there);
  }

  bool wait(std::chrono::milliseconds timeout) { return signal_->wait_for(timeout); }

  template <class Sample>
  bool write(const Stamp& stamp) {
    auto& link = std::get<Link<Sample>>(links_);
    fill(link.outgoing, stamp);
    return link.write(link.outgoing);
  }

  template <class Sample, class Each>
  void take(Each each) {
    for (const auto& sample : std::get<Link<Sample>>(links_).reader->take(taken_at_once)) {
      each(Stamp{.incarnation = sample.origin.epoch,
                 .phase = static_cast<Phase>(sample.origin.science_version),
                 .number = sample.sequence,
                 .intact = is_intact(sample)},
           sample);
    }
  }

  template <class Sample>
  bool write_back(const Sample& sample) {
    return std::get<Link<Sample>>(links_).write(sample);
  }

 private:
  template <class Sample>
  void open(messaging::Partition to, messaging::Partition from) {
    auto& link = std::get<Link<Sample>>(links_);
    link.reader = participant_->reader<Sample>(signal_, from);
    link.writer = participant_->writer<Sample>(to);
  }

  static constexpr std::size_t taken_at_once = 16;  // the processor's cache still has them when they are looked at

  std::shared_ptr<messaging::Signal> signal_ = std::make_shared<messaging::Signal>();
  std::unique_ptr<messaging::Participant> participant_;
  std::tuple<Link<Lease>, Link<ResultBatch>> links_;
};

}  // namespace

int main(int count, char** arguments) {
  return loop_main<PortEnd>(count, arguments, "One end of a loop over the messaging port.");
}
