#pragma once

#include "messaging/ros2/messages.hpp"

#include <optional>
#include <string>

namespace lamprey::messaging::ros2 {

/// As for the samples of messaging/limits.hpp.
std::optional<std::string> limit_violation(const JointState& message);
std::optional<std::string> limit_violation(const Diagnostics& message);
std::optional<std::string> limit_violation(const JointCommand& message);

}  // namespace lamprey::messaging::ros2
