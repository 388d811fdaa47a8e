#pragma once

#include "robot_bridge/calibration.hpp"

#include <chrono>

namespace lamprey::robot_bridge {

/// How a time step is spent: the servos move, then the device is asked where they are, then there is time for whoever
/// decides on the next step.
struct StepRhythm {
  std::chrono::nanoseconds period;
  std::chrono::nanoseconds move;  ///< the servos move so long
  std::chrono::nanoseconds read;  ///< from the beginning of the step to the question
  /// Whether there is time to ask, too, if servos that have not arrived are still on their way.
  bool asks_whether_moving = false;
};
StepRhythm step_rhythm(DeviceFamily family, double rate);

}  // namespace lamprey::robot_bridge
