#pragma once

#include "messaging/fastdds/entity.hpp"
#include "messaging/fastdds/qos.hpp"
#include "messaging/fastdds/ros2_wire.hpp"
#include "messaging/fastdds/type_support.hpp"
#include "messaging/fastdds/wire.hpp"
#include "messaging/limits.hpp"
#include "messaging/malformed_samples.hpp"
#include "messaging/port.hpp"
#include "messaging/ros2/limits.hpp"
#include "messaging/ros2/topics.hpp"
#include "messaging/traffic_counters.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fastdds/dds/core/LoanableSequence.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// Writers and readers over Fast DDS, the same for our own topics and for ROS 2's.
namespace lamprey::messaging::fastdds {

using ReturnCode = eprosima::fastrtps::types::ReturnCode_t;

inline const char* text_of(ReturnCode code) {
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
  FastWriter(dds::DomainParticipant& participant, dds::Topic& topic, const std::string& partition,
             TopicCounters& counters)
      : counters_(counters),
        publisher_(own(participant.create_publisher(publisher_qos(participant, partition)), "publisher")),
        writer_(own(publisher_->create_datawriter(&topic, writer_qos<Sample>(*publisher_)),
                    "writer of " + std::string(Topic<Sample>::name))) {}

  WriteResult write(const Sample& sample) override {
    if (auto violation = limit_violation(sample)) return {WriteResult::Kind::failed, cannot_write() + *violation};
    to_wire(sample, data_);
    const ReturnCode code = writer_->write(&data_, dds::HANDLE_NIL);
    counters_.count_write(code == ReturnCode::RETCODE_OK);
    if (code == ReturnCode::RETCODE_OK) return {};
    const auto kind = code == ReturnCode::RETCODE_TIMEOUT ? WriteResult::Kind::full : WriteResult::Kind::failed;
    return {kind, cannot_write() + text_of(code) + " (Fast DDS " + std::to_string(code()) + ")"};
  }

 private:
  static std::string cannot_write() { return "cannot write to " + std::string(Topic<Sample>::name) + ": "; }

  TopicCounters& counters_;
  typename Wire<Sample>::Type data_;  ///< kept for its memory: a batch of results has hundreds of vectors
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
             std::shared_ptr<Signal> signal, std::shared_ptr<MalformedSamples> malformed, TopicCounters& counters)
      : counters_(counters),
        malformed_(std::move(malformed)),
        notifier_(std::move(signal)),
        subscriber_(own(participant.create_subscriber(subscriber_qos(participant, partition)), "subscriber")),
        reader_(own(subscriber_->create_datareader(&topic, reader_qos<Sample>(*subscriber_), &notifier_,
                                                   dds::StatusMask::data_available()),
                    "reader of " + std::string(Topic<Sample>::name))) {}

  std::vector<Sample> take(std::size_t most) override {
    auto samples = take_up_to(most);
    counters_.count_read(samples.size());
    return samples;
  }

 private:
  static constexpr std::size_t taken_at_once = 16;

  std::vector<Sample> take_up_to(std::size_t most) {
    std::vector<Sample> samples;
    while (samples.size() < most) {
      const std::size_t chunk = std::min(most - samples.size(), taken_at_once);
      if (take_some(samples, chunk) < chunk) return samples;
    }
    notifier_.notify();  // there may be more, and no other sample need come to say so
    return samples;
  }

  /// Takes at most `most` from Fast DDS and appends the valid ones; how many were taken.
  std::size_t take_some(std::vector<Sample>& samples, std::size_t most) {
    data_.length(0);
    infos_.length(0);
    if (reader_->take(data_, infos_, static_cast<std::int32_t>(most)) != ReturnCode::RETCODE_OK) return 0;
    const auto count = infos_.length();
    samples.reserve(samples.size() + static_cast<std::size_t>(count));
    for (std::int32_t i = 0; i < count; ++i) {
      if (!infos_[i].valid_data) continue;
      Sample sample;
      if (const auto fault = fault_of(data_[i], sample)) {
        malformed_->note(Topic<Sample>::name, source(infos_[i]), *fault);
        continue;
      }
      samples.push_back(std::move(sample));
    }
    return static_cast<std::size_t>(count);
  }

  static std::optional<std::string> fault_of(typename Wire<Sample>::Type& data, Sample& sample) {
    if (!from_wire(data, sample)) return "it has an unknown enumerator or columns of unequal length";
    return limit_violation(sample);
  }

  static std::string source(const dds::SampleInfo& info) {
    std::ostringstream text;
    text << "writer " << info.sample_identity.writer_guid();
    return text.str();
  }

  TopicCounters& counters_;
  // Kept for their memory. Fast DDS fills them rather than lend what is its own.
  dds::LoanableSequence<typename Wire<Sample>::Type> data_{taken_at_once};
  dds::SampleInfoSeq infos_{taken_at_once};
  std::shared_ptr<MalformedSamples> malformed_;
  Notifier notifier_;
  Owned<dds::Subscriber> subscriber_;
  Owned<dds::DataReader> reader_;  // destroyed first: afterwards no listener runs
};

/// Registers the type with the participant and makes the topic: once for each participant.
template <class Sample>
Owned<dds::Topic> make_topic(dds::DomainParticipant& participant, const std::shared_ptr<MalformedSamples>& malformed) {
  const std::string name(Topic<Sample>::name);
  dds::TypeSupport type(new GuardedType<Sample>(malformed));
  if (type.register_type(&participant) != ReturnCode::RETCODE_OK) {
    throw std::runtime_error("Fast DDS cannot register the type of " + name);
  }
  return own(participant.create_topic(name, type.get_type_name(), participant.get_default_topic_qos()),
             "topic " + name);
}

}  // namespace lamprey::messaging::fastdds
