#include "messaging/fastdds/discovery_watch.hpp"

#include "messaging/fastdds/configuration.hpp"
#include "messaging/fastdds/entity.hpp"

#include <algorithm>
#include <cstdint>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/rtps/participant/ParticipantDiscoveryInfo.h>
#include <fastdds/rtps/reader/ReaderDiscoveryInfo.h>
#include <fastdds/rtps/writer/WriterDiscoveryInfo.h>
#include <map>
#include <mutex>
#include <string>
#include <utility>

namespace lamprey::messaging::fastdds {
namespace {

namespace rtps = eprosima::fastrtps::rtps;
using discovery::Endpoint;
using discovery::EndpointQos;
using discovery::Guid;

Guid guid_of(const rtps::GUID_t& from) {
  Guid guid{};
  std::copy_n(from.guidPrefix.value, rtps::GuidPrefix_t::size, guid.begin());
  std::copy_n(from.entityId.value, rtps::EntityId_t::size, guid.begin() + rtps::GuidPrefix_t::size);
  return guid;
}

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

/// Called by Fast DDS's threads.
class Census final : public dds::DomainParticipantListener {
 public:
  discovery::DomainView view() {
    const std::scoped_lock lock(mutex_);
    discovery::DomainView view;
    for (const auto& [guid, participant] : participants_) view.participants.push_back(participant);
    for (const auto& [guid, endpoint] : endpoints_) view.endpoints.push_back(endpoint);
    return view;
  }

  void on_participant_discovery(dds::DomainParticipant*, rtps::ParticipantDiscoveryInfo&& discovered) override {
    const auto& data = discovered.info;
    const Guid guid = guid_of(data.m_guid);
    const auto& octets = data.m_userData;
    const bool changed = discovered.status == rtps::ParticipantDiscoveryInfo::CHANGED_QOS_PARTICIPANT;
    const bool there = changed || discovered.status == rtps::ParticipantDiscoveryInfo::DISCOVERED_PARTICIPANT;
    const std::scoped_lock lock(mutex_);
    // Fast DDS lets go of its locks before it tells: what one thread tells of a participant that has announced itself
    // once more may come after what another has told of its leaving.
    if (changed && !participants_.contains(guid)) return;
    if (!there) {
      participants_.erase(guid);
      std::erase_if(endpoints_, [&](const auto& entry) { return entry.second.participant == guid; });
      return;
    }
    const std::string user_data(octets.begin(), octets.end());
    participants_[guid] = {guid, data.m_participantName.to_string(), discovery::introduction_in(user_data)};
  }

  void on_publisher_discovery(dds::DomainParticipant*, rtps::WriterDiscoveryInfo&& discovered) override {
    note(discovered.info, true, discovered.status != rtps::WriterDiscoveryInfo::REMOVED_WRITER);
  }
  void on_subscriber_discovery(dds::DomainParticipant*, rtps::ReaderDiscoveryInfo&& discovered) override {
    note(discovered.info, false, discovered.status != rtps::ReaderDiscoveryInfo::REMOVED_READER);
  }

 private:
  template <class Data>
  void note(const Data& data, bool writes, bool there) {
    const std::scoped_lock lock(mutex_);
    if (!there) {
      endpoints_.erase(guid_of(data.guid()));
      return;
    }
    endpoints_[guid_of(data.guid())] = {guid_of(data.guid()),         participant_of(data.guid()), writes,
                                        data.topicName().to_string(), data.typeName().to_string(), qos_of(data.m_qos)};
  }

  std::mutex mutex_;
  std::map<Guid, discovery::Participant> participants_;
  std::map<Guid, Endpoint> endpoints_;
};

class FastWatch final : public discovery::Watch {
 public:
  explicit FastWatch(const JoinOptions& options)
      : participant_(own(dds::DomainParticipantFactory::get_instance()->create_participant(
                             options.domain, participant_qos(options), &census_, dds::StatusMask::none()),
                         "a participant that watches the domain")) {}

  discovery::DomainView look() override { return census_.view(); }

 private:
  Census census_;
  Owned<dds::DomainParticipant> participant_;  // destroyed first: afterwards nobody calls the census
};

}  // namespace

std::unique_ptr<discovery::Watch> make_discovery_watch(const JoinOptions& options) {
  return std::make_unique<FastWatch>(options);
}

}  // namespace lamprey::messaging::fastdds
