#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace lamprey::robot_bridge::emulators::dynamixel {

// ROBOTIS Protocol 2.0 on the wire:
//   packet      = FF FF FD 00 id length:2 instruction parameters crc:2
//   status      = FF FF FD 00 id length:2 55 error parameters crc:2
// Numbers are little-endian; `length` counts what follows it. Wherever FF FF FD occurs from the instruction on, another
// FD follows it (byte stuffing), which `length` and `crc` cover.

inline constexpr std::uint8_t broadcast = 0xFE;
inline constexpr std::uint8_t highest_id = 252;

enum class Instruction : std::uint8_t {
  ping = 0x01,
  read = 0x02,
  write = 0x03,
  reg_write = 0x04,
  action = 0x05,
  reboot = 0x08,
  status = 0x55,
  sync_read = 0x82,
  sync_write = 0x83,
  bulk_read = 0x92,
  bulk_write = 0x93,
};

/// The number in the error octet of a status.
enum class Error : std::uint8_t {
  none = 0,
  result_fail = 1,
  instruction = 2,
  crc = 3,
  data_range = 4,
  data_length = 5,
  data_limit = 6,
  access = 7,
};
/// The error octet's bit that tells of a hardware error.
inline constexpr std::uint8_t alert_bit = 0x80;

struct Packet {
  std::uint8_t id;
  std::uint8_t instruction;
  std::vector<std::uint8_t> parameters;
  bool intact;  ///< its checksum agrees
};

/// Polynomial 0x8005, from 0, most significant bit first.
std::uint16_t crc16(std::span<const std::uint8_t> octets);

std::vector<std::uint8_t> encode(std::uint8_t id, Instruction instruction, std::span<const std::uint8_t> parameters);
std::vector<std::uint8_t> encode_status(std::uint8_t id, std::uint8_t error, std::span<const std::uint8_t> parameters);

/// Finds packets in a stream of octets. A header within a packet begins a new one: stuffing keeps it out of whole ones.
class Decoder {
 public:
  /// The packet that this octet completes.
  std::optional<Packet> take(std::uint8_t octet);

  /// Octets that were no part of any packet.
  std::uint64_t skipped() const { return skipped_; }
  void clear() { octets_.clear(); }

 private:
  std::vector<std::uint8_t> octets_;
  std::uint64_t skipped_ = 0;
};

}  // namespace lamprey::robot_bridge::emulators::dynamixel
