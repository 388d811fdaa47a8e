#include "science/actuators/reflex.hpp"

#include "science/actuators/actuator.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace lamprey::science::actuators {
namespace {

TEST(Reflex, ByDefaultBothPolesOfAHalfStepAreOneHalf) {
  // A double pole p from rest: the error is (1 + cn)·pⁿ after n half-steps, with c = 3/4 as the first takes an eighth
  // off it. All numbers are exact in binary, and slow enough for the speed limit.
  const Reflex reflex;
  Servo servo;
  double power = 1;
  for (int time = 1; time <= 20; ++time) {
    drive(reflex, 0.25, servo);
    power /= 4;
    EXPECT_EQ(0.25 - servo.angle, 0.25 * (1 + 0.75 * 2 * time) * power) << time;
  }
}

TEST(Reflex, GainFourAndDampingThreeMakeTheUnitMove) {
  const Reflex deadbeat{4, 3};
  Servo servo;
  EXPECT_EQ(voltage(deadbeat, servo, 1), unit_move_voltage);
  drive_half_step(servo, unit_move_voltage);
  EXPECT_EQ(voltage(deadbeat, servo, 1), -unit_move_voltage);
}

TEST(Reflex, SpeedIsLimitedToOnePositionPerStep) {
  const Reflex reflex;
  Servo servo;
  drive(reflex, 30, servo);
  EXPECT_EQ(servo, (Servo{0.75, 1})) << "half a step to reach the highest speed";
  for (int time = 1; time < 20; ++time) {
    drive(reflex, 30, servo);
    EXPECT_EQ(servo, (Servo{0.75 + time, 1}));
  }
  drive(reflex, -30, servo);
  EXPECT_EQ(servo.speed, -1) << "and back";
}

TEST(Reflex, NeverOvershootsByDefaultFromAnywhere) {
  const Reflex reflex;
  for (double error = -30; error <= 30; error += 0.125) {
    Servo servo{error, 0};
    for (int time = 0; time < 60; ++time) {
      drive(reflex, 0, servo);
      ASSERT_GE(servo.angle * error, 0) << error << " at " << time;
      ASSERT_LE(std::fabs(servo.speed), highest_speed) << error << " at " << time;
    }
    EXPECT_LT(std::fabs(servo.angle), 1e-6) << error;
  }
}

/// The linear loop is stable if and only if (Jury) 1 − trace + determinant, 1 + trace + determinant and
/// 1 − determinant are all positive.
bool stable(const Reflex& reflex) {
  const double a = reflex.gain * half_step * half_step / 2;
  const double b = reflex.damping * half_step;
  const double trace = 2 - a - b;
  const double determinant = 1 - b + a;
  return 1 - trace + determinant > 0 && 1 + trace + determinant > 0 && 1 - determinant > 0;
}

TEST(Reflex, TheLinearLoopIsTheOneThatTheServoMakes) {
  // Trace and determinant are those of the map of (error, speed) over a half-step, found by driving unit vectors.
  const Reflex reflex{0.3, 1.3};
  Servo from_error{1, 0};
  Servo from_speed{0, 1};
  drive_half_step(from_error, voltage(reflex, from_error, 0));
  drive_half_step(from_speed, voltage(reflex, from_speed, 0));
  const double a = reflex.gain * half_step * half_step / 2;
  const double b = reflex.damping * half_step;
  EXPECT_NEAR(from_error.angle + from_speed.speed, 2 - a - b, 1e-15);
  EXPECT_NEAR(from_error.angle * from_speed.speed - from_speed.angle * from_error.speed, 1 - b + a, 1e-15);
}

TEST(Reflex, EveryGainAndDampingOfTheRangesIsStable) {
  const double gains[] = {reflex_gain_range.minimum, 0.5, 1, 2, 3, reflex_gain_range.maximum};
  const double dampings[] = {reflex_damping_range.minimum, 1.75, 2.5, 3, reflex_damping_range.maximum};
  for (const double gain : gains) {
    for (const double damping : dampings) {
      const Reflex reflex{gain, damping};
      EXPECT_TRUE(stable(reflex)) << gain << ' ' << damping;
      // With the speed limit the loop isn't linear: it settles from both limits, at any allowed speed.
      for (const double error : {-30.0, -7.3, 0.6, 30.0}) {
        for (const double speed : {-1.0, 0.0, 1.0}) {
          Servo servo{error, speed};
          for (int time = 0; time < 400; ++time) drive(reflex, 0, servo);
          EXPECT_LT(std::fabs(servo.angle), 0.01) << gain << ' ' << damping << ' ' << error << ' ' << speed;
        }
      }
    }
  }
  EXPECT_FALSE(stable({4, 1})) << "damping = gain / 4 is the border";
  EXPECT_FALSE(stable({1, 4})) << "and so is 4";
}

}  // namespace
}  // namespace lamprey::science::actuators
