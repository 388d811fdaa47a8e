#include "science/networks/one_mother.hpp"

#include "science/gaits/presets.hpp"
#include "tests/science/networks/output_text.hpp"

#include <gtest/gtest.h>
#include <string>

namespace lamprey::science::networks {
namespace {

OneMotherNetwork one_child(const ChildTimes& times, double trigger_period) {
  OneMotherNetwork network{.trigger_period = trigger_period};
  network.child_times[0] = times;
  return network;
}

std::string outputs(const OneMotherNetwork& network, int time_steps, OneMotherState& state) {
  return output_text(whole_steps(network), state, time_steps)[0];
}

std::string outputs(const OneMotherNetwork& network, int time_steps) {
  OneMotherState state;
  return outputs(network, time_steps, state);
}

TEST(OneMother, TriggersAtTheFirstStepAndThenEveryTriggerPeriod) {
  EXPECT_EQ(outputs(one_child({0, 1, 0, 1}, 4), 12), "+-00+-00+-00");
}

TEST(OneMother, AChildRunsThroughItsWholeCycle) {
  EXPECT_EQ(outputs(one_child({2, 3, 4, 1}, 100), 14), "00+++0000-0000");
}

TEST(OneMother, ATriggerDuringAChildsCycleIsIgnored) {
  // A cycle of five steps: the triggers at 3, 9 and so on come too early.
  EXPECT_EQ(outputs(one_child({0, 2, 1, 2}, 3), 12), "++0--0++0--0");
}

TEST(OneMother, ATriggerInTheStepAfterACycleStartsTheNext) {
  EXPECT_EQ(outputs(one_child({0, 2, 0, 2}, 4), 12), "++--++--++--");
}

TEST(OneMother, TimesAreRoundedDownAndATriggerPeriodBelowOneIsOne) {
  EXPECT_EQ(outputs(one_child({0.9, 1.9, 0, 1.2}, 4.99), 8), "+-00+-00");
  EXPECT_EQ(outputs(one_child({1, 1, 0, 1}, 0), 9), "0+-0+-0+-");
}

TEST(OneMother, AChildWithoutTimesIsSilent) {
  EXPECT_EQ(outputs(one_child({0, 0, 0, 0}, 1), 5), "00000");
}

TEST(OneMother, AFinishedCycleStaysFinishedUnderLongerTimes) {
  OneMotherState state;
  EXPECT_EQ(outputs(one_child({0, 2, 0, 0}, 10), 4, state), "++00");
  EXPECT_EQ(outputs(one_child({0, 8, 0, 0}, 10), 8, state), "000000++");
}

TEST(OneMother, ACycleThatShrinksBelowItsPlaceEndsAndTheNextTriggerStartsAnother) {
  OneMotherState state;
  EXPECT_EQ(outputs(one_child({0, 20, 0, 0}, 5), 5, state), "+++++");
  EXPECT_EQ(outputs(one_child({0, 3, 0, 0}, 5), 5, state), "+++00");
}

TEST(OneMother, WithTheTimesOfFigure713AndATriggerPeriodOfNineMakesTheTilesOfThatFigureForEver) {
  const std::array<std::string, children> tiles{"0000+000-", "+0000000-", "0000+-000", "+-0000000",
                                                "000000+0-", "00+00000-", "000000+-0", "00+-00000"};
  OneMotherState state;
  const auto text = output_text(whole_steps(gaits::one_mother(gaits::Gait::walk_frames)), state, 36);
  for (std::size_t number = 1; number <= children; ++number) {
    const std::string& tile = tiles[number - 1];
    EXPECT_EQ(text[child_of_neuron(number)], tile + tile + tile + tile) << "N" << number;
  }
}

}  // namespace
}  // namespace lamprey::science::networks
