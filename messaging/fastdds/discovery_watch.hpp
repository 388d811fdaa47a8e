#pragma once

#include "messaging/discovery/watch.hpp"

#include <memory>

namespace lamprey::messaging::fastdds {

/// Throws std::runtime_error with Fast DDS's reason, as far as it gives one.
std::unique_ptr<discovery::Watch> make_discovery_watch(const JoinOptions& options);

}  // namespace lamprey::messaging::fastdds
