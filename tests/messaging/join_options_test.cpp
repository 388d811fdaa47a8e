#include "messaging/program/join_options.hpp"

#include <cstdlib>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
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
    for (const char* name : {"LAMPREY_DDS", "LAMPREY_DOMAIN", "ROS_DOMAIN_ID", "LAMPREY_ISOLATION", "LAMPREY_PEERS"}) {
      unsetenv(name);
    }
  }

  /// What went wrong, or nothing.
  std::string parse(std::vector<std::string> arguments) {
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
  EXPECT_THAT(options.peers, ::testing::IsEmpty());
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

}  // namespace
}  // namespace lamprey::messaging::program
