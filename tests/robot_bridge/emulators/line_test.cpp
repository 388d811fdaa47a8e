#include "robot_bridge/emulators/line.hpp"

#include "echo_controller.hpp"

#include <gtest/gtest.h>

namespace lamprey::robot_bridge::emulators {
namespace {

using namespace std::chrono_literals;
using Octets = std::vector<std::uint8_t>;

class LineTest : public testing::Test {
 protected:
  EchoController controller;
  Line line{controller, 1'000'000, 1};
};

TEST_F(LineTest, AnOctetIsActedUponWhenItsStopBitHasComeAndNotBefore) {
  line.sent(Octets{10, 20}, 1s);
  EXPECT_TRUE(line.run(1s + 9us).empty());
  EXPECT_TRUE(controller.received.empty());
  line.run(1s + 15us);
  ASSERT_EQ(controller.received.size(), 1U);
  EXPECT_EQ(line.waiting(), 1U);
  // However late the program wakes, the time is the line's.
  line.run(2s);
  ASSERT_EQ(controller.received.size(), 2U);
  EXPECT_EQ(controller.received[1], (std::pair{std::uint8_t{20}, Time{1s + 20us}}));
}

TEST_F(LineTest, AnswersLeaveAtTheLinesPaceOneAfterTheOther) {
  line.sent(Octets{10, 20}, 0s);
  EXPECT_TRUE(line.run(20us).empty());
  EXPECT_EQ(line.run(129us), (Octets{10}));  // 10 + 100 + 10, then 130
  EXPECT_EQ(line.run(130us), (Octets{11}));
  EXPECT_TRUE(line.run(239us).empty());  // 100 more once the line is free
  EXPECT_EQ(line.run(250us), (Octets{20, 21}));
}

TEST_F(LineTest, TellsWhenToRunNext) {
  EXPECT_FALSE(line.next());
  line.sent(Octets{10}, 0s);
  EXPECT_EQ(line.next(), 10us);
  line.run(10us);
  EXPECT_EQ(line.next(), 130us);
  line.run(130us);
  EXPECT_FALSE(line.next());
}

TEST_F(LineTest, FaultsAreInTheWayOfAnswersOnly) {
  line.faults().silence = true;
  line.sent(Octets{10}, 0s);
  EXPECT_TRUE(line.run(1s).empty());
  EXPECT_EQ(controller.received.size(), 1U);
  line.faults().clear();
  line.faults().slow = 5ms;
  line.sent(Octets{10}, 1s);
  EXPECT_TRUE(line.run(1s + 5ms).empty());
  EXPECT_EQ(line.run(1s + 5130us), (Octets{10, 11}));
}

TEST_F(LineTest, WhatIsOnTheWayWhenTheLineIsCutIsLost) {
  line.sent(Octets{10}, 0s);
  line.run(10us);
  line.sent(Octets{20}, 10us);
  line.cut();
  EXPECT_TRUE(line.run(1s).empty());
  EXPECT_EQ(controller.received.size(), 1U);
  EXPECT_EQ(controller.disconnections, 1);
}

TEST_F(LineTest, CountsOctetsInBothDirections) {
  line.sent(Octets{1, 2, 3}, 0s);
  line.run(1s);
  line.sent_at_another_speed(7);
  line.overrun(2);
  const auto report = line.report();
  EXPECT_EQ(report["octets_received"], 3);
  EXPECT_EQ(report["octets_answered"], 6);
  EXPECT_EQ(report["peak_octets_received_per_second"], 3);
  EXPECT_EQ(report["peak_octets_answered_per_second"], 6);
  EXPECT_EQ(report["octets_at_another_speed"], 7);
  EXPECT_EQ(report["octets_overrun"], 2);
}

}  // namespace
}  // namespace lamprey::robot_bridge::emulators
