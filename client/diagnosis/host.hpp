#pragma once

#include "client/diagnosis/check.hpp"
#include "messaging/network_interfaces.hpp"
#include "messaging/port.hpp"

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

/// What this host alone shows, before anybody else is looked for.
namespace lamprey::client::diagnosis {

using messaging::NetworkInterface;

/// Sends itself a datagram by way of the group that DDS discovery uses; why it did not come, or nothing.
std::string multicast_fault(const NetworkInterface& interface);

/// Which of this machine's interfaces programs use with these options.
Check check_interfaces(const std::vector<NetworkInterface>& interfaces, const messaging::JoinOptions& join);

/// Whether multicast works on each interface, by `fault_of`; where programs look for peers by name it isn't needed.
std::vector<Check> check_multicast(const std::vector<NetworkInterface>& interfaces, const messaging::JoinOptions& join,
                                   const std::function<std::string(const NetworkInterface&)>& fault_of);

/// UDP ports that are bound, from the text of /proc/net/udp and the like.
std::set<std::uint16_t> bound_ports(std::string_view proc_net_udp);

/// Participant indices of the domain that are taken on this host: their port for discovery is bound (section 9.6.1 of
/// DDSI-RTPS). With none left no other program of the domain starts.
Check check_ports(const std::set<std::uint16_t>& bound, std::uint32_t domain);

/// `granted`: the most octets that the system lets a socket's receive buffer have (net.core.rmem_max).
Check check_receive_buffers(std::uint64_t granted);

/// Nobody of ours uses shared memory, but a profile of the user's own may: `free_octets` of /dev/shm, and segments that
/// programs of Fast DDS have left there.
Check check_shared_memory(std::uint64_t free_octets, std::size_t fastdds_segments, bool users_profile);

/// What of the environment decides how programs meet. `value_of`: of a variable, or an empty text.
std::vector<Check> check_environment(const std::function<std::string(const char*)>& value_of,
                                     const messaging::JoinOptions& join);

}  // namespace lamprey::client::diagnosis
