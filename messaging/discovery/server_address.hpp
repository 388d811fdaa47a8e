#pragma once

#include "messaging/discovery/domain_view.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lamprey::messaging::discovery {

/// Of our own, in its introduction.
inline constexpr std::string_view server_role = "discovery-server";

/// Where a discovery server of Fast DDS listens. Its clients must know its identity, a number of one octet, which
/// follows from its port here, so that nobody need say it: 11811 less 11811 is 0, as `fastdds discovery -i 0` has it.
struct ServerAddress {
  static constexpr std::uint16_t first_port = 11811;  ///< the usual one of a server with identity 0
  static constexpr std::uint16_t last_port = first_port + 255;

  std::string host;
  std::uint16_t port = first_port;

  std::uint8_t identity() const { return static_cast<std::uint8_t>(port - first_port); }
  bool operator==(const ServerAddress&) const = default;
};

/// Where the server of a domain is expected: a server keeps no domains apart, so each has its own.
constexpr std::uint16_t server_port_of(std::uint32_t domain) {
  return static_cast<std::uint16_t>(ServerAddress::first_port + domain);
}

/// Of a participant that is a discovery server: its GUID begins with "DS", the identity, and "_EPROSIMA".
std::optional<std::uint8_t> server_identity(const Guid& participant);

/// Why "HOST" or "HOST:PORT" is not such a place, or nothing.
std::string server_fault(std::string_view text);

/// The places; where no port is said, that of the domain (up to 230). Throws std::runtime_error where one has a fault,
/// and where two have one port: their clients would take them for one.
std::vector<ServerAddress> server_addresses(const std::vector<std::string>& texts, std::uint32_t domain);

}  // namespace lamprey::messaging::discovery
