#pragma once

#include "robot_bridge/emulators/dynamixel/control_table.hpp"
#include "robot_bridge/emulators/dynamixel/device.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace lamprey::robot_bridge::emulators::dynamixel {

/// A small device on the same bus, such as people build from a microcontroller: feet's contacts are the bits of an
/// octet that can be read.
class ContactBoard : public Device {
 public:
  static constexpr std::uint16_t lowest_address = 10;
  static constexpr std::uint16_t highest_address = 255;

  /// `contacts` gives the octet, which stands at `address`, lowest_address..highest_address.
  ContactBoard(std::uint8_t id, std::uint8_t baud_register, std::uint16_t address,
               std::function<std::uint8_t()> contacts);

  std::uint16_t model() const override;
  std::uint8_t firmware() const override;
  Time return_delay() const override;
  std::uint8_t status_return_level() const override { return 2; }
  bool alert() const override { return false; }
  Error read(std::uint16_t address, std::uint16_t octets, std::vector<std::uint8_t>& values) override;
  Error write(std::uint16_t address, std::span<const std::uint8_t> octets, Time time) override;
  Error reg_write(std::uint16_t, std::span<const std::uint8_t>) override { return Error::instruction; }
  Error action(Time) override { return Error::instruction; }
  void reboot(Time) override { table_.initialise(true); }

 private:
  std::vector<Item> items_;
  ControlTable table_;
  std::uint16_t address_;
  std::function<std::uint8_t()> contacts_;
};

}  // namespace lamprey::robot_bridge::emulators::dynamixel
