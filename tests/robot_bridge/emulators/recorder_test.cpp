#include "robot_bridge/emulators/recorder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>

namespace lamprey::robot_bridge::emulators {
namespace {

using namespace std::chrono_literals;

TEST(RecorderTest, KeepsExtremesChangesAndSpeeds) {
  Recorder recorder;
  recorder.turned_on(3, 1040.0, 1000, 1s);
  recorder.target(3, 1000, 0ms, 1s);
  recorder.target(3, 1050, 20ms, 2s);        // 50 in a second: time has passed since the command before
  recorder.target(3, 1000, 20ms, 2s + 5ms);  // 50 in 20 ms: the move takes as long
  recorder.target(3, 1300, 5ms, 2s + 105ms);
  const auto servo = recorder.report()["servos"]["3"];
  EXPECT_EQ(servo["moves"], 4);
  EXPECT_EQ(servo["lowest"], 1000);
  EXPECT_EQ(servo["highest"], 1300);
  EXPECT_EQ(servo["largest_change"], 300);
  EXPECT_DOUBLE_EQ(servo["largest_speed"], 3000.0);
  EXPECT_DOUBLE_EQ(servo["largest_jump"], 40.0);
}

TEST(RecorderTest, AChangeWhileOffIsNoneButTurningOnFarAwayIsAJump) {
  Recorder recorder;
  recorder.turned_on(0, 1000, 1000, 1s);
  recorder.target(0, 1000, 0ms, 1s);
  recorder.turned_off(0, 2s);
  recorder.turned_on(0, 1000, 2000, 3s);
  recorder.target(0, 2000, 0ms, 3s);
  const auto servo = recorder.report()["servos"]["0"];
  EXPECT_EQ(servo["largest_change"], 0);
  EXPECT_DOUBLE_EQ(servo["largest_jump"], 1000.0);
  EXPECT_EQ(servo["times_turned_on"], 2);
  EXPECT_EQ(servo["times_turned_off"], 1);
}

TEST(RecorderTest, LogsEveryCommandWithItsTime) {
  std::ostringstream log;
  Recorder recorder(&log);
  recorder.target(5, 1500, 20ms, 123456789ns);
  recorder.turned_off(5, 2s);
  EXPECT_EQ(log.str(), "time_ns,servo,value,duration_ms\n123456789,5,1500,20\n2000000000,5,,0\n");
}

TEST(RecorderTest, CountsRefusalsByReason) {
  Recorder recorder;
  recorder.refused("channel");
  recorder.refused("time");
  recorder.refused("channel");
  EXPECT_EQ(recorder.refusals(), 3U);
  EXPECT_EQ(recorder.report()["refused"], (nlohmann::json{{"channel", 2}, {"time", 1}}));
}

}  // namespace
}  // namespace lamprey::robot_bridge::emulators
