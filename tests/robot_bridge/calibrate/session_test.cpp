#include "robot_bridge/calibrate/session.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sstream>
#include <utility>

namespace lamprey::robot_bridge::calibrate {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Remembers what it was told, and can be moved by hand.
class FakeDriver : public Driver {
 public:
  void connect() override { ++connected; }
  std::optional<Pose> present_position() override { return sensors ? std::optional(pose) : std::nullopt; }
  void enable(const Pose& start) override {
    pose = start;
    on = true;
  }
  void move(const Pose& target, std::chrono::microseconds duration) override {
    if (std::exchange(fails_once, false)) throw DriverError(DriverError::Kind::silent, "no answer");
    pose = target;
    durations.push_back(duration);
  }
  Feedback read() override { return {.position = pose}; }
  bool moving() override { return false; }
  void hold() override {}
  void release() override {
    on = false;
    if (by_hand) pose = *by_hand;
  }
  bool let_go() noexcept override { return true; }
  void cancel() noexcept override {}
  std::string description() const override { return "a device"; }
  double highest_rate() const override { return 50; }

  bool sensors = true;
  bool on = false;
  bool fails_once = false;
  int connected = 0;
  Pose pose = standing_pose();
  std::optional<Pose> by_hand;
  std::vector<std::chrono::microseconds> durations;
};

class SessionTest : public testing::Test {
 protected:
  Ending talk(const std::string& lines) {
    std::istringstream in(lines);
    std::ostringstream out;
    Session session(driver, begin, in, out, [] { return false; });
    const Ending ending = session.run();
    calibration = session.calibration();
    said = out.str();
    return ending;
  }

  FakeDriver driver;
  Calibration begin = first_draft(DeviceFamily::ssc32, 115200);
  Calibration calibration;
  std::string said;
};

TEST_F(SessionTest, MarksOneJointAndLeavesTheOthers) {
  const auto ending = talk("next\n1200\nstand\n1700\nunits 20\n+100\nmaximum\n1000\nminimum\nslew 2500\nsave\n");
  EXPECT_EQ(ending, Ending::save);
  Calibration expected = begin;
  expected.joints[1] = {.channel = 1,
                        .minimum = 1000,
                        .centre = 1200,
                        .maximum = 1800,
                        .per_unit = 50,
                        .direction = 1,
                        .offset = 0,
                        .slew_rate = 2500};
  EXPECT_EQ(calibration, expected);
  EXPECT_EQ(parse_calibration(to_yaml(calibration), "written"), calibration);
}

TEST_F(SessionTest, FindsOutThatAServoIsMountedTheOtherWayRound) {
  talk("1500\nstand\n1100\nunits 30\nsave\n");
  EXPECT_EQ(calibration.joints[0].per_unit, 20);
  EXPECT_EQ(calibration.joints[0].direction, -1);
}

TEST_F(SessionTest, MovesOneServoSlowly) {
  Pose before{};
  talk("1500\nquit\n");
  before = driver.pose;
  driver.durations.clear();
  talk("+100\nquit\n");
  for (std::size_t servo = 1; servo < servos; ++servo) EXPECT_EQ(driver.pose[servo], before[servo]);
  ASSERT_EQ(driver.durations.size(), 1U);
  EXPECT_GE(driver.durations.front(), std::chrono::milliseconds(240)) << "the whole range of 2000 µs takes 5 s";
}

TEST_F(SessionTest, WhatIsMovedByHandIsReadWhereTheDeviceHasSensors) {
  driver.by_hand = standing_pose();
  driver.by_hand->at(0) = whole_range(begin).joints[0].to_units(1321);
  talk("free\nstand\nsave\n");
  EXPECT_EQ(calibration.joints[0].centre, 1321);
}

TEST_F(SessionTest, WithoutSensorsNothingMovesBeforeSomebodyAgrees) {
  driver.sensors = false;
  EXPECT_EQ(talk("no\n"), Ending::quit);
  EXPECT_FALSE(driver.on);
  EXPECT_TRUE(driver.durations.empty());
  EXPECT_THAT(said, HasSubstr("type yes"));
  EXPECT_EQ(talk("yes\nsave\n"), Ending::save);
}

TEST_F(SessionTest, ServosAreFreeAtTheEnd) {
  talk("1500\nquit\n");
  EXPECT_FALSE(driver.on);
  talk("1500\n");
  EXPECT_FALSE(driver.on) << "also where the talk just ends";
}

TEST_F(SessionTest, ADeviceThatFailsCostsNothingThatWasMeasured) {
  driver.fails_once = true;
  EXPECT_EQ(talk("slew 77\n+1\n+1\nhold\n+1\nsave\n"), Ending::save);
  EXPECT_EQ(driver.connected, 1);
  EXPECT_EQ(driver.durations.size(), 1U) << "not before the servos are held again";
  EXPECT_EQ(calibration.joints[0].slew_rate, 77);
}

TEST_F(SessionTest, WhatABridgeWouldRefuseIsNotSavedButCanBeMended) {
  EXPECT_EQ(talk("1500\nstand\n+50\nminimum\nsave\nquit\n"), Ending::quit);
  EXPECT_THAT(said, HasSubstr("minimum"));
  EXPECT_EQ(talk("1500\nstand\n+50\nminimum\nsave\n-100\nminimum\nsave\n"), Ending::save);
  EXPECT_EQ(calibration.joints[0].minimum, 1450);
}

TEST_F(SessionTest, RefusesWhatTheDeviceCanNot) {
  talk("3000\nquit\n");
  EXPECT_THAT(said, HasSubstr("3000 is not in 500..2500"));
  EXPECT_TRUE(driver.durations.empty());
}

TEST_F(SessionTest, FreeServosAreNotMoved) {
  talk("free\n1500\nquit\n");
  EXPECT_THAT(said, HasSubstr("'hold' them first"));
  EXPECT_TRUE(driver.durations.empty());
}

TEST_F(SessionTest, AUnitNeedsADistance) {
  talk("1500\nstand\nunits 20\nunits 10\nunits x\nunits 31\nquit\n");
  EXPECT_THAT(said, HasSubstr("move it further"));
  EXPECT_THAT(said, HasSubstr("units takes a number in 0..30 but 10"));
  EXPECT_EQ(calibration.joints[0].per_unit, begin.joints[0].per_unit);
}

TEST_F(SessionTest, JointsAreChosenByNameOrNumber) {
  talk("joint back right horizontal\njoint 3\njoint 9\njoint nose\nquit\n");
  EXPECT_THAT(said, HasSubstr("8 back right horizontal at"));
  EXPECT_THAT(said, HasSubstr("3 front left horizontal at"));
  EXPECT_THAT(said, HasSubstr("'9' is no joint"));
  EXPECT_THAT(said, HasSubstr("'nose' is no joint; they are 1 front left vertical"));
}

TEST_F(SessionTest, UnknownWordsAreAnsweredWithTheKnownOnes) {
  talk("dance\nquit\n");
  EXPECT_THAT(said, HasSubstr("'dance' is none of these"));
}

TEST_F(SessionTest, AFirstDraftIsAValidCalibration) {
  for (const auto family : {DeviceFamily::ssc32, DeviceFamily::dynamixel}) {
    const auto draft = first_draft(family, family == DeviceFamily::ssc32 ? 115200 : 1000000);
    EXPECT_EQ(parse_calibration(to_yaml(draft), "draft"), draft);
  }
}

}  // namespace
}  // namespace lamprey::robot_bridge::calibrate
