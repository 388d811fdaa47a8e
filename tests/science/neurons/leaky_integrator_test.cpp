#include "science/neurons/leaky_integrator.hpp"

#include <gtest/gtest.h>

namespace lamprey::science::neurons {
namespace {

TEST(LeakyIntegrator, StepResponseApproachesTheInputByAShareOfTheRest) {
  // y = 1 − (1 − 1/τ)ⁿ; with τ = 2 and 4 exact in binary.
  for (const double time_constant : {2.0, 4.0}) {
    LeakyIntegratorState state;
    double rest = 1;
    for (int n = 1; n <= 12; ++n) {
      rest *= 1 - 1 / time_constant;
      EXPECT_EQ(step({time_constant}, 1, state), 1 - rest) << time_constant << ' ' << n;
    }
  }
}

TEST(LeakyIntegrator, LeaksBackWithoutInput) {
  LeakyIntegratorState state{1};
  EXPECT_EQ(step({2}, 0, state), 0.5);
  EXPECT_EQ(step({2}, 0, state), 0.25);
  EXPECT_EQ(state.output, 0.25);
}

TEST(LeakyIntegrator, ATimeConstantOfOnePassesTheInputThrough) {
  LeakyIntegratorState state{-1};
  EXPECT_EQ(step({1}, 0.75, state), 0.75);
}

TEST(LeakyIntegrator, TurnsAPulseIntoARiseAndADecay) {
  LeakyIntegratorState state;
  const double expected[] = {0.5, 0.75, 0.375, 0.1875};
  for (int n = 0; n < 4; ++n) EXPECT_EQ(step({2}, n < 2 ? 1 : 0, state), expected[n]) << n;
}

}  // namespace
}  // namespace lamprey::science::neurons
