#include "robot_bridge/emulators/control.hpp"

#include "echo_controller.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdexcept>

namespace lamprey::robot_bridge::emulators {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;

class ControlTest : public testing::Test {
 protected:
  std::string say(std::string_view text) { return control(text, line, actions, 5s); }

  EchoController controller;
  Line line{controller, 9600, 1};
  std::vector<std::string> done;
  ProgramActions actions{[this] { done.emplace_back("unplug"); }, [] { throw std::runtime_error("is plugged in"); },
                         [] { return std::string("{}"); }};
};

TEST_F(ControlTest, SetsFaults) {
  EXPECT_EQ(say("silence on"), "ok");
  EXPECT_EQ(say("partial on"), "ok");
  EXPECT_EQ(say("noise 0.25"), "ok");
  EXPECT_EQ(say("slow 12.5"), "ok");
  EXPECT_TRUE(line.faults().silence);
  EXPECT_TRUE(line.faults().partial);
  EXPECT_EQ(line.faults().noise, 0.25);
  EXPECT_EQ(line.faults().slow, 12500us);
  for (const char* off : {"silence off", "partial off", "noise off", "slow off"}) EXPECT_EQ(say(off), "ok");
  EXPECT_FALSE(line.faults().silence);
  EXPECT_FALSE(line.faults().partial);
  EXPECT_EQ(line.faults().noise, 0);
  EXPECT_EQ(line.faults().slow, 0ns);
}

TEST_F(ControlTest, ReachesTheControllerAndTheProgram) {
  EXPECT_EQ(say("overload 3 on"), "ok");
  EXPECT_EQ(say("  place 2\t1500\r"), "ok");
  EXPECT_EQ(say("state"), R"({"time":5000000000})");
  EXPECT_EQ(say("report"), "{}");
  EXPECT_EQ(say("unplug"), "ok");
  EXPECT_EQ(say("replug"), "error replug: is plugged in");
  EXPECT_THAT(controller.told, ElementsAre("overload 3 on", "place 2 1500.000000"));
  EXPECT_THAT(done, ElementsAre("unplug"));
}

TEST_F(ControlTest, ResetEndsFaultsToo) {
  say("silence on");
  EXPECT_EQ(say("reset"), "ok");
  EXPECT_FALSE(line.faults().silence);
  EXPECT_THAT(controller.told, ElementsAre("reset"));
}

TEST_F(ControlTest, SaysWhatIsWrongAndChangesNothing) {
  EXPECT_EQ(say("silent on"),
            "error unknown command 'silent'; commands are silence, noise, partial, slow, unplug, replug, overload, "
            "place, reset, state, report");
  EXPECT_TRUE(say("").starts_with("error unknown command ''"));
  EXPECT_EQ(say("silence"), "error usage: silence on|off");
  EXPECT_EQ(say("silence yes"), "error silence: expected on or off, not 'yes'");
  EXPECT_EQ(say("noise 1.5"), "error noise: '1.5' is not in 0..1, or off");
  EXPECT_EQ(say("noise nan"), "error noise: 'nan' is not in 0..1, or off");
  EXPECT_EQ(say("slow -1"), "error slow: '-1' is not in 0..60000 (milliseconds), or off");
  EXPECT_EQ(say("overload 7 on"), "error overload: no servo '7'");
  EXPECT_EQ(say("overload x on"), "error overload: no servo 'x'");
  EXPECT_EQ(say("state now"), "error usage: state");
  EXPECT_TRUE(controller.told.empty());
  EXPECT_FALSE(line.faults().silence);
  EXPECT_EQ(line.faults().noise, 0);
}

}  // namespace
}  // namespace lamprey::robot_bridge::emulators
