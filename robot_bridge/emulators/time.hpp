#pragma once

#include <chrono>

namespace lamprey::robot_bridge::emulators {

/// A moment, since the origin of the machine's monotonic clock (CLOCK_MONOTONIC), or a span of time. Whatever reckons
/// with time is handed it; only the programs look at a clock.
using Time = std::chrono::nanoseconds;

/// Motion and sensors are computed for moments this far apart.
inline constexpr Time tick = std::chrono::milliseconds{1};

inline double in_seconds(Time time) {
  return std::chrono::duration<double>(time).count();
}

}  // namespace lamprey::robot_bridge::emulators
