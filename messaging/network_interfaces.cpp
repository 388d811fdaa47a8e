#include "messaging/network_interfaces.hpp"

#include <algorithm>
#include <arpa/inet.h>
#include <array>
#include <cerrno>
#include <ifaddrs.h>
#include <memory>
#include <net/if.h>
#include <netinet/in.h>
#include <stdexcept>
#include <sys/socket.h>
#include <system_error>

namespace lamprey::messaging {
namespace {

bool is_meant(std::string_view chosen, const NetworkInterface& interface) {
  return interface.name == chosen || interface.address == chosen;
}

std::string listed(const std::vector<NetworkInterface>& existing) {
  std::string text;
  for (const auto& interface : existing) {
    if (interface.loopback) continue;
    text += (text.empty() ? "" : ", ") + interface.name + " (" + interface.address + ")";
  }
  return text.empty() ? "there is none but loopback" : "there are: " + text;
}

}  // namespace

std::vector<NetworkInterface> network_interfaces() {
  ifaddrs* first = nullptr;
  if (::getifaddrs(&first) != 0) throw std::system_error(errno, std::generic_category(), "getifaddrs");
  const std::unique_ptr<ifaddrs, decltype(&::freeifaddrs)> guard(first, ::freeifaddrs);
  std::vector<NetworkInterface> found;
  for (const ifaddrs* each = first; each != nullptr; each = each->ifa_next) {
    if (each->ifa_addr == nullptr || each->ifa_addr->sa_family != AF_INET || (each->ifa_flags & IFF_UP) == 0) continue;
    std::array<char, INET_ADDRSTRLEN> text{};
    const auto* const address = reinterpret_cast<const sockaddr_in*>(each->ifa_addr);
    ::inet_ntop(AF_INET, &address->sin_addr, text.data(), text.size());
    found.push_back(
        {each->ifa_name, text.data(), (each->ifa_flags & IFF_LOOPBACK) != 0, (each->ifa_flags & IFF_MULTICAST) != 0});
  }
  return found;
}

bool is_among(const NetworkInterface& interface, const std::vector<std::string>& chosen) {
  return std::ranges::any_of(chosen, [&](const std::string& each) { return is_meant(each, interface); });
}

std::string interface_fault(std::string_view chosen, const std::vector<NetworkInterface>& existing) {
  const std::string name = "'" + std::string(chosen) + "'";
  const auto found =
      std::ranges::find_if(existing, [&](const NetworkInterface& interface) { return is_meant(chosen, interface); });
  if (found == existing.end()) {
    return "no network interface that is up has the name or IPv4 address " + name + "; " + listed(existing);
  }
  // It reaches nobody else, and programs of one machine meet on any interface.
  if (found->loopback) return name + " is the loopback interface: to stay on this machine take --loopback-only";
  return {};
}

std::vector<std::string> addresses_of(const std::vector<std::string>& chosen,
                                      const std::vector<NetworkInterface>& existing) {
  std::vector<std::string> addresses;
  for (const auto& each : chosen) {
    if (const auto fault = interface_fault(each, existing); !fault.empty()) throw std::runtime_error(fault);
    for (const auto& interface : existing) {
      const bool is_new = std::ranges::find(addresses, interface.address) == addresses.end();
      if (is_meant(each, interface) && is_new) addresses.push_back(interface.address);
    }
  }
  if (addresses.size() > most_interfaces) {
    throw std::runtime_error("the chosen network interfaces have " + std::to_string(addresses.size()) +
                             " IPv4 addresses, and at most " + std::to_string(most_interfaces) +
                             " can be used: name some by their address");
  }
  return addresses;
}

}  // namespace lamprey::messaging
