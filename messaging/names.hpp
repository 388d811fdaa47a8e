#pragma once

#include "messaging/port.hpp"

#include <string>
#include <string_view>

/// Names that go to a DDS vendor: partitions (every publisher and subscriber of ours is in exactly one) and peers.
namespace lamprey::messaging {

/// 1 to 64 of A–Z a–z 0–9 _ . - : no '/' (it separates) and none of DDS's wildcards.
bool is_valid_isolation(std::string_view name);

/// "<isolation>/common", or "<isolation>/" and the receiver as 16 hex digits.
std::string partition_name(std::string_view isolation, Partition partition);

/// Matches the common partition of every isolation, for readers that look at all of them.
inline constexpr std::string_view common_partition_of_all = "*/common";

/// Whether it looks like a host name or an address: 1 to 253 of A–Z a–z 0–9 _ . - :
bool is_valid_peer(std::string_view host);

}  // namespace lamprey::messaging
