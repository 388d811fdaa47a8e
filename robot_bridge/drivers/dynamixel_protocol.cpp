#include "robot_bridge/drivers/dynamixel_protocol.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace lamprey::robot_bridge::drivers::dynamixel {

namespace {

constexpr std::array<std::uint8_t, 4> header = {0xFF, 0xFF, 0xFD, 0x00};
constexpr std::size_t before_instruction = 7;  // header, id, length
constexpr std::size_t crc_octets = 2;
constexpr std::size_t shortest_length = 3;  // an instruction and the CRC

enum Instruction : std::uint8_t {
  ping_instruction = 0x01,
  read_instruction = 0x02,
  write_instruction = 0x03,
  status_instruction = 0x55,
  sync_read_instruction = 0x82,
  sync_write_instruction = 0x83,
};

/// Whether the last three octets are FF FF FD.
bool ends_as_header(const Octets& octets) {
  const std::size_t size = octets.size();
  return size >= 3 && octets[size - 3] == 0xFF && octets[size - 2] == 0xFF && octets[size - 1] == 0xFD;
}

Octets packet(std::uint8_t id, std::uint8_t instruction, std::span<const std::uint8_t> parameters) {
  Octets body = {instruction};
  for (const auto octet : parameters) {
    body.push_back(octet);
    if (ends_as_header(body)) body.push_back(0xFD);
  }
  Octets octets(header.begin(), header.end());
  octets.push_back(id);
  append(octets, static_cast<std::uint32_t>(body.size() + crc_octets), 2);
  octets.insert(octets.end(), body.begin(), body.end());
  append(octets, crc16(octets), crc_octets);
  return octets;
}

/// The octets as they were before `packet` put any in.
Octets without_stuffing(std::span<const std::uint8_t> body) {
  Octets octets;
  for (std::size_t i = 0; i < body.size(); ++i) {
    octets.push_back(body[i]);
    if (ends_as_header(octets) && i + 1 < body.size() && body[i + 1] == 0xFD) ++i;
  }
  return octets;
}

constexpr std::array<std::uint16_t, 256> crc_table() {
  constexpr unsigned polynomial = 0x8005;
  std::array<std::uint16_t, 256> table{};
  for (unsigned octet = 0; octet < table.size(); ++octet) {
    unsigned crc = octet << 8U;
    for (int bit = 0; bit < 8; ++bit) crc = (crc << 1U) ^ ((crc & 0x8000U) != 0 ? polynomial : 0U);
    table[octet] = static_cast<std::uint16_t>(crc & 0xFFFFU);
  }
  return table;
}

}  // namespace

std::uint16_t crc16(std::span<const std::uint8_t> octets) {
  static constexpr auto table = crc_table();
  unsigned crc = 0;
  for (const auto octet : octets) crc = ((crc << 8U) ^ table[((crc >> 8U) ^ octet) & 0xFFU]) & 0xFFFFU;
  return static_cast<std::uint16_t>(crc);
}

Octets ping(std::uint8_t id) {
  return packet(id, ping_instruction, {});
}

Octets read(std::uint8_t id, Register what) {
  Octets parameters;
  append(parameters, what.address, 2);
  append(parameters, what.octets, 2);
  return packet(id, read_instruction, parameters);
}

Octets write(std::uint8_t id, Register what, std::uint32_t value) {
  Octets parameters;
  append(parameters, what.address, 2);
  append(parameters, value, what.octets);
  return packet(id, write_instruction, parameters);
}

Octets sync_read(Register what, std::span<const std::uint8_t> ids) {
  Octets parameters;
  append(parameters, what.address, 2);
  append(parameters, what.octets, 2);
  parameters.insert(parameters.end(), ids.begin(), ids.end());
  return packet(broadcast_id, sync_read_instruction, parameters);
}

Octets sync_write(std::uint16_t address, std::span<const SyncValue> values) {
  Octets parameters;
  append(parameters, address, 2);
  append(parameters, static_cast<std::uint32_t>(values.empty() ? 0 : values.front().octets.size()), 2);
  for (const auto& [id, octets] : values) {
    parameters.push_back(id);
    parameters.insert(parameters.end(), octets.begin(), octets.end());
  }
  return packet(broadcast_id, sync_write_instruction, parameters);
}

void append(Octets& octets, std::uint32_t value, std::size_t width) {
  for (std::size_t i = 0; i < width; ++i) octets.push_back(static_cast<std::uint8_t>(value >> (8 * i) & 0xFFU));
}

std::uint32_t value_of(std::span<const std::uint8_t> octets) {
  std::uint32_t value = 0;
  for (std::size_t i = octets.size(); i > 0; --i) value = value << 8U | octets[i - 1];
  return value;
}

Octets encode(const StatusPacket& status) {
  Octets parameters = {status.error};
  parameters.insert(parameters.end(), status.parameters.begin(), status.parameters.end());
  return packet(status.id, status_instruction, parameters);
}

std::string error_text(std::uint8_t error) {
  constexpr std::array<std::string_view, 8> texts = {"",
                                                     "result fail",
                                                     "instruction error",
                                                     "CRC error",
                                                     "data range error",
                                                     "data length error",
                                                     "data limit error",
                                                     "access error"};
  const std::size_t number = error & (alert_bit - 1U);
  return number < texts.size() ? std::string(texts[number]) : "error " + std::to_string(number);
}

std::string hardware_error_text(std::uint32_t status) {
  constexpr std::array<std::string_view, 8> bits = {"input voltage",    "bit 1",    "overheating", "motor encoder",
                                                    "electrical shock", "overload", "bit 6",       "bit 7"};
  std::string text;
  for (std::size_t bit = 0; bit < bits.size(); ++bit) {
    if ((status >> bit & 1U) != 0) text.append(text.empty() ? "" : ", ").append(bits[bit]);
  }
  return text.empty() ? "no error that its hardware error status tells" : text;
}

StatusDecoder::Result StatusDecoder::next() {
  while (skip_to_header()) {
    if (octets_.size() < before_instruction) return {};
    const std::size_t length = octets_[5] | static_cast<std::size_t>(octets_[6]) << 8U;
    if (length < shortest_length || length > longest_packet) {
      skip(1);
      continue;
    }
    const std::size_t size = before_instruction + length;
    if (octets_.size() < size) return {};
    const Octets packet(octets_.begin(), octets_.begin() + static_cast<std::ptrdiff_t>(size));
    const std::span all(packet);
    if (crc16(all.first(size - crc_octets)) != value_of(all.last(crc_octets))) {
      // It may be noise that looks like a header, and a packet may be within: only the header is skipped.
      skip(1);
      return {.kind = Kind::garbled, .status = {}};
    }
    skip(size);
    const Octets body = without_stuffing(all.subspan(before_instruction, length - crc_octets));
    if (body[0] != status_instruction) continue;
    if (body.size() < 2) return {.kind = Kind::garbled, .status = {}};
    return {.kind = Kind::status,
            .status = {.id = packet[4], .error = body[1], .parameters = {body.begin() + 2, body.end()}}};
  }
  return {};
}

/// Whether the octets now begin with a header. Otherwise only what may be the beginning of one is left.
bool StatusDecoder::skip_to_header() {
  const auto found = std::search(octets_.begin(), octets_.end(), header.begin(), header.end());
  if (found != octets_.end()) {
    octets_.erase(octets_.begin(), found);
    return true;
  }
  if (octets_.size() >= header.size()) skip(octets_.size() - header.size() + 1);
  while (!std::equal(octets_.begin(), octets_.end(), header.begin())) octets_.pop_front();
  return false;
}

void StatusDecoder::skip(std::size_t count) {
  octets_.erase(octets_.begin(), octets_.begin() + static_cast<std::ptrdiff_t>(count));
}

}  // namespace lamprey::robot_bridge::drivers::dynamixel
