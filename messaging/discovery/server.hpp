#pragma once

#include "messaging/port.hpp"

#include <chrono>
#include <cstdint>
#include <memory>

namespace lamprey::messaging::discovery {

/// Lets programs of Fast DDS find each other that name its place (server_address.hpp), while it lives. Data never goes
/// through it.
class Server {
 public:
  virtual ~Server() = default;
};

/// After this long without a sign of life clients forget a server. Until then they take one that was killed and started
/// again for the one they know, ignore what it tells, and tell it nothing: who starts a server anew waits for longer.
inline constexpr std::chrono::seconds server_lease{3};

/// A server of that port (ServerAddress::first_port to last_port), with the interfaces and the introduction of
/// `options`; its isolation has no meaning. Throws JoinError, among else where the port is taken or the vendor has no
/// such server.
std::unique_ptr<Server> serve(const JoinOptions& options, std::uint16_t port);

}  // namespace lamprey::messaging::discovery
