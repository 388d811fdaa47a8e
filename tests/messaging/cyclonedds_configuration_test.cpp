#include "messaging/cyclonedds/configuration.hpp"

#include <cstdlib>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdexcept>

namespace lamprey::messaging::cyclonedds {
namespace {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(CycloneConfiguration, UsersOwnComesLastAndSoDecides) {
  setenv("CYCLONEDDS_URI", "file:///etc/cyclone.xml", 1);
  EXPECT_THAT(configuration({}, {}),
              AllOf(HasSubstr("<CycloneDDS>"), EndsWith("</CycloneDDS>,file:///etc/cyclone.xml")));
  unsetenv("CYCLONEDDS_URI");
  EXPECT_THAT(configuration({}, {}), EndsWith("</CycloneDDS>"));
}

TEST(CycloneConfiguration, PeersReplaceMulticast) {
  JoinOptions options;
  EXPECT_THAT(configuration(options, {}), Not(HasSubstr("AllowMulticast")));
  options.peers = {"a.example", "192.0.2.1"};
  EXPECT_THAT(configuration(options, {}),
              AllOf(HasSubstr("<AllowMulticast>false"), HasSubstr("\"a.example\""), HasSubstr("\"192.0.2.1\"")));
}

TEST(CycloneConfiguration, LoopbackOnlyNamesNoOtherInterface) {
  JoinOptions options;
  options.loopback_only = true;
  EXPECT_THAT(configuration(options, {}),
              AllOf(HasSubstr("<AllowMulticast>false"), HasSubstr("<NetworkInterface address=\"127.0.0.1\""),
                    HasSubstr("<Peer address=\"127.0.0.1\"/>")));
}

TEST(CycloneConfiguration, ChosenInterfacesAreTheOnlyOnes) {
  JoinOptions options;
  EXPECT_THAT(configuration(options, {}), Not(HasSubstr("<Interfaces>")));
  options.interfaces = {"192.0.2.7", "198.51.100.7"};
  EXPECT_THAT(configuration(options, {}), AllOf(HasSubstr("<Interfaces><NetworkInterface address=\"192.0.2.7\"/>"
                                                          "<NetworkInterface address=\"198.51.100.7\"/></Interfaces>"),
                                                Not(HasSubstr("AllowMulticast"))));
}

TEST(CycloneConfiguration, OneOfManyAnnouncesItselfAndDoesNotListen) {
  JoinOptions options;
  options.domain = 3;
  options.one_of_many = true;
  EXPECT_THAT(configuration(options, {}),
              AllOf(HasSubstr("<AllowMulticast>ssm"), HasSubstr("<Peer address=\"239.255.0.1:8150\"/>"),
                    HasSubstr("<MulticastMetaOffset>2<"), HasSubstr("<ParticipantIndex>auto")));
  options.peers = {"a.example"};
  EXPECT_THAT(configuration(options, {}), AllOf(HasSubstr("<AllowMulticast>false"), Not(HasSubstr("239.255.0.1")),
                                                HasSubstr("<ParticipantIndex>auto")))
      << "and can be found by its host's address";
  options.peers.clear();
  options.loopback_only = true;
  EXPECT_THAT(configuration(options, {}), AllOf(HasSubstr("<AllowMulticast>false"), Not(HasSubstr("239.255.0.1")),
                                                HasSubstr("<ParticipantIndex>none")));
}

TEST(CycloneConfiguration, DiscoveryServersAreRefusedSinceItHasNone) {
  JoinOptions options;
  options.discovery_servers = {"a.example"};
  EXPECT_THROW(configuration(options, {}), std::runtime_error);
}

TEST(CycloneConfiguration, MessagesOnANetworkAreOneFrameEach) {
  JoinOptions options;
  EXPECT_THAT(configuration(options, {}), HasSubstr("<MaxMessageSize>1400B</MaxMessageSize>"));
  options.loopback_only = true;
  EXPECT_THAT(configuration(options, {}), Not(HasSubstr("MaxMessageSize")));
}

TEST(CycloneConfiguration, KeyHashesAreSentToAllButRos2) {
  EXPECT_THAT(configuration({}, {}), HasSubstr("<GenerateKeyhash>true"));
  EXPECT_THAT(configuration({}, {}, KeyHashes::omitted), Not(HasSubstr("GenerateKeyhash")));
}

TEST(CycloneConfiguration, PeerThatIsNoHostIsRefused) {
  JoinOptions options;
  options.peers = {"\"/><Tracing>"};
  EXPECT_THROW(configuration(options, {}), std::runtime_error);
}

}  // namespace
}  // namespace lamprey::messaging::cyclonedds
