#include "messaging/discovery/domain_view.hpp"
#include "tests/client/site.hpp"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lamprey::tests {
namespace {

namespace discovery = messaging::discovery;
using ::testing::HasSubstr;
using ::testing::Not;

discovery::Guid guid(std::uint8_t vendor, std::uint8_t participant, std::uint8_t entity = 0) {
  discovery::Guid guid{1, vendor};
  guid[11] = participant;
  guid[15] = entity;
  return guid;
}

discovery::Participant ours(const discovery::Guid& guid, const std::string& role, std::uint32_t process) {
  return {.guid = guid,
          .name = role,
          .introduction = discovery::Introduction{
              .role = role, .host = "alpha", .process = process, .build = "0.1.0", .isolation = "lab", .wire = 4}};
}

discovery::Endpoint endpoint(const discovery::Guid& participant, bool writes, const std::string& topic) {
  discovery::Guid own = participant;
  own[15] = writes ? 2 : 7;
  return {.guid = own, .participant = participant, .writes = writes, .topic = topic, .type = "T", .qos = {}};
}

class Net : public ::testing::Test {
 protected:
  ToolRun net(std::vector<std::string> arguments = {}) {
    const bool has_time = std::ranges::find(arguments, "--seconds") != arguments.end();
    if (!has_time) arguments.insert(arguments.begin(), {"--seconds", "0.1"});
    arguments.insert(arguments.begin(), "net");
    return site.run(arguments);
  }
  Site site;
};

TEST_F(Net, SaysWhereNobodyIs) {
  const auto run = net();
  EXPECT_EQ(run.exit_code, client::exit_ok);
  EXPECT_THAT(run.out, HasSubstr("Nobody else is in domain 0"));
  EXPECT_THAT(run.out, HasSubstr("lamprey doctor"));
}

TEST_F(Net, ShowsAProcessOnceWhateverItsParticipants) {
  site.domain.participants = {ours(guid(0x0f, 1), "bridge", 7), ours(guid(0x10, 2), "bridge", 7),
                              ours(guid(0x10, 3), "coordinator", 9)};
  site.domain.endpoints = {endpoint(guid(0x0f, 1), true, "a"), endpoint(guid(0x10, 2), false, "b")};
  const auto json = net({"--format", "json"}).json();
  ASSERT_EQ(json["programs"].size(), 2U);
  EXPECT_EQ(json["programs"][0]["role"], "coordinator") << "it comes first";
  EXPECT_EQ(json["programs"][1]["vendors"], client::Json({"Cyclone DDS", "Fast DDS"}));
  EXPECT_EQ(json["programs"][1]["writers"], 1);
  EXPECT_EQ(json["programs"][1]["readers"], 1);
  EXPECT_EQ(json["programs"][1]["host"], "alpha");
}

TEST_F(Net, ShowsStrangersWithoutTrustingTheirNames) {
  site.domain.participants = {{.guid = guid(0x0f, 5), .name = "rviz\x1b[2J", .introduction = {}}};
  const auto run = net();
  EXPECT_EQ(run.exit_code, client::exit_ok);
  EXPECT_THAT(run.out, HasSubstr("not ours  rviz?[2J"));
}

TEST_F(Net, NamesWhoFailsToMeetWhomAndWhy) {
  site.domain.participants = {ours(guid(0x0f, 1), "bridge", 7),
                              {.guid = guid(0x10, 2), .name = "rviz", .introduction = {}}};
  auto reader = endpoint(guid(0x10, 2), false, "rt/joint_states");
  reader.qos.reliable = true;
  site.domain.endpoints = {endpoint(guid(0x0f, 1), true, "rt/joint_states"), reader};
  const auto run = net();
  EXPECT_EQ(run.exit_code, client::exit_mismatch);
  EXPECT_THAT(run.out,
              HasSubstr("Never meet on rt/joint_states: bridge alpha/7 writes, participant "
                        "01100000.00000000.00000002 (rviz) reads, but the writer offers best effort, the reader "
                        "asks for reliable."));
  const auto json = net({"--format", "json"}).json();
  EXPECT_EQ(json["mismatches"][0]["writer"], "bridge alpha/7");
}

TEST_F(Net, NamesProgramsOfAnotherVersion) {
  site.domain.participants = {ours(guid(0x0f, 1), "worker", 7)};
  site.domain.endpoints = {endpoint(guid(0x0f, 1), true, "lamprey/2/result")};
  const auto run = net();
  EXPECT_EQ(run.exit_code, client::exit_mismatch);
  EXPECT_THAT(run.out, HasSubstr("Programs of another version"));
  EXPECT_THAT(run.out, HasSubstr("lamprey/2/result"));
}

TEST_F(Net, ListsWritersAndReadersWhenAsked) {
  site.domain.participants = {ours(guid(0x0f, 1), "worker", 7)};
  auto writer = endpoint(guid(0x0f, 1), true, "lamprey/4/result");
  writer.qos.partitions = {"lab/common"};
  site.domain.endpoints = {writer, endpoint(guid(0x0f, 9), false, "unknown")};
  EXPECT_THAT(net().out, Not(HasSubstr("lamprey/4/result")));
  const auto run = net({"--topics"});
  EXPECT_THAT(run.out, HasSubstr("lamprey/4/result  lab/common  written by  worker alpha/7"));
  EXPECT_THAT(run.out, HasSubstr("an unknown program"));
}

TEST_F(Net, ShowsHowManySamplesAProgramExchangesASecond) {
  site.domain.participants = {ours(guid(0x0f, 1), "worker", 7), ours(guid(0x0f, 2), "worker", 8)};
  site.domain.traffic = {
      {.participant = guid(0x0f, 1), .seconds = 10, .malformed = 3, .topics = {{"a", 100, 2, 0}, {"b", 0, 0, 40}}}};
  const auto json = net({"--seconds", "0.8", "--format", "json"}).json();
  const auto& samples = json["programs"][0]["samples"];
  EXPECT_EQ(samples["written"], 100);
  EXPECT_EQ(samples["refused"], 2);
  EXPECT_EQ(samples["read"], 40);
  EXPECT_EQ(samples["malformed"], 3);
  EXPECT_EQ(samples["written_per_second"], 10);
  EXPECT_EQ(samples["read_per_second"], 4);
  EXPECT_TRUE(json["programs"][1]["samples"].is_null());
  EXPECT_THAT(net({"--seconds", "0.8"}).out, HasSubstr("    10     4\n"));
}

}  // namespace
}  // namespace lamprey::tests
