#pragma once

#include "messaging/discovery/server.hpp"
#include "messaging/discovery/watch.hpp"
#include "messaging/port.hpp"
#include "messaging/ros2/node.hpp"

#include <cstdint>
#include <exception>
#include <string>
#include <vector>

/// What a vendor's library (liblamprey_messaging_<vendor>.so) exports; join() looks it up by name.
extern "C" {

/// A participant that the caller deletes; or nullptr, with the reason in `error`. Throws nothing. The library must stay
/// loaded for the rest of the process: the vendors' own threads and thread-local data do not survive unloading.
[[gnu::visibility("default")]] lamprey::messaging::Participant* lamprey_messaging_join(
    const lamprey::messaging::JoinOptions& options, std::string& error) noexcept;

/// The same for a node of ROS 2; ros2::join() looks it up.
[[gnu::visibility("default")]] lamprey::messaging::ros2::Node* lamprey_messaging_join_ros2(
    const lamprey::messaging::JoinOptions& options, std::string& error) noexcept;

/// The same for a watch of the domain; discovery::watch() looks it up.
[[gnu::visibility("default")]] lamprey::messaging::discovery::Watch* lamprey_messaging_watch(
    const lamprey::messaging::JoinOptions& options, std::string& error) noexcept;

/// The same for a discovery server of that port; discovery::serve() looks it up.
[[gnu::visibility("default")]] lamprey::messaging::discovery::Server* lamprey_messaging_serve_discovery(
    const lamprey::messaging::JoinOptions& options, std::uint16_t port, std::string& error) noexcept;
}

namespace lamprey::messaging {

/// Makes a Participant, a ros2::Node, a discovery::Watch or, of a port, a discovery::Server.
template <class Member, class... More>
using JoinFunction = Member* (*)(const JoinOptions&, More..., std::string&) noexcept;
inline constexpr const char* join_function_name = "lamprey_messaging_join";
inline constexpr const char* join_ros2_function_name = "lamprey_messaging_join_ros2";
inline constexpr const char* watch_function_name = "lamprey_messaging_watch";
inline constexpr const char* serve_discovery_function_name = "lamprey_messaging_serve_discovery";
inline constexpr const char* vendor_library_prefix = "liblamprey_messaging_";

/// For what a vendor's library exports: the pointer that `make` returned the owner of, or nullptr and why.
template <class Make>
auto made(std::string& error, Make make) noexcept -> decltype(make().release()) {
  try {
    return make().release();
  } catch (const std::exception& exception) {
    error = exception.what();
    return nullptr;
  }
}

/// The vendors whose libraries are next to the program or in ../lib, sorted.
std::vector<std::string> available_vendors();

}  // namespace lamprey::messaging
