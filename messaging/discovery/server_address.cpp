#include "messaging/discovery/server_address.hpp"

#include "messaging/names.hpp"

#include <algorithm>
#include <charconv>
#include <stdexcept>
#include <system_error>

namespace lamprey::messaging::discovery {
namespace {

std::string_view host_in(std::string_view text) {
  return text.substr(0, text.find(':'));
}

/// 0 where it is none that a server may have.
std::uint16_t port_in(std::string_view text) {
  std::uint16_t port = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  const bool whole = error == std::errc{} && end == text.data() + text.size();
  return whole && port >= ServerAddress::first_port && port <= ServerAddress::last_port ? port : 0;
}

}  // namespace

std::optional<std::uint8_t> server_identity(const Guid& participant) {
  constexpr std::string_view begin = "DS";
  constexpr std::string_view end = "_EPROSIMA";
  const bool is_server = std::equal(begin.begin(), begin.end(), participant.begin()) &&
                         std::equal(end.begin(), end.end(), participant.begin() + begin.size() + 1);
  return is_server ? std::optional(participant[begin.size()]) : std::nullopt;
}

std::string server_fault(std::string_view text) {
  const auto host = host_in(text);
  const std::string quoted = "'" + std::string(text) + "'";
  if (!is_valid_peer(host)) return quoted + " is not HOST or HOST:PORT, a host's name or IPv4 address";
  if (host.size() == text.size() || port_in(text.substr(host.size() + 1)) != 0) return {};
  return quoted + ": a discovery server's port is " + std::to_string(ServerAddress::first_port) + " to " +
         std::to_string(ServerAddress::last_port) + ", since its identity (0 to 255) is what that is above " +
         std::to_string(ServerAddress::first_port);
}

std::vector<ServerAddress> server_addresses(const std::vector<std::string>& texts, std::uint32_t domain) {
  std::vector<ServerAddress> addresses;
  for (const auto& text : texts) {
    if (const auto fault = server_fault(text); !fault.empty()) throw std::runtime_error(fault);
    const auto host = host_in(text);
    const bool has_port = host.size() < text.size();
    const ServerAddress address{
        std::string(host), has_port ? port_in(std::string_view(text).substr(host.size() + 1)) : server_port_of(domain)};
    const auto same = std::ranges::find(addresses, address.port, &ServerAddress::port);
    if (same != addresses.end()) {
      throw std::runtime_error("discovery servers '" + same->host + "' and '" + address.host + "' have one port, " +
                               std::to_string(address.port) + ", by which they are told apart: give one another");
    }
    addresses.push_back(address);
  }
  return addresses;
}

}  // namespace lamprey::messaging::discovery
