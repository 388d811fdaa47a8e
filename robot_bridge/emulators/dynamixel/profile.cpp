#include "robot_bridge/emulators/dynamixel/profile.hpp"

#include "robot_bridge/emulators/time.hpp"

#include <algorithm>
#include <cmath>

namespace lamprey::robot_bridge::emulators::dynamixel {
namespace {

/// Ticks of position that a sum of steps may be off by rounding. A remainder of one bit, divided over a move's time,
/// would be too little to be added: the servo would never be there.
constexpr double rounding = 1e-6;

/// The highest speed from which one comes to rest within `distance` when each tick takes the same from it: from
/// s = v²/2a + v·t/2.
double stopping_speed(double distance, double acceleration, double seconds) {
  if (std::isinf(acceleration)) return acceleration;
  const double change = acceleration * seconds;
  return (std::sqrt(change * change + 8 * acceleration * distance) - change) / 2;
}

}  // namespace

void Motion::go_to(double goal, const Profile& profile) {
  goal_ = goal;
  profile_ = profile;
}

void Motion::stop() {
  goal_ = position_;
  velocity_ = 0;
}

void Motion::place(double position) {
  position_ = position;
  stop();
}

void Motion::follow() {
  const double seconds = in_seconds(tick);
  const double distance = goal_ - position_;
  const double change = profile_.acceleration * seconds;
  const double speed = std::min(profile_.speed, stopping_speed(std::abs(distance), profile_.acceleration, seconds));
  const double wanted = distance == 0 ? 0 : std::copysign(speed, distance);
  velocity_ = std::clamp(wanted, velocity_ - change, velocity_ + change);
  const double step = velocity_ * seconds;
  const bool reached = std::signbit(step) == std::signbit(distance) && std::abs(step) + rounding >= std::abs(distance);
  // Too fast to stop in time, it passes its goal and comes back. (Nothing is too fast for a motor without limits.)
  if (reached && !(std::abs(velocity_ - wanted) > change)) {
    position_ = goal_;
    velocity_ = 0;
    return;
  }
  position_ += step;
}

}  // namespace lamprey::robot_bridge::emulators::dynamixel
