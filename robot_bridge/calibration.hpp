#pragma once

#include "robot_bridge/pose.hpp"
#include "science/robots/quadruped.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace lamprey::robot_bridge {

/// How a servo's position in the robot's units (`pose.hpp`) becomes the device's: pulse widths in µs (SSC-32), ticks of
/// 1/4096 turn (Dynamixel). device = centre + offset + direction · per_unit · (units − 10).
struct Joint {
  std::int32_t channel = 0;  ///< SSC-32: 0..31; Dynamixel: id 0..252
  double minimum = 0;        ///< device units; nothing below is ever sent
  double centre = 0;         ///< where the leg stands (unit 10), before the offset
  double maximum = 0;        ///< device units; nothing above is ever sent
  double per_unit = 0;       ///< device units per unit of the robot, more than 0
  int direction = 1;         ///< 1, or −1 for a servo that is mounted the other way round
  double offset = 0;         ///< device units: what the horn is off by
  double slew_rate = 0;      ///< device units per second, more than 0: the fastest it is ever asked to move

  bool operator==(const Joint&) const = default;

  /// Clamped to minimum..maximum.
  double to_device(double units) const;
  double to_units(double device) const;
};

/// Where a leg's foot contact is read. None: a foot counts as down where its leg stands at or below the ground level
/// (unit 10), by the position that the device reports.
struct FootContact {
  std::int32_t channel = 0;  ///< SSC-32: input A..F as 0..5; Dynamixel: bit 0..7 of the contact board's octet
  bool closed_is_low = true;
  bool operator==(const FootContact&) const = default;
};

/// A board on a Dynamixel bus with the contacts of the feet: one octet of its control table.
struct ContactBoard {
  std::int32_t id = 0;       ///< 0..252, no joint's
  std::int32_t address = 0;  ///< 0..65535
  bool operator==(const ContactBoard&) const = default;
};

enum class DeviceFamily : std::uint8_t { mock, ssc32, dynamixel };

/// What a calibration file says (docs/formats/calibration.md). A value.
struct Calibration {
  DeviceFamily family = DeviceFamily::mock;
  std::int32_t baud = 115200;                                            ///< mock: of no meaning
  std::array<Joint, servos> joints{};                                    ///< by servo
  std::array<std::optional<FootContact>, science::robots::legs> feet{};  ///< by Leg
  std::optional<ContactBoard> contact_board;                             ///< Dynamixel, where any foot has a contact
  bool operator==(const Calibration&) const = default;
};

/// What a device's numbers of positions may be: µs of pulses, ticks.
struct DeviceNumbers {
  double lowest;
  double highest;
};
DeviceNumbers device_numbers(DeviceFamily family);

/// Units per second that a servo may move at most.
double slew_in_units(const Joint& joint);

/// Reads a calibration; throws experiment::InvalidInput with all that is wrong, each with file, line, column, field,
/// value, range and the nearest known name. Limits of size, depth, duplicate keys and aliases are those of sweep files.
Calibration parse_calibration(const std::string& text, const std::string& file);
/// The same from a file; throws experiment::InvalidInput also where it can't be read.
Calibration read_calibration(const std::string& path);

/// As a file that parse_calibration reads to the same value.
std::string to_yaml(const Calibration& calibration);

/// Of the mock: a unit is a device unit, and the slew rate is high enough for 1000 steps per second.
Calibration mock_calibration();

std::string_view to_text(DeviceFamily family);

}  // namespace lamprey::robot_bridge
