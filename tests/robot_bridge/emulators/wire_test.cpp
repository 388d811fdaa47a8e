#include "robot_bridge/emulators/wire.hpp"

#include <gtest/gtest.h>
#include <numeric>

namespace lamprey::robot_bridge::emulators {
namespace {

using namespace std::chrono_literals;

std::vector<std::uint8_t> octets(std::size_t count) {
  std::vector<std::uint8_t> result(count);
  std::iota(result.begin(), result.end(), std::uint8_t{0});
  return result;
}

TEST(WireTest, AnEightServoMoveTakesTheTimeOfItsTenBitsAnOctet) {
  for (const auto& [baud, whole] : {std::pair{9600U, 63541666ns}, {38400U, 15885416ns}, {115200U, 5295138ns}}) {
    Wire wire(baud);
    wire.send(octets(61), 1s);
    EXPECT_EQ(wire.free_at(), 1s + whole) << baud;
    EXPECT_EQ(wire.take(1s + whole - 1ns).size(), 60U);
    EXPECT_EQ(wire.take(1s + whole).size(), 1U);
  }
}

TEST(WireTest, OctetsArriveInOrderEachWithItsOwnTime) {
  Wire wire(1'000'000);
  wire.send(octets(3), 1ms);
  const auto arrived = wire.take(2ms);
  ASSERT_EQ(arrived.size(), 3U);
  for (std::uint8_t i = 0; i < 3; ++i) {
    EXPECT_EQ(arrived[i].value, i);
    EXPECT_EQ(arrived[i].time, 1ms + (i + 1) * 10us);
  }
  EXPECT_EQ(wire.waiting(), 0U);
}

TEST(WireTest, WhatIsSentWhileTheWireIsBusyWaits) {
  Wire wire(1'000'000);
  wire.send(octets(10), 0us);
  wire.send(octets(1), 50us);
  EXPECT_EQ(wire.free_at(), 110us);
  wire.send(octets(1), 1ms);
  EXPECT_EQ(wire.free_at(), 1010us);
}

TEST(WireTest, PausesLieBetweenOctetsOnly) {
  Wire wire(1'000'000);
  wire.send(octets(3), 0us, 70us);
  EXPECT_EQ(wire.free_at(), 30us + 2 * 70us);
}

TEST(WireTest, RoundingDoesNotAddUp) {
  Wire wire(115200);
  wire.send(octets(11520), 0s);
  EXPECT_EQ(wire.free_at(), 1s);
}

TEST(WireTest, OneWakesOncePerMillisecondAndForTheLastOctet) {
  Wire wire(1'000'000);
  EXPECT_FALSE(wire.next());
  wire.send(octets(250), 0s);
  EXPECT_EQ(wire.next(), 1010us);  // from the first octet's end, so much later
  wire.take(*wire.next());
  EXPECT_EQ(wire.next(), 2020us);
  wire.take(*wire.next());
  EXPECT_EQ(wire.next(), 2500us);
  wire.take(*wire.next());
  EXPECT_FALSE(wire.next());
}

TEST(WireTest, ACutWireIsEmptyAndFree) {
  Wire wire(9600);
  wire.send(octets(100), 0s);
  wire.clear();
  EXPECT_FALSE(wire.next());
  wire.send(octets(1), 5ms);
  EXPECT_EQ(wire.free_at(), 5ms + 1041666ns);
}

}  // namespace
}  // namespace lamprey::robot_bridge::emulators
