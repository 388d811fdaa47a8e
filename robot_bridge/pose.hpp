#pragma once

#include "science/robots/quadruped.hpp"

#include <array>
#include <cstddef>

namespace lamprey::robot_bridge {

inline constexpr std::size_t servos = science::robots::servos;

/// A position per servo, numbered as in science/robots/quadruped.hpp, in the robot's units: 0..30, standing at 10. A
/// device may stand between two units.
using Pose = std::array<double, servos>;

inline constexpr double lowest_position = science::robots::lowest_position;
inline constexpr double highest_position = science::robots::highest_position;

/// All servos at standing_position: where homing goes to.
constexpr Pose standing_pose() {
  Pose pose{};
  pose.fill(science::robots::standing_position);
  return pose;
}

}  // namespace lamprey::robot_bridge
