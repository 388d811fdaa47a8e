#pragma once

#include "messaging/discovery/domain_view.hpp"

#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/rtps/participant/ParticipantDiscoveryInfo.h>
#include <fastdds/rtps/reader/ReaderDiscoveryInfo.h>
#include <fastdds/rtps/writer/WriterDiscoveryInfo.h>
#include <map>
#include <mutex>
#include <vector>

/// What Fast DDS tells of a domain, without the participant that listens. Called by Fast DDS's threads, asked by any.
namespace lamprey::messaging::fastdds {

discovery::Guid guid_of(const eprosima::fastrtps::rtps::GUID_t& guid);

/// Of participants only: what every program listens to.
class ParticipantCensus : public eprosima::fastdds::dds::DomainParticipantListener {
 public:
  std::vector<discovery::Participant> participants() const;

  void on_participant_discovery(eprosima::fastdds::dds::DomainParticipant* participant,
                                eprosima::fastrtps::rtps::ParticipantDiscoveryInfo&& discovered) override;

 private:
  mutable std::mutex mutex_;
  std::map<discovery::Guid, discovery::Participant> participants_;
};

/// Of writers and readers, too.
class DomainCensus final : public ParticipantCensus {
 public:
  discovery::DomainView view() const;

  void on_participant_discovery(eprosima::fastdds::dds::DomainParticipant* participant,
                                eprosima::fastrtps::rtps::ParticipantDiscoveryInfo&& discovered) override;
  void on_publisher_discovery(eprosima::fastdds::dds::DomainParticipant* participant,
                              eprosima::fastrtps::rtps::WriterDiscoveryInfo&& discovered) override;
  void on_subscriber_discovery(eprosima::fastdds::dds::DomainParticipant* participant,
                               eprosima::fastrtps::rtps::ReaderDiscoveryInfo&& discovered) override;

 private:
  template <class Data>
  void note(const Data& data, bool writes, bool there);

  mutable std::mutex mutex_;
  std::map<discovery::Guid, discovery::Endpoint> endpoints_;
};

}  // namespace lamprey::messaging::fastdds
