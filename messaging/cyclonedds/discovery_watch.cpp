#include "messaging/cyclonedds/discovery_watch.hpp"

#include "messaging/cyclonedds/domain.hpp"
#include "messaging/cyclonedds/entity.hpp"
#include "messaging/cyclonedds/participant_qos.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <dds/dds.h>
#include <map>
#include <memory>
#include <string>
#include <utility>

namespace lamprey::messaging::cyclonedds {
namespace {

using discovery::Endpoint;
using discovery::EndpointQos;
using discovery::Guid;

/// Strings and arrays that Cyclone's getters hand over.
struct Free {
  void operator()(void* memory) const { dds_free(memory); }
};
template <class Type>
using Handed = std::unique_ptr<Type, Free>;

Guid guid_of(const dds_guid_t& guid) {
  return std::to_array(guid.v);
}

std::string user_data_in(const dds_qos_t* qos) {
  void* data = nullptr;
  std::size_t size = 0;
  if (!dds_qget_userdata(qos, &data, &size) || data == nullptr) return {};
  const Handed<void> guard(data);
  return {static_cast<const char*>(data), size};
}

std::string name_in(const dds_qos_t* qos) {
  char* name = nullptr;
  if (!dds_qget_entity_name(qos, &name) || name == nullptr) return {};
  return Handed<char>(name).get();
}

std::vector<std::string> partitions_in(const dds_qos_t* qos) {
  std::uint32_t count = 0;
  char** names = nullptr;
  std::vector<std::string> partitions;
  if (!dds_qget_partition(qos, &count, &names) || names == nullptr) return partitions;
  const Handed<char*> guard(names);
  for (std::uint32_t i = 0; i < count; ++i) partitions.emplace_back(Handed<char>(names[i]).get());
  return partitions;
}

std::vector<std::int16_t> representations_in(const dds_qos_t* qos) {
  std::uint32_t count = 0;
  dds_data_representation_id_t* values = nullptr;
  if (!dds_qget_data_representation(qos, &count, &values) || values == nullptr) return {};
  const Handed<dds_data_representation_id_t> guard(values);
  return {values, values + count};
}

/// Cyclone's "infinite" is ours, too: the largest number of nanoseconds.
static_assert(DDS_INFINITY == EndpointQos::infinite.count());

EndpointQos qos_in(const dds_qos_t* from) {
  EndpointQos qos;
  if (dds_reliability_kind_t kind{}; dds_qget_reliability(from, &kind, nullptr)) {
    qos.reliable = kind == DDS_RELIABILITY_RELIABLE;
  }
  if (dds_ownership_kind_t kind{}; dds_qget_ownership(from, &kind)) qos.exclusive = kind == DDS_OWNERSHIP_EXCLUSIVE;
  if (dds_durability_kind_t kind{}; dds_qget_durability(from, &kind)) {
    qos.durability = static_cast<discovery::Durability>(kind);
  }
  dds_duration_t duration = DDS_INFINITY;
  if (dds_liveliness_kind_t kind{}; dds_qget_liveliness(from, &kind, &duration)) {
    qos.liveliness = static_cast<discovery::Liveliness>(kind);
    qos.liveliness_lease = std::chrono::nanoseconds(duration);
  }
  if (dds_qget_deadline(from, &duration)) qos.deadline = std::chrono::nanoseconds(duration);
  qos.partitions = partitions_in(from);
  qos.representations = representations_in(from);
  return qos;
}

static_assert(DDS_DURABILITY_VOLATILE == static_cast<int>(discovery::Durability::volatile_));
static_assert(DDS_DURABILITY_TRANSIENT_LOCAL == static_cast<int>(discovery::Durability::transient_local));
static_assert(DDS_DURABILITY_TRANSIENT == static_cast<int>(discovery::Durability::transient));
static_assert(DDS_DURABILITY_PERSISTENT == static_cast<int>(discovery::Durability::persistent));
static_assert(DDS_LIVELINESS_AUTOMATIC == static_cast<int>(discovery::Liveliness::automatic));
static_assert(DDS_LIVELINESS_MANUAL_BY_PARTICIPANT == static_cast<int>(discovery::Liveliness::manual_by_participant));
static_assert(DDS_LIVELINESS_MANUAL_BY_TOPIC == static_cast<int>(discovery::Liveliness::manual_by_topic));

discovery::Participant converted(const dds_builtintopic_participant_t& from) {
  return {guid_of(from.key), name_in(from.qos), discovery::introduction_in(user_data_in(from.qos))};
}

Endpoint converted(const dds_builtintopic_endpoint_t& from, bool writes) {
  return {guid_of(from.key), guid_of(from.participant_key), writes, from.topic_name, from.type_name, qos_in(from.qos)};
}

/// Takes what has come to a reader of a builtin topic; `appear` and `vanish` get samples of its type.
template <class Sample, class Appear, class Vanish>
void take_all(dds_entity_t reader, Appear appear, Vanish vanish) {
  constexpr std::size_t most = 64;
  while (true) {
    std::array<void*, most> loans{};
    std::array<dds_sample_info_t, most> infos{};
    const dds_return_t count = dds_take(reader, loans.data(), infos.data(), most, most);
    if (count <= 0) return;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      const auto& sample = *static_cast<const Sample*>(loans[i]);
      const bool there = infos[i].valid_data && infos[i].instance_state == DDS_IST_ALIVE;
      there ? appear(sample) : vanish(sample);
    }
    dds_return_loan(reader, loans.data(), count);
  }
}

class CycloneWatch final : public discovery::Watch {
 public:
  explicit CycloneWatch(const JoinOptions& options)
      : domain_(make_domain(options)),
        participant_(dds_create_participant(number_of(domain_), make_participant_qos(options).get(), nullptr),
                     "participant"),
        participants_(reader_of(DDS_BUILTIN_TOPIC_DCPSPARTICIPANT, "participants")),
        publications_(reader_of(DDS_BUILTIN_TOPIC_DCPSPUBLICATION, "writers")),
        subscriptions_(reader_of(DDS_BUILTIN_TOPIC_DCPSSUBSCRIPTION, "readers")) {
    dds_guid_t own{};
    if (const auto code = dds_get_guid(participant_.get(), &own); code < 0) {
      throw std::runtime_error(describe("cannot ask for the participant's GUID", code));
    }
    own_ = guid_of(own);
  }

  discovery::DomainView look() override {
    take_all<dds_builtintopic_participant_t>(
        participants_.get(),
        [this](const auto& sample) {
          if (guid_of(sample.key) != own_) known_participants_[guid_of(sample.key)] = converted(sample);
        },
        [this](const auto& sample) { known_participants_.erase(guid_of(sample.key)); });
    take_endpoints(publications_.get(), true);
    take_endpoints(subscriptions_.get(), false);
    discovery::DomainView view;
    for (const auto& [guid, participant] : known_participants_) view.participants.push_back(participant);
    for (const auto& [guid, endpoint] : known_endpoints_) view.endpoints.push_back(endpoint);
    return view;
  }

 private:
  Entity reader_of(dds_entity_t topic, const std::string& what) {
    return {dds_create_reader(participant_.get(), topic, nullptr, nullptr), "reader of the domain's " + what};
  }

  void take_endpoints(dds_entity_t reader, bool writes) {
    take_all<dds_builtintopic_endpoint_t>(
        reader,
        [&](const auto& sample) {
          if (guid_of(sample.participant_key) != own_)
            known_endpoints_[guid_of(sample.key)] = converted(sample, writes);
        },
        [this](const auto& sample) { known_endpoints_.erase(guid_of(sample.key)); });
  }

  Entity domain_;
  Entity participant_;
  Entity participants_;
  Entity publications_;
  Entity subscriptions_;
  Guid own_{};
  std::map<Guid, discovery::Participant> known_participants_;
  std::map<Guid, Endpoint> known_endpoints_;
};

}  // namespace

std::unique_ptr<discovery::Watch> make_discovery_watch(const JoinOptions& options) {
  return std::make_unique<CycloneWatch>(options);
}

}  // namespace lamprey::messaging::cyclonedds
