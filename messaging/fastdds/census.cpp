#include "messaging/fastdds/census.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <string>
#include <utility>

namespace lamprey::messaging::fastdds {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

discovery::Guid guid_of(const rtps::GUID_t& from) {
  discovery::Guid guid{};
  std::copy_n(from.guidPrefix.value, rtps::GuidPrefix_t::size, guid.begin());
  std::copy_n(from.entityId.value, rtps::EntityId_t::size, guid.begin() + rtps::GuidPrefix_t::size);
  return guid;
}

namespace {

using discovery::EndpointQos;
using discovery::Guid;

Guid participant_of(const rtps::GUID_t& endpoint) {
  return guid_of({endpoint.guidPrefix, rtps::c_EntityId_RTPSParticipant});
}

std::chrono::nanoseconds nanoseconds(const eprosima::fastrtps::Duration_t& duration) {
  if (duration == eprosima::fastrtps::c_TimeInfinite) return EndpointQos::infinite;
  return std::chrono::nanoseconds(duration.to_ns());
}

discovery::Durability durability_of(dds::DurabilityQosPolicyKind kind) {
  switch (kind) {
    case dds::TRANSIENT_LOCAL_DURABILITY_QOS:
      return discovery::Durability::transient_local;
    case dds::TRANSIENT_DURABILITY_QOS:
      return discovery::Durability::transient;
    case dds::PERSISTENT_DURABILITY_QOS:
      return discovery::Durability::persistent;
    default:
      return discovery::Durability::volatile_;
  }
}

discovery::Liveliness liveliness_of(dds::LivelinessQosPolicyKind kind) {
  switch (kind) {
    case dds::MANUAL_BY_PARTICIPANT_LIVELINESS_QOS:
      return discovery::Liveliness::manual_by_participant;
    case dds::MANUAL_BY_TOPIC_LIVELINESS_QOS:
      return discovery::Liveliness::manual_by_topic;
    default:
      return discovery::Liveliness::automatic;
  }
}

/// Of a writer's or a reader's policies, which have no type in common.
template <class Policies>
EndpointQos qos_of(const Policies& from) {
  EndpointQos qos;
  qos.reliable = from.m_reliability.kind == dds::RELIABLE_RELIABILITY_QOS;
  qos.exclusive = from.m_ownership.kind == dds::EXCLUSIVE_OWNERSHIP_QOS;
  qos.durability = durability_of(from.m_durability.kind);
  qos.liveliness = liveliness_of(from.m_liveliness.kind);
  qos.liveliness_lease = nanoseconds(from.m_liveliness.lease_duration);
  qos.deadline = nanoseconds(from.m_deadline.period);
  for (const auto representation : from.representation.m_value) {
    qos.representations.push_back(static_cast<std::int16_t>(representation));
  }
  for (const auto& partition : from.m_partition.getNames()) qos.partitions.push_back(partition);
  return qos;
}

bool is_there(const rtps::ParticipantDiscoveryInfo& discovered) {
  return discovered.status == rtps::ParticipantDiscoveryInfo::DISCOVERED_PARTICIPANT ||
         discovered.status == rtps::ParticipantDiscoveryInfo::CHANGED_QOS_PARTICIPANT;
}

}  // namespace

std::vector<discovery::Participant> ParticipantCensus::participants() const {
  const std::scoped_lock lock(mutex_);
  std::vector<discovery::Participant> all;
  for (const auto& [guid, participant] : participants_) all.push_back(participant);
  return all;
}

void ParticipantCensus::on_participant_discovery(dds::DomainParticipant*, rtps::ParticipantDiscoveryInfo&& discovered) {
  const auto& data = discovered.info;
  const Guid guid = guid_of(data.m_guid);
  const auto& octets = data.m_userData;
  const std::scoped_lock lock(mutex_);
  if (!is_there(discovered)) {
    participants_.erase(guid);
    return;
  }
  // Fast DDS lets go of its locks before it tells: what one thread tells of a participant that has announced itself
  // once more may come after what another has told of its leaving.
  const bool again = discovered.status == rtps::ParticipantDiscoveryInfo::CHANGED_QOS_PARTICIPANT;
  if (again && !participants_.contains(guid)) return;
  const std::string user_data(octets.begin(), octets.end());
  participants_[guid] = {guid, data.m_participantName.to_string(), discovery::introduction_in(user_data)};
}

discovery::DomainView DomainCensus::view() const {
  discovery::DomainView view;
  view.participants = participants();
  const std::scoped_lock lock(mutex_);
  for (const auto& [guid, endpoint] : endpoints_) view.endpoints.push_back(endpoint);
  return view;
}

void DomainCensus::on_participant_discovery(dds::DomainParticipant* participant,
                                            rtps::ParticipantDiscoveryInfo&& discovered) {
  if (!is_there(discovered)) {
    const Guid gone = guid_of(discovered.info.m_guid);
    const std::scoped_lock lock(mutex_);
    std::erase_if(endpoints_, [&](const auto& entry) { return entry.second.participant == gone; });
  }
  ParticipantCensus::on_participant_discovery(participant, std::move(discovered));
}

void DomainCensus::on_publisher_discovery(dds::DomainParticipant*, rtps::WriterDiscoveryInfo&& discovered) {
  note(discovered.info, true, discovered.status != rtps::WriterDiscoveryInfo::REMOVED_WRITER);
}

void DomainCensus::on_subscriber_discovery(dds::DomainParticipant*, rtps::ReaderDiscoveryInfo&& discovered) {
  note(discovered.info, false, discovered.status != rtps::ReaderDiscoveryInfo::REMOVED_READER);
}

template <class Data>
void DomainCensus::note(const Data& data, bool writes, bool there) {
  const std::scoped_lock lock(mutex_);
  if (!there) {
    endpoints_.erase(guid_of(data.guid()));
    return;
  }
  endpoints_[guid_of(data.guid())] = {guid_of(data.guid()),         participant_of(data.guid()), writes,
                                      data.topicName().to_string(), data.typeName().to_string(), qos_of(data.m_qos)};
}

}  // namespace lamprey::messaging::fastdds
