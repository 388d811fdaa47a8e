#include "messaging/fastdds/participant.hpp"

#include "messaging/fastdds/configuration.hpp"
#include "messaging/fastdds/entity.hpp"
#include "messaging/fastdds/qos.hpp"
#include "messaging/fastdds/type_support.hpp"
#include "messaging/fastdds/wire.hpp"
#include "messaging/limits.hpp"
#include "messaging/names.hpp"
#include "messaging/participant_of.hpp"
#include "messaging/tuning.hpp"

#include <cstddef>
#include <exception>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <mutex>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace lamprey::messaging::fastdds {
namespace {

using ReturnCode = eprosima::fastrtps::types::ReturnCode_t;

const char* text_of(ReturnCode code) {
  switch (code()) {
    case ReturnCode::RETCODE_ERROR:
      return "error";
    case ReturnCode::RETCODE_UNSUPPORTED:
      return "unsupported";
    case ReturnCode::RETCODE_BAD_PARAMETER:
      return "bad parameter";
    case ReturnCode::RETCODE_PRECONDITION_NOT_MET:
      return "precondition not met";
    case ReturnCode::RETCODE_OUT_OF_RESOURCES:
      return "out of resources";
    case ReturnCode::RETCODE_NOT_ENABLED:
      return "not enabled";
    case ReturnCode::RETCODE_TIMEOUT:
      return "timeout";
    default:
      return "unexpected";
  }
}

template <class Sample>
class FastWriter final : public Writer<Sample> {
 public:
  FastWriter(dds::DomainParticipant& participant, dds::Topic& topic, const std::string& partition)
      : publisher_(own(participant.create_publisher(publisher_qos(participant, partition)), "publisher")),
        writer_(own(publisher_->create_datawriter(&topic, writer_qos<Sample>(*publisher_)),
                    "writer of " + std::string(Topic<Sample>::name))) {}

  WriteResult write(const Sample& sample) override {
    const std::string topic(Topic<Sample>::name);
    if (auto violation = limit_violation(sample)) {
      return {WriteResult::Kind::failed, "cannot write to " + topic + ": " + *violation};
    }
    auto data = to_wire(sample);
    const ReturnCode code = writer_->write(&data, dds::HANDLE_NIL);
    if (code == ReturnCode::RETCODE_OK) return {};
    const auto kind = code == ReturnCode::RETCODE_TIMEOUT ? WriteResult::Kind::full : WriteResult::Kind::failed;
    return {kind, "cannot write to " + topic + ": " + text_of(code) + " (Fast DDS " + std::to_string(code()) + ")"};
  }

 private:
  Owned<dds::Publisher> publisher_;
  Owned<dds::DataWriter> writer_;
};

class Notifier final : public dds::DataReaderListener {
 public:
  explicit Notifier(std::shared_ptr<Signal> signal) : signal_(std::move(signal)) {}
  void on_data_available(dds::DataReader*) override { notify(); }
  void notify() {
    if (signal_) signal_->notify();
  }

 private:
  std::shared_ptr<Signal> signal_;
};

/// Samples stay in Fast DDS's reader until they are taken, so a slow program makes reliable writers wait.
template <class Sample>
class FastReader final : public Reader<Sample> {
 public:
  FastReader(dds::DomainParticipant& participant, dds::Topic& topic, const std::string& partition,
             std::shared_ptr<Signal> signal)
      : notifier_(std::move(signal)),
        subscriber_(own(participant.create_subscriber(subscriber_qos(participant, partition)), "subscriber")),
        reader_(own(subscriber_->create_datareader(&topic, reader_qos<Sample>(*subscriber_), &notifier_,
                                                   dds::StatusMask::data_available()),
                    "reader of " + std::string(Topic<Sample>::name))) {}

  std::vector<Sample> take(std::size_t most) override {
    std::vector<Sample> samples;
    while (samples.size() < most) {
      typename Wire<Sample>::Type data;
      dds::SampleInfo info;
      if (reader_->take_next_sample(&data, &info) != ReturnCode::RETCODE_OK) return samples;
      if (!info.valid_data) continue;
      Sample sample;
      if (!from_wire(data, sample) || limit_violation(sample)) continue;
      samples.push_back(std::move(sample));
    }
    notifier_.notify();  // there may be more, and no other sample need come to say so
    return samples;
  }

 private:
  Notifier notifier_;
  Owned<dds::Subscriber> subscriber_;
  Owned<dds::DataReader> reader_;  // destroyed first: afterwards no listener runs
};

/// A topic as the participant knows it: once, however many writers and readers it has.
template <class Sample>
struct Registered {
  Owned<dds::Topic> topic;
};

class FastParticipant final : public ParticipantOf<FastParticipant> {
 public:
  explicit FastParticipant(const JoinOptions& options)
      : isolation_(options.isolation),
        participant_(own(
            dds::DomainParticipantFactory::get_instance()->create_participant(options.domain, participant_qos(options)),
            "a participant (is the network up, and are there fewer than " + std::to_string(participants_per_host) +
                " programs of this domain on the host?)")) {}

  template <class Sample>
  std::unique_ptr<Writer<Sample>> open_writer(Partition partition) {
    return std::make_unique<FastWriter<Sample>>(*participant_, topic<Sample>(), partition_name(isolation_, partition));
  }
  template <class Sample>
  std::unique_ptr<Reader<Sample>> open_reader(Partition partition, std::shared_ptr<Signal> signal) {
    return std::make_unique<FastReader<Sample>>(*participant_, topic<Sample>(), partition_name(isolation_, partition),
                                                std::move(signal));
  }
  std::string vendor() const override { return "fastdds"; }

 private:
  template <class Sample>
  dds::Topic& topic() {
    const std::lock_guard lock(mutex_);
    auto& registered = std::get<Registered<Sample>>(topics_);
    if (registered.topic == nullptr) {
      const std::string name(Topic<Sample>::name);
      dds::TypeSupport type(new GuardedType<Sample>());
      if (type.register_type(participant_.get()) != ReturnCode::RETCODE_OK) {
        throw std::runtime_error("Fast DDS cannot register the type of " + name);
      }
      registered.topic =
          own(participant_->create_topic(name, type.get_type_name(), participant_->get_default_topic_qos()),
              "topic " + name);
    }
    return *registered.topic;
  }

  std::string isolation_;
  Owned<dds::DomainParticipant> participant_;
  std::mutex mutex_;
  std::tuple<Registered<WorkerStatus>, Registered<SweepSpecification>, Registered<Lease>, Registered<ResultBatch>,
             Registered<ResultAcknowledgement>, Registered<Request>, Registered<Reply>, Registered<SweepProgress>>
      topics_;
};

}  // namespace

std::unique_ptr<Participant> make_participant(const JoinOptions& options) {
  return std::make_unique<FastParticipant>(options);
}

}  // namespace lamprey::messaging::fastdds
