#pragma once

#include "messaging/ros2/node.hpp"

#include <memory>

namespace lamprey::messaging::fastdds {

/// Throws std::runtime_error with Fast DDS's reason, as far as it gives one.
std::unique_ptr<ros2::Node> make_ros2_node(const JoinOptions& options);

}  // namespace lamprey::messaging::fastdds
