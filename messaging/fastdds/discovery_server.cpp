#include "messaging/fastdds/discovery_server.hpp"

#include "messaging/discovery/server_address.hpp"
#include "messaging/fastdds/configuration.hpp"
#include "messaging/fastdds/entity.hpp"
#include "messaging/fastdds/udp_port.hpp"

#include <fastdds/rtps/attributes/ServerAttributes.h>

namespace lamprey::messaging::fastdds {
namespace {

namespace rtps = eprosima::fastrtps::rtps;
using eprosima::fastrtps::Duration_t;

dds::DomainParticipantQos server_qos(const JoinOptions& options, std::uint16_t port) {
  require_free(port);
  auto qos = participant_qos(options);
  const std::uint8_t identity = discovery::ServerAddress{{}, port}.identity();
  eprosima::fastdds::rtps::get_server_client_default_guidPrefix(identity, qos.wire_protocol().prefix);
  auto& builtin = qos.wire_protocol().builtin;
  builtin.metatrafficMulticastLocatorList.clear();
  builtin.metatrafficUnicastLocatorList.clear();
  builtin.metatrafficUnicastLocatorList.push_back(locator("0.0.0.0", port));
  builtin.initialPeersList.clear();
  builtin.discovery_config.discoveryProtocol = rtps::DiscoveryProtocol::SERVER;
  builtin.discovery_config.leaseDuration = Duration_t(static_cast<std::int32_t>(discovery::server_lease.count()), 0);
  builtin.discovery_config.leaseDuration_announcementperiod = Duration_t(1, 0);
  return qos;
}

class FastServer final : public discovery::Server {
 public:
  FastServer(const JoinOptions& options, std::uint16_t port)
      : participant_(own(dds::DomainParticipantFactory::get_instance()->create_participant(options.domain,
                                                                                           server_qos(options, port)),
                         "a discovery server")) {}

 private:
  Owned<dds::DomainParticipant> participant_;
};

}  // namespace

std::unique_ptr<discovery::Server> make_discovery_server(const JoinOptions& options, std::uint16_t port) {
  return std::make_unique<FastServer>(options, port);
}

}  // namespace lamprey::messaging::fastdds
