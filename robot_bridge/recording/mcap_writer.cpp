#include "robot_bridge/recording/mcap_writer.hpp"

#include "robot_bridge/recording/octets.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace lamprey::robot_bridge::recording {
namespace {

constexpr std::string_view magic = "\x89MCAP0\r\n";

namespace opcode {
constexpr std::uint8_t header = 0x01;
constexpr std::uint8_t footer = 0x02;
constexpr std::uint8_t schema = 0x03;
constexpr std::uint8_t channel = 0x04;
constexpr std::uint8_t message = 0x05;
constexpr std::uint8_t statistics = 0x0B;
constexpr std::uint8_t data_end = 0x0F;
}  // namespace opcode

/// In place of a CRC: there is none.
constexpr std::uint32_t no_crc = 0;

}  // namespace

McapWriter::McapWriter(const std::string& path, std::vector<Channel> channels)
    : path_(path),
      channels_(std::move(channels)),
      file_(path, std::ios::binary | std::ios::trunc),
      messages_(channels_.size()) {
  file_ << magic;
  written_ = magic.size();
  Octets header;
  append(header, std::string_view("ros2"));
  append(header, std::string_view("lamprey"));
  record(opcode::header, header);
  describe_channels();
  flush();
}

/// Schema and channel i have the number i + 1; 0 means none.
void McapWriter::describe_channels() {
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    const auto number = static_cast<std::uint16_t>(i + 1);
    const Channel& channel = channels_[i];
    Octets schema;
    append(schema, number);
    append(schema, std::string_view(channel.type));
    append(schema, std::string_view("ros2msg"));
    append(schema, std::string_view(channel.definition));
    record(opcode::schema, schema);
    Octets octets;
    append(octets, number);
    append(octets, number);
    append(octets, std::string_view(channel.topic));
    append(octets, std::string_view("cdr"));
    append(octets, std::uint32_t{0});  // no metadata
    record(opcode::channel, octets);
  }
}

void McapWriter::record(std::uint8_t opcode, const Octets& content) {
  Octets octets{opcode};
  append(octets, static_cast<std::uint64_t>(content.size()));
  octets.insert(octets.end(), content.begin(), content.end());
  file_.write(reinterpret_cast<const char*>(octets.data()), static_cast<std::streamsize>(octets.size()));
  written_ += octets.size();
}

void McapWriter::write(std::size_t channel, std::uint64_t nanoseconds, std::span<const std::uint8_t> message) {
  const bool first = std::accumulate(messages_.begin(), messages_.end(), std::uint64_t{0}) == 0;
  first_nanoseconds_ = first ? nanoseconds : std::min(first_nanoseconds_, nanoseconds);
  last_nanoseconds_ = std::max(last_nanoseconds_, nanoseconds);
  Octets octets;
  append(octets, static_cast<std::uint16_t>(channel + 1));
  append(octets, static_cast<std::uint32_t>(messages_.at(channel)++));
  append(octets, nanoseconds);  // logged
  append(octets, nanoseconds);  // published
  octets.insert(octets.end(), message.begin(), message.end());
  record(opcode::message, octets);
}

McapWriter::Octets McapWriter::statistics() const {
  Octets octets;
  append(octets, std::accumulate(messages_.begin(), messages_.end(), std::uint64_t{0}));
  append(octets, static_cast<std::uint16_t>(channels_.size()));  // schemas
  append(octets, static_cast<std::uint32_t>(channels_.size()));
  append(octets, std::uint32_t{0});  // attachments
  append(octets, std::uint32_t{0});  // metadata
  append(octets, std::uint32_t{0});  // chunks
  append(octets, first_nanoseconds_);
  append(octets, last_nanoseconds_);
  constexpr std::size_t entry = sizeof(std::uint16_t) + sizeof(std::uint64_t);
  append(octets, static_cast<std::uint32_t>(entry * channels_.size()));
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    append(octets, static_cast<std::uint16_t>(i + 1));
    append(octets, messages_[i]);
  }
  return octets;
}

void McapWriter::flush() {
  file_.flush();
  if (!file_) throw std::runtime_error("the recording '" + path_ + "' can't be written");
}

void McapWriter::finish() {
  Octets end;
  append(end, no_crc);
  record(opcode::data_end, end);
  const std::uint64_t summary = written_;
  describe_channels();
  record(opcode::statistics, statistics());
  Octets footer;
  append(footer, summary);
  append(footer, std::uint64_t{0});  // no offsets of the summary's parts
  append(footer, no_crc);
  record(opcode::footer, footer);
  file_ << magic;
  flush();
}

}  // namespace lamprey::robot_bridge::recording
