#pragma once

#include "messaging/discovery/watch.hpp"

#include <memory>

namespace lamprey::messaging::cyclonedds {

/// Throws std::runtime_error with Cyclone's reason.
std::unique_ptr<discovery::Watch> make_discovery_watch(const JoinOptions& options);

}  // namespace lamprey::messaging::cyclonedds
