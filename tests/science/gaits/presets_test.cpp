#include "science/gaits/presets.hpp"

#include "science/fitness/quadruped_fitness.hpp"
#include "science/gaits/two_beat.hpp"
#include "science/robots/quadruped.hpp"
#include "tests/science/networks/output_text.hpp"

#include <gtest/gtest.h>
#include <map>
#include <stdexcept>

namespace lamprey::science::gaits {
namespace {

using fitness::Fitness;
using fitness::QuadrupedCounts;
using robots::Quadruped;
using robots::Support;

constexpr Gait walking_gaits[] = {Gait::walk, Gait::trot, Gait::pace, Gait::gallop, Gait::pronk};

struct Walked {
  Quadruped robot = robots::standing();
  QuadrupedCounts counts;
  std::map<Support, int> supports;
};

/// The robot under a network that puts out pulses, by unit moves on flat ground.
template <typename State, typename Network>
Walked walk_by(const Network& network, int time_steps) {
  const auto steps = networks::whole_steps(network);
  State state;
  Walked result;
  for (int t = 0; t < time_steps; ++t) {
    const robots::QuadrupedStep done = robots::step(result.robot, step(steps, state));
    fitness::count(result.counts, done);
    ++result.supports[robots::support(done.feet_on_ground)];
  }
  return result;
}

Walked four_mother_walks(Gait gait, int time_steps) {
  return walk_by<networks::FourMotherState>(four_mother(gait), time_steps);
}

/// Over a hundred steps: one period of the walk, four of the others.
Fitness expected(Gait gait) {
  switch (gait) {
    case Gait::walk:
      return {.stability = 80, .distance = 60, .fuel = 83};
    case Gait::trot:
      return {.stability = 64, .distance = 192, .fuel = 77.6};
    case Gait::pace:
      return {.stability = 64, .distance = 192, .fuel = 58.4};
    case Gait::gallop:
      return {.stability = 64, .distance = 192, .fuel = 71.2};
    case Gait::pronk:
      return {.stability = 0, .distance = 192, .fuel = 68};
    case Gait::walk_frames:
      break;
  }
  return {};
}

int period(Gait gait) {
  return gait == Gait::walk ? 100 : 25;
}

TEST(FourMotherGaits, ScoreExactlyWhatTheyAreKnownFor) {
  for (const Gait gait : walking_gaits) {
    EXPECT_EQ(fitness::score(four_mother_walks(gait, 100).counts, 100), expected(gait)) << static_cast<int>(gait);
  }
}

TEST(FourMotherGaits, AreBackInTheirFirstPostureAfterOneAndAfterTenCycles) {
  for (const Gait gait : walking_gaits) {
    for (const int cycles : {1, 10}) {
      EXPECT_EQ(four_mother_walks(gait, cycles * period(gait)).robot, robots::standing()) << static_cast<int>(gait);
    }
  }
}

TEST(FourMotherGaits, MoveForwardAndNeitherInclineNorDragNorPushAgainstALimit) {
  for (const Gait gait : walking_gaits) {
    const QuadrupedCounts one = four_mother_walks(gait, period(gait)).counts;
    const QuadrupedCounts ten = four_mother_walks(gait, 10 * period(gait)).counts;
    EXPECT_GT(one.front_pushes, 0);
    EXPECT_GT(one.back_pushes, 0);
    EXPECT_EQ(ten.front_pushes, 10 * one.front_pushes);
    EXPECT_EQ(ten.back_pushes, 10 * one.back_pushes);
    EXPECT_EQ(ten.inclined_steps, 0);
    EXPECT_EQ(ten.drags, 0);
    EXPECT_EQ(ten.limit_steps, 0);
  }
}

TEST(FourMotherGaits, StandOnTheFeetThatGiveThemTheirNames) {
  const std::map<Gait, std::map<Support, int>> known{
      {Gait::walk, {{Support::three, 80}, {Support::four, 20}}},
      {Gait::trot, {{Support::diagonal_pair, 16}, {Support::four, 9}}},
      {Gait::pace, {{Support::side_pair, 16}, {Support::four, 9}}},
      {Gait::gallop, {{Support::front_or_back_pair, 16}, {Support::four, 9}}},
      {Gait::pronk, {{Support::none, 8}, {Support::four, 17}}}};
  for (const Gait gait : walking_gaits) {
    EXPECT_EQ(four_mother_walks(gait, period(gait)).supports, known.at(gait)) << static_cast<int>(gait);
  }
}

TEST(FourMotherGaits, TheGallopStandsOnItsBackPairThenOnItsFrontPair) {
  const auto steps = networks::whole_steps(four_mother(Gait::gallop));
  networks::FourMotherState state;
  Quadruped robot = robots::standing();
  for (int t = 0; t < 16; ++t) {
    const unsigned expected_feet = t < 8 ? 0b1100 : 0b0011;
    EXPECT_EQ(robots::step(robot, networks::step(steps, state)).feet_on_ground, expected_feet) << t;
  }
}

TEST(TwoBeatGaits, MoveTheirLegsInPairs) {
  EXPECT_EQ(second_group(Gait::trot), (std::array{false, true, true, false}));
  EXPECT_EQ(second_group(Gait::pace), (std::array{false, true, false, true}));
  EXPECT_EQ(second_group(Gait::gallop), (std::array{false, false, true, true}));
  EXPECT_EQ(second_group(Gait::pronk), (std::array{false, false, false, false}));
  EXPECT_THROW(second_group(Gait::walk), std::invalid_argument);
}

TEST(OneMotherGaits, ScoreWhatFourMothersDo) {
  for (const Gait gait : walking_gaits) {
    const Walked result = walk_by<networks::OneMotherState>(one_mother(gait), 100);
    EXPECT_EQ(fitness::score(result.counts, 100), expected(gait)) << static_cast<int>(gait);
    EXPECT_EQ(result.robot, robots::standing());
  }
}

TEST(OneMotherGaits, TheWalkHasTheTimesOfFigure713TenTimesAsLong) {
  const auto frames = one_mother(Gait::walk_frames);
  const auto walk = one_mother(Gait::walk);
  EXPECT_EQ(frames.trigger_period, 9);
  EXPECT_EQ(walk.trigger_period, 100);
  EXPECT_EQ(frames.child_times[networks::child_of_neuron(1)], (networks::ChildTimes{4, 1, 3, 1}));
  EXPECT_EQ(walk.child_times[networks::child_of_neuron(1)], (networks::ChildTimes{40, 10, 30, 10}));
  EXPECT_EQ(walk.child_times[networks::child_of_neuron(8)], (networks::ChildTimes{20, 10, 0, 10}));
}

template <typename State, typename Network>
auto text_of(const Network& network, int time_steps) {
  State state;
  return networks::output_text(networks::whole_steps(network), state, time_steps);
}

TEST(TimedLoopGaits, MoveEveryServoWhenFourMothersDo) {
  for (const Gait gait : walking_gaits) {
    EXPECT_EQ(text_of<networks::TimedLoopState>(timed_loop(gait), 1000),
              text_of<networks::FourMotherState>(four_mother(gait), 1000));
  }
}

TEST(OneMotherGaits, MoveEveryServoWhenFourMothersDoInTwoBeatGaits) {
  for (const Gait gait : {Gait::trot, Gait::pace, Gait::gallop, Gait::pronk}) {
    EXPECT_EQ(text_of<networks::OneMotherState>(one_mother(gait), 1000),
              text_of<networks::FourMotherState>(four_mother(gait), 1000));
  }
}

TEST(RecurrentEightGaits, HaveTheTimesOfOneMotherAndWeightsOfMinusOne) {
  for (const Gait gait : {Gait::walk, Gait::walk_frames}) {
    const auto network = recurrent_eight(gait, false);
    EXPECT_FALSE(network.delay_refirings);
    for (std::size_t i = 0; i < networks::children; ++i) {
      EXPECT_EQ(network.neurons[i].times, one_mother(gait).child_times[i]);
      EXPECT_EQ(network.neurons[i].weights, (std::array<double, 3>{-1, -1, -1}));
    }
  }
}

TEST(TonicGaits, AreTheRowsOfTheTableWithTheWeightsOfFigure91) {
  const std::map<Gait, networks::TonicGait> rows{{Gait::walk, networks::TonicGait::walk},
                                                 {Gait::gallop, networks::TonicGait::gallop},
                                                 {Gait::trot, networks::TonicGait::trot},
                                                 {Gait::pace, networks::TonicGait::pace}};
  for (const auto& [gait, row] : rows) {
    EXPECT_EQ(tonic(gait).tonic, networks::tonic_of(row));
    EXPECT_EQ(tonic(gait).weights, (std::array<double, 4>{2.5, 2.5, 2.5, 2.5}));
  }
}

TEST(Presets, ThereAreNoneOfOtherGaits) {
  EXPECT_THROW(four_mother(Gait::walk_frames), std::invalid_argument);
  EXPECT_THROW(timed_loop(Gait::walk_frames), std::invalid_argument);
  EXPECT_THROW(recurrent_eight(Gait::trot, true), std::invalid_argument);
  EXPECT_THROW(split_generator(Gait::walk), std::invalid_argument);
  EXPECT_THROW(split_generator(Gait::walk_frames), std::invalid_argument);
  EXPECT_THROW(tonic(Gait::pronk), std::invalid_argument);
  EXPECT_THROW(tonic(Gait::walk_frames), std::invalid_argument);
}

}  // namespace
}  // namespace lamprey::science::gaits
