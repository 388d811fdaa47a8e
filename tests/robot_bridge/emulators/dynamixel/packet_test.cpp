#include "robot_bridge/emulators/dynamixel/packet.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace lamprey::robot_bridge::emulators::dynamixel {
namespace {

using Octets = std::vector<std::uint8_t>;

std::vector<Packet> decode(Decoder& decoder, const Octets& octets) {
  std::vector<Packet> packets;
  for (const std::uint8_t octet : octets) {
    if (auto packet = decoder.take(octet)) packets.push_back(*packet);
  }
  return packets;
}

// Examples of the e-manual's page on protocol 2.0.
TEST(PacketTest, ChecksumsAreThoseOfTheManual) {
  EXPECT_EQ(encode(1, Instruction::ping, {}), (Octets{0xFF, 0xFF, 0xFD, 0x00, 0x01, 0x03, 0x00, 0x01, 0x19, 0x4E}));
  EXPECT_EQ(encode_status(1, 0, Octets{0x06, 0x04, 0x26}),
            (Octets{0xFF, 0xFF, 0xFD, 0x00, 0x01, 0x07, 0x00, 0x55, 0x00, 0x06, 0x04, 0x26, 0x65, 0x5D}));
  EXPECT_EQ(encode(broadcast, Instruction::sync_write, Octets{0x74, 0, 4, 0, 1, 0x96, 0, 0, 0, 2, 0xAA, 0, 0, 0}),
            (Octets{0xFF, 0xFF, 0xFD, 0x00, 0xFE, 0x11, 0x00, 0x83, 0x74, 0x00, 0x04, 0x00,
                    0x01, 0x96, 0x00, 0x00, 0x00, 0x02, 0xAA, 0x00, 0x00, 0x00, 0x82, 0x87}));
}

TEST(PacketTest, FindsAPacketAndItsParameters) {
  Decoder decoder;
  const auto packets =
      decode(decoder, {0xFF, 0xFF, 0xFD, 0x00, 0x01, 0x09, 0x00, 0x03, 0x74, 0x00, 0x00, 0x02, 0x00, 0x00, 0xCA, 0x89});
  ASSERT_EQ(packets.size(), 1U);
  EXPECT_TRUE(packets[0].intact);
  EXPECT_EQ(packets[0].id, 1);
  EXPECT_EQ(packets[0].instruction, 0x03);
  EXPECT_EQ(packets[0].parameters, (Octets{0x74, 0x00, 0x00, 0x02, 0x00, 0x00}));
  EXPECT_EQ(decoder.skipped(), 0U);
}

TEST(PacketTest, StuffsWhatLooksLikeAHeader) {
  const auto packet = encode(3, Instruction::write, Octets{0xFF, 0xFF, 0xFD, 0x00});
  EXPECT_EQ(packet[5], 8);  // the length counts the stuffing
  EXPECT_EQ(Octets(packet.begin() + 8, packet.begin() + 13), (Octets{0xFF, 0xFF, 0xFD, 0xFD, 0x00}));
}

TEST(PacketTest, WhateverIsEncodedIsDecoded) {
  std::mt19937 random(2006);
  Decoder decoder;
  for (int round = 0; round < 20'000; ++round) {
    Octets parameters(random() % 20);
    for (auto& octet : parameters) octet = random() % 3 == 0 ? 0xFD : 0xFF;
    const auto packets =
        decode(decoder, encode(static_cast<std::uint8_t>(round % 253), Instruction::write, parameters));
    ASSERT_EQ(packets.size(), 1U);
    ASSERT_TRUE(packets[0].intact);
    ASSERT_EQ(packets[0].parameters, parameters);
  }
  EXPECT_EQ(decoder.skipped(), 0U);
}

TEST(PacketTest, FindsPacketsBetweenOtherOctets) {
  Decoder decoder;
  Octets stream{0x00, 0xFF, 0xFF, 0xFF, 0x12};
  const auto ping = encode(1, Instruction::ping, {});
  stream.insert(stream.end(), {0xFF});
  stream.insert(stream.end(), ping.begin(), ping.end());
  stream.insert(stream.end(), {0xFF, 0xFF, 0xFD, 0xFD});
  stream.insert(stream.end(), ping.begin(), ping.end());
  const auto packets = decode(decoder, stream);
  ASSERT_EQ(packets.size(), 2U);
  EXPECT_TRUE(packets[0].intact && packets[1].intact);
  EXPECT_EQ(decoder.skipped(), 10U);
}

TEST(PacketTest, APacketThatWasCutDoesNotSwallowTheNext) {
  Decoder decoder;
  auto stream = encode(1, Instruction::write, Octets{116, 0, 1, 2, 3, 4});
  stream.resize(10);
  const auto ping = encode(1, Instruction::ping, {});
  stream.insert(stream.end(), ping.begin(), ping.end());
  const auto packets = decode(decoder, stream);
  ASSERT_EQ(packets.size(), 1U);
  EXPECT_EQ(packets[0].instruction, 0x01);
  EXPECT_TRUE(packets[0].intact);
}

TEST(PacketTest, AnyFlippedBitOfAPacketIsSeen) {
  const auto good = encode(1, Instruction::write, Octets{116, 0, 0, 8, 0, 0});
  for (std::size_t bit = 8 * 7; bit < 8 * good.size(); ++bit) {
    Octets bad = good;
    bad[bit / 8] = static_cast<std::uint8_t>(bad[bit / 8] ^ (1U << (bit % 8)));
    Decoder decoder;
    const auto packets = decode(decoder, bad);
    ASSERT_EQ(packets.size(), 1U) << bit;
    EXPECT_FALSE(packets[0].intact) << bit;
  }
}

TEST(PacketTest, ImpossibleLengthsAreSkipped) {
  for (const auto& length : {Octets{0, 0}, Octets{2, 0}, Octets{0xFF, 0xFF}}) {
    Decoder decoder;
    Octets stream{0xFF, 0xFF, 0xFD, 0x00, 0x01};
    stream.insert(stream.end(), length.begin(), length.end());
    const auto ping = encode(1, Instruction::ping, {});
    stream.insert(stream.end(), ping.begin(), ping.end());
    EXPECT_EQ(decode(decoder, stream).size(), 1U);
  }
}

TEST(PacketTest, NoOctetsDoHarm) {
  std::mt19937 random(7);
  Decoder decoder;
  std::size_t found = 0;
  for (int round = 0; round < 20'000; ++round) {
    Octets parameters(random() % 12);
    std::ranges::generate(parameters, [&] { return static_cast<std::uint8_t>(random()); });
    Octets stream = encode(1, Instruction::read, parameters);
    for (auto left = random() % 3; left > 0; --left)
      stream[random() % stream.size()] = static_cast<std::uint8_t>(random());
    found += decode(decoder, stream).size();
  }
  EXPECT_GT(found, 5000U);
}

}  // namespace
}  // namespace lamprey::robot_bridge::emulators::dynamixel
