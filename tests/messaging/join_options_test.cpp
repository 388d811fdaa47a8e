#include "messaging/program/join_options.hpp"

#include "messaging/network_interfaces.hpp"
#include "tests/messaging/scratch_folder.hpp"

#include <algorithm>
#include <cstdlib>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>
#include <sstream>
#include <string>
#include <vector>

namespace lamprey::messaging::program {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class JoinCommandLine : public ::testing::Test {
 protected:
  void SetUp() override { clear(); }
  void TearDown() override { clear(); }

  static void clear() {
    for (const char* name : {"LAMPREY_DDS", "LAMPREY_DOMAIN", "ROS_DOMAIN_ID", "LAMPREY_ISOLATION", "LAMPREY_PEERS",
                             "LAMPREY_INTERFACES", "LAMPREY_DISCOVERY_SERVERS", "LAMPREY_CONFIG"}) {
      unsetenv(name);
    }
  }

  /// Where a configuration file usually is there is none, or this one.
  std::string write_usual(const std::string& text) { return folder.write("lamprey/lamprey.yaml", text); }

  /// What went wrong, or nothing.
  std::string parse(std::vector<std::string> arguments) {
    options = {};
    CLI::App app("test", "test");
    app.add_option("sweep", positional);
    add_join_options(app, options);
    std::reverse(arguments.begin(), arguments.end());
    try {
      app.parse(arguments);
      return {};
    } catch (const CLI::ParseError& error) {
      return error.what();
    }
  }

  tests::ScratchFolder folder;
  tests::Variable no_users_own{"XDG_CONFIG_HOME", folder.path("")};
  JoinOptions options;
  std::string positional;
};

TEST_F(JoinCommandLine, WithoutAnyOptionTheDefaultsStay) {
  EXPECT_EQ(parse({}), "");
  EXPECT_EQ(options.vendor, "cyclonedds");
  EXPECT_EQ(options.domain, 0u);
  EXPECT_EQ(options.isolation, "lamprey");
  EXPECT_THAT(options.peers, ::testing::IsEmpty());
  EXPECT_FALSE(options.loopback_only);
}

TEST_F(JoinCommandLine, EveryOptionIsTaken) {
  EXPECT_EQ(parse({"--dds", "fastdds", "--domain", "230", "--isolation", "lab", "--peer", "a.example", "--peer",
                   "192.0.2.1", "file.yaml"}),
            "");
  EXPECT_EQ(options.vendor, "fastdds");
  EXPECT_EQ(options.domain, 230u);
  EXPECT_EQ(options.isolation, "lab");
  EXPECT_THAT(options.peers, ElementsAre("a.example", "192.0.2.1"));
  EXPECT_EQ(positional, "file.yaml") << "a peer takes one argument only";
  EXPECT_EQ(parse({"--loopback-only"}), "");
  EXPECT_TRUE(options.loopback_only);
}

TEST_F(JoinCommandLine, EnvironmentFillsWhatTheCommandLineLeavesOpen) {
  setenv("LAMPREY_DDS", "fastdds", 1);
  setenv("LAMPREY_DOMAIN", "7", 1);
  setenv("ROS_DOMAIN_ID", "8", 1);
  setenv("LAMPREY_ISOLATION", "lab", 1);
  EXPECT_EQ(parse({"--isolation", "mine"}), "");
  EXPECT_EQ(options.vendor, "fastdds");
  EXPECT_EQ(options.domain, 7u);
  EXPECT_EQ(options.isolation, "mine");
}

TEST_F(JoinCommandLine, PeersOfTheEnvironmentAreASiteWideSettingThatTheCommandLineReplaces) {
  setenv("LAMPREY_PEERS", "a.example,192.0.2.1", 1);
  EXPECT_EQ(parse({}), "");
  EXPECT_THAT(options.peers, ElementsAre("a.example", "192.0.2.1"));
  EXPECT_EQ(parse({"--peer", "b.example"}), "");
  EXPECT_THAT(options.peers, ElementsAre("b.example"));
  EXPECT_EQ(parse({"--loopback-only"}), "") << "one machine needs none";
  EXPECT_THAT(options.peers, ElementsAre("a.example", "192.0.2.1")) << "a robot may be elsewhere all the same";
  EXPECT_THAT(parse({"--loopback-only", "--peer", "b.example"}), HasSubstr("--peer"));
  setenv("LAMPREY_PEERS", "a<b", 1);
  EXPECT_THAT(parse({}), AllOf(HasSubstr("'a<b'"), HasSubstr("LAMPREY_PEERS")));
}

TEST_F(JoinCommandLine, RosDomainCountsWhereOursIsNotSet) {
  setenv("ROS_DOMAIN_ID", "8", 1);
  setenv("LAMPREY_DOMAIN", "", 1);
  EXPECT_EQ(parse({}), "");
  EXPECT_EQ(options.domain, 8u);
}

TEST_F(JoinCommandLine, BadValuesSayWhatIsAllowed) {
  EXPECT_THAT(parse({"--dds", "rti"}), AllOf(HasSubstr("'rti'"), HasSubstr("cyclonedds, fastdds")));
  EXPECT_THAT(parse({"--dds", "fastdd"}), HasSubstr("did you mean 'fastdds'?"));
  EXPECT_THAT(parse({"--domain", "231"}), AllOf(HasSubstr("'231'"), HasSubstr("0 to 230")));
  EXPECT_THAT(parse({"--domain", "-1"}), HasSubstr("0 to 230"));
  EXPECT_THAT(parse({"--domain", "1x"}), HasSubstr("'1x'"));
  EXPECT_THAT(parse({"--isolation", "a*"}), AllOf(HasSubstr("'a*'"), HasSubstr("letters")));
  EXPECT_THAT(parse({"--peer", "a<b"}), HasSubstr("host name or address"));
  EXPECT_THAT(parse({"--peer", "a", "--loopback-only"}), HasSubstr("--peer"));
}

TEST_F(JoinCommandLine, BadEnvironmentIsAnErrorTooAndNamesTheVariable) {
  setenv("ROS_DOMAIN_ID", "many", 1);
  EXPECT_THAT(parse({}), AllOf(HasSubstr("'many'"), HasSubstr("ROS_DOMAIN_ID")));
  clear();
  setenv("LAMPREY_DDS", "rti", 1);
  EXPECT_THAT(parse({}), HasSubstr("LAMPREY_DDS"));
}

TEST_F(JoinCommandLine, InterfaceThatIsNotThereIsAnsweredWithTheNearestOne) {
  EXPECT_THAT(parse({"--interface", "127.0.0.2"}),
              AllOf(HasSubstr("--interface: "), HasSubstr("'127.0.0.2'"), HasSubstr("did you mean '127.0.0.1'?")));
  EXPECT_THAT(parse({"--interface", "lo"}), HasSubstr("--loopback-only"));
  EXPECT_THAT(parse({"--interface", ""}), HasSubstr("name or address"));
  setenv("LAMPREY_INTERFACES", "no-such-interface", 1);
  EXPECT_THAT(parse({}), HasSubstr("LAMPREY_INTERFACES: no network interface"));
  EXPECT_EQ(parse({"--loopback-only"}), "") << "then it is not used";
  const auto file = write_usual("\ninterfaces: no-such-interface\n");
  clear();
  EXPECT_THAT(parse({}), HasSubstr(file + ":2: interfaces: no network interface"));
}

TEST_F(JoinCommandLine, InterfacesAreTakenByNameAndAddress) {
  const auto existing = network_interfaces();
  const auto usable =
      std::ranges::find_if(existing, [](const NetworkInterface& interface) { return !interface.loopback; });
  if (usable == existing.end()) GTEST_SKIP() << "this machine has no interface but loopback";
  EXPECT_EQ(parse({"--interface", usable->name, "--interface", usable->address}), "");
  EXPECT_THAT(options.interfaces, ElementsAre(usable->name, usable->address));
  EXPECT_THAT(parse({"--interface", usable->name, "--loopback-only"}), HasSubstr("--interface"));
  setenv("LAMPREY_INTERFACES", (usable->name + "," + usable->address).c_str(), 1);
  EXPECT_EQ(parse({}), "");
  EXPECT_THAT(options.interfaces, ElementsAre(usable->name, usable->address));
}

TEST_F(JoinCommandLine, DiscoveryServerIsFastDdsOnly) {
  EXPECT_EQ(parse({"--dds", "fastdds", "--discovery-server", "a.example", "--discovery-server", "b.example:11812"}),
            "");
  EXPECT_THAT(options.discovery_servers, ElementsAre("a.example", "b.example:11812"));
  EXPECT_THAT(parse({"--discovery-server", "a.example"}),
              AllOf(HasSubstr("--discovery-server: Cyclone DDS has no discovery server"), HasSubstr("--dds fastdds")));
  setenv("LAMPREY_DISCOVERY_SERVERS", "a.example", 1);
  EXPECT_THAT(parse({}), HasSubstr("LAMPREY_DISCOVERY_SERVERS: Cyclone DDS"));
  EXPECT_EQ(parse({"--dds", "fastdds"}), "");
  EXPECT_THAT(options.discovery_servers, ElementsAre("a.example"));
}

TEST_F(JoinCommandLine, BadDiscoveryServersSayWhatIsAllowed) {
  EXPECT_THAT(parse({"--dds", "fastdds", "--discovery-server", "a:80"}), HasSubstr("11811 to 12066"));
  EXPECT_THAT(parse({"--dds", "fastdds", "--discovery-server", "a,b"}),
              AllOf(HasSubstr("'a' and 'b'"), HasSubstr("one port, 11811")));
  EXPECT_THAT(parse({"--dds", "fastdds", "--discovery-server", "a", "--peer", "b"}), HasSubstr("--peer"));
  EXPECT_THAT(parse({"--dds", "fastdds", "--discovery-server", "a", "--loopback-only"}),
              HasSubstr("--discovery-server"));
}

TEST_F(JoinCommandLine, OfPeersAndDiscoveryServersTheOnesSaidInTheStrongerPlaceCount) {
  setenv("LAMPREY_PEERS", "a.example", 1);
  EXPECT_EQ(parse({"--dds", "fastdds", "--discovery-server", "b.example"}), "");
  EXPECT_THAT(options.peers, ::testing::IsEmpty());
  setenv("LAMPREY_DISCOVERY_SERVERS", "b.example", 1);
  EXPECT_EQ(parse({"--peer", "c.example"}), "") << "Cyclone DDS, too, since no server is asked";
  EXPECT_THAT(options.peers, ElementsAre("c.example"));
  EXPECT_THAT(options.discovery_servers, ::testing::IsEmpty());
}

TEST_F(JoinCommandLine, FileIsAskedLast) {
  const auto file = write_usual("dds: fastdds\ndomain: 5\nisolation: lab\npeers: [a.example, b.example]\n");
  EXPECT_EQ(parse({}), "");
  EXPECT_EQ(options.vendor, "fastdds");
  EXPECT_EQ(options.domain, 5U);
  EXPECT_EQ(options.isolation, "lab");
  EXPECT_THAT(options.peers, ElementsAre("a.example", "b.example"));
  EXPECT_EQ(options.configuration_file, file);
  setenv("LAMPREY_DOMAIN", "6", 1);
  setenv("LAMPREY_PEERS", "c.example", 1);
  EXPECT_EQ(parse({"--isolation", "mine"}), "");
  EXPECT_EQ(options.vendor, "fastdds");
  EXPECT_EQ(options.domain, 6U);
  EXPECT_EQ(options.isolation, "mine");
  EXPECT_THAT(options.peers, ElementsAre("c.example"));
}

TEST_F(JoinCommandLine, FileIsTheOneThatIsNamed) {
  write_usual("domain: 1\n");
  const auto of_environment = folder.write("of_environment.yaml", "domain: 2\n");
  const auto of_command_line = folder.write("of_command_line.yaml", "domain: 3\n");
  setenv("LAMPREY_CONFIG", of_environment.c_str(), 1);
  EXPECT_EQ(parse({}), "");
  EXPECT_EQ(options.domain, 2U);
  EXPECT_EQ(parse({"--config", of_command_line}), "");
  EXPECT_EQ(options.domain, 3U);
  EXPECT_EQ(parse({"--config", "/dev/null"}), "");
  EXPECT_EQ(options.domain, 0U);
  EXPECT_THAT(parse({"--config", folder.path("no.yaml")}), HasSubstr(folder.path("no.yaml") + ": no such file"));
}

TEST_F(JoinCommandLine, MistakesOfAFileAreRefusedAsThoseOfTheCommandLine) {
  const auto file = write_usual("isolation: lab\npears: a.example\n");
  EXPECT_THAT(parse({}), AllOf(HasSubstr(file + ":2:1: "), HasSubstr("'pears'; did you mean 'peers'?")));
}

TEST_F(JoinCommandLine, LoopbackOnlyInAFileIsNotOverruledInSilence) {
  const auto file = write_usual("loopback_only: true\n");
  EXPECT_EQ(parse({}), "");
  EXPECT_TRUE(options.loopback_only);
  EXPECT_THAT(parse({"--peer", "a.example"}), AllOf(HasSubstr(file + ":1: loopback_only"), HasSubstr("--peer")));
  EXPECT_EQ(parse({"--peer", "a.example", "--loopback-only=false"}), "");
  EXPECT_FALSE(options.loopback_only);
  EXPECT_THAT(options.peers, ElementsAre("a.example"));
}

TEST_F(JoinCommandLine, LoopbackOnlyHeedsNoPeersOfAFile) {
  write_usual("peers: a.example\n");
  EXPECT_EQ(parse({"--loopback-only"}), "");
  EXPECT_TRUE(options.loopback_only);
}

TEST_F(JoinCommandLine, WhatIsRemovedFromTheCommandLineIsHeededInAFileOnly) {
  write_usual("isolation: lab\n");
  setenv("LAMPREY_ISOLATION", "mine", 1);
  CLI::App app("test", "test");
  add_join_options(app, options);
  app.remove_option(app.get_option("--isolation"));
  app.parse(std::vector<std::string>{});
  EXPECT_EQ(options.isolation, "lab");
}

class OpenDoor : public ::testing::Test {
 protected:
  /// What is logged of it.
  static std::string warning(const JoinOptions& options, bool bridges_too = false) {
    std::ostringstream log;
    const auto before = spdlog::default_logger();
    spdlog::set_default_logger(
        std::make_shared<spdlog::logger>("test", std::make_shared<spdlog::sinks::ostream_sink_mt>(log)));
    warn_of_open_door(options, bridges_too);
    spdlog::set_default_logger(before);
    return log.str();
  }
};

TEST_F(OpenDoor, IsWarnedOfOnceWhereOthersCanReachTheProgram) {
  JoinOptions options;
  options.domain = 7;
  const auto text = warning(options);
  EXPECT_THAT(
      text, AllOf(HasSubstr("warning"), HasSubstr("no security"), HasSubstr("domain 7"), HasSubstr("--loopback-only")));
  EXPECT_EQ(std::ranges::count(text, '\n'), 1);
  options.interfaces = {"eth0", "eth1"};
  EXPECT_THAT(warning(options), HasSubstr("over eth0, eth1"));
}

TEST_F(OpenDoor, IsNoneOnThisMachineUnlessARobotMayBeElsewhere) {
  JoinOptions options;
  options.loopback_only = true;
  EXPECT_EQ(warning(options), "");
  EXPECT_THAT(warning(options, true), AllOf(HasSubstr("no security"), HasSubstr("robot")));
}

}  // namespace
}  // namespace lamprey::messaging::program
