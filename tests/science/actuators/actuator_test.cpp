#include "science/actuators/actuator.hpp"

#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <type_traits>
#include <vector>

namespace lamprey::science::actuators {
namespace {

static_assert(std::is_trivially_copyable_v<ActuatorState>);

constexpr std::int16_t standing = 10;

Actuator chain() {
  return {.path = ActuatorPath::leaky_chain};
}

/// A servo of a robot with limits, under an actuator.
struct Driven {
  Actuator actuator;
  std::int16_t position = standing;
  ActuatorState state{};

  std::int16_t drive(OutputKind kind, double output) {
    const std::int16_t given = command(actuator, kind, output, position, standing, state);
    const int wanted = position + given;
    position = static_cast<std::int16_t>(std::clamp<int>(wanted, robots::lowest_position, robots::highest_position));
    return given;
  }
};

TEST(UnitMove, APulseIsTheCommand) {
  Driven servo{{}};
  EXPECT_EQ(servo.drive(OutputKind::pulses, 1), 1);
  EXPECT_EQ(servo.drive(OutputKind::pulses, 0), 0);
  EXPECT_EQ(servo.drive(OutputKind::pulses, -1), -1);
  EXPECT_EQ(servo.state, ActuatorState{});
}

TEST(UnitMove, ALevelIsApproachedOnePositionAtATime) {
  Driven servo{{}};
  for (const int expected : {11, 12, 13, 13}) {
    servo.drive(OutputKind::levels, 13.4);
    EXPECT_EQ(servo.position, expected);
  }
  servo.drive(OutputKind::levels, 13.5);
  EXPECT_EQ(servo.position, 14) << "halves upwards";
  servo.drive(OutputKind::levels, 0);
  EXPECT_EQ(servo.position, 13);
}

TEST(LeakyChain, StaysWhereItStandsWithoutOutput) {
  Driven servo{chain()};
  for (int time = 0; time < 50; ++time) {
    EXPECT_EQ(servo.drive(OutputKind::pulses, 0), 0);
    EXPECT_EQ(servo.drive(OutputKind::levels, standing), 0);
  }
  EXPECT_EQ(servo.state, ActuatorState{});
}

TEST(LeakyChain, AnUnendingPulseMovesByTheStroke) {
  for (const int direction : {1, -1}) {
    Driven servo{chain()};
    for (int time = 0; time < 100; ++time) servo.drive(OutputKind::pulses, direction);
    EXPECT_EQ(servo.position, standing + direction * 5);
    EXPECT_NEAR(servo.state.servo.angle, direction * 5, 1e-9);
    EXPECT_NEAR(servo.state.servo.speed, 0, 1e-9);
  }
}

TEST(LeakyChain, IsTheIntegratorTheReflexAndTheServoInARow) {
  // τ = 2, stroke 1/4, from rest: y = 1/8; V = 1/8, then 1/8 − θ − 7/4·dθ/dt.
  Driven servo{chain()};
  servo.actuator.stroke = 0.25;
  servo.drive(OutputKind::pulses, 1);
  EXPECT_EQ(servo.state.integrator.output, 0.125);
  // First half-step: V = 1/8, θ = 1/64, speed 1/16. Second: V = 1/8 − 1/64 − 7/64 = 0, so it coasts: θ = 1/64 + 1/32.
  EXPECT_EQ(servo.state.servo, (Servo{0.046875, 0.0625}));
  EXPECT_EQ(servo.position, standing);
}

TEST(LeakyChain, ALevelIsTheWantedPositionWhateverTheStroke) {
  Driven servo{chain()};
  servo.actuator.stroke = 0;
  for (int time = 0; time < 100; ++time) servo.drive(OutputKind::levels, 17);
  EXPECT_EQ(servo.position, 17);
}

TEST(LeakyChain, TheRobotsPositionIsTheServosRoundedAndMovesOnePositionAtMost) {
  for (const double gain : {reflex_gain_range.minimum, reflex_gain_range.maximum}) {
    for (const double damping : {reflex_damping_range.minimum, reflex_damping_range.maximum}) {
      Driven servo{chain()};
      servo.actuator.integrator.time_constant = 1;
      servo.actuator.stroke = 9;
      servo.actuator.reflex = {gain, damping};
      for (int time = 0; time < 300; ++time) {
        // Pulses of changing lengths, both signs and rests.
        const int pulse = (time * time / 37) % 3 - 1;
        EXPECT_LE(std::abs(servo.drive(OutputKind::pulses, pulse)), 1);
        ASSERT_EQ(servo.position, nearest_position(standing + servo.state.servo.angle)) << time;
      }
    }
  }
}

TEST(LeakyChain, AServoThatPressesAgainstAStopGivesACommandBeyondItAndRestsThere) {
  Driven servo{chain()};
  servo.actuator.stroke = 20;
  int last = 0;
  for (int time = 0; time < 60; ++time) last = servo.drive(OutputKind::pulses, -1);
  EXPECT_EQ(servo.position, robots::lowest_position);
  EXPECT_EQ(last, -1) << "the wanted position is −10";
  EXPECT_EQ(servo.state.servo, (Servo{robots::lowest_position - standing, 0}));

  // Free again as soon as something within the limits is wanted: nothing has been wound up but the integrator.
  servo.actuator.integrator.time_constant = 1;
  servo.drive(OutputKind::levels, 5);
  servo.drive(OutputKind::levels, 5);
  EXPECT_GT(servo.position, robots::lowest_position);
}

TEST(LeakyChain, AStateAtRestIsHeldByItsIntegrator) {
  Driven servo{chain(), 15, at_rest(5)};
  EXPECT_EQ(servo.drive(OutputKind::pulses, 1), 0);
  EXPECT_EQ(servo.state, at_rest(5)) << "5 is the stroke: +1 holds it";
}

TEST(Actuator, DefaultsAreThoseOfTheRanges) {
  const Actuator actuator;
  EXPECT_EQ(actuator.path, ActuatorPath::unit_move);
  EXPECT_EQ(actuator.integrator.time_constant, 2);
  EXPECT_EQ(actuator.stroke, 5);
  EXPECT_EQ(actuator.reflex, Reflex{});
  EXPECT_EQ(Reflex{}.gain, reflex_gain_range.default_value);
  EXPECT_EQ(Reflex{}.damping, reflex_damping_range.default_value);
}

}  // namespace
}  // namespace lamprey::science::actuators
