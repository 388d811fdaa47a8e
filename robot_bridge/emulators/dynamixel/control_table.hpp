#pragma once

#include "robot_bridge/emulators/dynamixel/packet.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace lamprey::robot_bridge::emulators::dynamixel {

/// Addresses of what the servo acts on.
enum Address : std::uint16_t {
  model_number = 0,
  firmware_version = 6,
  id_number = 7,
  baud_rate = 8,
  return_delay_time = 9,
  drive_mode = 10,
  operating_mode = 11,
  velocity_limit = 44,
  max_position_limit = 48,
  min_position_limit = 52,
  torque_enable = 64,
  status_return_level = 68,
  registered_instruction = 69,
  hardware_error_status = 70,
  bus_watchdog = 98,
  goal_pwm = 100,
  goal_current = 102,
  goal_velocity = 104,
  profile_acceleration = 108,
  profile_velocity = 112,
  goal_position = 116,
  realtime_tick = 120,
  moving = 122,
  moving_status = 123,
  present_pwm = 124,
  present_current = 126,
  present_velocity = 128,
  present_position = 132,
  velocity_trajectory = 136,
  position_trajectory = 140,
  present_input_voltage = 144,
  present_temperature = 146,
};

/// The EEPROM area lies below; it is locked while torque is on.
inline constexpr std::uint16_t first_ram_address = 64;

/// One row of a servo's control table.
struct Item {
  std::uint16_t address;
  std::uint8_t octets;
  bool writable;
  std::int64_t initial;
  std::int64_t lowest;
  std::int64_t highest;
};

/// The table of an XM430-W210 (ROBOTIS e-manual), up to its present values: indirect addresses are not there.
std::span<const Item> xm430();

/// The registers of one device, little-endian in a row.
class ControlTable {
 public:
  /// `items` are in the order of their addresses and outlive the table.
  explicit ControlTable(std::span<const Item> items);

  /// All items get their initial values again; `ram_only` leaves the EEPROM area.
  void initialise(bool ram_only);

  /// Signed where the item's range is. The address is an item's.
  std::int64_t get(std::uint16_t address) const;
  /// Whatever its range and access; the device itself does so.
  void set(std::uint16_t address, std::int64_t value);

  /// Octets that no item has read as 0; an error if there is no item among them, or the table ends before them.
  Error read(std::uint16_t address, std::uint16_t octets, std::vector<std::uint8_t>& values) const;

  using Check = std::function<Error(const Item&, std::int64_t)>;
  /// Writes whole items in a row, or, after an error, nothing. `check` may refuse what the item's range allows. The
  /// items that were written are put to `written`.
  Error write(std::uint16_t address, std::span<const std::uint8_t> octets, const Check& check,
              std::vector<std::uint16_t>& written);

 private:
  const Item* find(std::uint16_t address) const;

  std::span<const Item> items_;
  std::vector<std::uint8_t> memory_;
};

}  // namespace lamprey::robot_bridge::emulators::dynamixel
