#include "robot_bridge/emulators/ssc32/ssc32.hpp"

#include <array>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <string>

namespace lamprey::robot_bridge::emulators::ssc32 {
namespace {

using namespace std::chrono_literals;

constexpr double any_speed = std::numeric_limits<double>::infinity();

class Ssc32Test : public testing::Test {
 protected:
  /// Says `line` at `time` and returns the answer's octets.
  std::string say(const std::string& line, Time time) {
    for (const char c : line + "\r") controller.receive(static_cast<std::uint8_t>(c), time);
    std::string answer;
    for (const Answer& part : controller.take_answers()) answer.append(part.octets.begin(), part.octets.end());
    return answer;
  }
  /// The pulse of channel 0 in 10 µs.
  int pulse(Time time) { return static_cast<std::uint8_t>(say("QP0", time).at(0)); }
  double position(unsigned servo, Time time) {
    return controller.state(time)["servos"][std::to_string(servo)]["position"];
  }

  Recorder recorder;
  Settings settings{.feet = {{0, 0, true, 1000}, {1, 1, false, 1800}}, .servos = {}, .position = 1500, .speed = 2000};
  Ssc32 controller{settings, recorder, 0s};
};

TEST_F(Ssc32Test, TellsItsVersionAfterTheBoardsDelays) {
  for (const char c : {'v', 'e', 'r', '\r'}) controller.receive(static_cast<std::uint8_t>(c), 1s);
  const auto answers = controller.take_answers();
  ASSERT_EQ(answers.size(), 1U);
  EXPECT_EQ(std::string(answers[0].octets.begin(), answers[0].octets.end()), "SSC32-V2.50USB\r");
  EXPECT_EQ(answers[0].asked, 1s);
  EXPECT_EQ(answers[0].delay, 600us);
  EXPECT_EQ(answers[0].gap, 70us);
}

TEST_F(Ssc32Test, PulsesAreToldInTensOfMicrosecondsAndAs0WhereOff) {
  say("#5P1500#17P750", 1s);
  EXPECT_EQ(say("QP5QP0QP17", 1s), std::string("\x96\0\x4B", 3));
}

TEST_F(Ssc32Test, MovesAreNotAnswered) {
  EXPECT_EQ(say("#0P1500T1000", 1s), "");
  EXPECT_EQ(say("#0P0", 1s), "");
  EXPECT_EQ(say("STOP0", 1s), "");
}

TEST_F(Ssc32Test, FromOffThePulseJumpsWhateverTimeAndSpeedSay) {
  say("#0P2000S1T60000", 1s);
  EXPECT_EQ(pulse(1s), 200);
}

TEST_F(Ssc32Test, AMoveIsEvenAndEndsInTime) {
  say("#0P1000", 1s);
  say("#0P2000T1000", 2s);
  EXPECT_EQ(pulse(2s), 100);
  EXPECT_EQ(pulse(2250ms), 125);
  EXPECT_EQ(say("Q", 2999ms), "+");
  EXPECT_EQ(say("Q", 3s), ".");
  EXPECT_EQ(pulse(3s), 200);
  EXPECT_EQ(pulse(100s), 200);
}

TEST_F(Ssc32Test, ANewMoveBeginsWhereTheOldOneHasGotTo) {
  say("#0P1000", 1s);
  say("#0P2000T1000", 2s);
  say("#0P1000T500", 2500ms);
  EXPECT_EQ(pulse(2500ms), 150);
  EXPECT_EQ(pulse(2750ms), 125);
  EXPECT_EQ(pulse(3s), 100);
}

// SSC-32U user guide: "The entire move will take at least 2 seconds, but ch17 will not move faster than 500 µs/s."
TEST_F(Ssc32Test, AGroupStartsAndEndsTogetherByItsSlowestMember) {
  say("#0P1500#17P2250#2P1500", 1s);
  say("#0P1600#17P750S500#2P2250T2000", 2s);  // 1500 µs at 500 µs/s: three seconds
  EXPECT_EQ(say("QP0QP17QP2", 3500ms), std::string("\x9B\x96\xBC", 3));
  EXPECT_EQ(say("Q", 4999ms), "+");
  EXPECT_EQ(say("QP0QP17QP2", 5s), std::string("\xA0\x4B\xE1", 3));
  EXPECT_EQ(say("Q", 5s), ".");
}

TEST_F(Ssc32Test, WithoutTimeAndSpeedAMoveIsAJump) {
  say("#0P1000", 1s);
  say("#0P2000", 2s);
  EXPECT_EQ(pulse(2s), 200);
}

TEST_F(Ssc32Test, AStoppedServoStaysWhileItsGroupGoesOn) {
  say("#0P1000#1P1000", 1s);
  say("#0P2000#1P2000T1000", 2s);
  say("STOP0", 2500ms);
  EXPECT_EQ(say("QP0QP1", 3s), "\x96\xC8");
  EXPECT_EQ(say("Q", 2900ms), "+");
}

TEST_F(Ssc32Test, PulseWidth0TurnsAServoOff) {
  say("#0P1200", 1s);
  say("#0P0", 2s);
  EXPECT_EQ(pulse(2s), 0);
  say("#0P1800T1000", 3s);
  EXPECT_EQ(pulse(3s), 180);
}

TEST_F(Ssc32Test, TheServoFollowsThePulseAsFastAsItCanAndNoFaster) {
  say("#0P1900", 1s);
  EXPECT_NEAR(position(0, 1100ms), 1700, 2);
  EXPECT_EQ(position(0, 1200ms), 1900);
  say("#0P1800T100", 2s);
  EXPECT_NEAR(position(0, 2050ms), 1850, 1);
}

TEST_F(Ssc32Test, AnOverloadedServoStandsStillUntilTheLoadIsGone) {
  say("#0P1500", 1s);
  controller.overload(0, true, 2s);
  say("#0P1000", 2s);
  EXPECT_EQ(pulse(3s), 100);  // the controller does not know
  EXPECT_EQ(position(0, 3s), 1500);
  controller.overload(0, false, 3s);
  EXPECT_EQ(position(0, 4s), 1000);
  EXPECT_THROW(controller.overload(32, true, 4s), std::invalid_argument);
}

TEST_F(Ssc32Test, AFootIsSeenWhenItHasTouchedFor15Milliseconds) {
  say("#0P1500", 1s);
  EXPECT_EQ(say("AC", 2s), "11");
  say("#0P1000", 2s);  // 500 µs at 2000 µs/s: the foot is down after 250 ms
  EXPECT_EQ(say("A", 2s + 249ms + 14ms), "1");
  EXPECT_EQ(say("A", 2s + 250ms + 15ms), "0");
  say("#0P1500", 3s);
  EXPECT_EQ(say("A", 3s + 15ms), "0");
  EXPECT_EQ(say("A", 3s + 17ms), "1");
}

TEST_F(Ssc32Test, ATouchShorterThan15MillisecondsIsNotSeen) {
  say("#0P1010", 1s);
  say("#0P1000T4", 2s);
  say("#0P1010T4", 2008ms);
  EXPECT_EQ(say("AAL", 3s), "11");
}

TEST_F(Ssc32Test, AFootMayTouchAtOrAboveItsThreshold) {
  say("#1P1900", 1s);
  EXPECT_EQ(say("B", 2s), "0");
  say("#1P1700", 2s);
  EXPECT_EQ(say("B", 3s), "1");
}

TEST_F(Ssc32Test, ALatchRemembersATouchUntilItIsRead) {
  say("#0P1500", 1s);
  EXPECT_EQ(say("AL", 2s), "1");
  say("#0P1000", 2s);
  controller.state(3s);
  say("#0P1500", 3s);
  EXPECT_EQ(say("A", 4s), "1");
  EXPECT_EQ(say("AL", 4s), "0");
  EXPECT_EQ(say("AL", 4s), "1");
}

TEST_F(Ssc32Test, ALatchStaysLowWhileTheFootTouches) {
  say("#0P1000", 1s);
  EXPECT_EQ(say("AL", 2s), "0");
  EXPECT_EQ(say("AL", 3s), "0");
}

TEST_F(Ssc32Test, TheFirstAnalogReadingOfAPinIsWorthless) {
  say("#0P1000", 1s);
  say("VA", 2s);
  EXPECT_EQ(say("VAVB", 3s).at(0), '\0');
  EXPECT_EQ(say("VB", 3s), "\xFF");
}

TEST_F(Ssc32Test, EscapeCancelsALine) {
  say("#0P1200", 1s);
  EXPECT_EQ(say("#0P1800\x1BQ", 2s), ".");
  EXPECT_EQ(pulse(2s), 120);
  EXPECT_EQ(recorder.refusals(), 0U);
}

TEST_F(Ssc32Test, BadCommandsAreDroppedWholeInSilenceAndCounted) {
  say("#0P1200", 1s);
  EXPECT_EQ(say("#0P1800#1P9999", 2s), "");
  EXPECT_EQ(say("nonsense", 2s), "");
  EXPECT_EQ(say(std::string(2000, '#'), 2s), "");
  EXPECT_EQ(pulse(2s), 120);
  EXPECT_EQ(recorder.report()["refused"], (nlohmann::json{{"command", 1}, {"length", 1}, {"pulse width", 1}}));
}

TEST_F(Ssc32Test, ResetTurnsAllOffAndLeavesThemWhereTheyStand) {
  say("#0P1000#1P1200T100", 1s);
  controller.overload(1, true, 1s);
  controller.reset(3s);
  EXPECT_EQ(say("QP0QP1", 3s), std::string("\0\0", 2));
  EXPECT_EQ(position(0, 3s), 1000);
  EXPECT_EQ(say("A", 3s), "0");
  EXPECT_EQ(controller.state(3s)["servos"]["1"]["overloaded"], false);
}

TEST_F(Ssc32Test, AServoCanBePlacedByHandOnlyWhileItIsOff) {
  controller.place(0, 900, 1s);
  EXPECT_EQ(say("A", 1100ms), "0");
  say("#0P1500", 2s);
  EXPECT_EQ(recorder.report()["servos"]["0"]["largest_jump"], 600.0);
  EXPECT_THROW(controller.place(0, 1000, 3s), std::invalid_argument);
  EXPECT_THROW(controller.place(1, 499, 3s), std::invalid_argument);
}

TEST_F(Ssc32Test, LongQuietIsNoWork) {
  say("#0P1000T1000", 1s);
  EXPECT_EQ(say("A", 1s + std::chrono::hours{24 * 365}), "0");
}

TEST_F(Ssc32Test, TellsItsState) {
  say("#0P1000", 1s);
  say("#0P1600T1000", 2s);
  const auto state = controller.state(2500ms);
  EXPECT_EQ(state["servos"]["0"]["on"], true);
  EXPECT_NEAR(state["servos"]["0"]["pulse"], 1300, 0.01);
  EXPECT_EQ(state["servos"]["0"]["target"], 1600.0);
  EXPECT_EQ(state["moving"], true);
  EXPECT_EQ(state["contacts"], (nlohmann::json{{"A", false}, {"B", false}}));
}

TEST(Ssc32InstantTest, AServoWithoutLimitIsWhereItsPulseIs) {
  Recorder recorder;
  Ssc32 controller({.feet = {}, .servos = {}, .position = 1500, .speed = any_speed}, recorder, 0s);
  for (const char c : std::string("#0P2500\r")) controller.receive(static_cast<std::uint8_t>(c), 1s);
  EXPECT_EQ(controller.state(1001ms)["servos"]["0"]["position"], 2500.0);
}

TEST_F(Ssc32Test, RandomCommandsAndOctetsMoveNothingBeyondItsLimits) {
  std::mt19937 random(7);
  constexpr std::array<std::string_view, 14> parts{"#0P1500", "#31P2500", "#7P501", "#7P0", "#3P2600", "S100", "T20",
                                                   "QP7",     "AL",       "VA",     "\x1B", "\r",      "\r",   "\r"};
  Time time = 1s;
  for (int count = 0; count < 50'000; ++count) {
    std::string octets(parts[random() % parts.size()]);
    if (random() % 16 == 0) octets[random() % octets.size()] = static_cast<char>(random());
    for (const char octet : octets) {
      time += 87us;
      controller.receive(static_cast<std::uint8_t>(octet), time);
    }
    controller.take_answers();
  }
  EXPECT_GT(recorder.refusals(), 1000U);
  const auto state = controller.state(time);
  ASSERT_FALSE(state["servos"].empty());
  for (const auto& servo : state["servos"]) {
    EXPECT_GE(servo["position"], 500.0);
    EXPECT_LE(servo["position"], 2500.0);
  }
  const auto report = recorder.report();
  for (const char* servo : {"0", "7", "31"}) EXPECT_GT(report["servos"][servo]["moves"], 100) << servo;
}

}  // namespace
}  // namespace lamprey::robot_bridge::emulators::ssc32
