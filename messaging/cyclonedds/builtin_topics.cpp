#include "messaging/cyclonedds/builtin_topics.hpp"

#include "messaging/cyclonedds/entity.hpp"

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

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

}  // namespace

Guid guid_of(const dds_guid_t& guid) {
  return std::to_array(guid.v);
}

Guid guid_of(dds_entity_t participant) {
  dds_guid_t guid{};
  if (const auto code = dds_get_guid(participant, &guid); code < 0) {
    throw std::runtime_error(describe("cannot ask for the participant's GUID", code));
  }
  return guid_of(guid);
}

discovery::Participant converted(const dds_builtintopic_participant_t& from) {
  return {guid_of(from.key), name_in(from.qos), discovery::introduction_in(user_data_in(from.qos))};
}

Endpoint converted(const dds_builtintopic_endpoint_t& from, bool writes) {
  return {guid_of(from.key), guid_of(from.participant_key), writes, from.topic_name, from.type_name, qos_in(from.qos)};
}

Census::Census(dds_entity_t participant)
    : own_(guid_of(participant)),
      reader_(dds_create_reader(participant, DDS_BUILTIN_TOPIC_DCPSPARTICIPANT, nullptr, nullptr),
              "reader of the domain's participants") {}

std::vector<discovery::Participant> Census::participants() {
  take_all<dds_builtintopic_participant_t>(
      reader_.get(),
      [this](const auto& sample) {
        if (guid_of(sample.key) != own_) known_[guid_of(sample.key)] = converted(sample);
      },
      [this](const auto& sample) { known_.erase(guid_of(sample.key)); });
  std::vector<discovery::Participant> all;
  for (const auto& [guid, participant] : known_) all.push_back(participant);
  return all;
}

}  // namespace lamprey::messaging::cyclonedds
