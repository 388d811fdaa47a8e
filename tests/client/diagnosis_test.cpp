#include "client/diagnosis/domain.hpp"
#include "client/diagnosis/host.hpp"
#include "messaging/qos.hpp"
#include "tests/client/site.hpp"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <string>
#include <string_view>

namespace lamprey::client::diagnosis {
namespace {

using Level = Check::Level;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const NetworkInterface loopback{"lo", "127.0.0.1", true, false};
const NetworkInterface wire{"eth0", "192.0.2.7", false, true};
const NetworkInterface tunnel{"tun0", "10.0.0.1", false, false};

std::string works(const NetworkInterface&) {
  return "";
}
std::string fails(const NetworkInterface&) {
  return "a datagram did not come back";
}

TEST(Interfaces, AreToldAsTheyAreUsed) {
  EXPECT_EQ(check_interfaces({loopback, wire}, {}), (Check{Level::good, "interfaces", "eth0 (192.0.2.7)", ""}));
  messaging::JoinOptions join;
  join.loopback_only = true;
  EXPECT_EQ(check_interfaces({loopback, wire}, join).finding, "only loopback, with --loopback-only");
  EXPECT_EQ(check_interfaces({loopback}, {}).level, Level::notable);
}

TEST(Interfaces, OfWhichCycloneTakesOneShouldBeChosen) {
  messaging::JoinOptions join;
  EXPECT_EQ(check_interfaces({wire, tunnel}, join).level, Level::notable);
  EXPECT_THAT(check_interfaces({wire, tunnel}, join).advice, HasSubstr("--interface NAME"));
  join.vendor = "fastdds";
  EXPECT_EQ(check_interfaces({wire, tunnel}, join).level, Level::good) << "which takes all";
  join.vendor = "cyclonedds";
  join.interfaces = {"eth0"};
  EXPECT_EQ(check_interfaces({wire, tunnel}, join), (Check{Level::good, "interfaces", "chosen: eth0 (192.0.2.7)", ""}));
}

TEST(Multicast, WorksWhereOneInterfaceHasIt) {
  const auto checks = check_multicast({loopback, wire, tunnel}, {}, works);
  ASSERT_EQ(checks.size(), 2U);
  EXPECT_EQ(checks[0].level, Level::good);
  EXPECT_EQ(checks[0].finding, "eth0 (192.0.2.7) works");
  EXPECT_EQ(checks[1].level, Level::notable);
  EXPECT_EQ(checks[1].finding, "tun0 (10.0.0.1): the interface has none");
}

TEST(Multicast, IsMissedOnlyWhereNoPeerIsNamed) {
  EXPECT_EQ(check_multicast({loopback, wire}, {}, fails).back().level, Level::trouble);
  EXPECT_THAT(check_multicast({loopback, wire}, {}, fails).back().advice, HasSubstr("--peer HOST"));
  messaging::JoinOptions with_peer;
  with_peer.peers = {"coordinator.lab"};
  EXPECT_EQ(check_multicast({loopback, wire}, with_peer, fails).back().level, Level::notable);
  messaging::JoinOptions alone;
  alone.loopback_only = true;
  EXPECT_EQ(check_multicast({loopback, wire}, alone, fails).back().level, Level::good);
}

TEST(Multicast, IsTriedOnTheChosenInterfacesOnly) {
  messaging::JoinOptions join;
  join.interfaces = {"tun0"};
  const auto checks = check_multicast({loopback, wire, tunnel}, join, works);
  ASSERT_EQ(checks.size(), 2U);
  EXPECT_EQ(checks[0].finding, "tun0 (10.0.0.1): the interface has none");
  EXPECT_EQ(checks[1].level, Level::trouble);
}

TEST(Multicast, IsNotNeededWithADiscoveryServer) {
  messaging::JoinOptions join;
  join.discovery_servers = {"a.example"};
  const auto checks = check_multicast({loopback, wire}, join, fails);
  ASSERT_EQ(checks.size(), 1U);
  EXPECT_EQ(checks[0].level, Level::good);
}

TEST(Multicast, IsTriedOnTheLoopbackInterfaceOfThisMachine) {
  // Every Linux machine sends itself what it sends to a group, also where nothing else gets it.
  for (const auto& interface : messaging::network_interfaces()) {
    if (!interface.multicast) continue;
    EXPECT_EQ(multicast_fault(interface), "") << interface.name;
  }
  EXPECT_NE(multicast_fault({"none", "192.0.2.213", false, true}), "") << "no interface of this machine";
}

TEST(Ports, AreReadFromWhatTheKernelTells) {
  EXPECT_THAT(bound_ports("  sl  local_address rem_address   st\n"
                          " 2364: 0100007F:1CF2 00000000:0000 07 00000000:00000000\n"
                          "12382: 020200C0:D3C3 00000000:0000 07 00000000:00000000\n"
                          "nonsense\n 1: 00:zz\n"),
              ElementsAre(0x1CF2, 0xD3C3));
}

TEST(Ports, CountTheDomainsPlaces) {
  const auto few = check_ports({7410, 7412, 7413, 7660}, 0);
  EXPECT_EQ(few.level, Level::good);
  EXPECT_EQ(few.finding, "2 of 120 places of domain 0 on this host are taken (UDP ports 7410 to 7649)");
  EXPECT_THAT(check_ports({7410, 7412, 7660}, 1).finding, HasSubstr("1 of 120 places of domain 1"));
  std::set<std::uint16_t> all;
  for (int port = 7410; port < 7650; ++port) all.insert(static_cast<std::uint16_t>(port));
  EXPECT_EQ(check_ports(all, 0).level, Level::trouble);
}

TEST(ReceiveBuffers, AreCalledSmallWithTheCommandThatMendsIt) {
  EXPECT_EQ(check_receive_buffers(8 << 20).level, Level::good);
  EXPECT_EQ(check_receive_buffers(212992).level, Level::notable);
  EXPECT_THAT(check_receive_buffers(212992).advice, HasSubstr("sysctl -w net.core.rmem_max=4194304"));
}

TEST(SharedMemory, MattersToAUsersOwnProfileOnly) {
  EXPECT_EQ(check_shared_memory(0, 9, false).level, Level::good);
  EXPECT_EQ(check_shared_memory(0, 9, true).level, Level::trouble);
  EXPECT_EQ(check_shared_memory(1 << 30, 9, true).level, Level::good);
}

TEST(Environment, IsToldWhereItSurprises) {
  std::map<std::string, std::string> variables;
  const auto value_of = [&](const char* name) { return variables[name]; };
  EXPECT_THAT(check_environment(value_of, {}), IsEmpty());
  variables = {{"LAMPREY_DOMAIN", "3"}, {"ROS_DOMAIN_ID", "7"}, {"CYCLONEDDS_URI", "file:///etc/dds.xml"}};
  const auto checks = check_environment(value_of, {});
  ASSERT_EQ(checks.size(), 2U);
  EXPECT_EQ(checks[0].finding, "LAMPREY_DOMAIN is 3, ROS_DOMAIN_ID 7");
  EXPECT_EQ(checks[1].finding, "CYCLONEDDS_URI is set, and heeded: file:///etc/dds.xml");
}

TEST(Environment, TellsWhichConfigurationIsHeeded) {
  messaging::JoinOptions join;
  join.configuration_file = "/etc/lamprey/lamprey.yaml";
  const auto checks = check_environment([](const char*) { return std::string(); }, join);
  ASSERT_EQ(checks.size(), 1U);
  EXPECT_EQ(checks[0].finding, "/etc/lamprey/lamprey.yaml is heeded");
}

messaging::discovery::Participant program(const std::string& role, std::uint32_t process,
                                          const std::string& isolation = "lamprey", const std::string& build = "1",
                                          std::uint32_t wire_version = messaging::wire_version) {
  return {.guid = {1, 0x10, static_cast<std::uint8_t>(process)},
          .name = {},
          .introduction = messaging::discovery::Introduction{.role = role,
                                                             .host = "alpha",
                                                             .process = process,
                                                             .build = build,
                                                             .isolation = isolation,
                                                             .wire = wire_version}};
}

TEST(Company, HasOneCoordinator) {
  const auto good = check_company({{program("coordinator", 1), program("worker", 2)}, {}}, {});
  EXPECT_EQ(good[0], (Check{Level::good, "coordinator", "coordinator alpha/1", ""}));
  EXPECT_EQ(good[1].finding, "2 programs of Lamprey's are in isolation lamprey");
  const auto two = check_company({{program("coordinator", 1), program("coordinator", 2)}, {}}, {});
  EXPECT_EQ(two[0].level, Level::trouble);
  EXPECT_EQ(two[0].finding, "there are 2 in isolation lamprey: coordinator alpha/1, coordinator alpha/2");
}

TEST(Company, InAnotherIsolationMayBeTheOneThatIsMeant) {
  const auto checks = check_company({{program("coordinator", 1, "lab"), program("worker", 2)}, {}}, {});
  EXPECT_EQ(checks[0].level, Level::trouble);
  EXPECT_EQ(checks[0].finding, "none in domain 0, isolation lamprey");
  EXPECT_EQ(checks[2].finding, "1 program is in isolation lab, which never meet those in lamprey");
  EXPECT_EQ(checks[2].advice, "If that is where you want to be: --isolation lab.");
}

TEST(Company, OfADiscoveryServerIsNobodys) {
  messaging::JoinOptions join;
  join.discovery_servers = {"a.example"};
  const auto checks = check_company({{program("discovery-server", 1, "")}, {}}, join);
  ASSERT_EQ(checks.size(), 2U);
  EXPECT_THAT(checks[0].advice, HasSubstr("name the discovery server"));
  EXPECT_EQ(checks[1].finding, "0 programs of Lamprey's are in isolation lamprey");
}

TEST(Servers, AreThereOrTroubleEachByItself) {
  messaging::JoinOptions join;
  EXPECT_THAT(check_servers({}, join), IsEmpty());
  join.discovery_servers = {"a.example", "b.example:11813"};
  messaging::discovery::Participant server;
  const std::string_view guid("DS\0_EPROSIMA", 12);
  std::ranges::copy(guid, server.guid.begin());
  const auto checks = check_servers({{server}, {}}, join);
  ASSERT_EQ(checks.size(), 2U);
  EXPECT_EQ(checks[0], (Check{Level::good, "discovery server", "a.example:11811 is there", ""}));
  EXPECT_EQ(checks[1].level, Level::trouble);
  EXPECT_EQ(checks[1].finding, "b.example:11813 doesn't answer");
  join.loopback_only = true;
  EXPECT_THAT(check_servers({}, join), IsEmpty()) << "they are not asked";
}

TEST(Versions, ThatNeverMeetAreTrouble) {
  EXPECT_EQ(check_versions({{program("worker", 1)}, {}}, "1").front().level, Level::good);
  const auto mixed =
      check_versions({{program("worker", 1, "lamprey", "2"), program("worker", 2, "lamprey", "1", 3)}, {}}, "1");
  ASSERT_EQ(mixed.size(), 2U);
  EXPECT_EQ(mixed[0].level, Level::trouble);
  EXPECT_THAT(mixed[0].finding, HasSubstr("worker alpha/2 (3)"));
  EXPECT_EQ(mixed[1].level, Level::notable);
  EXPECT_EQ(mixed[1].finding, "not 1 but 2: worker alpha/1");
}

TEST(Clocks, ThatDifferAreTold) {
  EXPECT_EQ(check_clock(0.2, 0.001).level, Level::good);
  EXPECT_EQ(check_clock(1.5, 1).level, Level::good) << "that is not known";
  EXPECT_EQ(check_clock(-90, 0.001).level, Level::notable);
  EXPECT_EQ(check_clock(-90, 0.001).finding, "the coordinator's is 1 min 30 s behind this host's (± 1 ms)");
}

TEST(Doctor, EndsWithFiveWhereThereIsTrouble) {
  tests::Site site;
  const auto run = site.run({"doctor", "--seconds", "0.1", "--loopback-only"});
  EXPECT_EQ(run.exit_code, exit_mismatch);
  EXPECT_THAT(
      run.out,
      HasSubstr("trouble  coordinator: none in domain 0, isolation lamprey\n           Is lamprey-coordinator"));
  const auto json = site.run({"doctor", "--seconds", "0.1", "--loopback-only", "--format", "json"}).json();
  EXPECT_EQ(json["schema"], "lamprey/doctor/1");
  EXPECT_THAT(json["checks"].dump(), HasSubstr("\"subject\":\"multicast\",\"level\":\"ok\""));
}

}  // namespace
}  // namespace lamprey::client::diagnosis
