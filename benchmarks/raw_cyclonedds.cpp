// A loop of benchmarks/messaging over Cyclone DDS itself: the C types of idl/lamprey.idl are filled and read in place,
// samples are loaned, a waitset wakes the program. Settings and quality of service are those of our port.
#include "benchmarks/messaging_loop.hpp"
#include "messaging/cyclonedds/configuration.hpp"
#include "messaging/cyclonedds/endpoints.hpp"
#include "messaging/cyclonedds/entity.hpp"
#include "messaging/cyclonedds/wire.hpp"

#include <array>
#include <chrono>
#include <cstdint>
#include <dds/dds.h>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace {

using namespace lamprey;
using namespace lamprey::benchmarks;
using messaging::Lease;
using messaging::ResultBatch;
using messaging::cyclonedds::Entity;

template <class Sequence, class Element, std::size_t Count>
void lend(Sequence& sequence, std::array<Element, Count>& elements) {
  sequence._buffer = elements.data();
  sequence._length = Count;
  sequence._maximum = Count;
  sequence._release = false;
}

lamprey_wire_Origin origin(const Stamp& stamp) {
  return {.database_high = 1,
          .database_low = 2,
          .epoch = stamp.incarnation,
          .science_version = static_cast<std::uint32_t>(stamp.phase)};
}

lamprey_wire_Score score(std::uint64_t job, std::size_t place) {
  return {.stability = figure(job, place),
          .distance = figure(job, place + 1),
          .fuel = figure(job, place + 2),
          .total = figure(job, place + 3)};
}

/// A sample and the arrays that it points to.
template <class Sample>
struct Filled;

template <>
struct Filled<Lease> {
  lamprey_wire_Lease wire{};
  std::array<lamprey_wire_JobRange, ranges_of_lease> ranges{};
  std::array<char, 1> reason{};

  Filled() {
    lend(wire.ranges, ranges);
    wire.reason = reason.data();
  }
  void fill(const Stamp& stamp) {
    wire.worker = 3;
    wire.origin = origin(stamp);
    wire.kind = lamprey_wire_LEASE_GRANT;
    wire.lease_sequence = stamp.number;
    wire.lease = stamp.number;
    wire.sweep_high = 4;
    wire.sweep_low = 5;
    wire.duration_milliseconds = 10'000;
    for (std::size_t i = 0; i < ranges_of_lease; ++i) ranges[i] = {.first = stamp.number + i, .count = 1};
  }
};

struct Columns {
  std::array<std::uint32_t, changes_of_record> cycles;
  std::array<double, changes_of_record> stability;
  std::array<double, changes_of_record> distance;
  std::array<double, changes_of_record> fuel;
  std::array<double, changes_of_record> total;
};

void fill(lamprey_wire_JobResult& record, Columns& columns, std::uint64_t job) {
  record.job = job;
  record.kind = lamprey_wire_RESULT_DONE;
  record.lease = job;
  record.fragment = 0;
  record.fragments = 1;
  for (std::size_t i = 0; i < std::size(record.identity); ++i) record.identity[i] = octet(job, i);
  for (std::size_t i = 0; i < std::size(record.digest); ++i) record.digest[i] = octet(job, i + 1);
  auto& outcome = record.outcome;
  outcome.expected = score(job, 0);
  outcome.initial = score(job, 1);
  outcome.evolved = score(job, 2);
  outcome.highest = score(job, 3);
  outcome.last = score(job, 4);
  outcome.cycles = 1000;
  outcome.accepted = changes_of_record;
  outcome.successes = changes_of_record;
  outcome.success_rate = figure(job, 5);
  for (std::size_t i = 0; i < changes_of_record; ++i) {
    columns.cycles[i] = static_cast<std::uint32_t>(i);
    columns.stability[i] = figure(job, i);
    columns.distance[i] = figure(job, i + 1);
    columns.fuel[i] = figure(job, i + 2);
    columns.total[i] = figure(job, i + 3);
  }
  record.seconds = figure(job, 6);
  record.waited = figure(job, 7);
}

template <>
struct Filled<ResultBatch> {
  lamprey_wire_ResultBatch wire{};
  std::array<lamprey_wire_JobResult, records_of_batch> records{};
  std::array<Columns, records_of_batch> columns{};
  std::array<char, 1> reason{};

  Filled() {
    lend(wire.results, records);
    for (std::size_t i = 0; i < records_of_batch; ++i) {
      auto& trace = records[i].outcome.trace;
      lend(trace.cycles, columns[i].cycles);
      lend(trace.stability, columns[i].stability);
      lend(trace.distance, columns[i].distance);
      lend(trace.fuel, columns[i].fuel);
      lend(trace.total, columns[i].total);
      records[i].reason = reason.data();
    }
  }
  void fill(const Stamp& stamp) {
    wire.worker = 3;
    wire.origin = origin(stamp);
    wire.batch_sequence = stamp.number;
    wire.sweep_high = 4;
    wire.sweep_low = 5;
    for (std::size_t i = 0; i < records_of_batch; ++i) ::fill(records[i], columns[i], job_of(stamp.number, i));
  }
};

bool is_intact(const lamprey_wire_Lease& lease) {
  return lease.ranges._length == ranges_of_lease &&
         lease.ranges._buffer[ranges_of_lease - 1].first == lease.lease_sequence + ranges_of_lease - 1;
}

bool is_intact(const lamprey_wire_JobResult& record, std::uint64_t job) {
  constexpr std::size_t octets = std::extent_v<decltype(record.digest)>;
  const auto& trace = record.outcome.trace;
  return record.job == job && record.digest[octets - 1] == octet(job, octets) &&
         trace.total._length == changes_of_record &&
         trace.total._buffer[changes_of_record - 1] == figure(job, changes_of_record + 2) &&
         record.waited == figure(job, 7);
}

bool is_intact(const lamprey_wire_ResultBatch& batch) {
  bool intact = batch.results._length == records_of_batch;
  for (std::uint32_t i = 0; intact && i < records_of_batch; ++i) {
    intact = is_intact(batch.results._buffer[i], job_of(batch.batch_sequence, i));
  }
  return intact;
}

std::uint64_t number_of(const lamprey_wire_Lease& lease) {
  return lease.lease_sequence;
}
std::uint64_t number_of(const lamprey_wire_ResultBatch& batch) {
  return batch.batch_sequence;
}

void check(dds_return_t code, const std::string& what) {
  if (code < 0) throw std::runtime_error(messaging::cyclonedds::describe(what, code));
}

bool written(dds_return_t code) {
  if (code == DDS_RETCODE_TIMEOUT) return false;
  check(code, "cannot write");
  return true;
}

/// Both ways of one kind of sample: a topic each.
template <class Sample>
class Link {
  using Wire = messaging::cyclonedds::Wire<Sample>;

 public:
  Link(dds_entity_t participant, dds_entity_t waitset, const TopicNames& names)
      : to_(topic(participant, names.to)),
        from_(topic(participant, names.from)),
        reader_(dds_create_reader(participant, from_.get(), messaging::cyclonedds::make_reader_qos<Sample>().get(),
                                  nullptr),
                "reader"),
        arrived_(dds_create_readcondition(reader_.get(), DDS_ANY_STATE), "read condition"),
        writer_(
            dds_create_writer(participant, to_.get(), messaging::cyclonedds::make_writer_qos<Sample>().get(), nullptr),
            "writer") {
    check(dds_waitset_attach(waitset, arrived_.get(), 0), "cannot attach to the waitset");
  }

  bool write(const Stamp& stamp) {
    outgoing_.fill(stamp);
    return write_back(outgoing_.wire);
  }
  bool write_back(const typename Wire::Type& sample) { return written(dds_write(writer_.get(), &sample)); }

  template <class Each>
  void take(Each each) {
    std::array<void*, 64> loans{};
    std::array<dds_sample_info_t, 64> infos{};
    const dds_return_t count = dds_take(reader_.get(), loans.data(), infos.data(), loans.size(), loans.size());
    check(count, "cannot take");
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      if (!infos[i].valid_data) continue;
      const auto& sample = *static_cast<const typename Wire::Type*>(loans[i]);
      each(Stamp{.incarnation = sample.origin.epoch,
                 .phase = static_cast<Phase>(sample.origin.science_version),
                 .number = number_of(sample),
                 .intact = is_intact(sample)},
           sample);
    }
    if (count > 0) check(dds_return_loan(reader_.get(), loans.data(), count), "cannot return loans");
  }

 private:
  static Entity topic(dds_entity_t participant, const std::string& name) {
    return {dds_create_topic(participant, Wire::descriptor(), name.c_str(), nullptr, nullptr), "topic " + name};
  }

  Entity to_;
  Entity from_;
  Entity reader_;
  Entity arrived_;
  Entity writer_;
  Filled<Sample> outgoing_;
};

class RawCycloneEnd {
 public:
  RawCycloneEnd(const messaging::JoinOptions& options, bool sender)
      : domain_(dds_create_domain(options.domain, messaging::cyclonedds::configuration(options, std::nullopt).c_str()),
                "domain"),
        participant_(dds_create_participant(options.domain, nullptr, nullptr), "participant"),
        waitset_(dds_create_waitset(participant_.get()), "waitset"),
        leases_(participant_.get(), waitset_.get(), topic_names<Lease>(options, sender)),
        batches_(participant_.get(), waitset_.get(), topic_names<ResultBatch>(options, sender)) {}

  bool wait(std::chrono::milliseconds timeout) {
    const auto triggered = dds_waitset_wait(waitset_.get(), nullptr, 0, DDS_MSECS(timeout.count()));
    check(triggered, "cannot wait");
    return triggered > 0;
  }
  template <class Sample>
  bool write(const Stamp& stamp) {
    return link<Sample>().write(stamp);
  }
  template <class Sample, class Each>
  void take(Each each) {
    link<Sample>().take(each);
  }
  template <class Sample>
  bool write_back(const typename messaging::cyclonedds::Wire<Sample>::Type& sample) {
    return link<Sample>().write_back(sample);
  }

 private:
  template <class Sample>
  Link<Sample>& link() {
    if constexpr (std::is_same_v<Sample, Lease>) {
      return leases_;
    } else {
      return batches_;
    }
  }

  Entity domain_;
  Entity participant_;
  Entity waitset_;
  Link<Lease> leases_;
  Link<ResultBatch> batches_;
};

}  // namespace

int main(int count, char** arguments) {
  return loop_main<RawCycloneEnd>(count, arguments, "One end of a loop over Cyclone DDS itself.");
}
