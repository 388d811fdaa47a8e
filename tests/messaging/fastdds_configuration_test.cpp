#include "messaging/fastdds/configuration.hpp"

#include <fastdds/rtps/transport/ChainingTransportDescriptor.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace lamprey::messaging::fastdds {
namespace {

namespace rtps = eprosima::fastrtps::rtps;
using eprosima::fastdds::rtps::ChainingTransportDescriptor;
using eprosima::fastdds::rtps::UDPv4TransportDescriptor;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// The addresses that the only transport is limited to; empty: to none.
std::vector<std::string> allowed(const JoinOptions& options) {
  const auto qos = participant_qos(options);
  EXPECT_FALSE(qos.transport().use_builtin_transports);
  EXPECT_EQ(qos.transport().user_transports.size(), 1U);
  const auto chain = std::dynamic_pointer_cast<ChainingTransportDescriptor>(qos.transport().user_transports.front());
  const auto udp = std::dynamic_pointer_cast<UDPv4TransportDescriptor>(chain->low_level_descriptor);
  return udp->interfaceWhiteList;
}

TEST(FastConfiguration, ChosenInterfacesAndLoopbackAreTheOnlyOnes) {
  JoinOptions options;
  EXPECT_THAT(allowed(options), IsEmpty());
  options.interfaces = {"192.0.2.7", "198.51.100.7"};
  EXPECT_THAT(allowed(options), ElementsAre("192.0.2.7", "198.51.100.7", "127.0.0.1"));
  options.interfaces.clear();
  options.loopback_only = true;
  EXPECT_THAT(allowed(options), ElementsAre("127.0.0.1"));
}

TEST(FastConfiguration, DiscoveryServersReplaceEverythingElse) {
  JoinOptions options;
  options.domain = 3;
  options.discovery_servers = {"192.0.2.7", "192.0.2.8:11812"};
  const auto builtin = participant_qos(options).wire_protocol().builtin;
  const auto& discovery = builtin.discovery_config;
  EXPECT_EQ(discovery.discoveryProtocol, rtps::DiscoveryProtocol::CLIENT);
  EXPECT_TRUE(builtin.metatrafficMulticastLocatorList.empty());
  EXPECT_FALSE(builtin.metatrafficUnicastLocatorList.empty()) << "which is what turns multicast off";
  ASSERT_EQ(discovery.m_DiscoveryServers.size(), 2U);
  const auto& first = discovery.m_DiscoveryServers.front();
  EXPECT_EQ(rtps::IPLocator::getPhysicalPort(*first.metatrafficUnicastLocatorList.begin()), 11814);
  EXPECT_EQ(rtps::IPLocator::ip_to_string(*first.metatrafficUnicastLocatorList.begin()), "192.0.2.7");
  EXPECT_EQ(first.guidPrefix.value[2], 3) << "the identity is the port's place";
  EXPECT_EQ(discovery.m_DiscoveryServers.back().guidPrefix.value[2], 1);
}

TEST(FastConfiguration, OneOfManyAnnouncesItselfAndDoesNotListen) {
  JoinOptions options;
  options.domain = 3;
  options.one_of_many = true;
  auto builtin = participant_qos(options).wire_protocol().builtin;
  EXPECT_TRUE(builtin.metatrafficMulticastLocatorList.empty());
  ASSERT_FALSE(builtin.metatrafficUnicastLocatorList.empty());
  EXPECT_EQ(builtin.metatrafficUnicastLocatorList.begin()->port, 0U)
      << "a well-known port: found by its host's address";
  ASSERT_EQ(builtin.initialPeersList.size(), 1U);
  EXPECT_EQ(rtps::IPLocator::ip_to_string(*builtin.initialPeersList.begin()), "239.255.0.1");
  EXPECT_EQ(builtin.initialPeersList.begin()->port, 8150U);

  options.loopback_only = true;
  builtin = participant_qos(options).wire_protocol().builtin;
  ASSERT_FALSE(builtin.metatrafficUnicastLocatorList.empty());
  EXPECT_NE(builtin.metatrafficUnicastLocatorList.begin()->port, 0U) << "no well-known port: all announce to these";
}

TEST(FastConfiguration, WithoutServersEverybodyFindsEverybody) {
  const auto qos = participant_qos({});
  EXPECT_EQ(qos.wire_protocol().builtin.discovery_config.discoveryProtocol, rtps::DiscoveryProtocol::SIMPLE);
}

TEST(FastConfiguration, HostWithoutAnAddressIsRefused) {
  JoinOptions options;
  options.discovery_servers = {"no-such-host.invalid"};
  EXPECT_THROW(participant_qos(options), std::runtime_error);
}

}  // namespace
}  // namespace lamprey::messaging::fastdds
