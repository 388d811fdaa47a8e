#include "messaging/program/configuration_file.hpp"

#include "experiment/problem.hpp"
#include "tests/messaging/scratch_folder.hpp"

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
using ::testing::IsEmpty;
using ::testing::SizeIs;

class ConfigurationFile : public ::testing::Test {
 protected:
  Configuration read(const std::string& text) {
    return read_configuration(folder.write("site.yaml", text), join_fields());
  }

  /// The problems' texts; none where the file is good.
  std::vector<std::string> problems(const std::string& text) {
    std::vector<std::string> texts;
    try {
      read(text);
    } catch (const experiment::InvalidInput& error) {
      for (const auto& problem : error.problems()) texts.push_back(problem.text());
    }
    return texts;
  }

  tests::ScratchFolder folder;
};

TEST_F(ConfigurationFile, SaysWhatItSays) {
  const auto configuration = read(
      "dds: fastdds\ndomain: 7\n\nisolation: gaits\npeers: [a.example, 192.0.2.7]\ninterfaces: eth0\n"
      "loopback_only: false\n");
  EXPECT_EQ(configuration.file, folder.path("site.yaml"));
  ASSERT_NE(configuration.find("peers"), nullptr);
  EXPECT_THAT(configuration.find("peers")->values, ElementsAre("a.example", "192.0.2.7"));
  EXPECT_EQ(configuration.find("peers")->line, 5);
  EXPECT_THAT(configuration.find("interfaces")->values, ElementsAre("eth0")) << "one needs no list";
  EXPECT_THAT(configuration.find("loopback_only")->values, ElementsAre("false"));
  EXPECT_EQ(configuration.find("discovery_servers"), nullptr);
}

TEST_F(ConfigurationFile, MaySayNothing) {
  EXPECT_THAT(read("").entries, IsEmpty());
  EXPECT_THAT(read("# domain: 7\n").entries, IsEmpty());
  EXPECT_THAT(read("peers: []\n").find("peers")->values, IsEmpty()) << "none, whatever the default";
  EXPECT_THAT(read_configuration("/dev/null", join_fields()).entries, IsEmpty());
}

TEST_F(ConfigurationFile, UnknownFieldsAreAnsweredWithTheNearestAndAll) {
  const std::string place = folder.path("site.yaml") + ":2:1: ";
  EXPECT_THAT(problems("domain: 7\npers: [a]\n"),
              ElementsAre(AllOf(HasSubstr(place), HasSubstr("there is no field 'pers'; did you mean 'peers'?"),
                                HasSubstr("dds, domain, isolation, peers, interfaces"))));
}

TEST_F(ConfigurationFile, EveryBadValueIsToldWithItsPlace) {
  const auto found = problems("domain: 231\npeers: [good, 'a<b']\ndds: rti\nloopback_only: maybe\n");
  const std::string file = folder.path("site.yaml");
  ASSERT_THAT(found, SizeIs(4));
  EXPECT_THAT(found[0], AllOf(HasSubstr(file + ":1:9: domain: '231'"), HasSubstr("0 to 230")));
  EXPECT_THAT(found[1], HasSubstr(file + ":2:15: peers: 'a<b' is not a host name or address"));
  EXPECT_THAT(found[2], AllOf(HasSubstr(":3:6: dds: "), HasSubstr("cyclonedds, fastdds")));
  EXPECT_THAT(found[3], HasSubstr(":4:16: loopback_only: 'maybe' is neither true nor false"));
}

TEST_F(ConfigurationFile, OfAnotherShapeIsRefused) {
  EXPECT_THAT(problems("- domain\n"), ElementsAre(AllOf(HasSubstr("fields are expected"), HasSubstr("a list"))));
  EXPECT_THAT(problems("domain: [1, 2]\n"),
              ElementsAre(AllOf(HasSubstr(":1:"), HasSubstr("domain: wants a single value, not a list"))));
  EXPECT_THAT(problems("peers: {a: b}\n"), ElementsAre(HasSubstr("peers: wants texts, not a mapping")));
  EXPECT_THAT(problems("isolation:\n"), ElementsAre(HasSubstr("wants a single value, not nothing")));
  EXPECT_THAT(problems("domain: 1\ndomain: 2\n"), ElementsAre(HasSubstr("duplicate key 'domain'")));
  EXPECT_THAT(problems("domain: [\n"), SizeIs(1));
}

TEST_F(ConfigurationFile, ThatIsNotThereIsNamed) {
  try {
    read_configuration(folder.path("no.yaml"), join_fields());
    FAIL() << "there is none";
  } catch (const experiment::InvalidInput& error) {
    EXPECT_EQ(error.what(), folder.path("no.yaml") + ": no such file");
  }
}

TEST_F(ConfigurationFile, IsUsuallyTheUsersOwn) {
  const tests::Variable config("XDG_CONFIG_HOME", folder.path("config"));
  const tests::Variable home("HOME", folder.path("home"));
  const auto of_site = usual_configuration_file();  // this machine's own, or nothing
  EXPECT_THAT(of_site, ::testing::AnyOf("", "/etc/lamprey/lamprey.yaml"));
  const auto in_home = folder.write("home/.config/lamprey/lamprey.yaml", "");
  EXPECT_EQ(usual_configuration_file(), of_site) << "XDG_CONFIG_HOME says where it is looked for";
  {
    const tests::Variable unset("XDG_CONFIG_HOME", "");
    EXPECT_EQ(usual_configuration_file(), in_home);
  }
  const auto in_config = folder.write("config/lamprey/lamprey.yaml", "");
  EXPECT_EQ(usual_configuration_file(), in_config);
}

}  // namespace
}  // namespace lamprey::messaging::program
