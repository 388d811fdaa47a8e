#pragma once

#include "robot_bridge/emulators/dynamixel/control_table.hpp"
#include "robot_bridge/emulators/dynamixel/device.hpp"
#include "robot_bridge/emulators/dynamixel/profile.hpp"
#include "robot_bridge/emulators/recorder.hpp"

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

namespace lamprey::robot_bridge::emulators::dynamixel {

struct ServoSettings {
  std::uint8_t id = 1;
  std::uint8_t firmware = 45;
  std::uint8_t baud_register = 1;
  double position = 2048;  ///< before anything is commanded, in ticks
  double speed = 5257;     ///< at most, in ticks per second: an XM430-W210 without load at 12 V, 77 rev/min
};

/// One DYNAMIXEL X servo in position control, with its control table.
class Servo : public Device {
 public:
  Servo(const ServoSettings& settings, Recorder& recorder);

  std::uint16_t model() const override;
  std::uint8_t firmware() const override { return settings_.firmware; }
  Time return_delay() const override;
  std::uint8_t status_return_level() const override;
  bool alert() const override { return shut_down_; }
  Error read(std::uint16_t address, std::uint16_t octets, std::vector<std::uint8_t>& values) override;
  Error write(std::uint16_t address, std::span<const std::uint8_t> octets, Time time) override;
  Error reg_write(std::uint16_t address, std::span<const std::uint8_t> octets) override;
  Error action(Time time) override;
  void reboot(Time time) override;

  /// Passes one tick that ends at `time`.
  void follow(Time time);
  /// Nothing changes by itself.
  bool at_rest() const;
  /// An instruction for anybody was on the bus.
  void heard(Time time) { heard_ = time; }

  /// While it lasts, the servo shuts down as soon as it has torque; it stays so until it is rebooted.
  void overload(bool on, Time time);
  bool torque() const;
  double position() const { return motion_.position(); }
  void place(double position) { motion_.place(position); }
  /// Power off and on.
  void power_cycle(Time time);
  nlohmann::json state() const;

 private:
  Error check(const Item& item, std::int64_t value) const;
  Error check_mode(const Item& item, std::int64_t value) const;
  void changed(const std::vector<std::uint16_t>& addresses, bool had_torque, Time time);
  void go_to_goal();
  void set_torque(bool on, Time time);
  void shut_down(Time time);
  void initialise(bool ram_only);
  bool moves_to_positions() const;
  Profile profile(double distance) const;
  Time stated_duration(double distance) const;
  void refresh();

  ServoSettings settings_;
  Recorder* recorder_;
  ControlTable table_;
  Motion motion_;
  bool overloaded_ = false;
  bool shut_down_ = false;
  struct Registered {
    std::uint16_t address;
    std::vector<std::uint8_t> octets;
  };
  std::optional<Registered> registered_;
  Time heard_{};
  Time now_{};
};

}  // namespace lamprey::robot_bridge::emulators::dynamixel
