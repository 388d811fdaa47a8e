#pragma once

#include "science/actuators/servo.hpp"

#include <algorithm>

namespace lamprey::science::actuators {

/// McMinn's artificial stretch reflex (2.6.1, fig. 2.5): a position controller with feedback from the actuator,
/// V = gain·(wanted − θ) − damping·dθ/dt, which drives the servo of eq. 6.1 anew every half-step.
///
/// With h = 1/2, a = gain·h²/2 and b = damping·h the closed loop has trace 2 − a − b and determinant 1 − b + a, so it
/// is stable if and only if gain > 0 and gain/4 < damping < 4, and critically damped where b = √(8a) − a, with both
/// poles at 1 − √(2a). Gain 1 and damping 7/4 put them at 1/2 exactly: an error shrinks to a quarter in a time step, in
/// the long run. Gain 4 and damping 3 put them at 0, and then the voltages for one position are the unit move's +4 and
/// −4.
struct Reflex {
  double gain = 1;        ///< per squared time step
  double damping = 1.75;  ///< per time step

  bool operator==(const Reflex&) const = default;
};

/// The robots' legs move at most one position in a time step (7.2).
inline constexpr double highest_speed = 1;

constexpr double voltage(const Reflex& reflex, const Servo& servo, double wanted_angle) {
  return reflex.gain * (wanted_angle - servo.angle) - reflex.damping * servo.speed;
}

/// `wanted_voltage`, or what of it brings the servo to its highest speed by the end of the half-step.
constexpr double speed_limited(const Servo& servo, double wanted_voltage) {
  const double fastest_forward = (highest_speed - servo.speed) / half_step;
  const double fastest_back = (-highest_speed - servo.speed) / half_step;
  return std::clamp(wanted_voltage, fastest_back, fastest_forward);
}

/// One time step towards `wanted_angle`. A servo within its highest speed stays so, and moves at most one position.
/// Pure but for `servo`.
inline void drive(const Reflex& reflex, double wanted_angle, Servo& servo) {
  for (int half = 0; half < half_steps; ++half) {
    drive_half_step(servo, speed_limited(servo, voltage(reflex, servo, wanted_angle)));
  }
}

}  // namespace lamprey::science::actuators
