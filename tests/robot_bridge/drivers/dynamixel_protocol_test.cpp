#include "robot_bridge/drivers/dynamixel_protocol.hpp"

#include <charconv>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sstream>

namespace lamprey::robot_bridge::drivers::dynamixel {
namespace {

using Kind = StatusDecoder::Kind;

Octets hex(const std::string& text) {
  Octets octets;
  std::istringstream stream(text);
  for (std::string pair; stream >> pair;) octets.push_back(static_cast<std::uint8_t>(std::stoul(pair, nullptr, 16)));
  return octets;
}

Octets joined(std::initializer_list<Octets> parts) {
  Octets all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

/// All packets that the decoder finds, and at its end how many were garbled.
std::pair<std::vector<StatusPacket>, int> decoded(const Octets& octets, std::size_t chunk) {
  StatusDecoder decoder;
  std::vector<StatusPacket> packets;
  int garbled = 0;
  for (std::size_t begin = 0; begin < octets.size(); begin += chunk) {
    decoder.add(std::span(octets).subspan(begin, std::min(chunk, octets.size() - begin)));
    for (auto result = decoder.next(); result.kind != Kind::incomplete; result = decoder.next()) {
      if (result.kind == Kind::status) packets.push_back(result.status);
      garbled += result.kind == Kind::garbled ? 1 : 0;
    }
  }
  return {packets, garbled};
}

// The examples of the e-Manual's page on Protocol 2.0.
TEST(DynamixelProtocol, SendsTheManualsInstructions) {
  EXPECT_EQ(ping(1), hex("FF FF FD 00 01 03 00 01 19 4E"));
  EXPECT_EQ(ping(broadcast_id), hex("FF FF FD 00 FE 03 00 01 31 42"));
  EXPECT_EQ(read(1, present_position), hex("FF FF FD 00 01 07 00 02 84 00 04 00 1D 15"));
  EXPECT_EQ(write(1, goal_position, 512), hex("FF FF FD 00 01 09 00 03 74 00 00 02 00 00 CA 89"));
  const Octets ids = {1, 2};
  EXPECT_EQ(sync_read(present_position, ids), hex("FF FF FD 00 FE 09 00 82 84 00 04 00 01 02 CE FA"));
  const std::vector<SyncValue> goals = {{1, hex("96 00 00 00")}, {2, hex("AA 00 00 00")}};
  EXPECT_EQ(sync_write(goal_position.address, goals),
            hex("FF FF FD 00 FE 11 00 83 74 00 04 00 01 96 00 00 00 02 AA 00 00 00 82 87"));
}

TEST(DynamixelProtocol, ReadsTheManualsAnswers) {
  const Octets answers = joined({hex("FF FF FD 00 01 07 00 55 00 06 04 26 65 5D"),       // ping
                                 hex("FF FF FD 00 01 04 00 55 00 A1 0C"),                // write
                                 hex("FF FF FD 00 01 08 00 55 00 A6 00 00 00 8C C0"),    // sync read, first
                                 hex("FF FF FD 00 02 08 00 55 00 1F 08 00 00 BA BE")});  // and second
  const std::vector<StatusPacket> expected = {
      {1, 0, hex("06 04 26")}, {1, 0, {}}, {1, 0, hex("A6 00 00 00")}, {2, 0, hex("1F 08 00 00")}};
  for (std::size_t chunk = 1; chunk <= answers.size(); ++chunk) {
    const auto [packets, garbled] = decoded(answers, chunk);
    EXPECT_EQ(packets, expected) << "in chunks of " << chunk;
    EXPECT_EQ(garbled, 0);
  }
  EXPECT_EQ(value_of(expected[3].parameters), 2079U);
}

TEST(DynamixelProtocol, EncodesAnswersAsServosDo) {
  EXPECT_EQ(encode({1, 0, hex("A6 00 00 00")}), hex("FF FF FD 00 01 08 00 55 00 A6 00 00 00 8C C0"));
}

TEST(DynamixelProtocol, StuffsHeadersWithinPackets) {
  const auto packet = write(1, goal_position, 0x00FDFFFF);
  EXPECT_EQ(Octets(packet.begin(), packet.end() - 2), hex("FF FF FD 00 01 0A 00 03 74 00 FF FF FD FD 00"));
  for (const char* parameters : {"FF FF FD", "FF FF FD FD", "FF FF FD 00 FF FF FD", "FF FF FF FD FD FF", "FF FF"}) {
    const StatusPacket status{7, 0, hex(parameters)};
    const auto [packets, garbled] = decoded(encode(status), 1);
    EXPECT_EQ(packets, std::vector{status}) << parameters;
    EXPECT_EQ(garbled, 0) << parameters;
  }
}

TEST(DynamixelProtocol, FindsPacketsBetweenNoiseAndParts) {
  const StatusPacket status{3, 0, hex("01 02 03 04")};
  const Octets packet = encode(status);
  const Octets part(packet.begin(), packet.begin() + 3);
  for (const char* noise : {"00", "FF", "FF FF", "FF FF FD", "FF FF FF", "FD 00 FF FF FD", "55 AA 55 AA 55"}) {
    for (std::size_t chunk : {1U, 4U, 64U}) {
      const auto [packets, garbled] = decoded(joined({hex(noise), packet, part, packet}), chunk);
      EXPECT_EQ(packets, (std::vector{status, status})) << noise;
      EXPECT_EQ(garbled, 0) << noise;
    }
  }
}

TEST(DynamixelProtocol, SkipsHeadersWithALengthThatNobodySends) {
  const StatusPacket status{3, 0, {}};
  EXPECT_EQ(decoded(joined({hex("FF FF FD 00 01 FF FF"), encode(status)}), 1).first, std::vector{status});
  EXPECT_EQ(decoded(joined({hex("FF FF FD 00 01 02 00"), encode(status)}), 1).first, std::vector{status});
}

TEST(DynamixelProtocol, TellsAWrongChecksumAndReadsWhatFollows) {
  const StatusPacket status{3, 0, hex("01 02 03 04")};
  for (std::size_t octet = 7; octet < encode(status).size(); ++octet) {
    Octets wrong = encode(status);
    wrong[octet] ^= 0x10;
    const auto [packets, garbled] = decoded(joined({wrong, encode(status)}), 5);
    EXPECT_EQ(packets, std::vector{status});
    EXPECT_EQ(garbled, 1);
  }
}

TEST(DynamixelProtocol, TakesAnEchoOfAnInstructionForNoAnswer) {
  const StatusPacket status{1, 0, hex("06 04 26")};
  EXPECT_EQ(decoded(joined({ping(1), encode(status)}), 3).first, std::vector{status});
}

TEST(DynamixelProtocol, NamesErrors) {
  EXPECT_EQ(error_text(0), "");
  EXPECT_EQ(error_text(alert_bit), "");
  EXPECT_EQ(error_text(1), "result fail");
  EXPECT_EQ(error_text(alert_bit | 7), "access error");
  EXPECT_EQ(error_text(9), "error 9");
  EXPECT_EQ(hardware_error_text(0b100100), "overheating, overload");
  EXPECT_EQ(hardware_error_text(1), "input voltage");
}

}  // namespace
}  // namespace lamprey::robot_bridge::drivers::dynamixel
