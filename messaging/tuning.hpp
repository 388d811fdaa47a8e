#pragma once

#include "messaging/keys.hpp"
#include "messaging/qos.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string_view>

/// Numbers that both vendors are set to. What was measured to choose them: docs/decisions/0001-messaging.md.
namespace lamprey::messaging {

/// Of a reliable writer that waits for its readers (port.hpp promises it).
inline constexpr std::chrono::milliseconds maximum_blocking{100};

/// After this long without a sign of life DDS forgets a participant, and its readers no longer hold writers up. Long,
/// because forgetting a participant over a cut link loses samples; who is alive is decided by our own heartbeats.
inline constexpr std::chrono::seconds participant_lease{15};

/// How often a participant announces itself. Who comes back after a longer cut is met at its next announcement, and
/// should be at work within two seconds; workers don't hear those of others.
inline constexpr std::chrono::seconds announcement_period{1};

/// Programs of one domain on one host that find each other without multicast: participant indices 0 … 119. With one
/// more, the ports (7400 + 250 × domain + 10 + 2 × index) would run into those of the next domain.
inline constexpr std::uint32_t participants_per_host = 120;

/// Where participants of a domain announce themselves by multicast (DDSI-RTPS 2.3, 9.6.2): the group and its port.
inline constexpr std::string_view announcement_group = "239.255.0.1";
constexpr std::uint16_t announcement_port(std::uint32_t domain) {
  return static_cast<std::uint16_t>(7400 + 250 * domain);
}

/// Highest domain whose ports are below 65536 for all of these.
inline constexpr std::uint32_t highest_domain = 230;

inline constexpr std::uint32_t socket_receive_buffer_bytes = 4 * 1024 * 1024;

/// Of a message on a network, so that it is one frame: of a datagram that IP has cut into frames one lost frame loses
/// all, and where frames are lost it never arrives.
inline constexpr std::uint32_t maximum_message_bytes = 1400;
/// Of a sample's fragment within it.
inline constexpr std::uint32_t maximum_fragment_bytes = 1200;

/// Keys that a reader or writer of a keyed topic may know.
inline constexpr std::int32_t maximum_keys = 100'000;

}  // namespace lamprey::messaging
