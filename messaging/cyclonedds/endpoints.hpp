#pragma once

#include "messaging/cyclonedds/entity.hpp"
#include "messaging/cyclonedds/ros2_wire.hpp"
#include "messaging/cyclonedds/wire.hpp"
#include "messaging/limits.hpp"
#include "messaging/malformed_samples.hpp"
#include "messaging/port.hpp"
#include "messaging/qos.hpp"
#include "messaging/ros2/limits.hpp"
#include "messaging/ros2/topics.hpp"
#include "messaging/traffic_counters.hpp"
#include "messaging/tuning.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <dds/dds.h>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Writers and readers over Cyclone, the same for our own topics and for ROS 2's.
namespace lamprey::messaging::cyclonedds {

inline dds_duration_t nanoseconds(std::chrono::nanoseconds duration) {
  return duration.count();
}

/// What a writer and a reader of the topic have in common. XCDR1 is all that both vendors read of each other.
template <class Sample>
Qos make_qos() {
  constexpr QosProfile profile = Topic<Sample>::profile;
  Qos qos(dds_create_qos());
  const dds_data_representation_id_t representation = DDS_DATA_REPRESENTATION_XCDR1;
  dds_qset_data_representation(qos.get(), 1, &representation);
  dds_qset_reliability(qos.get(), profile.reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
                       nanoseconds(longest_blocking<Sample>()));
  dds_qset_durability(qos.get(), profile.transient_local ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  if (const std::string announced = user_data<Sample>(); !announced.empty()) {
    dds_qset_userdata(qos.get(), announced.data(), announced.size());
  }
  if (profile.liveliness.count() > 0) {
    dds_qset_liveliness(qos.get(), DDS_LIVELINESS_AUTOMATIC, nanoseconds(profile.liveliness));
  }
  return qos;
}

template <class Sample>
Qos make_writer_qos() {
  constexpr QosProfile profile = Topic<Sample>::profile;
  constexpr auto depth = static_cast<std::int32_t>(profile.depth);
  Qos qos = make_qos<Sample>();
  dds_qset_history(qos.get(), profile.keep_all ? DDS_HISTORY_KEEP_ALL : DDS_HISTORY_KEEP_LAST, depth);
  // What late readers get is set by the durability service's history, not by the writer's.
  dds_qset_durability_service(qos.get(), 0, DDS_HISTORY_KEEP_LAST, depth, DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED,
                              DDS_LENGTH_UNLIMITED);
  if (profile.keep_all) dds_qset_resource_limits(qos.get(), depth, DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED);
  // Nothing is disposed of on deletion: what has ended is said by samples, and vendors differ in what they make of it.
  dds_qset_writer_data_lifecycle(qos.get(), false);
  return qos;
}

/// Keep-last throughout, also where the profile says keep-all: a keep-all reader that is full blocks Cyclone's
/// receiving thread, and with it every topic, all acknowledgements and the reader's own deletion. Beyond so many
/// untaken samples the oldest is lost instead, and has to be sent again by the program that gets no answer.
template <class Sample>
Qos make_reader_qos() {
  constexpr QosProfile profile = Topic<Sample>::profile;
  constexpr auto depth = static_cast<std::int32_t>(Keyed<Sample> ? profile.depth : profile.untaken);
  Qos qos = make_qos<Sample>();
  dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, depth);
  return qos;
}

/// `partition`: empty for the default one, which is ROS 2's.
inline Qos make_partition_qos(const std::string& partition) {
  Qos qos(dds_create_qos());
  if (!partition.empty()) dds_qset_partition1(qos.get(), partition.c_str());
  return qos;
}

template <class Sample>
Entity make_topic(dds_entity_t participant) {
  const std::string name(Topic<Sample>::name);
  return {dds_create_topic(participant, Wire<Sample>::descriptor(), name.c_str(), nullptr, nullptr), "topic " + name};
}

template <class Sample>
class CycloneWriter final : public Writer<Sample> {
 public:
  CycloneWriter(dds_entity_t participant, const std::string& partition, TopicCounters& counters)
      : counters_(counters),
        topic_(make_topic<Sample>(participant)),
        publisher_(dds_create_publisher(participant, make_partition_qos(partition).get(), nullptr), "publisher"),
        writer_(dds_create_writer(publisher_.get(), topic_.get(), make_writer_qos<Sample>().get(), nullptr),
                "writer of " + std::string(Topic<Sample>::name)) {}

  WriteResult write(const Sample& sample) override {
    if (auto violation = limit_violation(sample))
      return {WriteResult::Kind::failed, cannot_write() + ": " + *violation};
    std::array<std::byte, small_sample> memory;
    Arena arena(memory.data(), memory.size());
    const auto wire = to_wire(sample, arena);
    const dds_return_t code = dds_write(writer_.get(), &wire);
    counters_.count_write(code == DDS_RETCODE_OK);
    if (code == DDS_RETCODE_OK) return {};
    const auto kind = code == DDS_RETCODE_TIMEOUT ? WriteResult::Kind::full : WriteResult::Kind::failed;
    return {kind, describe(cannot_write(), code)};
  }

 private:
  /// Octets of arrays that are put together without the heap, which is most of what a small sample costs.
  static constexpr std::size_t small_sample = 1024;

  static std::string cannot_write() { return "cannot write to " + std::string(Topic<Sample>::name); }

  TopicCounters& counters_;
  Entity topic_;
  Entity publisher_;
  Entity writer_;
};

/// Samples stay in Cyclone's reader until they are taken.
template <class Sample>
class CycloneReader final : public Reader<Sample> {
 public:
  CycloneReader(dds_entity_t participant, const std::string& partition, std::shared_ptr<Signal> signal,
                std::shared_ptr<MalformedSamples> malformed, TopicCounters& counters)
      : counters_(counters),
        signal_(std::move(signal)),
        malformed_(std::move(malformed)),
        topic_(make_topic<Sample>(participant)),
        subscriber_(dds_create_subscriber(participant, make_partition_qos(partition).get(), nullptr), "subscriber"),
        reader_(dds_create_reader(subscriber_.get(), topic_.get(), make_reader_qos<Sample>().get(),
                                  make_listener(signal_.get()).get()),
                "reader of " + std::string(Topic<Sample>::name)) {}

  std::vector<Sample> take(std::size_t most) override {
    auto samples = take_up_to(most);
    counters_.count_read(samples.size());
    return samples;
  }

 private:
  static constexpr std::size_t loan_size = 64;

  std::vector<Sample> take_up_to(std::size_t most) {
    std::vector<Sample> samples;
    while (samples.size() < most) {
      const std::size_t chunk = std::min(most - samples.size(), loan_size);
      if (take_some(samples, chunk) < chunk) return samples;
    }
    if (signal_) signal_->notify();  // there may be more, and no other sample need come to say so
    return samples;
  }

  static Listener make_listener(Signal* signal) {
    Listener listener(dds_create_listener(signal));
    if (signal != nullptr) {
      dds_lset_data_available(listener.get(),
                              [](dds_entity_t, void* argument) { static_cast<Signal*>(argument)->notify(); });
    }
    return listener;
  }

  /// Takes at most `most` from Cyclone and appends the valid ones; how many were taken.
  std::size_t take_some(std::vector<Sample>& samples, std::size_t most) {
    std::array<void*, loan_size> loans{};
    std::array<dds_sample_info_t, loan_size> infos{};
    const dds_return_t count =
        dds_take(reader_.get(), loans.data(), infos.data(), most, static_cast<std::uint32_t>(most));
    if (count <= 0) return 0;
    const Return guard{reader_.get(), loans.data(), count};
    if (samples.empty()) samples.reserve(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      if (!infos[i].valid_data) continue;
      Sample sample;
      if (const auto fault = fault_of(*static_cast<const typename Wire<Sample>::Type*>(loans[i]), sample)) {
        malformed_->note(Topic<Sample>::name, source(infos[i].publication_handle), *fault);
        continue;
      }
      samples.push_back(std::move(sample));
    }
    return static_cast<std::size_t>(count);
  }

  static std::optional<std::string> fault_of(const typename Wire<Sample>::Type& wire, Sample& sample) {
    if (!from_wire(wire, sample)) return "it has an unknown enumerator or columns of unequal length";
    return limit_violation(sample);
  }

  /// The writer's GUID in hex, if it still is there.
  std::string source(dds_instance_handle_t publication) const {
    auto* const writer = dds_get_matched_publication_data(reader_.get(), publication);
    if (writer == nullptr) return "a writer that has left";
    std::string text = "writer ";
    for (const auto octet : writer->key.v) {
      std::array<char, 3> digits{};
      std::snprintf(digits.data(), digits.size(), "%02x", octet);
      text += digits.data();
    }
    dds_builtintopic_free_endpoint(writer);
    return text;
  }

  /// Gives loaned samples back.
  struct Return {
    dds_entity_t reader;
    void** loans;
    dds_return_t count;
    ~Return() { dds_return_loan(reader, loans, count); }
  };

  TopicCounters& counters_;
  std::shared_ptr<Signal> signal_;
  std::shared_ptr<MalformedSamples> malformed_;
  Entity topic_;
  Entity subscriber_;
  Entity reader_;  // destroyed first: afterwards no listener runs
};

}  // namespace lamprey::messaging::cyclonedds
