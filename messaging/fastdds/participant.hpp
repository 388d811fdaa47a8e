#pragma once

#include "messaging/port.hpp"

#include <memory>

namespace lamprey::messaging::fastdds {

/// Throws std::runtime_error with Fast DDS's reason, as far as it gives one.
std::unique_ptr<Participant> make_participant(const JoinOptions& options);

}  // namespace lamprey::messaging::fastdds
