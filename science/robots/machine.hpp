#pragma once

#include "science/robots/quadruped.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>

namespace lamprey::science::robots {

/// Positions of servos that need not be whole: of a real robot.
using MachinePositions = std::array<double, servos>;

/// What a robot reports.
struct MachineReport {
  MachinePositions position{};
  unsigned feet_down = 0;  ///< a bit per leg, 1 << Leg: its contact is closed
};

/// What happened since the machine began the evaluation is worth nothing: a step was missed or late. It is to be begun
/// again, from where it began.
class EvaluationVoid : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A robot that is moved step by step in the simulated one's place. What it throws besides EvaluationVoid ends the
/// job's attempt.
class Machine {
 public:
  virtual ~Machine() = default;

  /// An evaluation of `time_steps` steps begins, with the servos at `posture`: where the robot does not stand there, it
  /// is brought there first.
  virtual MachineReport begin(const std::array<std::int16_t, servos>& posture, std::int32_t time_steps) = 0;

  /// One time step, at the end of which the servos are to be at `target`, within lowest_position..highest_position.
  virtual MachineReport step(const std::array<std::int16_t, servos>& target) = 0;
};

/// Where the servos are in whole positions: what a fitness counts moves by.
inline Quadruped nearest_posture(const MachineReport& report) {
  Quadruped robot{};
  for (std::size_t servo = 0; servo < servos; ++servo) {
    const double nearest = std::round(report.position[servo]);
    robot.position[servo] = static_cast<std::int16_t>(
        std::clamp(nearest, static_cast<double>(lowest_position), static_cast<double>(highest_position)));
  }
  return robot;
}

/// What a time step did by what the robot reports before and after it: as `step` (7.3), with the contacts of real feet.
/// `limit_pushed`: a servo was sent beyond a limit.
inline QuadrupedStep observed_step(const MachineReport& before, const MachineReport& after, bool limit_pushed) {
  const Quadruped from = nearest_posture(before);
  const Quadruped to = nearest_posture(after);
  QuadrupedStep result;
  result.limit_pushed = limit_pushed;
  result.moved = from != to;
  result.feet_on_ground = before.feet_down & after.feet_down & ((1U << legs) - 1);
  std::int16_t lowest_foot = highest_position;
  std::int16_t highest_foot = lowest_position;
  for (std::size_t leg = 0; leg < legs; ++leg) {
    if ((result.feet_on_ground >> leg & 1U) == 0) continue;
    const std::size_t horizontal = horizontal_servo(leg);
    const int push = to.position[horizontal] < from.position[horizontal] ? 1 : 0;
    (is_front(leg) ? result.front_pushes : result.back_pushes) += push;
    result.drags += to.position[horizontal] > from.position[horizontal] ? 1 : 0;
    lowest_foot = std::min(lowest_foot, to.position[vertical_servo(leg)]);
    highest_foot = std::max(highest_foot, to.position[vertical_servo(leg)]);
  }
  result.inclined = lowest_foot < highest_foot;
  return result;
}

}  // namespace lamprey::science::robots
