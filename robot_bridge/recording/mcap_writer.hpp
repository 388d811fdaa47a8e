#pragma once

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <span>
#include <string>
#include <vector>

namespace lamprey::robot_bridge::recording {

/// A channel of an MCAP file: messages of one type on one topic.
struct Channel {
  std::string topic;
  std::string type;        ///< "sensor_msgs/msg/JointState"
  std::string definition;  ///< the type's .msg text and, behind it, those of the types that it uses
};

/// Writes an MCAP file (mcap.dev/spec, version 0) of profile "ros2": schemas "ros2msg", messages "cdr", one record
/// after the other without chunks. What is written is readable however the program ends; finish() adds the summary. One
/// thread. The constructor and flush() throw std::runtime_error where the file can't be written.
class McapWriter {
 public:
  McapWriter(const std::string& path, std::vector<Channel> channels);

  /// `channel`: its place in the constructor's list. `nanoseconds`: since 1970.
  void write(std::size_t channel, std::uint64_t nanoseconds, std::span<const std::uint8_t> message);

  /// So that nothing that was written is lost with the program.
  void flush();

  /// Nothing can be written afterwards.
  void finish();

 private:
  using Octets = std::vector<std::uint8_t>;

  void record(std::uint8_t opcode, const Octets& content);
  void describe_channels();
  Octets statistics() const;

  std::string path_;
  std::vector<Channel> channels_;
  std::ofstream file_;
  std::uint64_t written_ = 0;  ///< octets
  std::vector<std::uint64_t> messages_;
  std::uint64_t first_nanoseconds_ = 0;
  std::uint64_t last_nanoseconds_ = 0;
};

}  // namespace lamprey::robot_bridge::recording
