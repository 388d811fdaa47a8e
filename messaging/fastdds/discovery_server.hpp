#pragma once

#include "messaging/discovery/server.hpp"

#include <cstdint>
#include <memory>

namespace lamprey::messaging::fastdds {

/// Throws std::runtime_error where the port is taken, or with Fast DDS's reason as far as it gives one.
std::unique_ptr<discovery::Server> make_discovery_server(const JoinOptions& options, std::uint16_t port);

}  // namespace lamprey::messaging::fastdds
