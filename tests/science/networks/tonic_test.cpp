#include "science/networks/tonic.hpp"

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace lamprey::science::networks {
namespace {

TEST(Tonic, TheTableIsThatOf93) {
  EXPECT_EQ(tonic_of(TonicGait::walk), (Tonic{+1, -1, -1, -1}));
  EXPECT_EQ(tonic_of(TonicGait::gallop), (Tonic{+1, -1, -1, +1}));
  EXPECT_EQ(tonic_of(TonicGait::trot), (Tonic{+1, -1, +1, -1}));
  EXPECT_EQ(tonic_of(TonicGait::pace), (Tonic{+1, +1, -1, -1}));
  EXPECT_EQ(static_cast<int>(TonicGait::walk), 1);
  EXPECT_EQ(static_cast<int>(TonicGait::gallop), 2);
  EXPECT_EQ(static_cast<int>(TonicGait::trot), 3);
  EXPECT_EQ(static_cast<int>(TonicGait::pace), 4);
}

TEST(Tonic, AGaitIsItsExactRowAndTwelveTonicsAreNone) {
  int rows = 0;
  for (unsigned bits = 0; bits < 16; ++bits) {
    Tonic tonic;
    for (std::size_t mother = 0; mother < tonic_mothers; ++mother) tonic[mother] = (bits >> mother & 1U) != 0 ? 1 : -1;
    const auto gait = gait_of(tonic);
    rows += gait.has_value();
    if (gait) {
      EXPECT_EQ(tonic_of(*gait), tonic);
    }
  }
  EXPECT_EQ(rows, 4);
  EXPECT_EQ(gait_of({-1, +1, -1, +1}), std::nullopt) << "a trot the other way round is no row";
}

TEST(Tonic, AGenesSignIsThePulse) {
  EXPECT_EQ(pulse_of_gene(-1), -1);
  EXPECT_EQ(pulse_of_gene(-0.1), -1);
  EXPECT_EQ(pulse_of_gene(0), 1);
  EXPECT_EQ(pulse_of_gene(1), 1);
}

TEST(Tonic, ASwingIsThreeShiftsClockwiseAndThreeBack) {
  std::vector<int> places;
  for (int shift = 0; shift < shifts_per_swing; ++shift) places.push_back(places_clockwise(shift));
  EXPECT_EQ(places, (std::vector<int>{0, 1, 2, 3, 2, 1}));
}

TEST(Tonic, AWeightOfTwoAndAHalfStretchesFromFourteenToSix) {
  // 1 + 1/(1 + e^−2.5) = 1.92414… and 1 + 1/(1 + e^2.5) = 1.07585…
  const TonicSteps steps = whole_steps({.tonic = tonic_of(TonicGait::walk), .weights = {2.5, 0, 2.5, 2.5}});
  EXPECT_NEAR(steps.activated[0], 10 + 10 * 0.42414181997875655, 1e-12);
  EXPECT_NEAR(steps.reversed[0], 10 - 10 * 0.42414181997875655, 1e-12);
  EXPECT_EQ(steps.activated[1], 10) << "a weight of 0 is the middle";
}

/// Each shift's positions of right front, right back, left back and left front: F forward, B back, S standing.
std::vector<std::string> shifts(TonicGait gait, int count) {
  const TonicSteps steps = whole_steps({.tonic = tonic_of(gait), .weights = {2.5, 2.5, 2.5, 2.5}});
  TonicState state;
  std::vector<std::string> rows;
  for (int shift = 0; shift < count; ++shift) {
    std::string row;
    for (int t = 0; t < steps_per_shift; ++t) {
      const ChildLevels levels = step(steps, state);
      std::string now;
      for (const std::size_t servo : horizontal_child_of_tonic_mother) {
        now += levels[servo] > 14 ? 'F' : levels[servo] < 6 ? 'B' : 'S';
      }
      for (const std::size_t servo : vertical_children) EXPECT_EQ(levels[servo], 10) << "vertical children are passive";
      if (t == 0) row = now;
      EXPECT_EQ(now, row) << "positions change where a shift begins only";
    }
    rows.push_back(row);
  }
  return rows;
}

// By hand from eq. 9.1. The pulses of gallop, say, in the order right front, right back, left back, left front:
// +−−+, ++−−, −++−, −−++, −++−, ++−−, +−−+, ++−−. A + after a − puts a leg forward, a + after a + puts it back.

TEST(TonicSwing, Walk) {
  EXPECT_EQ(shifts(TonicGait::walk, 8),
            (std::vector<std::string>{"FSSS", "FFSS", "FFFS", "FFFF", "FFFF", "FFFF", "FFFF", "FFFF"}));
}

TEST(TonicSwing, Trot) {
  EXPECT_EQ(shifts(TonicGait::trot, 4), (std::vector<std::string>{"FSFS", "FFFF", "FFFF", "FFFF"}));
}

TEST(TonicSwing, Gallop) {
  EXPECT_EQ(shifts(TonicGait::gallop, 8),
            (std::vector<std::string>{"FSSF", "BFSF", "BBFF", "BBBF", "BFBF", "FBBF", "BBBF", "BFBF"}));
}

TEST(TonicSwing, Pace) {
  EXPECT_EQ(shifts(TonicGait::pace, 7),
            (std::vector<std::string>{"FFSS", "FBFS", "FBBF", "FBBB", "FBFB", "FFBB", "FBBB"}));
}

TEST(TonicSwing, TheMothersAreTheLegsOfTheRobotClockwise) {
  // Horizontal servos: front left 2, front right 3, back left 6, back right 7.
  EXPECT_EQ(horizontal_child_of_tonic_mother[right_front], child(front_horizontal, right));
  EXPECT_EQ(horizontal_child_of_tonic_mother[right_back], child(back_horizontal, right));
  EXPECT_EQ(horizontal_child_of_tonic_mother[left_back], child(back_horizontal, left));
  EXPECT_EQ(horizontal_child_of_tonic_mother[left_front], child(front_horizontal, left));
}

}  // namespace
}  // namespace lamprey::science::networks
