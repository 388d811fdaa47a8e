#include "robot_bridge/emulators/dynamixel/control_table.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace lamprey::robot_bridge::emulators::dynamixel {
namespace {

constexpr std::int64_t any32 = 0x7FFFFFFF;
constexpr bool readable_only = false;
constexpr bool writable = true;

constexpr std::array xm430_items{
    Item{model_number, 2, readable_only, 1030, 0, 0xFFFF},
    Item{2, 4, readable_only, 0, 0, any32},
    Item{firmware_version, 1, readable_only, 45, 0, 0xFF},
    Item{id_number, 1, writable, 1, 0, highest_id},
    Item{baud_rate, 1, writable, 1, 0, 7},
    Item{return_delay_time, 1, writable, 250, 0, 254},
    Item{drive_mode, 1, writable, 0, 0, 13},
    Item{operating_mode, 1, writable, 3, 0, 16},
    Item{12, 1, writable, 255, 0, 255},   // secondary id
    Item{13, 1, writable, 2, 2, 2},       // protocol type
    Item{20, 4, writable, 0, 0, 0},       // homing offset
    Item{24, 4, writable, 10, 0, 1023},   // moving threshold
    Item{31, 1, writable, 80, 0, 100},    // temperature limit
    Item{32, 2, writable, 160, 95, 160},  // voltage limits
    Item{34, 2, writable, 95, 95, 160},
    Item{36, 2, writable, 885, 0, 885},    // PWM limit
    Item{38, 2, writable, 1193, 0, 1193},  // current limit
    Item{velocity_limit, 4, writable, 330, 0, 1023},
    Item{max_position_limit, 4, writable, 4095, 0, 4095},
    Item{min_position_limit, 4, writable, 0, 0, 4095},
    Item{60, 1, writable, 0, 0, 3},    // startup configuration
    Item{63, 1, writable, 52, 0, 63},  // shutdown
    Item{torque_enable, 1, writable, 0, 0, 1},
    Item{65, 1, writable, 0, 0, 1},  // LED
    Item{status_return_level, 1, writable, 2, 0, 2},
    Item{registered_instruction, 1, readable_only, 0, 0, 1},
    Item{hardware_error_status, 1, readable_only, 0, 0, 0xFF},
    Item{76, 2, writable, 1920, 0, 16383},  // velocity gains
    Item{78, 2, writable, 100, 0, 16383},
    Item{80, 2, writable, 0, 0, 16383},  // position gains
    Item{82, 2, writable, 0, 0, 16383},
    Item{84, 2, writable, 800, 0, 16383},
    Item{88, 2, writable, 0, 0, 16383},  // feedforward gains
    Item{90, 2, writable, 0, 0, 16383},
    Item{bus_watchdog, 1, writable, 0, -1, 127},
    Item{goal_pwm, 2, writable, 885, -885, 885},
    Item{goal_current, 2, writable, 1193, -1193, 1193},
    Item{goal_velocity, 4, writable, 0, -1023, 1023},
    Item{profile_acceleration, 4, writable, 0, 0, 32767},
    Item{profile_velocity, 4, writable, 0, 0, 32767},
    Item{goal_position, 4, writable, 0, -1048575, 1048575},
    Item{realtime_tick, 2, readable_only, 0, 0, 32767},
    Item{moving, 1, readable_only, 0, 0, 1},
    Item{moving_status, 1, readable_only, 0, 0, 0xFF},
    Item{present_pwm, 2, readable_only, 0, -885, 885},
    Item{present_current, 2, readable_only, 0, -1193, 1193},
    Item{present_velocity, 4, readable_only, 0, -any32, any32},
    Item{present_position, 4, readable_only, 0, -any32, any32},
    Item{velocity_trajectory, 4, readable_only, 0, -any32, any32},
    Item{position_trajectory, 4, readable_only, 0, -any32, any32},
    Item{present_input_voltage, 2, readable_only, 120, 0, 0xFFFF},
    Item{present_temperature, 1, readable_only, 35, 0, 0xFF},
};

std::int64_t number(std::span<const std::uint8_t> octets, bool is_signed) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < octets.size(); ++i) value |= static_cast<std::uint64_t>(octets[i]) << (8 * i);
  const auto bits = 8 * octets.size();
  const bool negative = is_signed && ((value >> (bits - 1)) & 1U) != 0;
  return static_cast<std::int64_t>(value) - (negative ? std::int64_t{1} << bits : 0);
}

}  // namespace

std::span<const Item> xm430() {
  return xm430_items;
}

ControlTable::ControlTable(std::span<const Item> items)
    : items_(items), memory_(static_cast<std::size_t>(items.back().address) + items.back().octets) {
  initialise(false);
}

void ControlTable::initialise(bool ram_only) {
  for (const Item& item : items_) {
    if (!ram_only || item.address >= first_ram_address) set(item.address, item.initial);
  }
}

const Item* ControlTable::find(std::uint16_t address) const {
  const auto item = std::ranges::lower_bound(items_, address, {}, &Item::address);
  return item != items_.end() && item->address == address ? &*item : nullptr;
}

std::int64_t ControlTable::get(std::uint16_t address) const {
  const Item* item = find(address);
  if (item == nullptr) throw std::logic_error("no item at " + std::to_string(address));
  return number(std::span(memory_).subspan(address, item->octets), item->lowest < 0);
}

void ControlTable::set(std::uint16_t address, std::int64_t value) {
  const Item* item = find(address);
  if (item == nullptr) throw std::logic_error("no item at " + std::to_string(address));
  for (std::size_t i = 0; i < item->octets; ++i) {
    memory_[address + i] = static_cast<std::uint8_t>(static_cast<std::uint64_t>(value) >> (8 * i));
  }
}

Error ControlTable::read(std::uint16_t address, std::uint16_t octets, std::vector<std::uint8_t>& values) const {
  const std::size_t end = std::size_t{address} + octets;
  if (octets == 0) return Error::data_length;
  const bool any = std::ranges::any_of(
      items_, [&](const Item& item) { return item.address < end && item.address + item.octets > address; });
  if (!any || end > memory_.size()) return Error::access;
  values.assign(memory_.begin() + address, memory_.begin() + static_cast<std::ptrdiff_t>(end));
  return Error::none;
}

Error ControlTable::write(std::uint16_t address, std::span<const std::uint8_t> octets, const Check& check,
                          std::vector<std::uint16_t>& written) {
  if (octets.empty()) return Error::data_length;
  std::vector<std::pair<const Item*, std::int64_t>> values;
  for (std::size_t done = 0; done < octets.size(); done += values.back().first->octets) {
    const std::size_t at = address + done;
    const Item* item = at <= 0xFFFF ? find(static_cast<std::uint16_t>(at)) : nullptr;
    if (item == nullptr || !item->writable) return Error::access;
    if (octets.size() - done < item->octets) return Error::data_length;
    const std::int64_t value = number(octets.subspan(done, item->octets), item->lowest < 0);
    if (value < item->lowest || value > item->highest) return Error::data_range;
    if (const Error error = check(*item, value); error != Error::none) return error;
    values.emplace_back(item, value);
  }
  for (const auto& [item, value] : values) {
    set(item->address, value);
    written.push_back(item->address);
  }
  return Error::none;
}

}  // namespace lamprey::robot_bridge::emulators::dynamixel
