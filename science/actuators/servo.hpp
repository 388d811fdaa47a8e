#pragma once

#include "science/saving/archive.hpp"

namespace lamprey::science::actuators {

/// The linear servomotor of eq. 6.1, a double integrator: d²θ/dt² = V.
struct Servo {
  double angle = 0;  ///< θ, in positions
  double speed = 0;  ///< dθ/dt, in positions per time step

  bool operator==(const Servo&) const = default;
};

void fields(auto& archive, saving::Of<Servo> auto& servo) {
  archive.real("angle", servo.angle);
  archive.real("speed", servo.speed);
}

/// A voltage is held for half a time step, so that one step can both start a move and stop it.
inline constexpr double half_step = 0.5;
inline constexpr int half_steps = 2;

/// Held for a half-step each, +V and −V move the servo by exactly one position and leave it at rest; that is what a
/// pulse of +1 does to a leg (eqs 6.2 and 7.2).
inline constexpr double unit_move_voltage = 4;

/// Half a time step at constant `voltage`: the exact solution of eq. 6.1, θ + θ̇h + Vh²/2 and θ̇ + Vh. Pure but for
/// `servo`.
inline void drive_half_step(Servo& servo, double voltage) {
  servo.angle += servo.speed * half_step + 0.5 * voltage * half_step * half_step;
  servo.speed += voltage * half_step;
}

}  // namespace lamprey::science::actuators
