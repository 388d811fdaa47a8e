#pragma once

#include "science/robots/terrain.hpp"
#include "science/saving/archive.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace lamprey::science::robots {

// The quadruped of 7.2: four legs, each with a vertical and a horizontal servo.

enum Leg : std::uint8_t { front_left = 0, front_right = 1, back_left = 2, back_right = 3 };
inline constexpr std::size_t legs = 4;
inline constexpr std::size_t servos = 8;

/// Servos are numbered: front vertical left, right; front horizontal left, right; back vertical; back horizontal.
constexpr std::size_t vertical_servo(std::size_t leg) {
  return 4 * (leg / 2) + leg % 2;
}
constexpr std::size_t horizontal_servo(std::size_t leg) {
  return vertical_servo(leg) + 2;
}
constexpr bool is_front(std::size_t leg) {
  return leg < 2;
}

/// Limits of fig. 7.4 and the posture in which the robot stands, in servo positions (units of one step's move).
inline constexpr std::int16_t lowest_position = 0;
inline constexpr std::int16_t highest_position = 30;
inline constexpr std::int16_t standing_position = 10;

/// A foot at or below its ground level, a vertical position, reaches the ground; above it, it is lifted. By leg.
using GroundLevels = std::array<std::int16_t, legs>;
inline constexpr GroundLevels flat_ground = Terrain{}.ground_level;
inline constexpr std::int16_t flat_ground_level = flat_ground[0];

/// −1, 0 or +1 per servo for one time step.
using ServoCommands = std::array<std::int16_t, servos>;

struct Quadruped {
  std::array<std::int16_t, servos> position;  ///< lowest_position..highest_position

  bool operator==(const Quadruped&) const = default;
};

void fields(auto& archive, saving::Of<Quadruped> auto& robot) {
  saving::wholes(archive, "position", robot.position, lowest_position, highest_position);
}

constexpr Quadruped standing() {
  Quadruped robot{};
  robot.position.fill(standing_position);
  return robot;
}

/// What one time step did, as the fitness of 7.3 counts it.
struct QuadrupedStep {
  unsigned feet_on_ground = 0;  ///< a bit per leg: 1 << Leg
  bool inclined = false;        ///< touching feet ended at different vertical positions (fig. 7.10)
  int front_pushes = 0;         ///< touching front legs that moved back (eq. 7.8)
  int back_pushes = 0;          ///< touching back legs that moved back (eq. 7.8)
  int drags = 0;                ///< touching legs that moved forward: the feet brush the ground (eq. 7.8)
  bool limit_pushed = false;    ///< a servo was sent beyond a limit (fuel row 1)
  bool moved = false;           ///< any position changed (fuel row 9)

  bool operator==(const QuadrupedStep&) const = default;
};

/// The foot sensor of eq. 7.1. A foot is on the ground during a step only if it was down both before and after it: a
/// foot that lifts or lands in the step is in the air. Of the readings tried only this one yields the published mean
/// expected fitness of 139.375 (docs/decisions).
constexpr bool touches(std::int16_t vertical_before, std::int16_t vertical_after, std::int16_t ground_level) {
  return std::max(vertical_before, vertical_after) <= ground_level;
}

/// One time step (eq. 7.2): each servo moves by its command; beyond a limit it stays there. Pure but for `robot`.
inline QuadrupedStep step(Quadruped& robot, const ServoCommands& commands, const GroundLevels& ground = flat_ground) {
  const auto before = robot.position;
  auto after = before;
  int beyond = 0;
  int change = 0;
  for (std::size_t servo = 0; servo < servos; ++servo) {
    const auto wanted = static_cast<std::int16_t>(before[servo] + commands[servo]);
    const auto reached = std::min(std::max(wanted, lowest_position), highest_position);
    beyond |= wanted ^ reached;
    change |= before[servo] ^ reached;
    after[servo] = reached;
  }
  robot.position = after;

  QuadrupedStep result;
  result.limit_pushed = beyond != 0;
  result.moved = change != 0;
  std::int16_t lowest_foot = highest_position;
  std::int16_t highest_foot = lowest_position;
  for (std::size_t leg = 0; leg < legs; ++leg) {
    const std::size_t vertical = vertical_servo(leg);
    const std::size_t horizontal = horizontal_servo(leg);
    const bool on_ground = touches(before[vertical], after[vertical], ground[leg]);
    const int push = int{on_ground} & int{after[horizontal] < before[horizontal]};
    result.feet_on_ground |= static_cast<unsigned>(on_ground) << leg;
    (is_front(leg) ? result.front_pushes : result.back_pushes) += push;
    result.drags += int{on_ground} & int{after[horizontal] > before[horizontal]};
    lowest_foot = std::min(lowest_foot, on_ground ? after[vertical] : highest_position);
    highest_foot = std::max(highest_foot, on_ground ? after[vertical] : lowest_position);
  }
  result.inclined = lowest_foot < highest_foot;
  return result;
}

/// How the feet on the ground support the robot (figs 7.6 to 7.9).
enum class Support : std::uint8_t { none, one, side_pair, front_or_back_pair, diagonal_pair, three, four };
inline constexpr std::size_t supports = 7;

/// `feet_on_ground` as in QuadrupedStep, below 16.
constexpr Support support(unsigned feet_on_ground) {
  using enum Support;
  constexpr std::array<Support, 16> by_feet{
      none,          one,       one,   front_or_back_pair, one,   side_pair, diagonal_pair, three, one,
      diagonal_pair, side_pair, three, front_or_back_pair, three, three,     four};
  return by_feet[feet_on_ground];
}

}  // namespace lamprey::science::robots
