#pragma once

#include "messaging/robot_samples.hpp"

#include <string_view>

namespace lamprey::messaging {

/// "unconfigured", "inactive", "active", "fault" or "finalized".
std::string_view to_text(RobotState state);

}  // namespace lamprey::messaging
