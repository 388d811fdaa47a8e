#pragma once

#include <cstdint>
#include <string_view>

namespace lamprey::messaging {

/// What a robot is known by on the wire (idl/robot.idl): the first 64 bits, big-endian, of the SHA-256 of its name.
std::uint64_t robot_number(std::string_view name);

/// 1 to 64 of A–Z a–z 0–9 _ . -
bool is_valid_robot(std::string_view name);

}  // namespace lamprey::messaging
