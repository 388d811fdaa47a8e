#pragma once

// Dynamixel Protocol 2.0 (ROBOTIS e-Manual): packets
//   FF FF FD 00 | ID | LENGTH (low, high) | INSTRUCTION | PARAMETERS … | CRC (low, high)
// LENGTH counts from the instruction to the CRC. From the instruction to the last parameter an FD is put behind each
// FF FF FD, so that no header stands within a packet. A status packet has instruction 55 and an error octet before its
// parameters. Numbers are little-endian.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lamprey::robot_bridge::drivers::dynamixel {

using Octets = std::vector<std::uint8_t>;

inline constexpr std::uint8_t broadcast_id = 0xFE;
inline constexpr std::uint8_t alert_bit = 0x80;  ///< of the error octet: hardware error status is not 0
inline constexpr std::size_t status_overhead = 11;
inline constexpr std::size_t longest_packet = 1024;  ///< a header with more is noise: nobody is asked for so much

/// Addresses and widths in the control table of the X series.
struct Register {
  std::uint16_t address;
  std::uint16_t octets;
};
inline constexpr Register return_delay_time{9, 1};  ///< units of 2 µs
inline constexpr Register drive_mode{10, 1};        ///< bit 2: the profile is given by its time
inline constexpr Register operating_mode{11, 1};    ///< 3: position control
inline constexpr Register torque_enable{64, 1};     ///< 0 or 1
inline constexpr Register hardware_error_status{70, 1};
inline constexpr Register profile_acceleration{108, 4};
inline constexpr Register profile_velocity{112, 4};  ///< under a profile given by its time: milliseconds, 1..32737
inline constexpr Register goal_position{116, 4};     ///< ticks, 0..4095
inline constexpr Register moving_status{123, 1};     ///< bit 1: the profile is still being followed
inline constexpr Register present_position{132, 4};  ///< ticks, signed

std::uint16_t crc16(std::span<const std::uint8_t> octets);

Octets ping(std::uint8_t id);
Octets read(std::uint8_t id, Register what);
Octets write(std::uint8_t id, Register what, std::uint32_t value);
/// One answer per servo, in this order.
Octets sync_read(Register what, std::span<const std::uint8_t> ids);

/// What one servo is written by a sync write.
struct SyncValue {
  std::uint8_t id = 0;
  Octets octets;  ///< of all servos as many
};
/// From the address on. Not answered.
Octets sync_write(std::uint16_t address, std::span<const SyncValue> values);

/// Puts a value of so many octets (at most 4) behind others.
void append(Octets& octets, std::uint32_t value, std::size_t width);
/// The value of at most 4 octets.
std::uint32_t value_of(std::span<const std::uint8_t> octets);

struct StatusPacket {
  std::uint8_t id = 0;
  std::uint8_t error = 0;  ///< 0..7, and perhaps alert_bit
  Octets parameters;
  bool operator==(const StatusPacket&) const = default;
};
/// As a servo sends it.
Octets encode(const StatusPacket& status);

/// "access error" for 7: what a device says of an instruction. Empty for 0 and for none but an alert.
std::string error_text(std::uint8_t error);
/// "overload, overheating": the bits of the hardware error status.
std::string hardware_error_text(std::uint32_t status);

/// Takes status packets out of what comes over the line, however it is cut. Skips what is none: noise, and
/// instructions, which adapters of half-duplex lines may echo.
class StatusDecoder {
 public:
  enum class Kind : std::uint8_t {
    incomplete,  ///< more octets are needed
    status,
    garbled,  ///< a packet with a wrong CRC, or a status without an error octet; its header has been skipped
  };
  struct Result {
    Kind kind = Kind::incomplete;
    StatusPacket status;
  };

  void add(std::span<const std::uint8_t> octets) { octets_.insert(octets_.end(), octets.begin(), octets.end()); }
  /// The next one. To be called until it is incomplete.
  Result next();
  void clear() { octets_.clear(); }
  /// Octets that are no packet yet.
  std::size_t pending() const { return octets_.size(); }

 private:
  bool skip_to_header();
  void skip(std::size_t count);

  std::deque<std::uint8_t> octets_;
};

}  // namespace lamprey::robot_bridge::drivers::dynamixel
