#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace lamprey::robot_bridge::recording {

/// Little-endian.
template <class Integer>
void append(std::vector<std::uint8_t>& octets, Integer value) {
  for (std::size_t octet = 0; octet < sizeof value; ++octet) {
    octets.push_back(static_cast<std::uint8_t>(static_cast<std::uint64_t>(value) >> (8 * octet)));
  }
}

/// Behind its length in 32 bits.
inline void append(std::vector<std::uint8_t>& octets, std::string_view text) {
  append(octets, static_cast<std::uint32_t>(text.size()));
  octets.insert(octets.end(), text.begin(), text.end());
}

}  // namespace lamprey::robot_bridge::recording
