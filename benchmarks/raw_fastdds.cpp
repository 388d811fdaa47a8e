// A loop of benchmarks/messaging over Fast DDS itself: the generated types of idl/lamprey.idl are filled and read in
// place, samples are loaned, a listener wakes the program. Settings and quality of service are those of our port.
#include "benchmarks/messaging_loop.hpp"
#include "messaging/fastdds/configuration.hpp"
#include "messaging/fastdds/entity.hpp"
#include "messaging/fastdds/qos.hpp"

#include <array>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <fastdds/dds/core/LoanableSequence.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/rtps/transport/ChainingTransportDescriptor.h>
#include <lampreyPubSubTypes.h>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace {

using namespace lamprey;
using namespace lamprey::benchmarks;
using messaging::Lease;
using messaging::ResultBatch;
using messaging::fastdds::own;
using messaging::fastdds::Owned;
namespace dds = eprosima::fastdds::dds;
using ReturnCode = eprosima::fastrtps::types::ReturnCode_t;

void fill(wire::Origin& origin, const Stamp& stamp) {
  origin.database_high(1);
  origin.database_low(2);
  origin.epoch(stamp.incarnation);
  origin.science_version(static_cast<std::uint32_t>(stamp.phase));
}

void fill(wire::Score& score, std::uint64_t job, std::size_t place) {
  score.stability(figure(job, place));
  score.distance(figure(job, place + 1));
  score.fuel(figure(job, place + 2));
  score.total(figure(job, place + 3));
}

void fill(wire::Lease& lease, const Stamp& stamp) {
  lease.worker(3);
  fill(lease.origin(), stamp);
  lease.kind(wire::LEASE_GRANT);
  lease.lease_sequence(stamp.number);
  lease.lease(stamp.number);
  lease.sweep_high(4);
  lease.sweep_low(5);
  lease.duration_milliseconds(10'000);
  lease.ranges().resize(ranges_of_lease);
  for (std::size_t i = 0; i < ranges_of_lease; ++i) {
    lease.ranges()[i].first(stamp.number + i);
    lease.ranges()[i].count(1);
  }
}

void fill(std::vector<double>& column, std::uint64_t job, std::size_t place) {
  column.resize(changes_of_record);
  for (std::size_t i = 0; i < changes_of_record; ++i) column[i] = figure(job, place + i);
}

void fill(std::array<std::uint8_t, 32>& octets, std::uint64_t job, std::size_t place) {
  for (std::size_t i = 0; i < octets.size(); ++i) octets[i] = octet(job, place + i);
}

void fill(wire::Trace& trace, std::uint64_t job) {
  auto& cycles = trace.cycles();
  cycles.resize(changes_of_record);
  for (std::size_t i = 0; i < changes_of_record; ++i) cycles[i] = static_cast<std::uint32_t>(i);
  fill(trace.stability(), job, 0);
  fill(trace.distance(), job, 1);
  fill(trace.fuel(), job, 2);
  fill(trace.total(), job, 3);
}

void fill(wire::JobResult& record, std::uint64_t job) {
  record.job(job);
  record.kind(wire::RESULT_DONE);
  record.lease(job);
  record.fragment(0);
  record.fragments(1);
  fill(record.identity(), job, 0);
  fill(record.digest(), job, 1);
  auto& outcome = record.outcome();
  fill(outcome.expected(), job, 0);
  fill(outcome.initial(), job, 1);
  fill(outcome.evolved(), job, 2);
  fill(outcome.highest(), job, 3);
  fill(outcome.last(), job, 4);
  outcome.cycles(1000);
  outcome.accepted(changes_of_record);
  outcome.successes(changes_of_record);
  outcome.success_rate(figure(job, 5));
  fill(outcome.trace(), job);
  record.seconds(figure(job, 6));
  record.waited(figure(job, 7));
}

void fill(wire::ResultBatch& batch, const Stamp& stamp) {
  batch.worker(3);
  fill(batch.origin(), stamp);
  batch.batch_sequence(stamp.number);
  batch.sweep_high(4);
  batch.sweep_low(5);
  auto& records = batch.results();
  records.resize(records_of_batch);
  for (std::size_t i = 0; i < records_of_batch; ++i) fill(records[i], job_of(stamp.number, i));
}

bool is_intact(const wire::Lease& lease) {
  return lease.ranges().size() == ranges_of_lease &&
         lease.ranges().back().first() == lease.lease_sequence() + ranges_of_lease - 1;
}

bool is_intact(const wire::JobResult& record, std::uint64_t job) {
  const auto& total = record.outcome().trace().total();
  return record.job() == job && record.digest().back() == octet(job, record.digest().size()) &&
         total.size() == changes_of_record && total.back() == figure(job, changes_of_record + 2) &&
         record.waited() == figure(job, 7);
}

bool is_intact(const wire::ResultBatch& batch) {
  const auto& records = batch.results();
  bool intact = records.size() == records_of_batch;
  for (std::size_t i = 0; intact && i < records_of_batch; ++i) {
    intact = is_intact(records[i], job_of(batch.batch_sequence(), i));
  }
  return intact;
}

std::uint64_t number_of(const wire::Lease& lease) {
  return lease.lease_sequence();
}
std::uint64_t number_of(const wire::ResultBatch& batch) {
  return batch.batch_sequence();
}

class Arrivals final : public dds::DataReaderListener {
 public:
  void on_data_available(dds::DataReader*) override {
    {
      const std::lock_guard lock(mutex_);
      some_ = true;
    }
    condition_.notify_one();
  }
  bool wait(std::chrono::milliseconds timeout) {
    std::unique_lock lock(mutex_);
    const bool some = condition_.wait_for(lock, timeout, [this] { return some_; });
    some_ = false;
    return some;
  }

 private:
  std::mutex mutex_;
  std::condition_variable condition_;
  bool some_ = false;
};

/// A participant with one publisher and one subscriber.
struct Membership {
  Owned<dds::DomainParticipant> participant;
  Owned<dds::Publisher> publisher;
  Owned<dds::Subscriber> subscriber;

  explicit Membership(const messaging::JoinOptions& options)
      : participant(own(
            dds::DomainParticipantFactory::get_instance()->create_participant(options.domain, participant_qos(options)),
            "participant")),
        publisher(own(participant->create_publisher(dds::PUBLISHER_QOS_DEFAULT), "publisher")),
        subscriber(own(participant->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT), "subscriber")) {}

  /// Ours, with Fast DDS's own UDP instead of what we put around it.
  static dds::DomainParticipantQos participant_qos(const messaging::JoinOptions& options) {
    auto qos = messaging::fastdds::participant_qos(options);
    for (auto& transport : qos.transport().user_transports) {
      const auto ours = std::dynamic_pointer_cast<eprosima::fastdds::rtps::ChainingTransportDescriptor>(transport);
      if (ours != nullptr) transport = ours->low_level_descriptor;
    }
    return qos;
  }
};

/// The generated type and its type support.
template <class Sample>
struct Generated;
template <>
struct Generated<Lease> {
  using Type = wire::Lease;
  using Support = wire::LeasePubSubType;
};
template <>
struct Generated<ResultBatch> {
  using Type = wire::ResultBatch;
  using Support = wire::ResultBatchPubSubType;
};

/// Both ways of one kind of sample: a topic each.
template <class Sample>
class Link {
  using Type = typename Generated<Sample>::Type;

 public:
  Link(Membership& membership, Arrivals& arrivals, const TopicNames& names)
      : to_(topic(*membership.participant, names.to)),
        from_(topic(*membership.participant, names.from)),
        reader_(own(membership.subscriber->create_datareader(
                        from_.get(), messaging::fastdds::reader_qos<Sample>(*membership.subscriber), &arrivals,
                        dds::StatusMask::data_available()),
                    "reader")),
        writer_(own(membership.publisher->create_datawriter(
                        to_.get(), messaging::fastdds::writer_qos<Sample>(*membership.publisher)),
                    "writer")) {}

  bool write(const Stamp& stamp) {
    fill(outgoing_, stamp);
    return write_back(outgoing_);
  }

  bool write_back(const Type& sample) {
    // Only read through.
    const ReturnCode code = writer_->write(const_cast<Type*>(&sample), dds::HANDLE_NIL);
    if (code != ReturnCode::RETCODE_OK && code != ReturnCode::RETCODE_TIMEOUT) {
      throw std::runtime_error("cannot write (Fast DDS " + std::to_string(code()) + ")");
    }
    return code == ReturnCode::RETCODE_OK;
  }

  template <class Each>
  void take(Each each) {
    dds::LoanableSequence<Type> samples;
    dds::SampleInfoSeq infos;
    while (reader_->take(samples, infos) == ReturnCode::RETCODE_OK) {
      for (dds::LoanableCollection::size_type i = 0; i < infos.length(); ++i) {
        if (!infos[i].valid_data) continue;
        const Type& sample = samples[i];
        each(Stamp{.incarnation = sample.origin().epoch(),
                   .phase = static_cast<Phase>(sample.origin().science_version()),
                   .number = number_of(sample),
                   .intact = is_intact(sample)},
             sample);
      }
      reader_->return_loan(samples, infos);
    }
  }

 private:
  static Owned<dds::Topic> topic(dds::DomainParticipant& participant, const std::string& name) {
    dds::TypeSupport type(new typename Generated<Sample>::Support);
    if (type.register_type(&participant) != ReturnCode::RETCODE_OK) throw std::runtime_error("cannot register a type");
    return own(participant.create_topic(name, type.get_type_name(), dds::TOPIC_QOS_DEFAULT), "topic " + name);
  }

  Owned<dds::Topic> to_;
  Owned<dds::Topic> from_;
  Owned<dds::DataReader> reader_;
  Owned<dds::DataWriter> writer_;
  Type outgoing_;
};

class RawFastEnd {
 public:
  RawFastEnd(const messaging::JoinOptions& options, bool sender)
      : membership_(options),
        leases_(membership_, arrivals_, topic_names<Lease>(options, sender)),
        batches_(membership_, arrivals_, topic_names<ResultBatch>(options, sender)) {}

  bool wait(std::chrono::milliseconds timeout) { return arrivals_.wait(timeout); }
  template <class Sample>
  bool write(const Stamp& stamp) {
    return link<Sample>().write(stamp);
  }
  template <class Sample, class Each>
  void take(Each each) {
    link<Sample>().take(each);
  }
  template <class Sample>
  bool write_back(const typename Generated<Sample>::Type& sample) {
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

  Arrivals arrivals_;
  Membership membership_;
  Link<Lease> leases_;
  Link<ResultBatch> batches_;
};

}  // namespace

int main(int count, char** arguments) {
  return loop_main<RawFastEnd>(count, arguments, "One end of a loop over Fast DDS itself.");
}
