#include "messaging/fastdds/configuration.hpp"

#include "messaging/fastdds/transport.hpp"
#include "messaging/tuning.hpp"

#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>
#include <fastrtps/xmlparser/XMLProfileManager.h>
#include <memory>
#include <stdexcept>
#include <string>

namespace lamprey::messaging::fastdds {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;
using eprosima::fastdds::rtps::UDPv4TransportDescriptor;
using eprosima::fastrtps::Duration_t;

const std::string loopback = "127.0.0.1";

/// Port 0 stands for the well-known ports of all participants of a host.
rtps::Locator_t locator(const std::string& address) {
  rtps::Locator_t result;
  result.kind = LOCATOR_KIND_UDPv4;
  result.port = 0;
  rtps::IPLocator::setIPv4(result, address);
  return result;
}

std::string resolve(const std::string& peer) {
  if (rtps::IPLocator::isIPv4(peer)) return peer;
  const auto addresses = rtps::IPLocator::resolveNameDNS(peer).first;
  if (addresses.empty()) throw std::runtime_error("peer '" + peer + "' has no IPv4 address");
  return *addresses.begin();
}

/// UDP only: the default shared-memory transport drops samples when its port queue overflows.
void set_transport(const JoinOptions& options, dds::DomainParticipantQos& qos) {
  auto& transport = qos.transport();
  const bool users_own = !transport.use_builtin_transports || !transport.user_transports.empty();
  if (users_own && !options.loopback_only) return;
  auto udp = std::make_shared<UDPv4TransportDescriptor>();
  udp->receiveBufferSize = socket_receive_buffer_bytes;
  udp->maxInitialPeersRange = participants_per_host;
  if (options.loopback_only) {
    udp->interfaceWhiteList = {loopback};
  } else {
    // One frame of a network each (tuning.hpp). On loopback nothing is lost on the way, and large datagrams cost less.
    udp->maxMessageSize = maximum_message_bytes;
  }
  transport.use_builtin_transports = false;
  transport.user_transports = {announcing(std::move(udp))};
}

void set_discovery(const JoinOptions& options, dds::DomainParticipantQos& qos) {
  auto& builtin = qos.wire_protocol().builtin;
  auto& discovery = builtin.discovery_config;
  discovery.leaseDuration = Duration_t(static_cast<std::int32_t>(participant_lease.count()), 0);
  discovery.leaseDuration_announcementperiod = Duration_t(3, 0);
  // The first announcements decide how soon programs that start together meet.
  discovery.initial_announcements.count = 10;
  discovery.initial_announcements.period = Duration_t(0, 100'000'000);
  builtin.readerHistoryMemoryPolicy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  builtin.writerHistoryMemoryPolicy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;

  for (const auto& peer : options.peers) builtin.initialPeersList.push_back(locator(resolve(peer)));
  if (options.loopback_only) builtin.initialPeersList.push_back(locator(loopback));
  if (!options.loopback_only && options.peers.empty()) return;
  // A unicast list without a multicast one is what turns multicast off.
  builtin.metatrafficMulticastLocatorList.clear();
  builtin.metatrafficUnicastLocatorList.clear();
  builtin.metatrafficUnicastLocatorList.push_back(locator(options.loopback_only ? loopback : "0.0.0.0"));
  if (options.loopback_only) {
    qos.wire_protocol().default_unicast_locator_list.clear();
    qos.wire_protocol().default_unicast_locator_list.push_back(locator(loopback));
  }
}

/// Two participants in one process would else call each other's listeners from their own writes.
void use_network_within_process() {
  auto settings = eprosima::fastrtps::xmlparser::XMLProfileManager::library_settings();
  settings.intraprocess_delivery = eprosima::fastrtps::INTRAPROCESS_OFF;
  eprosima::fastrtps::xmlparser::XMLProfileManager::library_settings(settings);
}

}  // namespace

dds::DomainParticipantQos participant_qos(const JoinOptions& options) {
  auto* const factory = dds::DomainParticipantFactory::get_instance();
  factory->load_profiles();
  use_network_within_process();
  dds::DomainParticipantQos qos = factory->get_default_participant_qos();
  set_transport(options, qos);
  set_discovery(options, qos);
  const std::string introduction = user_data_of(options);
  qos.user_data().data_vec({introduction.begin(), introduction.end()});
  return qos;
}

}  // namespace lamprey::messaging::fastdds
