#include "science/fitness/quadruped_trial.hpp"

#include "science/gaits/walk.hpp"

#include <gtest/gtest.h>

namespace lamprey::science::fitness {
namespace {

using namespace networks;

TEST(QuadrupedTrial, ANetworkThatDoesNothingStandsStill) {
  QuadrupedTrial::Body body;
  EXPECT_EQ(QuadrupedTrial{}.evaluate({}, body), (Fitness{.stability = 0, .distance = 0, .fuel = 100}));
  EXPECT_EQ(body.robot, robots::standing());
}

TEST(QuadrupedTrial, OneLegLiftedAndLoweredByHand) {
  FourMotherNetwork network;
  network.mother_times[front_vertical] = {10, 10};
  network.child_times[child(front_vertical, left)] = {2, 3, 0, 3};
  QuadrupedTrial::Body body;
  // Steps 2..4 lift and 10..12 lower the foot: in the air in 2..12, which are 11 of 20 steps on three feet (eq. 7.5);
  // fuel 1000 − 11 (row 8) − 6 (row 9).
  EXPECT_EQ(QuadrupedTrial{.time_steps = 20}.evaluate(network, body),
            (Fitness{.stability = 55, .distance = 0, .fuel = 98.3}));
}

TEST(QuadrupedTrial, OneLegPushedAgainstItsLimitByHand) {
  FourMotherNetwork network;
  network.mother_times[back_horizontal] = {1, 99};
  network.child_times[child(back_horizontal, right)] = {0, 0, 0, 14};
  QuadrupedTrial::Body body;
  // From step 1 the back right leg pushes ten times, then meets the limit four times: D = 100·2·10/50,
  // fuel 1000 − 10 (row 9) − 4·10 (row 1).
  EXPECT_EQ(QuadrupedTrial{.time_steps = 50}.evaluate(network, body),
            (Fitness{.stability = 0, .distance = 40, .fuel = 95}));
  EXPECT_EQ(body.robot.position[robots::horizontal_servo(robots::back_right)], 0);
}

TEST(QuadrupedTrial, OneLegPressedDownInclinesTheBodyByHand) {
  FourMotherNetwork network;
  network.mother_times[front_vertical] = {1, 99};
  network.child_times[child(front_vertical, right)] = {0, 0, 4, 2};
  QuadrupedTrial::Body body;
  // The foot goes down in steps 5 and 6 and stays: inclined in 5..9, on four feet.
  EXPECT_EQ(QuadrupedTrial{.time_steps = 10}.evaluate(network, body),
            (Fitness{.stability = -50, .distance = 0, .fuel = 99.8}));
}

TEST(QuadrupedTrial, ABodyWalksOnWhereItWasLeft) {
  // Four evaluations of 25 steps pass through the same states as one of 100.
  const auto walk = gaits::walk();
  QuadrupedTrial::Body whole;
  const Fitness all = QuadrupedTrial{.time_steps = 100}.evaluate(walk, whole);
  QuadrupedTrial::Body parts;
  Fitness sum;
  for (int part = 0; part < 4; ++part) {
    const Fitness quarter = QuadrupedTrial{.time_steps = 25}.evaluate(walk, parts);
    sum.stability += quarter.stability / 4;
    sum.distance += quarter.distance / 4;
    sum.fuel += quarter.fuel - 100;
  }
  EXPECT_EQ(parts, whole);
  EXPECT_NEAR(sum.stability, all.stability, 1e-12);
  EXPECT_NEAR(sum.distance, all.distance, 1e-12);
  EXPECT_NEAR(100 + sum.fuel, all.fuel, 1e-12);
}

}  // namespace
}  // namespace lamprey::science::fitness
