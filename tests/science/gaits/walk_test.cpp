#include "science/gaits/walk.hpp"

#include "science/problems/quadruped_problem.hpp"
#include "science/robots/quadruped.hpp"

#include <gtest/gtest.h>

namespace lamprey::science::gaits {
namespace {

using namespace robots;

/// One evaluation of 100 steps from where the body is.
fitness::Fitness walk_on(evolution::Body& body) {
  static const auto problem = problems::make_quadruped_problem({});
  return problem->evaluate(problem->preset(), {}, body);
}

TEST(Walk, ScoresEightySixtyEightyThreeExactly) {
  evolution::Body body;
  EXPECT_EQ(walk_on(body), (fitness::Fitness{.stability = 80, .distance = 60, .fuel = 83}));
}

TEST(Walk, HasThePublishedMeanExpectedFitnessOverTheGridsWeights) {
  evolution::Body body;
  const fitness::Fitness walked = walk_on(body);
  double sum = 0;
  for (const double s : {0.25, 0.5, 0.75, 1.0}) {
    for (const double d : {0.25, 0.5, 0.75, 1.0}) {
      for (const double f : {0.25, 0.5, 0.75, 1.0}) sum += fitness::total(walked, {s, d, f});
    }
  }
  EXPECT_EQ(sum / 64, 139.375);  // 8.3.2
}

TEST(Walk, ScoresTheSameInEveryPeriod) {
  evolution::Body body;
  const fitness::Fitness first = walk_on(body);
  for (int period = 1; period < 10; ++period) EXPECT_EQ(walk_on(body), first) << period;
}

TEST(Walk, LiftsOneLegAtATimeBackLeftFirstThenRestsThenPushesWithAllLegs) {
  const auto steps = networks::whole_steps(walk());
  networks::FourMotherState state;
  Quadruped robot = standing();
  for (const Leg leg : {back_left, front_left, back_right, front_right}) {
    for (int t = 0; t < 20; ++t) {
      const QuadrupedStep result = step(robot, networks::step(steps, state));
      ASSERT_EQ(result.feet_on_ground, 15U & ~(1U << leg)) << leg << " " << t;
      ASSERT_EQ(result.drags, 0);
    }
    EXPECT_EQ(robot.position[horizontal_servo(leg)], 20);
  }
  for (int t = 0; t < 10; ++t)
    ASSERT_EQ(step(robot, networks::step(steps, state)), QuadrupedStep{.feet_on_ground = 15});
  for (int t = 0; t < 10; ++t) {
    const QuadrupedStep push{.feet_on_ground = 15, .front_pushes = 2, .back_pushes = 2, .moved = true};
    ASSERT_EQ(step(robot, networks::step(steps, state)), push);
  }
  EXPECT_EQ(robot, standing());
}

}  // namespace
}  // namespace lamprey::science::gaits
