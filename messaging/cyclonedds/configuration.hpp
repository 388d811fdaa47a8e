#pragma once

#include "messaging/port.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace lamprey::messaging::cyclonedds {

/// Cyclone's configuration: our fragment and then, so that it has the last word, what CYCLONEDDS_URI says.
/// `external_domain`: the domain on the network where it differs from the one within the process.
/// Throws std::runtime_error on a peer that is no host name or address.
std::string configuration(const JoinOptions& options, std::optional<std::uint32_t> external_domain);

}  // namespace lamprey::messaging::cyclonedds
