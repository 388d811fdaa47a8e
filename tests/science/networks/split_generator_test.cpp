#include "science/networks/split_generator.hpp"

#include <gtest/gtest.h>
#include <string>

namespace lamprey::science::networks {
namespace {

/// Where one servo is wanted: ^ at its stroke, . standing.
std::string levels(const SplitGenerator& network, std::size_t servo, int time_steps) {
  const SplitGeneratorSteps steps = whole_steps(network);
  SplitGeneratorState state;
  std::string text;
  for (int t = 0; t < time_steps; ++t) {
    const double level = step(steps, state)[servo];
    text += level == standing_level + pulse_stroke ? '^' : level == standing_level ? '.' : '?';
  }
  return text;
}

/// A pattern neuron that follows the first or the second neuron of an oscillator.
SplitGenerator follower(double on_time, double off_time, double pulse, std::size_t followed) {
  SplitGenerator network{.oscillator_on_time = on_time, .oscillator_off_time = off_time};
  network.pattern[5] = {.threshold = 0.5, .time = pulse};
  network.pattern[5].weights[followed] = 1;
  return network;
}

TEST(SplitGenerator, TheOscillatorsNeuronsAreInAntiphaseFromTheFirstStepOn) {
  EXPECT_EQ(levels(follower(4, 4, 2, 0), 5, 24), "^^......^^......^^......");
  EXPECT_EQ(levels(follower(4, 4, 2, 1), 5, 24), "....^^......^^......^^..");
}

TEST(SplitGenerator, WithALongerOffTimeTheSecondNeuronFollowsTheFirstAndBothRest) {
  EXPECT_EQ(levels(follower(2, 6, 1, 0), 5, 16), "^.......^.......");
  EXPECT_EQ(levels(follower(2, 6, 1, 1), 5, 16), "..^.......^.....");
}

TEST(SplitGenerator, APulseMayOutlastTheBeatThatStartedIt) {
  EXPECT_EQ(levels(follower(4, 4, 6, 0), 5, 16), "^^^^^^..^^^^^^..");
}

TEST(SplitGenerator, ANetThatNeverPassesTheThresholdLeavesTheServoStanding) {
  SplitGenerator network = follower(4, 4, 2, 0);
  network.pattern[5].threshold = 1;
  EXPECT_EQ(levels(network, 5, 16), std::string(16, '.'));
  EXPECT_EQ(levels(follower(4, 4, 2, 0), 0, 16), std::string(16, '.')) << "no connections";
}

}  // namespace
}  // namespace lamprey::science::networks
