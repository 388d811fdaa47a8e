#include "client/diagnosis/host.hpp"

#include "client/output/formatting.hpp"
#include "messaging/tuning.hpp"

#include <algorithm>
#include <arpa/inet.h>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <netinet/in.h>
#include <poll.h>
#include <sstream>
#include <sys/socket.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace lamprey::client::diagnosis {

namespace {

using Level = Check::Level;

constexpr const char* discovery_group = "239.255.0.1";

class Socket {
 public:
  Socket() : descriptor_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {}
  ~Socket() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  int get() const { return descriptor_; }
  template <class Value>
  bool set(int level, int option, const Value& value) const {
    return ::setsockopt(descriptor_, level, option, &value, sizeof value) == 0;
  }

 private:
  int descriptor_;
};

sockaddr* generic(sockaddr_in& address) {
  return reinterpret_cast<sockaddr*>(&address);
}

std::string system_error() {
  return std::strerror(errno);
}

/// Bound to a port that the system has chosen, a member of the group on that interface; why not, or nothing.
std::string join_group(const Socket& socket, const in_addr& interface, sockaddr_in& bound) {
  bound = {};
  bound.sin_family = AF_INET;
  socklen_t size = sizeof bound;
  if (::bind(socket.get(), generic(bound), size) != 0) return system_error();
  if (::getsockname(socket.get(), generic(bound), &size) != 0) return system_error();
  ip_mreq membership{};
  membership.imr_interface = interface;
  ::inet_pton(AF_INET, discovery_group, &membership.imr_multiaddr);
  if (!socket.set(IPPROTO_IP, IP_ADD_MEMBERSHIP, membership)) return system_error();
  if (!socket.set(IPPROTO_IP, IP_MULTICAST_IF, interface)) return system_error();
  return {};
}

/// UDP ports of a participant: 7400 + 250 × domain + 10 + 2 × index.
constexpr std::uint32_t discovery_port(std::uint32_t domain, std::uint32_t index) {
  return 7400 + 250 * domain + 10 + 2 * index;
}

std::string name_of(const NetworkInterface& interface) {
  return interface.name + " (" + interface.address + ")";
}

/// Those that may be used to reach others.
std::vector<NetworkInterface> used(std::vector<NetworkInterface> interfaces, const messaging::JoinOptions& join) {
  std::erase_if(interfaces, [&](const NetworkInterface& interface) {
    return interface.loopback || (!join.interfaces.empty() && !is_among(interface, join.interfaces));
  });
  return interfaces;
}

}  // namespace

std::string multicast_fault(const NetworkInterface& interface) {
  constexpr int patience = 1000;  // milliseconds
  in_addr address{};
  ::inet_pton(AF_INET, interface.address.c_str(), &address);
  const Socket socket;
  if (socket.get() < 0) return system_error();
  sockaddr_in group{};
  if (auto fault = join_group(socket, address, group); !fault.empty()) return fault;
  ::inet_pton(AF_INET, discovery_group, &group.sin_addr);
  constexpr std::string_view text = "lamprey doctor";
  if (::sendto(socket.get(), text.data(), text.size(), 0, generic(group), sizeof group) < 0) return system_error();
  pollfd wait{socket.get(), POLLIN, 0};
  if (::poll(&wait, 1, patience) != 1) return "a datagram to " + std::string(discovery_group) + " did not come back";
  return {};
}

Check check_interfaces(const std::vector<NetworkInterface>& interfaces, const messaging::JoinOptions& join) {
  if (join.loopback_only) return {Level::good, "interfaces", "only loopback, with --loopback-only", {}};
  std::vector<std::string> names;
  for (const auto& interface : used(interfaces, join)) names.push_back(name_of(interface));
  const std::string listed = output::joined(names, ", ");
  if (names.empty()) {
    return {Level::notable, "interfaces", "this host has no network but loopback",
            "Programs of this host meet with --loopback-only; others can't be reached."};
  }
  if (!join.interfaces.empty()) return {Level::good, "interfaces", "chosen: " + listed, {}};
  if (names.size() == 1 || join.vendor != "cyclonedds") return {Level::good, "interfaces", listed, {}};
  return {Level::notable, "interfaces", "of " + listed + " Cyclone DDS uses one only, as it likes",
          "Say which: --interface NAME, or LAMPREY_INTERFACES."};
}

std::vector<Check> check_multicast(const std::vector<NetworkInterface>& interfaces, const messaging::JoinOptions& join,
                                   const std::function<std::string(const NetworkInterface&)>& fault_of) {
  if (join.loopback_only) return {{Level::good, "multicast", "not needed with --loopback-only", {}}};
  if (!join.discovery_servers.empty()) return {{Level::good, "multicast", "not needed with a discovery server", {}}};
  std::vector<Check> checks;
  bool works = false;
  for (const auto& interface : used(interfaces, join)) {
    const std::string name = name_of(interface);
    auto fault = interface.multicast ? fault_of(interface) : "the interface has none";
    works = works || fault.empty();
    checks.push_back({fault.empty() ? Level::good : Level::notable,
                      "multicast",
                      name + (fault.empty() ? " works" : ": " + fault),
                      {}});
  }
  if (!checks.empty() && !works && join.peers.empty()) {
    checks.push_back({Level::trouble, "multicast", "works on no interface, and no peer is named",
                      "Name the coordinator's host: --peer HOST, or LAMPREY_PEERS."});
  }
  return checks;
}

std::set<std::uint16_t> bound_ports(std::string_view proc_net_udp) {
  std::set<std::uint16_t> ports;
  std::istringstream lines{std::string(proc_net_udp)};
  std::string line;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    std::string slot;
    std::string local;
    words >> slot >> local;
    const auto colon = local.find(':');
    if (colon == std::string::npos) continue;
    std::uint16_t port = 0;
    const char* const end = local.data() + local.size();
    const auto [stopped, error] = std::from_chars(local.data() + colon + 1, end, port, 16);
    if (error == std::errc{} && stopped == end) ports.insert(port);
  }
  return ports;
}

Check check_ports(const std::set<std::uint16_t>& bound, std::uint32_t domain) {
  std::uint32_t taken = 0;
  for (std::uint32_t index = 0; index < messaging::participants_per_host; ++index) {
    taken += bound.contains(static_cast<std::uint16_t>(discovery_port(domain, index))) ? 1U : 0U;
  }
  const std::string range = std::to_string(discovery_port(domain, 0)) + " to " +
                            std::to_string(discovery_port(domain, messaging::participants_per_host - 1) + 1);
  const std::string finding = std::to_string(taken) + " of " + std::to_string(messaging::participants_per_host) +
                              " places of domain " + std::to_string(domain) + " on this host are taken (UDP ports " +
                              range + ")";
  if (taken < messaging::participants_per_host) return {Level::good, "ports", finding, {}};
  return {Level::trouble, "ports", finding,
          "No other program can start: end some, take another --domain, or give workers more --threads instead."};
}

Check check_receive_buffers(std::uint64_t granted) {
  const std::string finding = "the system grants receive buffers of " + output::with_thousands(granted) + " octets";
  if (granted >= messaging::socket_receive_buffer_bytes) return {Level::good, "buffers", finding, {}};
  const std::string wanted = std::to_string(messaging::socket_receive_buffer_bytes);
  return {Level::notable, "buffers",
          finding + ", " + output::with_thousands(messaging::socket_receive_buffer_bytes) + " are asked for",
          "What overflows is sent again, which costs time: sysctl -w net.core.rmem_max=" + wanted + "."};
}

Check check_shared_memory(std::uint64_t free_octets, std::size_t fastdds_segments, bool users_profile) {
  constexpr std::uint64_t enough = 16 * 1024 * 1024;
  if (!users_profile) return {Level::good, "shared memory", "not used", {}};
  const std::string finding = output::with_thousands(free_octets) +
                              " octets are free in /dev/shm, where Fast DDS has " + std::to_string(fastdds_segments) +
                              " files";
  if (free_octets >= enough) return {Level::good, "shared memory", finding, {}};
  return {Level::trouble, "shared memory", finding,
          "Your Fast DDS profile may use it, and fails without a word where it is full: fastdds shm clean removes what "
          "programs that have died left there."};
}

std::vector<Check> check_environment(const std::function<std::string(const char*)>& value_of,
                                     const messaging::JoinOptions& join) {
  std::vector<Check> checks;
  if (!join.configuration_file.empty()) {
    checks.push_back({Level::good, "configuration", join.configuration_file + " is heeded", {}});
  }
  const std::string ours = value_of("LAMPREY_DOMAIN");
  const std::string of_ros = value_of("ROS_DOMAIN_ID");
  if (!ours.empty() && !of_ros.empty() && ours != of_ros) {
    checks.push_back(
        {Level::notable, "domain", "LAMPREY_DOMAIN is " + ours + ", ROS_DOMAIN_ID " + of_ros,
         "Programs of Lamprey use the former; a robot's --ros2 side, too, unless --ros2-domain says else."});
  }
  const std::pair<const char*, std::string_view> profiles[] = {{"CYCLONEDDS_URI", "cyclonedds"},
                                                               {"FASTRTPS_DEFAULT_PROFILES_FILE", "fastdds"}};
  for (const auto& [variable, vendor] : profiles) {
    const std::string value = value_of(variable);
    if (value.empty() || join.vendor != vendor) continue;
    checks.push_back({Level::notable, "profile", std::string(variable) + " is set, and heeded: " + value,
                      "If programs don't meet, try without it first."});
  }
  return checks;
}

}  // namespace lamprey::client::diagnosis
