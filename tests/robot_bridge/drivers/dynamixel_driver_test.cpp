#include "robot_bridge/drivers/dynamixel_driver.hpp"

#include "pseudo_terminal.hpp"

#include <array>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <mutex>

namespace lamprey::robot_bridge::drivers {
namespace {

using dynamixel::Octets;
using Kind = DriverError::Kind;
using std::chrono::milliseconds;
using testing::HasSubstr;

constexpr std::int32_t board_id = 200;
constexpr std::int32_t board_address = 10;

/// Ids 11..18, a unit is 20 ticks, standing is 2048.
Calibration calibration() {
  Calibration calibration;
  calibration.family = DeviceFamily::dynamixel;
  calibration.baud = 1'000'000;
  for (std::size_t servo = 0; servo < servos; ++servo) {
    calibration.joints[servo] = {.channel = 11 + static_cast<std::int32_t>(servo),
                                 .minimum = 1800,
                                 .centre = 2048,
                                 .maximum = 2500,
                                 .per_unit = 20.3,
                                 .direction = servo % 2 == 0 ? 1 : -1,
                                 .offset = 0,
                                 .slew_rate = 2000};
  }
  calibration.feet[science::robots::front_left] = FootContact{.channel = 0, .closed_is_low = false};
  calibration.feet[science::robots::back_left] = FootContact{.channel = 6, .closed_is_low = false};
  calibration.contact_board = ContactBoard{.id = board_id, .address = board_address};
  return calibration;
}

/// Control tables that are read and written over the protocol, and answer at once. Servos follow no goals.
class Bus {
 public:
  Bus() {
    for (std::uint8_t id = 11; id <= 18; ++id) {
      set(id, dynamixel::operating_mode, 3);
      set(id, dynamixel::return_delay_time, 250);
      set(id, dynamixel::present_position, 2048);
    }
    tables_[board_id][board_address] = 0;
  }

  void set(int id, dynamixel::Register what, std::uint32_t value) {
    const std::lock_guard lock(mutex_);
    Octets octets;
    dynamixel::append(octets, value, what.octets);
    std::ranges::copy(octets, tables_[id].begin() + what.address);
  }
  std::uint32_t get(int id, dynamixel::Register what) {
    const std::lock_guard lock(mutex_);
    return dynamixel::value_of(std::span(tables_[id]).subspan(what.address, what.octets));
  }
  void remove(int id) {
    const std::lock_guard lock(mutex_);
    tables_.erase(id);
  }
  /// The error octet of all answers of a servo.
  void fail(int id, std::uint8_t error) {
    const std::lock_guard lock(mutex_);
    errors_[id] = error;
  }
  /// Changes every answer on its way.
  void disturb(std::function<void(Octets&)> noise) {
    const std::lock_guard lock(mutex_);
    noise_ = std::move(noise);
  }
  int writes(dynamixel::Register what) {
    const std::lock_guard lock(mutex_);
    return writes_[what.address];
  }

  std::string answer(std::string& received) {
    const std::lock_guard lock(mutex_);
    Octets answer;
    while (received.size() >= 7) {
      const auto octet = [&](std::size_t i) { return static_cast<std::uint8_t>(received[i]); };
      const std::size_t size = 7 + octet(5) + 256U * octet(6);
      if (received.size() < size) break;
      const Octets packet(received.begin(), received.begin() + static_cast<std::ptrdiff_t>(size));
      received.erase(0, size);
      obey(packet[4], packet[7], std::span(packet).subspan(8, size - 10), answer);
    }
    if (noise_ && !answer.empty()) noise_(answer);
    return {answer.begin(), answer.end()};
  }

 private:
  static std::uint16_t number(std::span<const std::uint8_t> parameters, std::size_t at) {
    return static_cast<std::uint16_t>(dynamixel::value_of(parameters.subspan(at, 2)));
  }

  void reply(int id, Octets parameters, Octets& answer) {
    const auto octets = dynamixel::encode({static_cast<std::uint8_t>(id), errors_[id], std::move(parameters)});
    answer.insert(answer.end(), octets.begin(), octets.end());
  }
  void reply_with(int id, std::uint16_t address, std::uint16_t count, Octets& answer) {
    const auto& table = tables_[id];
    reply(id, Octets(table.begin() + address, table.begin() + address + count), answer);
  }
  void put(int id, std::uint16_t address, std::span<const std::uint8_t> octets) {
    ++writes_[address];
    if (tables_.contains(id)) std::ranges::copy(octets, tables_[id].begin() + address);
  }

  void obey(int id, int instruction, std::span<const std::uint8_t> parameters, Octets& answer) {
    if (instruction == 0x82) {
      for (const int each : parameters.subspan(4)) {
        if (!tables_.contains(each)) return;  // those behind wait for it in vain
        reply_with(each, number(parameters, 0), number(parameters, 2), answer);
      }
    } else if (instruction == 0x83) {
      const std::size_t count = number(parameters, 2);
      for (auto rest = parameters.subspan(4); !rest.empty(); rest = rest.subspan(1 + count)) {
        put(rest[0], number(parameters, 0), rest.subspan(1, count));
      }
    } else if (tables_.contains(id)) {
      if (instruction == 0x01) reply(id, {0x06, 0x04, 0x26}, answer);
      if (instruction == 0x02) reply_with(id, number(parameters, 0), number(parameters, 2), answer);
      if (instruction == 0x03) {
        put(id, number(parameters, 0), parameters.subspan(2));
        reply(id, {}, answer);
      }
    }
  }

  std::mutex mutex_;
  std::map<int, std::array<std::uint8_t, 256>> tables_;
  std::map<int, std::uint8_t> errors_;
  std::map<int, int> writes_;
  std::function<void(Octets&)> noise_;
};

class DynamixelDriverTest : public testing::Test {
 protected:
  Bus bus;
  PseudoTerminal terminal{[this](std::string& received) { return bus.answer(received); }};
  DynamixelDriver driver{calibration(), terminal.port()};

  Kind kind_of_error(const std::function<void()>& call) {
    try {
      call();
    } catch (const DriverError& error) {
      message = error.what();
      return error.kind();
    }
    ADD_FAILURE() << "no error";
    return {};
  }
  std::string message;
};

TEST_F(DynamixelDriverTest, ConnectsAndTakesAwayTheDelayWhereTheTorqueIsOff) {
  bus.set(12, dynamixel::torque_enable, 1);
  bus.set(13, dynamixel::return_delay_time, 0);
  driver.connect();
  EXPECT_EQ(bus.get(11, dynamixel::return_delay_time), 0U);
  EXPECT_EQ(bus.get(12, dynamixel::return_delay_time), 250U) << "it can't be written under torque";
  EXPECT_EQ(bus.writes(dynamixel::return_delay_time), 6) << "such memory wears out";
  EXPECT_THAT(driver.description(), HasSubstr("return delay time up to 500 µs"));
  for (const auto& never : {dynamixel::torque_enable, dynamixel::goal_position, dynamixel::profile_velocity}) {
    EXPECT_EQ(bus.writes(never), 0) << never.address;
  }
}

TEST_F(DynamixelDriverTest, NamesTheServoThatDoesNotAnswer) {
  bus.remove(14);
  EXPECT_EQ(kind_of_error([&] { driver.connect(); }), Kind::silent);
  EXPECT_EQ(message, "no answer of front right horizontal (id 14)");
}

TEST_F(DynamixelDriverTest, NamesTheContactBoardThatDoesNotAnswer) {
  bus.remove(board_id);
  EXPECT_EQ(kind_of_error([&] { driver.connect(); }), Kind::silent);
  EXPECT_EQ(message, "no answer of contact board (id 200)");
}

TEST_F(DynamixelDriverTest, RefusesServosInAnotherOperatingMode) {
  bus.set(18, dynamixel::operating_mode, 1);
  EXPECT_EQ(kind_of_error([&] { driver.connect(); }), Kind::refused);
  EXPECT_THAT(message, HasSubstr("back right horizontal (id 18) is in operating mode 1; it must be in 3"));
}

TEST_F(DynamixelDriverTest, KnowsWhereServosAreThatAreOff) {
  driver.connect();
  bus.set(11, dynamixel::present_position, 2058);
  bus.set(12, dynamixel::present_position, 2058);
  const auto pose = driver.present_position();
  ASSERT_TRUE(pose);
  EXPECT_DOUBLE_EQ((*pose)[0], 10 + 10 / 20.3);
  EXPECT_DOUBLE_EQ((*pose)[1], 10 - 10 / 20.3);
  EXPECT_EQ((*pose)[2], 10);
}

TEST_F(DynamixelDriverTest, EnablesServosWhereTheyAreJustNow) {
  driver.connect();
  bus.set(11, dynamixel::present_position, 2070);
  bus.set(12, dynamixel::torque_enable, 1);
  bus.set(12, dynamixel::drive_mode, 4);
  driver.enable(standing_pose());
  EXPECT_EQ(bus.get(11, dynamixel::goal_position), 2070U) << "it has sagged: it may not jump back";
  EXPECT_EQ(bus.get(11, dynamixel::torque_enable), 1U);
  EXPECT_EQ(bus.get(11, dynamixel::drive_mode), 4U);
  EXPECT_EQ(bus.get(12, dynamixel::goal_position), 0U) << "a servo that is on is not told anything";
  EXPECT_EQ(bus.get(18, dynamixel::goal_position), 2048U);
}

TEST_F(DynamixelDriverTest, RefusesServosUnderTorqueThatMoveBySpeed) {
  driver.connect();
  bus.set(15, dynamixel::torque_enable, 1);
  EXPECT_EQ(kind_of_error([&] { driver.enable(standing_pose()); }), Kind::refused);
  EXPECT_THAT(message, HasSubstr("back left vertical (id 15) has torque, and no time-based profile"));
  EXPECT_EQ(bus.get(11, dynamixel::torque_enable), 0U) << "all or none";
  driver.connect();
  driver.release();
  EXPECT_NO_THROW(driver.enable(standing_pose()));
}

TEST_F(DynamixelDriverTest, MovesAllServosToEndTogether) {
  driver.connect();
  driver.enable(standing_pose());
  Pose pose = standing_pose();
  pose[0] = 11;
  pose[1] = 11;
  pose[2] = 1000;
  driver.move(pose, milliseconds(20));
  driver.present_position();
  EXPECT_EQ(bus.get(11, dynamixel::goal_position), 2068U);
  EXPECT_EQ(bus.get(12, dynamixel::goal_position), 2028U);
  EXPECT_EQ(bus.get(13, dynamixel::goal_position), 2500U);
  EXPECT_EQ(bus.get(18, dynamixel::goal_position), 2048U);
  for (int id = 11; id <= 18; ++id) EXPECT_EQ(bus.get(id, dynamixel::profile_velocity), 20U);
}

TEST_F(DynamixelDriverTest, TellsExactlyWhatWasAskedForWhereAServoHasReachedItsTick) {
  driver.connect();
  driver.enable(standing_pose());
  Pose pose = standing_pose();
  pose[0] = 11;
  pose[1] = 11;
  driver.move(pose, milliseconds(20));
  bus.set(11, dynamixel::present_position, 2068);
  bus.set(12, dynamixel::present_position, 2029);
  const Feedback feedback = driver.read();
  EXPECT_TRUE(feedback.measured);
  EXPECT_EQ(feedback.position[0], 11);
  EXPECT_DOUBLE_EQ(feedback.position[1], 10 + 19 / 20.3) << "it is where it is";
  EXPECT_EQ(feedback.position[2], 10);
}

TEST_F(DynamixelDriverTest, TellsServosThatHaveArrivedFromThoseOnTheirWay) {
  driver.connect();
  driver.enable(standing_pose());
  Pose pose = standing_pose();
  pose[0] = 11;
  driver.move(pose, milliseconds(20));
  bus.set(11, dynamixel::present_position, 2060);
  bus.set(11, dynamixel::moving_status, 0b10);
  EXPECT_FALSE(driver.read().arrived);
  EXPECT_TRUE(driver.moving());
  bus.set(11, dynamixel::moving_status, 0b01);
  EXPECT_FALSE(driver.read().arrived) << "its load keeps it from its goal";
  EXPECT_FALSE(driver.moving());
  bus.set(11, dynamixel::present_position, 2068);
  EXPECT_TRUE(driver.read().arrived);
}

TEST_F(DynamixelDriverTest, ReadsFeetFromTheContactBoardAndElseFromPositions) {
  driver.connect();
  bus.set(12, dynamixel::present_position, 1948);  // front right vertical, turned: lifted
  bus.set(board_id, {board_address, 1}, 0b0100'0000);
  EXPECT_EQ(driver.read().feet_down, 0b1100U);
  bus.set(board_id, {board_address, 1}, 0b0000'0001);
  EXPECT_EQ(driver.read().feet_down, 0b1001U);
}

TEST_F(DynamixelDriverTest, HoldsWhereTheServosAre) {
  driver.connect();
  driver.enable(standing_pose());
  Pose pose = standing_pose();
  pose[0] = 20;
  driver.move(pose, milliseconds(500));
  bus.set(11, dynamixel::present_position, 2099);
  driver.hold();
  driver.present_position();
  EXPECT_EQ(bus.get(11, dynamixel::goal_position), 2099U);
  EXPECT_EQ(bus.get(11, dynamixel::torque_enable), 1U);
}

TEST_F(DynamixelDriverTest, ReleasesAndMakesSureOfIt) {
  driver.connect();
  driver.enable(standing_pose());
  driver.release();
  for (int id = 11; id <= 18; ++id) EXPECT_EQ(bus.get(id, dynamixel::torque_enable), 0U);
  EXPECT_EQ(kind_of_error([&] { driver.move(standing_pose(), milliseconds(20)); }), Kind::refused);
}

TEST_F(DynamixelDriverTest, LetsGoWithoutAnAnswer) {
  driver.connect();
  driver.enable(standing_pose());
  EXPECT_TRUE(driver.let_go());
  EXPECT_EQ(kind_of_error([&] { driver.read(); }), Kind::disconnected);
  driver.connect();
  for (int id = 11; id <= 18; ++id) EXPECT_EQ(bus.get(id, dynamixel::torque_enable), 0U);
}

TEST_F(DynamixelDriverTest, NamesServoAndReasonOfAnAlertAndCanStillReleaseTheOthers) {
  driver.connect();
  driver.enable(standing_pose());
  bus.fail(13, dynamixel::alert_bit);
  bus.set(13, dynamixel::hardware_error_status, 0b100100);
  EXPECT_EQ(kind_of_error([&] { driver.read(); }), Kind::refused);
  EXPECT_EQ(message, "front left horizontal (id 13) reports overheating, overload");
  driver.connect();
  EXPECT_THAT(driver.description(), HasSubstr("front left horizontal (id 13) reports overheating, overload"));
  EXPECT_NO_THROW(driver.hold());
  EXPECT_NO_THROW(driver.release());
  EXPECT_EQ(bus.get(11, dynamixel::torque_enable), 0U);
  EXPECT_EQ(kind_of_error([&] { driver.enable(standing_pose()); }), Kind::refused);
}

TEST_F(DynamixelDriverTest, TellsWhatAServoSaysOfAnInstruction) {
  driver.connect();
  bus.fail(17, 7);
  EXPECT_EQ(kind_of_error([&] { driver.enable(standing_pose()); }), Kind::refused);
  EXPECT_EQ(message, "back left horizontal (id 17) answers with an error: access error");
}

TEST_F(DynamixelDriverTest, ReadsThroughNoiseBetweenAnswers) {
  driver.connect();
  bus.disturb([](Octets& answer) { answer.insert(answer.begin(), {0x00, 0xFF, 0xFF, 0x12}); });
  EXPECT_EQ(driver.present_position(), standing_pose());
}

TEST_F(DynamixelDriverTest, TellsAFlippedBitAPartAndAnAnswerOfSomebodyElse) {
  const std::vector<std::function<void(Octets&)>> noises = {
      [](Octets& answer) { answer[9] ^= 1; },
      [](Octets& answer) { answer.pop_back(); },
      [](Octets& answer) {
        answer = dynamixel::encode({99, 0, {0, 0, 0, 0}});
      },
      [](Octets& answer) {
        answer = dynamixel::encode({11, 0, {0, 0}});
      },
  };
  for (const auto& noise : noises) {
    bus.disturb({});
    driver.connect();
    bus.disturb(noise);
    EXPECT_EQ(kind_of_error([&] { driver.present_position(); }), Kind::garbled);
    EXPECT_EQ(kind_of_error([&] { driver.read(); }), Kind::disconnected) << "an error ends the connection";
  }
}

TEST_F(DynamixelDriverTest, NoticesAServoThatFallsSilent) {
  driver.connect();
  bus.remove(16);
  EXPECT_EQ(kind_of_error([&] { driver.read(); }), Kind::silent);
  EXPECT_EQ(message, "no answer of back right vertical (id 16)");
}

TEST_F(DynamixelDriverTest, NoticesThePlug) {
  driver.connect();
  terminal.unplug();
  EXPECT_EQ(kind_of_error([&] { driver.read(); }), Kind::disconnected);
}

TEST(DynamixelDriver, SaysWhichRateItsLineAllows) {
  Calibration fast = calibration();
  EXPECT_NEAR(DynamixelDriver(fast, "").highest_rate(), 198, 3);
  fast.baud = 57600;
  EXPECT_NEAR(DynamixelDriver(fast, "").highest_rate(), 21.3, 0.5);
}

}  // namespace
}  // namespace lamprey::robot_bridge::drivers
