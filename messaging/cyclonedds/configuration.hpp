#pragma once

#include "messaging/port.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace lamprey::messaging::cyclonedds {

/// Whether samples carry the hashes of their keys. ROS 2's nodes carry none, and some of its tools (Foxglove's own
/// RTPS) take what carries one for something else.
enum class KeyHashes { sent, omitted };

/// Cyclone's configuration: our fragment and then, so that it has the last word, what CYCLONEDDS_URI says.
/// `external_domain`: the domain on the network where it differs from the one within the process.
/// Interfaces are given by their addresses. Throws std::runtime_error on a peer that is no host name or address, and on
/// discovery servers.
std::string configuration(const JoinOptions& options, std::optional<std::uint32_t> external_domain,
                          KeyHashes key_hashes = KeyHashes::sent);

}  // namespace lamprey::messaging::cyclonedds
