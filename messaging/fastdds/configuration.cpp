#include "messaging/fastdds/configuration.hpp"

#include "messaging/discovery/server_address.hpp"
#include "messaging/fastdds/transport.hpp"
#include "messaging/fastdds/udp_port.hpp"
#include "messaging/tuning.hpp"

#include <cstdint>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/rtps/attributes/ServerAttributes.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>
#include <fastrtps/xmlparser/XMLProfileManager.h>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace lamprey::messaging::fastdds {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;
using eprosima::fastdds::rtps::UDPv4TransportDescriptor;
using eprosima::fastrtps::Duration_t;

const std::string loopback = "127.0.0.1";
const std::string every_address = "0.0.0.0";

std::string resolve(const std::string& host) {
  if (rtps::IPLocator::isIPv4(host)) return host;
  const auto addresses = rtps::IPLocator::resolveNameDNS(host).first;
  if (addresses.empty()) throw std::runtime_error("host '" + host + "' has no IPv4 address");
  return *addresses.begin();
}

/// What the program is limited to; empty: nothing. Loopback is always there: a program of this machine that is not
/// limited sends to no other address of it.
std::vector<std::string> allowed_addresses(const JoinOptions& options) {
  if (options.loopback_only) return {loopback};
  auto addresses = options.interfaces;
  if (!addresses.empty()) addresses.push_back(loopback);
  return addresses;
}

/// UDP only: the default shared-memory transport drops samples when its port queue overflows.
void set_transport(const JoinOptions& options, dds::DomainParticipantQos& qos) {
  auto& transport = qos.transport();
  const bool users_own = !transport.use_builtin_transports || !transport.user_transports.empty();
  const auto allowed = allowed_addresses(options);
  if (users_own && allowed.empty()) return;
  auto udp = std::make_shared<UDPv4TransportDescriptor>();
  udp->receiveBufferSize = socket_receive_buffer_bytes;
  // The system gives what it allows. Fast DDS 2.9 adds a heartbeat to all readers whenever a writer has sent as much
  // again, but of what it sends once more it counts, with each sample, all that the program has ever sent so: from some
  // 200 kB on every program that joins would cost a heartbeat to all others for each endpoint that it is told of.
  udp->sendBufferSize = std::numeric_limits<std::int32_t>::max();
  udp->maxInitialPeersRange = participants_per_host;
  udp->interfaceWhiteList = allowed;
  // One frame of a network each (tuning.hpp). On loopback nothing is lost on the way, and large datagrams cost less.
  if (!options.loopback_only) udp->maxMessageSize = maximum_message_bytes;
  transport.use_builtin_transports = false;
  transport.user_transports = {announcing(std::move(udp))};
}

rtps::LocatorList_t list_of(const rtps::Locator_t& only) {
  rtps::LocatorList_t list;
  list.push_back(only);
  return list;
}

/// Nobody is looked for but the servers, which tell of everybody else.
void ask_servers(const JoinOptions& options, rtps::BuiltinAttributes& builtin) {
  builtin.discovery_config.discoveryProtocol = rtps::DiscoveryProtocol::CLIENT;
  for (const auto& address : discovery::server_addresses(options.discovery_servers, options.domain)) {
    eprosima::fastdds::rtps::RemoteServerAttributes server;
    eprosima::fastdds::rtps::get_server_client_default_guidPrefix(address.identity(), server.guidPrefix);
    server.metatrafficUnicastLocatorList.push_back(locator(resolve(address.host), address.port));
    builtin.discovery_config.m_DiscoveryServers.push_back(server);
  }
}

void set_discovery(const JoinOptions& options, dds::DomainParticipantQos& qos) {
  auto& builtin = qos.wire_protocol().builtin;
  auto& discovery = builtin.discovery_config;
  discovery.leaseDuration = Duration_t(static_cast<std::int32_t>(participant_lease.count()), 0);
  discovery.leaseDuration_announcementperiod = Duration_t(static_cast<std::int32_t>(announcement_period.count()), 0);
  // The first announcements decide how soon programs that start together meet.
  discovery.initial_announcements.count = 10;
  discovery.initial_announcements.period = Duration_t(0, 100'000'000);
  builtin.readerHistoryMemoryPolicy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  builtin.writerHistoryMemoryPolicy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;

  if (!options.discovery_servers.empty()) ask_servers(options, builtin);
  for (const auto& peer : options.peers) builtin.initialPeersList.push_back(locator(resolve(peer)));
  if (options.loopback_only) builtin.initialPeersList.push_back(locator(loopback));
  if (!options.loopback_only && options.peers.empty() && options.discovery_servers.empty()) {
    if (!options.one_of_many) return;
    builtin.initialPeersList.push_back(locator(std::string(announcement_group), announcement_port(options.domain)));
  }
  // A unicast list without a multicast one is what keeps it from listening to multicast.
  builtin.metatrafficMulticastLocatorList.clear();
  builtin.metatrafficUnicastLocatorList =
      list_of(options.loopback_only ? locator(loopback, options.one_of_many ? any_free_port() : std::uint16_t{0})
                                    : locator(every_address));
  if (options.loopback_only) qos.wire_protocol().default_unicast_locator_list = list_of(locator(loopback));
}

/// Two participants in one process would else call each other's listeners from their own writes.
void use_network_within_process() {
  auto settings = eprosima::fastrtps::xmlparser::XMLProfileManager::library_settings();
  settings.intraprocess_delivery = eprosima::fastrtps::INTRAPROCESS_OFF;
  eprosima::fastrtps::xmlparser::XMLProfileManager::library_settings(settings);
}

}  // namespace

rtps::Locator_t locator(const std::string& address, std::uint16_t port) {
  rtps::Locator_t result;
  result.kind = LOCATOR_KIND_UDPv4;
  result.port = port;
  rtps::IPLocator::setIPv4(result, address);
  return result;
}

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
