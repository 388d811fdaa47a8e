#pragma once

#include "messaging/qos.hpp"
#include "messaging/ros2/messages.hpp"
#include "messaging/tuning.hpp"

#include <chrono>
#include <string>
#include <string_view>

/// The topics of ROS 2: name, quality of service, and the hash of the type's description (REP 2011 and REP 2016), which
/// each endpoint announces in its user data.
namespace lamprey::messaging {

namespace qos {
/// Whoever comes late is told where the joints are now.
inline constexpr QosProfile ros2_state{.transient_local = true};
inline constexpr QosProfile ros2_diagnostics{.transient_local = true, .depth = 10};
/// A best-effort reader meets publishers of either kind.
inline constexpr QosProfile ros2_command{.reliable = false, .untaken = 32};
}  // namespace qos

template <>
struct Topic<ros2::JointState> {
  static constexpr std::string_view name = "rt/joint_states";
  static constexpr QosProfile profile = qos::ros2_state;
  static constexpr std::string_view type_hash =
      "RIHS01_a13ee3a330e346c9d87b5aa18d24e11690752bd33a0350f11c5882bc9179260e";
};
template <>
struct Topic<ros2::Diagnostics> {
  static constexpr std::string_view name = "rt/diagnostics";
  static constexpr QosProfile profile = qos::ros2_diagnostics;
  static constexpr std::string_view type_hash =
      "RIHS01_5a8a36efb05fb25070fa0fb3810290c0e6cd4862b54a8fb975a1ee8dc55a333e";
};
template <>
struct Topic<ros2::JointCommand> {
  static constexpr std::string_view name = "rt/joint_commands";
  static constexpr QosProfile profile = qos::ros2_command;
  static constexpr std::string_view type_hash =
      "RIHS01_1025ddc6b9552d191f89ef1a8d2f60f3d373e28b283d8891ddcc974e8c55397f";
};

/// How long a write may wait for readers. Short for ROS 2's topics, since the bridge's loop would wait with it; and not
/// DDS's default of 100 ms, which Cyclone doesn't announce, as some clients take an endpoint without for a broken one.
template <class Sample>
constexpr std::chrono::milliseconds longest_blocking() {
  if constexpr (requires { Topic<Sample>::type_hash; }) {
    return std::chrono::milliseconds{10};
  } else {
    return maximum_blocking;
  }
}

/// What an endpoint of the topic announces in its user data; empty for topics that aren't ROS 2's.
template <class Sample>
std::string user_data() {
  if constexpr (requires { Topic<Sample>::type_hash; }) {
    return "typehash=" + std::string(Topic<Sample>::type_hash) + ";";
  } else {
    return {};
  }
}

}  // namespace lamprey::messaging
