#pragma once

#include "robot_bridge/emulators/dynamixel/packet.hpp"
#include "robot_bridge/emulators/time.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace lamprey::robot_bridge::emulators::dynamixel {

/// Whatever has an id on the bus.
class Device {
 public:
  virtual ~Device() = default;
  virtual std::uint16_t model() const = 0;
  virtual std::uint8_t firmware() const = 0;
  virtual Time return_delay() const = 0;
  /// To which instructions it answers: 0 to ping only, 1 to reading too, 2 to all.
  virtual std::uint8_t status_return_level() const = 0;
  virtual bool alert() const = 0;
  virtual Error read(std::uint16_t address, std::uint16_t octets, std::vector<std::uint8_t>& values) = 0;
  virtual Error write(std::uint16_t address, std::span<const std::uint8_t> octets, Time time) = 0;
  /// Keeps what to write, until `action`.
  virtual Error reg_write(std::uint16_t address, std::span<const std::uint8_t> octets) = 0;
  virtual Error action(Time time) = 0;
  virtual void reboot(Time time) = 0;
};

}  // namespace lamprey::robot_bridge::emulators::dynamixel
