#pragma once

#include "science/actuators/reflex.hpp"
#include "science/actuators/servo.hpp"
#include "science/neurons/leaky_integrator.hpp"
#include "science/robots/quadruped.hpp"
#include "science/saving/archive.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace lamprey::science::actuators {

// How a controller's output becomes the move of one servo. Both robots use it: in each time step `command` is called
// once per servo, and the robot moves by what it returns.

/// unit_move: a pulse moves the servo by one position (eqs 6.1, 6.2, 7.2). leaky_chain: McMinn's chain (2.6.1, figs 2.5
/// and 2.6): output → leaky integrator → reflex → servo of eq. 6.1.
enum class ActuatorPath : std::uint8_t { unit_move, leaky_chain };

/// What a controller puts out. pulses: −1, 0 or +1, the direction to move in. levels: a wanted servo position, any
/// real.
enum class OutputKind : std::uint8_t { pulses, levels };

struct Range {
  double minimum;
  double maximum;
  double default_value;
};

// The chain's parameters. Every reflex within its two ranges is stable.
inline constexpr Range integrator_time_constant_range{1, 100, 2};  ///< τ, time steps (fig. 2.6)
inline constexpr Range actuator_stroke_range{0, 20, 5};            ///< positions
inline constexpr Range reflex_gain_range{0.1, 4, 1};               ///< per squared time step (fig. 2.5)
inline constexpr Range reflex_damping_range{1.1, 3.5, 1.75};       ///< per time step (fig. 2.5)

/// The path of every servo of a robot. What follows `path` is the chain's; the unit move has no parameters.
struct Actuator {
  ActuatorPath path = ActuatorPath::unit_move;
  neurons::LeakyIntegrator integrator{integrator_time_constant_range.default_value};
  /// How far from standing an unending pulse of +1 moves a servo; levels do not use it.
  double stroke = actuator_stroke_range.default_value;
  Reflex reflex{reflex_gain_range.default_value, reflex_damping_range.default_value};

  bool operator==(const Actuator&) const = default;
};

/// What of one servo lives on from step to step. All positions are relative to the standing one, so a fresh state is at
/// rest in it. The unit move keeps nothing. Trivially copyable: it may travel in evolution::Body.
struct ActuatorState {
  neurons::LeakyIntegratorState integrator;  ///< in positions
  Servo servo;

  bool operator==(const ActuatorState&) const = default;
};

void fields(auto& archive, saving::Of<ActuatorState> auto& state) {
  fields(archive, state.integrator);
  fields(archive, state.servo);
}

/// At rest `offset` positions from standing, where the integrator's output holds it.
constexpr ActuatorState at_rest(double offset) {
  return {.integrator = {offset}, .servo = {offset, 0}};
}

constexpr std::int16_t sign(double value) {
  return static_cast<std::int16_t>(int{value > 0} - int{value < 0});
}

/// The nearest whole position, halves upwards.
inline double nearest_position(double angle) {
  return std::floor(angle + 0.5);
}

/// One time step of the chain; the command that keeps the robot's whole position the nearest to the servo's. The servo
/// has hard stops at the robot's limits: pressed against one by half a position or more, it gives a command beyond it.
inline std::int16_t leaky_chain_command(const Actuator& actuator, OutputKind kind, double output, std::int16_t position,
                                        std::int16_t standing, ActuatorState& state) {
  const double wanted = kind == OutputKind::pulses ? actuator.stroke * output : output - standing;
  drive(actuator.reflex, step(actuator.integrator, wanted, state.integrator), state.servo);

  const std::int16_t result = sign(nearest_position(standing + state.servo.angle) - position);
  const double lowest = robots::lowest_position - standing;
  const double highest = robots::highest_position - standing;
  if (state.servo.angle < lowest || state.servo.angle > highest) {
    state.servo = {std::clamp(state.servo.angle, lowest, highest), 0};
  }
  return result;
}

/// The command to a servo for one time step, −1, 0 or +1, given a controller's `output` of that kind.
/// `position` is the robot's position of that servo before the step; `standing` the one that the chain holds at an
/// output of 0, within the robot's limits. The unit move's command is the pulse itself, or one position towards the
/// level. Pure but for `state`.
inline std::int16_t command(const Actuator& actuator, OutputKind kind, double output, std::int16_t position,
                            std::int16_t standing, ActuatorState& state) {
  if (actuator.path == ActuatorPath::leaky_chain) {
    return leaky_chain_command(actuator, kind, output, position, standing, state);
  }
  return kind == OutputKind::pulses ? sign(output) : sign(nearest_position(output) - position);
}

}  // namespace lamprey::science::actuators
