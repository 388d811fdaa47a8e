// Any octets on a Dynamixel line, however they are cut: the same packets, and each is encoded as it was read. The first
// octet tells the length of the pieces, the second whether the rest is the line, or what packets with good checksums
// are made of, since no fuzzer guesses those.
#include "robot_bridge/drivers/dynamixel_protocol.hpp"
#include "tests/fuzz/fuzzing.hpp"

#include <algorithm>

namespace {

using namespace lamprey;
using namespace lamprey::robot_bridge::drivers;
using dynamixel::Octets;
using dynamixel::StatusDecoder;
using dynamixel::StatusPacket;
using fuzzing::require;

struct Found {
  std::vector<StatusPacket> packets;
  int garbled = 0;
  bool operator==(const Found&) const = default;
};

Found decode(std::span<const std::uint8_t> line, std::size_t piece) {
  StatusDecoder decoder;
  Found found;
  for (std::size_t begin = 0; begin < line.size(); begin += piece) {
    decoder.add(line.subspan(begin, std::min(piece, line.size() - begin)));
    for (auto next = decoder.next(); next.kind != StatusDecoder::Kind::incomplete; next = decoder.next()) {
      if (next.kind == StatusDecoder::Kind::status) found.packets.push_back(next.status);
      found.garbled += next.kind == StatusDecoder::Kind::garbled ? 1 : 0;
    }
    require(decoder.pending() <= dynamixel::longest_packet + dynamixel::status_overhead);
  }
  return found;
}

void look_at(const StatusPacket& status) {
  require(status.parameters.size() <= dynamixel::longest_packet);
  const auto again = decode(dynamixel::encode(status), 1);
  require(again.packets == std::vector{status} && again.garbled == 0);
  if (!fuzzing::reached<1>((status.error & dynamixel::alert_bit) != 0)) return;
  if (fuzzing::reached<2>(status.parameters.size() >= 9)) fuzzing::planted_bug();
}

/// Packets one behind the other, with noise between them where there is any.
void look_at_packets(fuzzing::Input& input, std::size_t piece) {
  Octets line;
  std::vector<StatusPacket> sent;
  bool is_quiet = true;
  while (!input.empty()) {
    const auto noise = input.octets(input.octet() % 4);
    is_quiet = is_quiet && noise.empty();
    line.insert(line.end(), noise.begin(), noise.end());
    StatusPacket status;
    status.id = input.octet();
    status.error = input.octet();
    const auto parameters = input.octets(input.octet() % 32);
    status.parameters.assign(parameters.begin(), parameters.end());
    const auto packet = dynamixel::encode(status);
    line.insert(line.end(), packet.begin(), packet.end());
    sent.push_back(std::move(status));
  }
  const auto found = decode(line, piece);
  require(found == decode(line, 1));
  if (is_quiet) require(found.packets == sent && found.garbled == 0);
  for (const auto& status : found.packets) look_at(status);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzzing::Input input(data, size);
  const std::size_t piece = 1U + input.octet();
  if (input.octet() % 2 == 1) {
    look_at_packets(input, piece);
  } else {
    const auto found = decode(input.rest(), piece);
    require(found == decode(input.rest(), 1));
    for (const auto& status : found.packets) look_at(status);
  }
  return 0;
}
