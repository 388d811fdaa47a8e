#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lamprey::messaging {

/// An IPv4 address of a network interface that is up; an interface with several addresses is there several times.
struct NetworkInterface {
  std::string name;
  std::string address;
  bool loopback = false;
  bool multicast = false;
  bool operator==(const NetworkInterface&) const = default;
};

/// Those of this machine, as they are now. Throws std::system_error.
std::vector<NetworkInterface> network_interfaces();

/// Whether it is one of those, by name or address.
bool is_among(const NetworkInterface& interface, const std::vector<std::string>& chosen);

/// Programs may be limited to so many addresses: Cyclone DDS sends over no more.
inline constexpr std::size_t most_interfaces = 4;

/// Why a program can't be limited to the interface of that name or address, or nothing: there is none among these, or
/// it is the loopback one. Says which there are.
std::string interface_fault(std::string_view chosen, const std::vector<NetworkInterface>& existing);

/// The addresses of the chosen interfaces, each once, in their order. Throws std::runtime_error where one has a fault,
/// or where there are more than most_interfaces.
std::vector<std::string> addresses_of(const std::vector<std::string>& chosen,
                                      const std::vector<NetworkInterface>& existing);

}  // namespace lamprey::messaging
