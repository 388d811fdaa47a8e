#pragma once

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <unistd.h>
#include <vector>

/// Takes an MCAP file apart, by its specification.
namespace lamprey::robot_bridge::recording {

using Octets = std::vector<std::uint8_t>;

class ScratchFile {
 public:
  ScratchFile() {
    std::string name = (std::filesystem::temp_directory_path() / "lamprey-mcap-XXXXXX").string();
    const int descriptor = ::mkstemp(name.data());
    if (descriptor < 0) throw std::runtime_error("mkstemp");
    ::close(descriptor);
    path_ = name;
  }
  ~ScratchFile() { std::filesystem::remove(path_); }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  const std::string& path() const { return path_; }
  Octets octets() const {
    std::ifstream file(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

 private:
  std::string path_;
};

/// Little-endian, as this machine's.
template <class Number>
Number number(const Octets& octets, std::size_t offset) {
  Number value;
  if (offset + sizeof value > octets.size()) throw std::out_of_range("behind the end");
  std::memcpy(&value, octets.data() + offset, sizeof value);
  return value;
}

struct Record {
  int opcode;
  std::size_t offset;
  Octets content;
};

/// All that are whole, between the magic numbers.
inline std::vector<Record> records(const Octets& octets) {
  constexpr std::size_t magic = 8;
  constexpr std::size_t head = 9;
  std::vector<Record> found;
  std::size_t offset = magic;
  while (offset + head <= octets.size()) {
    const auto length = number<std::uint64_t>(octets, offset + 1);
    if (offset + head + length > octets.size()) break;
    const auto begin = octets.begin() + static_cast<std::ptrdiff_t>(offset + head);
    found.push_back({octets[offset], offset, Octets(begin, begin + static_cast<std::ptrdiff_t>(length))});
    offset += head + length;
  }
  return found;
}

inline std::vector<int> opcodes(const Octets& octets) {
  std::vector<int> codes;
  for (const auto& record : records(octets)) codes.push_back(record.opcode);
  return codes;
}

}  // namespace lamprey::robot_bridge::recording
