#include "messaging/robot/robot_name.hpp"
#include "tests/client/site.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <thread>

// What talks with a robot's bridge: bridge status, stop, reset, activate and deactivate.

namespace lamprey::tests {
namespace {

using messaging::RobotReply;
using messaging::RobotRequest;
using messaging::RobotRequestKind;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Says the same to whoever asks, and keeps what was asked.
class ScriptedBridge {
 public:
  ScriptedBridge(messaging::in_memory::Bus& bus, RobotReply reply)
      : participant_(bus.join("bridge")),
        reply_(std::move(reply)),
        thread_([this](std::stop_token stop) { serve(stop); }) {}

  std::vector<RobotRequest> end() {
    thread_.request_stop();
    thread_.join();
    return std::move(asked_);
  }

 private:
  void serve(const std::stop_token& stop) {
    const auto robot = messaging::robot_number("bench");
    const auto signal = std::make_shared<messaging::Signal>();
    const auto requests = participant_->reader<RobotRequest>(signal, messaging::Partition::of(robot));
    const auto statuses = participant_->writer<messaging::RobotStatus>();
    messaging::RobotStatus status;
    status.robot = robot;
    status.name = "bench";
    status.state = messaging::RobotState::fault;
    status.reason = "the servo controller gives no answer";
    status.token = 12;
    status.rate = 50;
    status.counters = {{"steps", 1234}};
    EXPECT_TRUE(statuses->write(status));
    while (!stop.stop_requested()) {
      signal->wait_for(std::chrono::milliseconds(1));
      for (const auto& request : requests->take()) {
        asked_.push_back(request);
        auto reply = reply_;
        reply.robot = robot;
        reply.asker = request.asker;
        reply.correlation = request.correlation;
        auto& writer = writers_[request.asker];
        if (!writer) writer = participant_->writer<RobotReply>(messaging::Partition::of(request.asker));
        EXPECT_TRUE(writer->write(reply));
      }
    }
  }

  std::unique_ptr<messaging::Participant> participant_;
  RobotReply reply_;
  std::map<std::uint64_t, std::unique_ptr<messaging::Writer<RobotReply>>> writers_;
  std::vector<RobotRequest> asked_;
  std::jthread thread_;
};

RobotReply granted() {
  RobotReply reply;
  reply.granted = true;
  return reply;
}

TEST(BridgeCommandsTest, AStopSaysWhyAndIsToldWhenItIsDone) {
  Site site;
  ScriptedBridge bridge(site.bus, granted());
  const auto run = site.run({"bridge", "stop", "bench", "--reason", "it smells"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("Robot bench is stopped; its servos are off ("));
  const auto asked = bridge.end();
  ASSERT_FALSE(asked.empty());
  EXPECT_EQ(asked.front().kind, RobotRequestKind::stop);
  EXPECT_EQ(asked.front().reason, "it smells");
  EXPECT_THAT(site.joined, ElementsAre("cyclonedds"));
}

TEST(BridgeCommandsTest, AStopGoesOutFirstOverTheVendorThatFindsTheBridgeAtOnce) {
  Site site;
  ScriptedBridge bridge(site.bus, granted());
  EXPECT_EQ(site.run({"bridge", "stop", "bench", "--dds", "fastdds"}).exit_code, 0);
  EXPECT_THAT(site.joined, ElementsAre("cyclonedds"));
}

TEST(BridgeCommandsTest, AStopThatNobodyAnswersGoesOutOverTheVendorThatWasAskedForToo) {
  Site site;
  const auto run = site.run({"bridge", "stop", "bench", "--dds", "fastdds", "--timeout", "0.3"});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.err, HasSubstr("no bridge of robot 'bench' answered within 0.3 s"));
  EXPECT_THAT(site.joined, ElementsAre("cyclonedds", "fastdds"));
}

TEST(BridgeCommandsTest, AStopIsSentThoughTheOtherVendorIsMissing) {
  Site site;
  site.unjoinable = "cyclonedds";
  ScriptedBridge bridge(site.bus, granted());
  const auto run = site.run({"bridge", "stop", "bench", "--dds", "fastdds"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.err, HasSubstr("warning: the stop goes out over fastdds alone: no cyclonedds here"));
}

TEST(BridgeCommandsTest, AnythingElseIsAskedOverTheVendorThatWasAskedForAlone) {
  Site site;
  ScriptedBridge bridge(site.bus, granted());
  for (const char* action : {"reset", "activate", "deactivate"}) {
    EXPECT_EQ(site.run({"bridge", action, "bench", "--dds", "fastdds"}).exit_code, 0);
  }
  EXPECT_THAT(site.joined, ElementsAre("fastdds", "fastdds", "fastdds"));
}

TEST(BridgeCommandsTest, ARefusalIsAnErrorWithTheBridgesReason) {
  Site site;
  RobotReply reply;
  reply.reason = "emergency stop: it smells";
  ScriptedBridge bridge(site.bus, reply);
  const auto run = site.run({"bridge", "activate", "bench"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("robot 'bench': emergency stop: it smells"));
}

TEST(BridgeCommandsTest, StatusShowsEachRobot) {
  Site site;
  ScriptedBridge bridge(site.bus, granted());
  const auto run = site.run({"bridge", "status"});
  EXPECT_EQ(run.exit_code, 0);
  for (const char* text : {"bench", "fault", "the servo controller gives no answer", "nobody's", "1,234"}) {
    EXPECT_THAT(run.out, HasSubstr(text));
  }
  const auto json = site.run({"bridge", "status", "bench", "--format", "json"}).json();
  EXPECT_EQ(json["robots"][0]["state"], "fault");
  EXPECT_EQ(json["robots"][0]["counters"]["steps"], 1234);
}

TEST(BridgeCommandsTest, StatusOfARobotThatIsNotThereSaysWhereItLooked) {
  Site site;
  const auto run = site.run({"bridge", "status", "bench", "--timeout", "0.1", "--isolation", "lab"});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.err, HasSubstr("isolation lab"));
  EXPECT_THAT(run.out, IsEmpty());
}

}  // namespace
}  // namespace lamprey::tests
