#include "robot_bridge/emulators/dynamixel/control_table.hpp"

#include <gtest/gtest.h>

namespace lamprey::robot_bridge::emulators::dynamixel {
namespace {

using Octets = std::vector<std::uint8_t>;

class ControlTableTest : public testing::Test {
 protected:
  Error write(std::uint16_t address, const Octets& octets) {
    written.clear();
    return table.write(
        address, octets, [](const Item&, std::int64_t) { return Error::none; }, written);
  }
  Error read(std::uint16_t address, std::uint16_t octets) { return table.read(address, octets, values); }

  ControlTable table{xm430()};
  std::vector<std::uint16_t> written;
  Octets values;
};

TEST_F(ControlTableTest, RowsAreInOrderAndDoNotOverlap) {
  const auto items = xm430();
  for (std::size_t i = 1; i < items.size(); ++i) {
    EXPECT_GE(items[i].address, items[i - 1].address + items[i - 1].octets) << items[i].address;
  }
}

TEST_F(ControlTableTest, HoldsTheManualsInitialValues) {
  EXPECT_EQ(table.get(model_number), 1030);
  EXPECT_EQ(table.get(return_delay_time), 250);
  EXPECT_EQ(table.get(operating_mode), 3);
  EXPECT_EQ(table.get(status_return_level), 2);
  EXPECT_EQ(table.get(max_position_limit), 4095);
}

TEST_F(ControlTableTest, NumbersAreLittleEndianAndSigned) {
  EXPECT_EQ(write(goal_velocity, {0x9C, 0xFF, 0xFF, 0xFF}), Error::none);
  EXPECT_EQ(table.get(goal_velocity), -100);
  table.set(present_velocity, -2);
  EXPECT_EQ(read(present_velocity, 4), Error::none);
  EXPECT_EQ(values, (Octets{0xFE, 0xFF, 0xFF, 0xFF}));
}

TEST_F(ControlTableTest, OneWriteMayCoverItemsInARow) {
  EXPECT_EQ(write(profile_acceleration, {1, 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0}), Error::none);
  EXPECT_EQ(written, (std::vector<std::uint16_t>{108, 112, 116}));
  EXPECT_EQ(table.get(goal_position), 3);
}

TEST_F(ControlTableTest, AnErrorAnywhereLeavesAllAsItWas) {
  EXPECT_EQ(write(profile_acceleration, {1, 0, 0, 0, 0xFF, 0xFF, 0, 0}), Error::data_range);
  EXPECT_EQ(write(profile_acceleration, {1, 0, 0, 0, 2, 0}), Error::data_length);
  EXPECT_EQ(write(goal_position, {1, 0, 0, 0, 2, 0}), Error::access);  // the next one can only be read
  EXPECT_EQ(write(present_position, {1, 0, 0, 0}), Error::access);
  EXPECT_EQ(write(goal_position + 1, {1}), Error::access);
  EXPECT_EQ(write(1000, {1}), Error::access);
  EXPECT_EQ(write(0xFFFF, {1}), Error::access);
  EXPECT_EQ(write(goal_position, {}), Error::data_length);
  EXPECT_TRUE(written.empty());
  EXPECT_EQ(table.get(profile_acceleration), 0);
  EXPECT_EQ(table.get(goal_position), 0);
}

TEST_F(ControlTableTest, GapsReadAs0AndNothingAsAnError) {
  EXPECT_EQ(read(torque_enable, 7), Error::none);
  EXPECT_EQ(values, (Octets{0, 0, 0, 0, 2, 0, 0}));
  EXPECT_EQ(read(14, 2), Error::access);
  EXPECT_EQ(read(146, 2), Error::access);
  EXPECT_EQ(read(0xFFFF, 0xFFFF), Error::access);
  EXPECT_EQ(read(132, 0), Error::data_length);
}

TEST_F(ControlTableTest, InitialisingTheRamLeavesTheEeprom) {
  write(return_delay_time, {0});
  write(profile_velocity, {9, 0, 0, 0});
  table.initialise(true);
  EXPECT_EQ(table.get(return_delay_time), 0);
  EXPECT_EQ(table.get(profile_velocity), 0);
  table.initialise(false);
  EXPECT_EQ(table.get(return_delay_time), 250);
}

}  // namespace
}  // namespace lamprey::robot_bridge::emulators::dynamixel
