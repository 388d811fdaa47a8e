#pragma once

#include "messaging/ros2/node.hpp"

#include <memory>

namespace lamprey::messaging::cyclonedds {

/// Throws std::runtime_error with Cyclone's reason.
std::unique_ptr<ros2::Node> make_ros2_node(const JoinOptions& options);

}  // namespace lamprey::messaging::cyclonedds
