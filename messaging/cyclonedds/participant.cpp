#include "messaging/cyclonedds/participant.hpp"

#include "messaging/cyclonedds/configuration.hpp"
#include "messaging/cyclonedds/entity.hpp"
#include "messaging/cyclonedds/wire.hpp"
#include "messaging/limits.hpp"
#include "messaging/names.hpp"
#include "messaging/participant_of.hpp"
#include "messaging/tuning.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <dds/dds.h>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace lamprey::messaging::cyclonedds {
namespace {

dds_duration_t nanoseconds(std::chrono::nanoseconds duration) {
  return duration.count();
}

/// A domain of its own within the process for each participant: two in one process would otherwise share one domain,
/// which has one configuration and hands samples over without the network. The first takes the number that it has on
/// the network, so that the user's configuration may address it; others only look like it from outside.
Entity make_domain(const JoinOptions& options) {
  const dds_entity_t first = dds_create_domain(options.domain, configuration(options, std::nullopt).c_str());
  if (first != DDS_RETCODE_PRECONDITION_NOT_MET) return {first, "domain"};
  static std::atomic<dds_domainid_t> next = highest_domain + 1;
  return {dds_create_domain(next++, configuration(options, options.domain).c_str()), "domain"};
}

/// The domain's number within the process.
dds_domainid_t number_of(const Entity& domain) {
  dds_domainid_t number = 0;
  if (const auto code = dds_get_domainid(domain.get(), &number); code < 0) {
    throw std::runtime_error(describe("cannot ask for the domain's number", code));
  }
  return number;
}

/// What a writer and a reader of the topic have in common.
template <class Sample>
Qos make_qos() {
  constexpr QosProfile profile = Topic<Sample>::profile;
  Qos qos(dds_create_qos());
  const dds_data_representation_id_t representation = DDS_DATA_REPRESENTATION_XCDR1;
  dds_qset_data_representation(qos.get(), 1, &representation);
  dds_qset_reliability(qos.get(), profile.reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
                       nanoseconds(maximum_blocking));
  dds_qset_durability(qos.get(), profile.transient_local ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
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
  dds_qset_writer_data_lifecycle(qos.get(), false);
  return qos;
}

/// Keep-last throughout, also where the profile says keep-all: a keep-all reader that is full blocks Cyclone's
/// receiving thread, and with it every topic, all acknowledgements and the reader's own deletion. Beyond so many
/// untaken samples the oldest is lost instead, and has to be sent again by the program that gets no answer.
template <class Sample>
Qos make_reader_qos() {
  constexpr auto depth = Keyed<Sample> ? static_cast<std::int32_t>(Topic<Sample>::profile.depth) : maximum_untaken;
  Qos qos = make_qos<Sample>();
  dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, depth);
  return qos;
}

Qos make_partition_qos(const std::string& partition) {
  Qos qos(dds_create_qos());
  dds_qset_partition1(qos.get(), partition.c_str());
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
  CycloneWriter(dds_entity_t participant, const std::string& partition)
      : topic_(make_topic<Sample>(participant)),
        publisher_(dds_create_publisher(participant, make_partition_qos(partition).get(), nullptr), "publisher"),
        writer_(dds_create_writer(publisher_.get(), topic_.get(), make_writer_qos<Sample>().get(), nullptr),
                "writer of " + std::string(Topic<Sample>::name)) {}

  WriteResult write(const Sample& sample) override {
    const std::string topic(Topic<Sample>::name);
    if (auto violation = limit_violation(sample)) {
      return {WriteResult::Kind::failed, "cannot write to " + topic + ": " + *violation};
    }
    Arena arena;
    const auto wire = to_wire(sample, arena);
    const dds_return_t code = dds_write(writer_.get(), &wire);
    if (code == DDS_RETCODE_OK) return {};
    const auto kind = code == DDS_RETCODE_TIMEOUT ? WriteResult::Kind::full : WriteResult::Kind::failed;
    return {kind, describe("cannot write to " + topic, code)};
  }

 private:
  Entity topic_;
  Entity publisher_;
  Entity writer_;
};

/// Samples stay in Cyclone's reader until they are taken.
template <class Sample>
class CycloneReader final : public Reader<Sample> {
 public:
  CycloneReader(dds_entity_t participant, const std::string& partition, std::shared_ptr<Signal> signal)
      : signal_(std::move(signal)),
        topic_(make_topic<Sample>(participant)),
        subscriber_(dds_create_subscriber(participant, make_partition_qos(partition).get(), nullptr), "subscriber"),
        reader_(dds_create_reader(subscriber_.get(), topic_.get(), make_reader_qos<Sample>().get(),
                                  make_listener(signal_.get()).get()),
                "reader of " + std::string(Topic<Sample>::name)) {}

  std::vector<Sample> take(std::size_t most) override {
    std::vector<Sample> samples;
    while (samples.size() < most) {
      const std::size_t chunk = std::min(most - samples.size(), loan_size);
      if (take_some(samples, chunk) < chunk) return samples;
    }
    if (signal_) signal_->notify();  // there may be more, and no other sample need come to say so
    return samples;
  }

 private:
  static constexpr std::size_t loan_size = 64;

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
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      if (!infos[i].valid_data) continue;
      Sample sample;
      if (!from_wire(*static_cast<const typename Wire<Sample>::Type*>(loans[i]), sample)) continue;
      if (limit_violation(sample)) continue;
      samples.push_back(std::move(sample));
    }
    return static_cast<std::size_t>(count);
  }

  /// Gives loaned samples back.
  struct Return {
    dds_entity_t reader;
    void** loans;
    dds_return_t count;
    ~Return() { dds_return_loan(reader, loans, count); }
  };

  std::shared_ptr<Signal> signal_;
  Entity topic_;
  Entity subscriber_;
  Entity reader_;  // destroyed first: afterwards no listener runs
};

class CycloneParticipant final : public ParticipantOf<CycloneParticipant> {
 public:
  explicit CycloneParticipant(const JoinOptions& options)
      : isolation_(options.isolation),
        domain_(make_domain(options)),
        participant_(dds_create_participant(number_of(domain_), nullptr, nullptr), "participant") {}

  template <class Sample>
  std::unique_ptr<Writer<Sample>> open_writer(Partition partition) {
    return std::make_unique<CycloneWriter<Sample>>(participant_.get(), partition_name(isolation_, partition));
  }
  template <class Sample>
  std::unique_ptr<Reader<Sample>> open_reader(Partition partition, std::shared_ptr<Signal> signal) {
    return std::make_unique<CycloneReader<Sample>>(participant_.get(), partition_name(isolation_, partition),
                                                   std::move(signal));
  }
  std::string vendor() const override { return "cyclonedds"; }

 private:
  std::string isolation_;
  Entity domain_;
  Entity participant_;
};

}  // namespace

std::unique_ptr<Participant> make_participant(const JoinOptions& options) {
  return std::make_unique<CycloneParticipant>(options);
}

}  // namespace lamprey::messaging::cyclonedds
