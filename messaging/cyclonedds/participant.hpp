#pragma once

#include "messaging/port.hpp"

#include <memory>

namespace lamprey::messaging::cyclonedds {

/// Throws std::runtime_error with Cyclone's reason. Several participants in one process meet over the network, as
/// those of several processes do.
std::unique_ptr<Participant> make_participant(const JoinOptions& options);

}  // namespace lamprey::messaging::cyclonedds
