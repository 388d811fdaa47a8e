#pragma once

#include "science/robots/quadruped.hpp"
#include "science/saving/archive.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace lamprey::science::robots {

// The biped of 6.2.1, hung up so that it cannot fall: two legs, each with one servo at the hip and a knee that gives.
// Its servos have the quadruped's limits, 0 and 30 (fig. 6.4).

inline constexpr std::size_t biped_legs = 2;

/// Between these a leg that moves up touches the ground: touch-down and release of the knee (fig. 6.4).
inline constexpr std::int16_t touch_down_position = 10;
inline constexpr std::int16_t knee_release_position = 20;

/// −1, 0 or +1 per leg for one time step.
using BipedCommands = std::array<std::int16_t, biped_legs>;

/// The legs are numbered 1 and 2; leg 1 starts at touch-down, leg 2 at the knee's release (fig. 6.6).
struct Biped {
  std::array<std::int16_t, biped_legs> position{touch_down_position, knee_release_position};

  bool operator==(const Biped&) const = default;
};

void fields(auto& archive, saving::Of<Biped> auto& robot) {
  saving::wholes(archive, "position", robot.position, lowest_position, highest_position);
}

/// What one time step did, as eq. 6.4 counts it.
struct BipedStep {
  unsigned feet_on_ground = 0;  ///< bit 0 for leg 1, bit 1 for leg 2
  int advance = 0;              ///< how far the body came, in positions of a leg
  int leg_error = 0;            ///< legs that were outside 10..20 before or after the step

  bool operator==(const BipedStep&) const = default;
};

constexpr bool in_walking_range(std::int16_t position) {
  return touch_down_position <= position && position <= knee_release_position;
}

/// One time step of eq. 6.2: a leg moves by its command, at a limit it stays. A leg sent up from within 10..20 takes
/// the body along. A leg sent down has its knee released, so it is off the ground. Pure but for `robot`.
inline BipedStep step(Biped& robot, const BipedCommands& commands) {
  BipedStep result;
  for (std::size_t leg = 0; leg < biped_legs; ++leg) {
    const std::int16_t before = robot.position[leg];
    const auto wanted = static_cast<std::int16_t>(before + commands[leg]);
    const std::int16_t after = std::clamp(wanted, lowest_position, highest_position);
    robot.position[leg] = after;

    const bool in_range = in_walking_range(before);
    if (in_range && commands[leg] >= 0) result.feet_on_ground |= 1U << leg;
    if (in_range && commands[leg] > 0) ++result.advance;
    if (!in_range || !in_walking_range(after)) ++result.leg_error;
  }
  return result;
}

}  // namespace lamprey::science::robots
