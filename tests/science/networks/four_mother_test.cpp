#include "science/networks/four_mother.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace lamprey::science::networks {
namespace {

/// A network of which only the front vertical mother and its left child do anything.
FourMotherNetwork one_child(const MotherTimes& mother, const ChildTimes& times) {
  FourMotherNetwork network;
  network.mother_times[front_vertical] = mother;
  network.child_times[child(front_vertical, left)] = times;
  return network;
}

/// The outputs of one child over the steps, as +, − and 0.
std::string outputs(const FourMotherNetwork& network, int time_steps, FourMotherState& state, std::size_t of = 0) {
  const FourMotherSteps steps = whole_steps(network);
  std::string text;
  for (int t = 0; t < time_steps; ++t) {
    const int output = step(steps, state)[of];
    text += output > 0 ? '+' : output < 0 ? '-' : '0';
  }
  return text;
}

std::string outputs(const FourMotherNetwork& network, int time_steps, std::size_t of = 0) {
  FourMotherState state;
  return outputs(network, time_steps, state, of);
}

TEST(FourMother, TheRisingEdgeStartsTheOnPhaseAtTheFirstStep) {
  EXPECT_EQ(outputs(one_child({4, 6}, {0, 2, 0, 0}), 20), "++00000000++00000000");
  EXPECT_EQ(outputs(one_child({4, 6}, {3, 2, 0, 0}), 20), "000++00000000++00000");
}

TEST(FourMother, TheFallingEdgeStartsTheOffPhase) {
  EXPECT_EQ(outputs(one_child({4, 6}, {0, 0, 0, 3}), 20), "0000---0000000---000");
  EXPECT_EQ(outputs(one_child({4, 6}, {0, 0, 2, 3}), 20), "000000---0000000---0");
}

TEST(FourMother, ThePhasesRunIndependentlyAndAreSummed) {
  EXPECT_EQ(outputs(one_child({4, 6}, {0, 6, 0, 4}), 10), "++++00--00");
}

TEST(FourMother, AnOffWindowMayReachIntoTheNextPeriod) {
  EXPECT_EQ(outputs(one_child({2, 6}, {0, 0, 4, 4}), 18), "000000----0000----");
}

TEST(FourMother, ANewEdgeRestartsItsOwnPhase) {
  // The window of six never closes before the next rising edge opens it again; one of delay 8 never opens.
  EXPECT_EQ(outputs(one_child({2, 3}, {0, 6, 0, 0}), 15), "+++++++++++++++");
  EXPECT_EQ(outputs(one_child({2, 3}, {8, 6, 0, 0}), 15), "000000000000000");
  EXPECT_EQ(outputs(one_child({2, 3}, {3, 6, 0, 0}), 15), "000++000++000++");
}

TEST(FourMother, TimesAreRoundedDownToWholeSteps) {
  // 8.3.1: a T_ON of 2.512 gives two pulses; 0.488 more make three.
  EXPECT_EQ(outputs(one_child({10, 10}, {0, 2.512, 0, 0}), 10), "++00000000");
  EXPECT_EQ(outputs(one_child({10, 10}, {0, 2.512 + 0.488, 0, 0}), 10), "+++0000000");
  EXPECT_EQ(outputs(one_child({10, 10}, {1.999, 2.999, 0, 0}), 10), "0++0000000");
  EXPECT_EQ(outputs(one_child({2.9, 2.9}, {0, 1, 0, 1}), 10), "+0-0+0-0+0");
}

TEST(FourMother, TheLongestTimesFitAndAPhaseStaysClosedAfterItsWindow) {
  const std::string off(100, '0');
  const std::string plus(100, '+');
  const std::string minus(100, '-');
  EXPECT_EQ(outputs(one_child({100, 0}, {100, 100, 0, 0}), 100'000), off + plus + std::string(99'800, '0'));
  // The falling edge is at 100: delay 100, open from 200 to 300; the next rising edge at 200 closes nothing of it.
  EXPECT_EQ(outputs(one_child({100, 100}, {0, 0, 100, 100}), 400), off + off + minus + off);
}

TEST(FourMother, AMotherWithoutOnTimeMakesNoEdgeAndOneWithoutOffTimeOnlyTheFirst) {
  EXPECT_EQ(outputs(one_child({0, 5}, {0, 2, 0, 2}), 12), "000000000000");
  EXPECT_EQ(outputs(one_child({5, 0}, {0, 2, 0, 2}), 12), "++0000000000");
  EXPECT_EQ(outputs(one_child({0, 0}, {0, 2, 0, 2}), 12), "000000000000");
}

TEST(FourMother, AMotherWhoseLinkIsOffIsSilentAndTheOthersGoOn) {
  FourMotherNetwork network = one_child({4, 6, false}, {0, 2, 0, 2});
  network.mother_times[back_horizontal] = {4, 6};
  network.child_times[child(back_horizontal, right)] = {0, 2, 0, 2};
  EXPECT_EQ(outputs(network, 10, child(front_vertical, left)), "0000000000");
  EXPECT_EQ(outputs(network, 10, child(back_horizontal, right)), "++00--0000");
}

TEST(FourMother, AClockStoppedInMidPeriodLetsPendingWindowsRunOutAndGoesOnWhereItStood) {
  FourMotherNetwork network = one_child({4, 6}, {1, 3, 0, 2});
  FourMotherState state;
  EXPECT_EQ(outputs(network, 2, state), "0+");
  network.mother_times[front_vertical].linked = false;
  EXPECT_EQ(outputs(network, 6, state), "++0000");
  network.mother_times[front_vertical].linked = true;
  EXPECT_EQ(outputs(network, 8, state), "00--0000");
}

TEST(FourMother, EachMotherDrivesItsOwnTwoChildren) {
  for (std::size_t mother = 0; mother < mothers; ++mother) {
    FourMotherNetwork network;
    network.mother_times[mother] = {4, 6};
    network.child_times.fill({0, 1, 0, 1});
    for (std::size_t i = 0; i < children; ++i) {
      EXPECT_EQ(outputs(network, 6, i), i / 2 == mother ? "+000-0" : "000000") << mother << " " << i;
    }
  }
}

TEST(FourMother, NewTimesMeetPendingWindowsAtOnce) {
  FourMotherState state;
  EXPECT_EQ(outputs(one_child({20, 20}, {4, 2, 0, 0}), 3, state), "000");
  EXPECT_EQ(outputs(one_child({20, 20}, {1, 5, 0, 0}), 5, state), "+++00");
}

TEST(FourMother, AStateGoesOnWhereItWasLeft) {
  const auto network = one_child({7, 5}, {2, 3, 1, 4});
  FourMotherState state;
  std::string parts;
  for (const int part : {9, 1, 30}) parts += outputs(network, part, state);
  EXPECT_EQ(parts, outputs(network, 40));
}

TEST(FourMother, KindsAndLegPairsPartitionTheChildren) {
  std::vector<int> seen(children, 0);
  for (const auto i : vertical_children) ++seen[i];
  for (const auto i : horizontal_children) ++seen[i];
  EXPECT_EQ(seen, std::vector<int>(children, 1));
  // The pairs are front and back, left and right, and the two diagonals: each two make the whole robot.
  for (std::size_t pair = 0; pair < children_of_leg_pairs.size(); pair += 2) {
    std::vector<int> counts(children, 0);
    for (const auto i : children_of_leg_pairs[pair]) ++counts[i];
    for (const auto i : children_of_leg_pairs[pair + 1]) ++counts[i];
    EXPECT_EQ(counts, std::vector<int>(children, 1)) << pair;
  }
}

TEST(FourMother, ALegPairHoldsAVerticalAndAHorizontalChildOfEachLeg) {
  for (const auto& pair : children_of_leg_pairs) {
    const auto is_vertical = [](std::uint8_t i) { return std::ranges::count(vertical_children, i) == 1; };
    EXPECT_EQ(std::ranges::count_if(pair, is_vertical), 2);
    for (const auto i : pair) {
      if (is_vertical(i)) {
        EXPECT_EQ(std::ranges::count(pair, i + 2), 1) << "the same leg's horizontal child";
      }
    }
  }
}

}  // namespace
}  // namespace lamprey::science::networks
