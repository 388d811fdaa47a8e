#include "robot_bridge/emulators/dynamixel/packet.hpp"

#include <algorithm>
#include <array>

namespace lamprey::robot_bridge::emulators::dynamixel {
namespace {

constexpr std::array<std::uint8_t, 4> header{0xFF, 0xFF, 0xFD, 0x00};
constexpr std::array<std::uint8_t, 3> stuffed{0xFF, 0xFF, 0xFD};
constexpr std::uint8_t stuffing = 0xFD;
constexpr std::size_t length_at = 5;
constexpr std::size_t counted_from = 7;  ///< what `length` counts begins here
constexpr std::size_t crc_octets = 2;
constexpr std::size_t shortest = 3;  ///< an instruction and the checksum
constexpr std::size_t longest = 1024;

bool ends_with(std::span<const std::uint8_t> octets, std::span<const std::uint8_t> end) {
  return octets.size() >= end.size() && std::ranges::equal(octets.last(end.size()), end);
}

std::vector<std::uint8_t> without_stuffing(std::span<const std::uint8_t> octets) {
  std::vector<std::uint8_t> plain;
  std::size_t since = 0;  // octets of `plain` before this one belong to a pattern that was dealt with
  for (const std::uint8_t octet : octets) {
    if (octet == stuffing && ends_with(std::span(plain).subspan(since), stuffed)) {
      since = plain.size();
      continue;
    }
    plain.push_back(octet);
  }
  return plain;
}

}  // namespace

std::uint16_t crc16(std::span<const std::uint8_t> octets) {
  constexpr unsigned polynomial = 0x8005;
  unsigned crc = 0;
  for (const std::uint8_t octet : octets) {
    crc ^= static_cast<unsigned>(octet) << 8U;
    for (int bit = 0; bit < 8; ++bit) crc = ((crc << 1U) ^ ((crc & 0x8000U) != 0 ? polynomial : 0U)) & 0xFFFFU;
  }
  return static_cast<std::uint16_t>(crc);
}

std::vector<std::uint8_t> encode(std::uint8_t id, Instruction instruction, std::span<const std::uint8_t> parameters) {
  std::vector<std::uint8_t> packet;
  packet.reserve(counted_from + 1 + parameters.size() + crc_octets);
  packet.assign(header.begin(), header.end());
  for (const std::uint8_t octet : {id, std::uint8_t{0}, std::uint8_t{0}, static_cast<std::uint8_t>(instruction)}) {
    packet.push_back(octet);
  }
  for (const std::uint8_t octet : parameters) {
    packet.push_back(octet);
    if (ends_with(std::span(packet).subspan(counted_from), stuffed)) packet.push_back(stuffing);
  }
  const std::size_t length = packet.size() - counted_from + crc_octets;
  packet[length_at] = static_cast<std::uint8_t>(length);
  packet[length_at + 1] = static_cast<std::uint8_t>(length >> 8U);
  const std::uint16_t crc = crc16(packet);
  packet.push_back(static_cast<std::uint8_t>(crc));
  packet.push_back(static_cast<std::uint8_t>(crc >> 8U));
  return packet;
}

std::vector<std::uint8_t> encode_status(std::uint8_t id, std::uint8_t error, std::span<const std::uint8_t> parameters) {
  std::vector<std::uint8_t> body{error};
  body.insert(body.end(), parameters.begin(), parameters.end());
  return encode(id, Instruction::status, body);
}

std::optional<Packet> Decoder::take(std::uint8_t octet) {
  octets_.push_back(octet);
  const std::size_t known = std::min(octets_.size(), header.size());
  if (!std::equal(header.begin(), header.begin() + static_cast<std::ptrdiff_t>(known), octets_.begin())) {
    // Not a header, but its last octets may begin one.
    do {
      octets_.erase(octets_.begin());
      ++skipped_;
    } while (!std::equal(octets_.begin(), octets_.end(), header.begin()));
    return std::nullopt;
  }
  if (octets_.size() < counted_from) return std::nullopt;
  const std::size_t length = octets_[length_at] + (static_cast<std::size_t>(octets_[length_at + 1]) << 8U);
  if (length < shortest || length > longest) {
    skipped_ += octets_.size();
    octets_.clear();
    return std::nullopt;
  }
  if (octets_.size() < counted_from + length) {
    if (octets_.size() > counted_from && ends_with(octets_, header)) {
      skipped_ += octets_.size() - header.size();
      octets_.assign(header.begin(), header.end());
    }
    return std::nullopt;
  }
  const std::span whole(octets_);
  const auto body = without_stuffing(whole.subspan(counted_from, length - crc_octets));
  const auto crc = whole.last(crc_octets);
  const bool intact = crc16(whole.first(whole.size() - crc_octets)) == crc[0] + (static_cast<unsigned>(crc[1]) << 8U);
  Packet packet{octets_[header.size()], body.front(), {body.begin() + 1, body.end()}, intact};
  octets_.clear();
  return packet;
}

}  // namespace lamprey::robot_bridge::emulators::dynamixel
