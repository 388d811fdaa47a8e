#include "robot_bridge/emulators/dynamixel/bus.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <random>
#include <stdexcept>

namespace lamprey::robot_bridge::emulators::dynamixel {
namespace {

using namespace std::chrono_literals;
using Octets = std::vector<std::uint8_t>;

Octets little_endian(std::int64_t value, std::size_t octets) {
  Octets result;
  for (std::size_t i = 0; i < octets; ++i) {
    result.push_back(static_cast<std::uint8_t>(static_cast<std::uint64_t>(value) >> (8 * i)));
  }
  return result;
}

class BusTest : public testing::Test {
 protected:
  /// Sends octets at `time`; the octets of all answers, one after the other.
  Octets send(const Octets& octets, Time time) {
    for (const std::uint8_t octet : octets) bus.receive(octet, time);
    Octets all;
    for (const Answer& answer : bus.take_answers()) all.insert(all.end(), answer.octets.begin(), answer.octets.end());
    return all;
  }
  /// The answering packets; their first parameter is the error.
  std::vector<Packet> ask(std::uint8_t id, Instruction instruction, const Octets& parameters, Time time) {
    Decoder decoder;
    std::vector<Packet> packets;
    for (const std::uint8_t octet : send(encode(id, instruction, parameters), time)) {
      if (auto packet = decoder.take(octet)) packets.push_back(*packet);
    }
    return packets;
  }
  /// The error octet.
  int write(std::uint8_t id, std::uint16_t address, std::int64_t value, std::size_t octets, Time time) {
    Octets parameters = little_endian(address, 2);
    const Octets number = little_endian(value, octets);
    parameters.insert(parameters.end(), number.begin(), number.end());
    const auto packets = ask(id, Instruction::write, parameters, time);
    return packets.size() == 1 ? packets[0].parameters.at(0) : -1;
  }
  std::int64_t read(std::uint8_t id, std::uint16_t address, std::uint8_t octets, Time time) {
    const auto packets = ask(id, Instruction::read, {static_cast<std::uint8_t>(address), 0, octets, 0}, time);
    std::int64_t value = 0;
    for (std::size_t i = 0; i < octets; ++i) {
      value |= static_cast<std::int64_t>(packets.at(0).parameters.at(1 + i)) << (8 * i);
    }
    return value;
  }
  /// Turned on, at rest at the position it has.
  void enable(std::uint8_t id, Time time) { EXPECT_EQ(write(id, torque_enable, 1, 1, time), 0); }

  Recorder recorder;
  Settings settings{.servos = {1, 2},
                    .servo = {.firmware = 38, .baud_register = 3, .position = 2048, .speed = 5000},
                    .feet = {{0, 1, true, 2048}, {3, 2, false, 3000}},
                    .board = Board{200, 10}};
  Bus bus{settings, recorder, 0s};
};

// The exchanges of the e-manual's page on protocol 2.0.
TEST_F(BusTest, AnswersAPingAsTheManualSays) {
  EXPECT_EQ(send({0xFF, 0xFF, 0xFD, 0x00, 0x01, 0x03, 0x00, 0x01, 0x19, 0x4E}, 1s),
            (Octets{0xFF, 0xFF, 0xFD, 0x00, 0x01, 0x07, 0x00, 0x55, 0x00, 0x06, 0x04, 0x26, 0x65, 0x5D}));
}

TEST_F(BusTest, AllAnswerAPingForAllByTheirIds) {
  const Octets both{0xFF, 0xFF, 0xFD, 0x00, 0x01, 0x07, 0x00, 0x55, 0x00, 0x06, 0x04, 0x26, 0x65, 0x5D,
                    0xFF, 0xFF, 0xFD, 0x00, 0x02, 0x07, 0x00, 0x55, 0x00, 0x06, 0x04, 0x26, 0x6F, 0x6D};
  auto answer = send({0xFF, 0xFF, 0xFD, 0x00, 0xFE, 0x03, 0x00, 0x01, 0x31, 0x42}, 1s);
  ASSERT_GT(answer.size(), both.size());  // the board comes last
  answer.resize(both.size());
  EXPECT_EQ(answer, both);
}

TEST_F(BusTest, AnswersAReadAndASyncReadAsTheManualSays) {
  bus.place(1, 166, 1s);
  bus.place(2, 2079, 1s);
  const Octets first{0xFF, 0xFF, 0xFD, 0x00, 0x01, 0x08, 0x00, 0x55, 0x00, 0xA6, 0x00, 0x00, 0x00, 0x8C, 0xC0};
  const Octets second{0xFF, 0xFF, 0xFD, 0x00, 0x02, 0x08, 0x00, 0x55, 0x00, 0x1F, 0x08, 0x00, 0x00, 0xBA, 0xBE};
  EXPECT_EQ(send({0xFF, 0xFF, 0xFD, 0x00, 0x01, 0x07, 0x00, 0x02, 0x84, 0x00, 0x04, 0x00, 0x1D, 0x15}, 2s), first);
  Octets both = first;
  both.insert(both.end(), second.begin(), second.end());
  EXPECT_EQ(send({0xFF, 0xFF, 0xFD, 0x00, 0xFE, 0x09, 0x00, 0x82, 0x84, 0x00, 0x04, 0x00, 0x01, 0x02, 0xCE, 0xFA}, 2s),
            both);
}

TEST_F(BusTest, AnswersAWriteARegWriteAndAnActionAsTheManualSays) {
  const Octets done{0xFF, 0xFF, 0xFD, 0x00, 0x01, 0x04, 0x00, 0x55, 0x00, 0xA1, 0x0C};
  EXPECT_EQ(send({0xFF, 0xFF, 0xFD, 0x00, 0x01, 0x09, 0x00, 0x03, 0x74, 0x00, 0x00, 0x02, 0x00, 0x00, 0xCA, 0x89}, 1s),
            done);
  EXPECT_EQ(read(1, goal_position, 4, 1s), 512);
  EXPECT_EQ(send({0xFF, 0xFF, 0xFD, 0x00, 0x01, 0x09, 0x00, 0x04, 0x68, 0x00, 0xC8, 0x00, 0x00, 0x00, 0xAE, 0x8E}, 1s),
            done);
  EXPECT_EQ(read(1, goal_velocity, 4, 1s), 0);
  EXPECT_EQ(read(1, registered_instruction, 1, 1s), 1);
  EXPECT_EQ(send({0xFF, 0xFF, 0xFD, 0x00, 0x01, 0x03, 0x00, 0x05, 0x02, 0xCE}, 1s), done);
  EXPECT_EQ(read(1, goal_velocity, 4, 1s), 200);
  EXPECT_EQ(read(1, registered_instruction, 1, 1s), 0);
  EXPECT_EQ(ask(1, Instruction::action, {}, 1s)[0].parameters[0], 2);  // nothing is registered any more
}

TEST_F(BusTest, ASyncWriteIsNotAnswered) {
  EXPECT_TRUE(send({0xFF, 0xFF, 0xFD, 0x00, 0xFE, 0x11, 0x00, 0x83, 0x74, 0x00, 0x04, 0x00,
                    0x01, 0x96, 0x00, 0x00, 0x00, 0x02, 0xAA, 0x00, 0x00, 0x00, 0x82, 0x87},
                   1s)
                  .empty());
  EXPECT_EQ(read(1, goal_position, 4, 1s), 150);
  EXPECT_EQ(read(2, goal_position, 4, 1s), 170);
}

TEST_F(BusTest, AnswersABulkReadAsTheManualAsks) {
  const auto packets = ask(broadcast, Instruction::bulk_read, {1, 0x90, 0, 2, 0, 2, 0x92, 0, 1, 0}, 1s);
  ASSERT_EQ(packets.size(), 2U);
  EXPECT_EQ(packets[0].parameters, (Octets{0, 120, 0}));
  EXPECT_EQ(packets[1].parameters, (Octets{0, 35}));
  ask(broadcast, Instruction::bulk_write, {1, 116, 0, 4, 0, 1, 2, 0, 0, 2, 112, 0, 4, 0, 9, 0, 0, 0}, 1s);
  EXPECT_EQ(read(1, goal_position, 4, 1s), 513);
  EXPECT_EQ(read(2, profile_velocity, 4, 1s), 9);
}

TEST_F(BusTest, EachAnswerWaitsForTheReturnDelay) {
  EXPECT_EQ(write(2, return_delay_time, 0, 1, 1s), 0);
  for (const std::uint8_t octet : encode(broadcast, Instruction::sync_read, Octets{132, 0, 4, 0, 1, 2})) {
    bus.receive(octet, 1s);
  }
  const auto answers = bus.take_answers();
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(answers[0].delay, 500us);
  EXPECT_EQ(answers[1].delay, 0us);
}

TEST_F(BusTest, RefusalsHaveTheManualsNumbers) {
  EXPECT_EQ(write(1, goal_position, 4096, 4, 1s), 4);
  EXPECT_EQ(write(1, goal_position, -1, 4, 1s), 4);
  EXPECT_EQ(write(1, goal_position, 100, 2, 1s), 5);
  EXPECT_EQ(write(1, present_position, 100, 4, 1s), 7);
  EXPECT_EQ(write(1, 500, 1, 1, 1s), 7);
  EXPECT_EQ(ask(1, static_cast<Instruction>(0x77), {}, 1s)[0].parameters[0], 2);
  EXPECT_EQ(ask(1, Instruction::read, {132, 0, 4}, 1s)[0].parameters[0], 5);
  EXPECT_EQ(ask(1, Instruction::read, {0, 4, 4, 0}, 1s)[0].parameters[0], 7);
  EXPECT_EQ(write(1, min_position_limit, 1000, 4, 1s), 0);
  EXPECT_EQ(write(1, max_position_limit, 3000, 4, 1s), 0);
  EXPECT_EQ(write(1, goal_position, 999, 4, 1s), 4);
  EXPECT_EQ(write(1, goal_position, 3001, 4, 1s), 4);
  EXPECT_EQ(write(1, goal_position, 3000, 4, 1s), 0);
  EXPECT_EQ(recorder.report()["refused"],
            (nlohmann::json{
                {"access error", 3}, {"data length error", 2}, {"data range error", 4}, {"instruction error", 1}}));
}

TEST_F(BusTest, ADamagedPacketIsAnsweredByWhomItIsForAndByNobodyIfItIsForAll) {
  auto ping = encode(1, Instruction::ping, {});
  ping.back() ^= 1;
  Decoder decoder;
  std::optional<Packet> status;
  for (const std::uint8_t octet : send(ping, 1s)) status = decoder.take(octet);
  ASSERT_TRUE(status);
  EXPECT_EQ(status->parameters[0], 3);
  auto for_all = encode(broadcast, Instruction::ping, {});
  for_all.back() ^= 1;
  EXPECT_TRUE(send(for_all, 1s).empty());
  EXPECT_EQ(recorder.report()["refused"]["CRC error"], 2);
}

TEST_F(BusTest, NobodyAnswersForAnotherId) {
  EXPECT_TRUE(ask(3, Instruction::ping, {}, 1s).empty());
  EXPECT_EQ(ask(broadcast, Instruction::sync_read, {132, 0, 4, 0, 3, 2}, 1s).size(), 1U);
  EXPECT_EQ(recorder.refusals(), 1U);
}

TEST_F(BusTest, TheStatusReturnLevelSilencesAnswers) {
  EXPECT_EQ(write(1, status_return_level, 1, 1, 1s), -1);
  EXPECT_EQ(write(1, goal_position, 100, 4, 1s), -1);
  EXPECT_EQ(read(1, goal_position, 4, 1s), 100);
  EXPECT_EQ(write(1, status_return_level, 0, 1, 1s), -1);
  EXPECT_TRUE(ask(1, Instruction::read, {132, 0, 4, 0}, 1s).empty());
  EXPECT_EQ(ask(1, Instruction::ping, {}, 1s).size(), 1U);
}

TEST_F(BusTest, TheEepromIsLockedWhileTorqueIsOn) {
  enable(1, 1s);
  EXPECT_EQ(write(1, return_delay_time, 0, 1, 1s), 7);
  EXPECT_EQ(write(1, profile_velocity, 10, 4, 1s), 0);
  EXPECT_EQ(write(1, torque_enable, 0, 1, 1s), 0);
  EXPECT_EQ(write(1, return_delay_time, 0, 1, 1s), 0);
}

TEST_F(BusTest, GoesToItsGoalWithItsMotorsSpeed) {
  enable(1, 1s);
  EXPECT_EQ(write(1, goal_position, 3048, 4, 2s), 0);
  EXPECT_NEAR(static_cast<double>(read(1, present_position, 4, 2100ms)), 2548, 1);
  EXPECT_EQ(read(1, moving, 1, 2100ms), 1);
  EXPECT_EQ(read(1, moving_status, 1, 2100ms), 0b10) << "the profile is being followed";
  EXPECT_EQ(read(1, present_velocity, 4, 2100ms), 320);  // 5000 ticks/s, in 0.229 rev/min
  EXPECT_GT(read(1, present_current, 2, 2100ms), 0);
  EXPECT_EQ(read(1, present_position, 4, 2200ms), 3048);
  EXPECT_EQ(read(1, present_velocity, 4, 2201ms), 0);
  EXPECT_EQ(read(1, moving, 1, 2201ms), 0);
  EXPECT_EQ(read(1, moving_status, 1, 2201ms), 0b01) << "it is where it was to go";
}

TEST_F(BusTest, WithoutTorqueNothingMoves) {
  EXPECT_EQ(write(1, goal_position, 3048, 4, 1s), 0);
  EXPECT_EQ(read(1, present_position, 4, 3s), 2048);
}

TEST_F(BusTest, TorqueSendsAServoToItsLastGoalAtOnceAndThatIsAJump) {
  write(1, goal_position, 3048, 4, 1s);
  enable(1, 2s);
  EXPECT_EQ(read(1, present_position, 4, 3s), 3048);
  EXPECT_EQ(recorder.report()["servos"]["1"]["largest_jump"], 1000.0);
}

TEST_F(BusTest, TheProfilesVelocityLimitsTheSpeed) {
  enable(1, 1s);
  write(1, profile_velocity, 64, 4, 1s);  // 64 · 0.229 rev/min · 4096 / 60 = 1000.5 ticks/s
  write(1, goal_position, 3048, 4, 2s);
  EXPECT_NEAR(static_cast<double>(read(1, present_position, 4, 2500ms)), 2548, 2);
  EXPECT_EQ(read(1, present_position, 4, 3s), 3048);
}

TEST_F(BusTest, TimeBasedProfilesNeedFirmware42) {
  EXPECT_EQ(write(1, drive_mode, 4, 1, 1s), 4);
  settings.servo.firmware = 42;
  Bus newer(settings, recorder, 0s);
  const auto tell = [&](std::uint16_t address, std::int64_t value, std::size_t octets, Time time) {
    Octets parameters = little_endian(address, 2);
    const Octets number = little_endian(value, octets);
    parameters.insert(parameters.end(), number.begin(), number.end());
    for (const std::uint8_t octet : encode(1, Instruction::write, parameters)) newer.receive(octet, time);
  };
  tell(drive_mode, 4, 1, 1s);
  tell(torque_enable, 1, 1, 1s);
  tell(profile_velocity, 500, 4, 1s);
  tell(goal_position, 2248, 4, 2s);
  EXPECT_NEAR(newer.state(2250ms)["servos"]["1"]["position"], 2148.0, 1);
  EXPECT_EQ(newer.state(2501ms)["servos"]["1"]["position"], 2248.0);
  EXPECT_NEAR(recorder.report()["servos"]["1"]["largest_speed"], 200.0, 0.01);  // one second after it was turned on
}

TEST_F(BusTest, TheReportKnowsTheHighestSpeedCommanded) {
  enable(1, 1s);
  write(1, goal_position, 2088, 4, 2s);
  write(1, goal_position, 2048, 4, 2s + 20ms);
  const auto servo = recorder.report()["servos"]["1"];
  EXPECT_EQ(servo["largest_change"], 40);
  EXPECT_NEAR(servo["largest_speed"], 2000.0, 1e-6);
  EXPECT_EQ(servo["lowest"], 2048);
  EXPECT_EQ(servo["highest"], 2088);
}

TEST_F(BusTest, AnOverloadTakesTheTorqueAndAlertsUntilTheServoIsRebooted) {
  enable(1, 1s);
  write(1, goal_position, 3048, 4, 2s);
  bus.overload(1, true, 2100ms);
  EXPECT_EQ(read(1, torque_enable, 1, 2200ms), 0);
  EXPECT_EQ(read(1, hardware_error_status, 1, 2200ms), 0x20);
  EXPECT_NEAR(static_cast<double>(read(1, present_position, 4, 3s)), 2548, 1);
  EXPECT_EQ(ask(1, Instruction::ping, {}, 3s)[0].parameters[0], 0x80);
  bus.overload(1, false, 3s);
  EXPECT_EQ(write(1, torque_enable, 1, 1, 3s), 0x87);
  EXPECT_EQ(ask(1, Instruction::reboot, {}, 4s)[0].parameters[0], 0);
  EXPECT_EQ(read(1, hardware_error_status, 1, 4s), 0);
  EXPECT_EQ(read(1, goal_position, 4, 4s), read(1, present_position, 4, 4s));
  enable(1, 5s);
  EXPECT_THROW(bus.overload(3, true, 5s), std::invalid_argument);
}

TEST_F(BusTest, ARebootDoesNotHelpWhileTheLoadIsThere) {
  bus.overload(1, true, 1s);
  ask(1, Instruction::reboot, {}, 2s);
  write(1, torque_enable, 1, 1, 3s);
  EXPECT_EQ(read(1, torque_enable, 1, 3s), 0);
  EXPECT_EQ(read(1, hardware_error_status, 1, 3s), 0x20);
}

TEST_F(BusTest, TheBusWatchdogStopsAServoWhenNobodySpeaks) {
  enable(1, 1s);
  write(1, profile_velocity, 64, 4, 1s);
  write(1, bus_watchdog, 5, 1, 1s);  // 100 ms
  write(1, goal_position, 4000, 4, 2s);
  EXPECT_EQ(read(1, bus_watchdog, 1, 2s), 0xFF);  // a second had passed
  EXPECT_EQ(write(1, goal_position, 3000, 4, 2s), 4);
  EXPECT_EQ(write(1, bus_watchdog, 0, 1, 2s), 0);
  EXPECT_EQ(write(1, bus_watchdog, 5, 1, 2s), 0);
  EXPECT_EQ(write(1, profile_velocity, 64, 4, 2s), 0);
  EXPECT_EQ(write(1, goal_position, 4000, 4, 2s), 0);
  for (auto time = 2050ms; time < 2500ms; time += 50ms) ask(77, Instruction::ping, {}, time);
  const auto position = bus.state(10s)["servos"]["1"]["position"].get<double>();
  EXPECT_NEAR(position, 2048 + 1000 * 0.55, 5);
}

TEST_F(BusTest, TheContactBoardTellsWhichFeetTouch) {
  EXPECT_EQ(read(200, 10, 1, 1s), 0b0001);
  bus.place(1, 2049, 1s);
  EXPECT_EQ(read(200, 10, 1, 1s), 0);
  bus.place(2, 3000, 1s);
  EXPECT_EQ(read(200, 10, 1, 1s), 0b1000);
  EXPECT_EQ(write(200, 10, 1, 1, 1s), 7);
  EXPECT_EQ(write(200, return_delay_time, 0, 1, 1s), 0);
  const auto packets = ask(broadcast, Instruction::sync_read, {10, 0, 1, 0, 200}, 1s);
  ASSERT_EQ(packets.size(), 1U);
  EXPECT_EQ(packets[0].parameters, (Octets{0, 0b1000}));
}

TEST_F(BusTest, IdAndSpeedStayAsTheyAre) {
  EXPECT_EQ(write(1, id_number, 9, 1, 1s), 4);
  EXPECT_EQ(write(1, baud_rate, 1, 1, 1s), 4);
  EXPECT_EQ(write(1, id_number, 1, 1, 1s), 0);
}

TEST_F(BusTest, ExtendedPositionControlKnowsNoLimits) {
  EXPECT_EQ(write(1, operating_mode, 4, 1, 1s), 0);
  EXPECT_EQ(write(1, operating_mode, 2, 1, 1s), 4);
  enable(1, 1s);
  EXPECT_EQ(write(1, goal_position, -1000, 4, 1s), 0);
  EXPECT_EQ(static_cast<std::int32_t>(read(1, present_position, 4, 10s)), -1000);
}

TEST_F(BusTest, ResetIsAPowerCycle) {
  enable(1, 1s);
  write(1, goal_position, 3048, 4, 2s);
  bus.overload(2, true, 2s);
  bus.reset(2100ms);
  EXPECT_EQ(read(1, torque_enable, 1, 3s), 0);
  EXPECT_NEAR(static_cast<double>(read(1, present_position, 4, 3s)), 2548, 1);
  EXPECT_EQ(read(1, goal_position, 4, 3s), read(1, present_position, 4, 3s));
  enable(2, 4s);
  EXPECT_EQ(read(2, torque_enable, 1, 4s), 1);
}

TEST_F(BusTest, AServoCanBePlacedByHandOnlyWhileItIsOff) {
  enable(1, 1s);
  EXPECT_THROW(bus.place(1, 1000, 1s), std::invalid_argument);
  EXPECT_THROW(bus.place(2, 4096, 1s), std::invalid_argument);
  EXPECT_THROW(bus.place(9, 1000, 1s), std::invalid_argument);
}

TEST_F(BusTest, RandomPacketsDoNoHarm) {
  std::mt19937 random(2006);
  constexpr std::array instructions{0x01, 0x02, 0x03, 0x04, 0x05, 0x06, 0x08, 0x55, 0x82, 0x83, 0x92, 0x93};
  constexpr std::array<std::uint8_t, 5> ids{1, 2, 3, 200, broadcast};
  Time time = 1s;
  for (int round = 0; round < 20'000; ++round) {
    Octets parameters(random() % 16);
    std::ranges::generate(parameters, [&] { return static_cast<std::uint8_t>(random() % 150); });
    auto packet = encode(ids[random() % ids.size()],
                         static_cast<Instruction>(instructions[random() % instructions.size()]), parameters);
    if (random() % 8 == 0) packet[random() % packet.size()] = static_cast<std::uint8_t>(random());
    time += 300us;
    send(packet, time);
  }
  const auto state = bus.state(time);
  ASSERT_EQ(state["servos"].size(), 2U);
  for (const auto& servo : state["servos"]) {
    EXPECT_GE(servo["position"], -1048575.0);
    EXPECT_LE(servo["position"], 1048575.0);
  }
  EXPECT_GT(recorder.refusals(), 1000U);
}

TEST(BaudRegisterTest, NamesTheServosSpeeds) {
  EXPECT_EQ(baud_register(57600), 1);
  EXPECT_EQ(baud_register(1'000'000), 3);
  EXPECT_FALSE(baud_register(250'000));
}

}  // namespace
}  // namespace lamprey::robot_bridge::emulators::dynamixel
