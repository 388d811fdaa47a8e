#include "robot_bridge/drivers/ssc32_protocol.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lamprey::robot_bridge::drivers::ssc32 {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;
using testing::ElementsAre;
using testing::Optional;

std::vector<std::uint8_t> octets(const std::string& text) {
  return {text.begin(), text.end()};
}

// The user guide's example of a group move, without the optional spaces.
TEST(Ssc32Protocol, MovesServosAsAGroup) {
  const std::vector<ServoPulse> servos = {{5, 1600}, {10, 750}};
  EXPECT_EQ(move_command(servos, milliseconds(2500)), "#5P1600#10P750T2500\r");
}

TEST(Ssc32Protocol, SendsAnEightServoMoveIn61Octets) {
  std::vector<ServoPulse> servos;
  for (std::int32_t channel = 0; channel < 8; ++channel) servos.push_back({channel, 1500});
  EXPECT_EQ(move_command(servos, milliseconds(100)), "#0P1500#1P1500#2P1500#3P1500#4P1500#5P1500#6P1500#7P1500T100\r");
  EXPECT_EQ(move_command(servos, milliseconds(100)).size(), 61U);
}

TEST(Ssc32Protocol, RoundsTimesToMillisecondsWithinTheDevicesRange) {
  const std::vector<ServoPulse> servo = {{0, 1500}};
  EXPECT_EQ(move_command(servo, microseconds(20'400)), "#0P1500T20\r");
  EXPECT_EQ(move_command(servo, microseconds(20'600)), "#0P1500T21\r");
  EXPECT_EQ(move_command(servo, microseconds(0)), "#0P1500T1\r");
  EXPECT_EQ(move_command(servo, microseconds(-5)), "#0P1500T1\r");
  EXPECT_EQ(move_command(servo, std::chrono::hours(1)), "#0P1500T65535\r");
}

TEST(Ssc32Protocol, WritesTheOtherCommandsAsInTheUserGuide) {
  const std::vector<ServoPulse> servos = {{0, 1500}, {31, 600}};
  const std::vector<std::int32_t> channels = {0, 31};
  EXPECT_EQ(version_query(), "\x1bVER\r");
  EXPECT_EQ(start_command(servos), "#0P1500#31P600\r");
  EXPECT_EQ(stop_commands(channels), "STOP0\rSTOP31\r");
  EXPECT_EQ(release_command(channels), "\x1b#0P0#31P0\r");
  EXPECT_EQ(pulse_query(channels), "QP0QP31\r");
  EXPECT_EQ(input_query(std::vector<std::int32_t>{0, 1, 4, 3}), "ABED\r");
  EXPECT_EQ(input_query({}), "");
}

TEST(Ssc32Protocol, KnowsTheVersionOfAnSsc32Only) {
  EXPECT_THAT(version_of(octets("SSC32-V2.50USB")), Optional(std::string("SSC32-V2.50USB")));
  EXPECT_EQ(version_of(octets("GRBL 1.1")), std::nullopt);
  EXPECT_EQ(version_of(octets("xSSC32")), std::nullopt);
  EXPECT_EQ(version_of(octets("SSC32\x80")), std::nullopt);
  EXPECT_EQ(version_of({}), std::nullopt);
}

// The user guide: a pulse of 1500 µs is answered by the octet 150.
TEST(Ssc32Protocol, ReadsPulsesInTensOfMicroseconds) {
  const std::vector<std::uint8_t> answer = {150, 50, 250, 0};
  EXPECT_THAT(tens_of_microseconds(answer), Optional(ElementsAre(150, 50, 250, 0)));
  for (const int none : {1, 49, 251, 255}) {
    const std::vector<std::uint8_t> noise = {150, static_cast<std::uint8_t>(none)};
    EXPECT_EQ(tens_of_microseconds(noise), std::nullopt) << none;
  }
}

TEST(Ssc32Protocol, ReadsInputsAsDigits) {
  EXPECT_THAT(input_levels(octets("1001")), Optional(ElementsAre(true, false, false, true)));
  EXPECT_EQ(input_levels(octets("10a1")), std::nullopt);
  EXPECT_THAT(input_levels({}), Optional(ElementsAre()));
}

TEST(Ssc32Protocol, RecognisesAPulseRoundedOrCutOff) {
  EXPECT_TRUE(tells_pulse(150, 1500));
  EXPECT_TRUE(tells_pulse(150, 1509));
  EXPECT_TRUE(tells_pulse(151, 1505));
  EXPECT_FALSE(tells_pulse(151, 1504));
  EXPECT_FALSE(tells_pulse(149, 1500));
}

}  // namespace
}  // namespace lamprey::robot_bridge::drivers::ssc32
