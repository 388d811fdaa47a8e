#include "science/actuators/servo.hpp"

#include <gtest/gtest.h>

namespace lamprey::science::actuators {
namespace {

TEST(Servo, PlusAndMinusFourMoveExactlyOnePositionAndEndAtRest) {
  Servo servo{10, 0};
  drive_half_step(servo, unit_move_voltage);
  EXPECT_EQ(servo, (Servo{10.5, 2}));
  drive_half_step(servo, -unit_move_voltage);
  EXPECT_EQ(servo, (Servo{11, 0}));
  drive_half_step(servo, -unit_move_voltage);
  drive_half_step(servo, unit_move_voltage);
  EXPECT_EQ(servo, (Servo{10, 0}));
}

TEST(Servo, CoastsWithoutVoltage) {
  Servo servo{3, 0.5};
  for (int half = 0; half < 2 * half_steps; ++half) drive_half_step(servo, 0);
  EXPECT_EQ(servo, (Servo{4, 0.5}));
}

TEST(Servo, ConstantVoltageGivesTheParabola) {
  // θ = Vt²/2 = 1 and dθ/dt = Vt = 1 after t = 2 steps at V = 1/2.
  Servo servo;
  for (int half = 0; half < 2 * half_steps; ++half) drive_half_step(servo, 0.5);
  EXPECT_EQ(servo, (Servo{1, 1}));
}

}  // namespace
}  // namespace lamprey::science::actuators
