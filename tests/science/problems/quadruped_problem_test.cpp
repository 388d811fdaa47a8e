#include "science/problems/quadruped_problem.hpp"

#include "science/gaits/presets.hpp"
#include "science/problems/controlled_quadruped.hpp"

#include <gtest/gtest.h>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace lamprey::science::problems {
namespace {

using evolution::Body;
using fitness::Environment;
using fitness::Fitness;
using gaits::Gait;
using namespace networks;

constexpr QuadrupedNetwork all_networks[] = {QuadrupedNetwork::four_mother,     QuadrupedNetwork::one_mother,
                                             QuadrupedNetwork::recurrent_eight, QuadrupedNetwork::split_generator,
                                             QuadrupedNetwork::tonic,           QuadrupedNetwork::timed_loop};
constexpr Gait all_gaits[] = {Gait::walk, Gait::trot, Gait::pace, Gait::gallop, Gait::pronk, Gait::walk_frames};

std::unique_ptr<evolution::Problem> problem_of(QuadrupedNetwork network, Gait gait, int time_steps = 100) {
  return make_quadruped_problem({.network = network, .gait = gait, .actuator = {}, .time_steps = time_steps});
}

Fitness preset_fitness(const evolution::Problem& problem, const Environment& environment = {}) {
  Body standing;
  return problem.evaluate(problem.preset(), environment, standing);
}

/// The fitness of any four-mother network from standing, by unit moves on flat ground.
Fitness tried(const FourMotherNetwork& network, int time_steps) {
  const ControlledQuadruped<FourMotherController, DirectPath> problem({network}, {}, time_steps, nullptr);
  return preset_fitness(problem);
}

std::string name(QuadrupedNetwork network, Gait gait) {
  return "network " + std::to_string(static_cast<int>(network)) + ", gait " + std::to_string(static_cast<int>(gait));
}

template <typename Check>
void for_all_presets(const Check& check) {
  for (const QuadrupedNetwork network : all_networks) {
    for (const Gait gait : all_gaits) {
      if (!has_preset(network, gait)) continue;
      SCOPED_TRACE(name(network, gait));
      check(network, gait);
    }
  }
}

TEST(QuadrupedByHand, ANetworkThatDoesNothingStandsStill) {
  EXPECT_EQ(tried({}, 100), (Fitness{.stability = 0, .distance = 0, .fuel = 100}));
}

TEST(QuadrupedByHand, OneLegLiftedAndLowered) {
  FourMotherNetwork network;
  network.mother_times[front_vertical] = {10, 10};
  network.child_times[child(front_vertical, left)] = {2, 3, 0, 3};
  // Steps 2..4 lift and 10..12 lower the foot: in the air in 2..12, which are 11 of 20 steps on three feet (eq. 7.5);
  // fuel 1000 − 11 (row 8) − 6 (row 9).
  EXPECT_EQ(tried(network, 20), (Fitness{.stability = 55, .distance = 0, .fuel = 98.3}));
}

TEST(QuadrupedByHand, OneLegPushedAgainstItsLimit) {
  FourMotherNetwork network;
  network.mother_times[back_horizontal] = {1, 99};
  network.child_times[child(back_horizontal, right)] = {0, 0, 0, 14};
  // From step 1 the back right leg pushes ten times, then meets the limit four times: D = 100·2·10/50,
  // fuel 1000 − 10 (row 9) − 4·10 (row 1).
  EXPECT_EQ(tried(network, 50), (Fitness{.stability = 0, .distance = 40, .fuel = 95}));
}

TEST(QuadrupedByHand, OneLegPressedDownInclinesTheBody) {
  FourMotherNetwork network;
  network.mother_times[front_vertical] = {1, 99};
  network.child_times[child(front_vertical, right)] = {0, 0, 4, 2};
  // The foot goes down in steps 5 and 6 and stays: inclined in 5..9, on four feet.
  EXPECT_EQ(tried(network, 10), (Fitness{.stability = -50, .distance = 0, .fuel = 99.8}));
}

TEST(QuadrupedByHand, TheTonicWalkOnlyDragsItsLegsForwardOnce) {
  // The tonic passes each leg once; each goes forward by four positions, dragging: D = −100·16/100, fuel 1000 − 16
  // (row 9) − 2·16 (row 7). All feet stay on the ground.
  EXPECT_EQ(preset_fitness(*problem_of(QuadrupedNetwork::tonic, Gait::walk)),
            (Fitness{.stability = 0, .distance = -16, .fuel = 95.2}));
}

TEST(QuadrupedByHand, TheSplitGeneratorTrots) {
  // In 100 steps the first pair is in the air for eight steps and pushes for the next eight, five times. The second is
  // ten steps behind: it pushes four times eight, and two. D = 3·40 + 3·34; S: a pair is in the air in 80 steps; fuel
  // 1000 − 2·80 (row 6) − 100 (row 9).
  EXPECT_EQ(preset_fitness(*problem_of(QuadrupedNetwork::split_generator, Gait::trot)),
            (Fitness{.stability = 80, .distance = 222, .fuel = 74}));
}

TEST(QuadrupedProblem, TheSplitGeneratorWalksForwardInAllItsGaits) {
  for (const Gait gait : {Gait::trot, Gait::pace, Gait::gallop, Gait::pronk}) {
    EXPECT_GT(preset_fitness(*problem_of(QuadrupedNetwork::split_generator, gait)).distance, 0);
  }
}

TEST(QuadrupedProblem, ExpectsWhatTheFourMothersPresetScoresWhateverTheNetwork) {
  for_all_presets([](QuadrupedNetwork network, Gait gait) {
    if (gait == Gait::walk_frames) return;
    const auto problem = problem_of(network, gait, 130);
    EXPECT_EQ(problem->expected({}), preset_fitness(*problem_of(QuadrupedNetwork::four_mother, gait, 130)));
  });
}

TEST(QuadrupedProblem, TheLoopWithoutANetworkScoresWhatTheNetworkDoes) {
  for (const Gait gait : {Gait::walk, Gait::trot, Gait::pace, Gait::gallop, Gait::pronk}) {
    const auto problem = problem_of(QuadrupedNetwork::timed_loop, gait);
    EXPECT_EQ(preset_fitness(*problem), problem->expected({}));
  }
}

TEST(QuadrupedProblem, APlanHasEveryGeneInOneUnitAndThePresetWithinItsBounds) {
  for_all_presets([](QuadrupedNetwork network, Gait gait) {
    const auto problem = problem_of(network, gait);
    const evolution::GenePlan& plan = problem->plan();
    const auto preset = problem->preset();
    ASSERT_EQ(preset.size(), plan.genes.size());
    std::vector<int> seen(plan.genes.size(), 0);
    for (const auto& unit : plan.units) {
      for (const auto gene : unit) ++seen.at(gene);
    }
    EXPECT_EQ(seen, std::vector<int>(plan.genes.size(), 1));
    for (std::size_t gene = 0; gene < preset.size(); ++gene) {
      EXPECT_EQ(evolution::held(plan.genes[gene], preset[gene]), preset[gene]) << gene;
    }
    EXPECT_FALSE(plan.kinds.empty());
    for (const auto& set : plan.symmetric_units) {
      for (const auto unit : set) EXPECT_LT(unit, plan.units.size());
    }
  });
}

TEST(QuadrupedProblem, TheFourMothersGenesAreTheEightChildrensTimes) {
  const auto problem = problem_of(QuadrupedNetwork::four_mother, Gait::walk);
  const evolution::GenePlan& plan = problem->plan();
  EXPECT_EQ(plan.genes, std::vector<evolution::Gene>(32, {.minimum = 0, .maximum = 100, .step_unit = 1}));
  ASSERT_EQ(plan.units.size(), 8U);
  EXPECT_EQ(plan.units[3], (std::vector<std::uint32_t>{12, 13, 14, 15}));
  EXPECT_EQ(plan.symmetric_units.size(), 6U);
  EXPECT_EQ(plan.symmetric_units[4], (std::vector<std::uint32_t>{0, 2, 5, 7}));
  EXPECT_EQ(plan.kinds, (std::vector<std::vector<std::uint32_t>>{{0, 1, 4, 5}, {2, 3, 6, 7}}));
  const auto of_child = problem->preset().subspan(4 * child(front_vertical, right), 4);
  EXPECT_EQ(std::vector<double>(of_child.begin(), of_child.end()), (std::vector<double>{60, 10, 60, 10}));
}

std::vector<std::size_t> unit_sizes(QuadrupedNetwork network, Gait gait, TonicGenes tonic_genes = TonicGenes::tonic) {
  const auto problem =
      make_quadruped_problem({.network = network, .gait = gait, .actuator = {}, .tonic_genes = tonic_genes});
  std::vector<std::size_t> sizes;
  for (const auto& unit : problem->plan().units) sizes.push_back(unit.size());
  return sizes;
}

TEST(QuadrupedProblem, UnitsAreNeuronsOrServosAndWhatBeatsForAllOfThem) {
  using enum QuadrupedNetwork;
  EXPECT_EQ(unit_sizes(one_mother, Gait::walk), (std::vector<std::size_t>{4, 4, 4, 4, 4, 4, 4, 4, 1}));
  EXPECT_EQ(unit_sizes(recurrent_eight, Gait::walk), (std::vector<std::size_t>{7, 7, 7, 7, 7, 7, 7, 7}));
  EXPECT_EQ(unit_sizes(timed_loop, Gait::walk), (std::vector<std::size_t>{4, 4, 4, 4, 4, 4, 4, 4}));
  EXPECT_EQ(unit_sizes(split_generator, Gait::trot), (std::vector<std::size_t>{4, 4, 4, 4, 4, 4, 4, 4, 2}));
  EXPECT_EQ(unit_sizes(tonic, Gait::walk), (std::vector<std::size_t>{1, 1, 1, 1}));
  EXPECT_EQ(unit_sizes(tonic, Gait::walk, TonicGenes::tonic_and_weights), (std::vector<std::size_t>{2, 2, 2, 2}));
}

TEST(QuadrupedProblem, EveryGeneCanChangeWhatTheNetworkDoes) {
  for_all_presets([](QuadrupedNetwork network, Gait gait) {
    const auto problem = problem_of(network, gait);
    const auto preset = problem->preset();
    const auto outputs_with = [&](std::size_t gene, double value) {
      std::vector<double> genes(preset.begin(), preset.end());
      genes[gene] = value;
      return problem->record(genes, {}, 400).outputs;
    };
    for (std::size_t gene = 0; gene < preset.size(); ++gene) {
      // One weight may be outvoted by the two others of its neuron, whatever it is.
      if (network == QuadrupedNetwork::recurrent_eight && gene % 7 >= 4) continue;
      const evolution::Gene& bounds = problem->plan().genes[gene];
      const double middle = (bounds.minimum + bounds.maximum) / 2;
      EXPECT_TRUE(outputs_with(gene, bounds.minimum) != outputs_with(gene, bounds.maximum) ||
                  outputs_with(gene, bounds.minimum) != outputs_with(gene, middle))
          << "gene " << gene;
    }
  });
}

TEST(QuadrupedProblem, ABodyWalksOnWhereItWasLeft) {
  // Four evaluations of 25 steps pass through the same states as one of 100.
  for_all_presets([](QuadrupedNetwork network, Gait gait) {
    for (const auto path : {actuators::ActuatorPath::unit_move, actuators::ActuatorPath::leaky_chain}) {
      QuadrupedSettings settings{.network = network, .gait = gait, .actuator = {}};
      settings.actuator.path = path;
      const auto whole_problem = make_quadruped_problem(settings);
      settings.time_steps = 25;
      const auto part_problem = make_quadruped_problem(settings);
      const Fitness all = preset_fitness(*whole_problem);
      Fitness sum;
      Body body;
      for (int part = 0; part < 4; ++part) {
        const Fitness quarter = part_problem->evaluate(part_problem->preset(), {}, body);
        sum.stability += quarter.stability / 4;
        sum.distance += quarter.distance / 4;
      }
      EXPECT_NEAR(sum.stability, all.stability, 1e-10);  // sums of a few numbers below 1000, each rounded
      EXPECT_NEAR(sum.distance, all.distance, 1e-10);
    }
  });
}

TEST(QuadrupedProblem, AResetBodyStandsAgain) {
  const auto problem = problem_of(QuadrupedNetwork::four_mother, Gait::trot, 13);
  Body body;
  const Fitness first = problem->evaluate(problem->preset(), {}, body);
  EXPECT_NE(problem->evaluate(problem->preset(), {}, body), first);
  body.reset();
  EXPECT_EQ(problem->evaluate(problem->preset(), {}, body), first);
}

TEST(QuadrupedTerrain, APushFactorScalesTheDistanceOfTheWalk) {
  const auto problem = problem_of(QuadrupedNetwork::four_mother, Gait::walk);
  const Environment slippery{.weights = {}, .terrain = {.push_factor = 0.5}};
  EXPECT_EQ(preset_fitness(*problem, slippery), (Fitness{.stability = 80, .distance = 30, .fuel = 83}));
  EXPECT_EQ(problem->expected(slippery), (Fitness{.stability = 80, .distance = 30, .fuel = 83}));
}

TEST(QuadrupedTerrain, AHoleUnderOneLegTakesItsPushAndItsSupport) {
  // The front right leg never touches: three feet in the 20 steps in which all would stand and in the 20 in which it
  // would be lifted, else two. D_FL is 10 of its 20.
  const Environment hole{.weights = {}, .terrain = {.ground_level = {10, 9, 10, 10}}};
  const Fitness walked = preset_fitness(*problem_of(QuadrupedNetwork::four_mother, Gait::walk), hole);
  EXPECT_EQ(walked.stability, 100);
  EXPECT_EQ(walked.distance, 50);
}

TEST(QuadrupedActuators, AUnitMoveFollowsWantedPositionsByOneAStep) {
  const auto problem = problem_of(QuadrupedNetwork::tonic, Gait::walk);
  const auto recording = problem->record(problem->preset(), {}, 20);
  std::vector<double> right_front;
  for (const auto& row : recording.positions) right_front.push_back(row[robots::horizontal_servo(robots::front_right)]);
  EXPECT_EQ(right_front,
            (std::vector<double>{10, 11, 12, 13, 14, 14, 14, 14, 14, 14, 14, 14, 14, 14, 14, 14, 14, 14, 14, 14, 14}));
}

TEST(QuadrupedActuators, TheLeakyChainWalksAnotherWayAndExpectsItToo) {
  QuadrupedSettings settings;
  settings.actuator.path = actuators::ActuatorPath::leaky_chain;
  settings.actuator.stroke = 10;
  const auto chain = make_quadruped_problem(settings);
  EXPECT_EQ(chain->expected({}), preset_fitness(*chain));
  EXPECT_NE(chain->expected({}), problem_of(QuadrupedNetwork::four_mother, Gait::walk)->expected({}));
  EXPECT_GT(chain->expected({}).distance, 0);
}

TEST(QuadrupedRecording, HasEveryStepOfEveryServo) {
  const auto problem = problem_of(QuadrupedNetwork::four_mother, Gait::walk);
  const robots::Recording recording = problem->record(problem->preset(), {}, 150);
  EXPECT_EQ(recording.servos,
            (std::vector<std::string>{"front left vertical", "front right vertical", "front left horizontal",
                                      "front right horizontal", "back left vertical", "back right vertical",
                                      "back left horizontal", "back right horizontal"}));
  EXPECT_EQ(recording.outputs.size(), 150U);
  EXPECT_EQ(recording.positions.size(), 151U);
  EXPECT_EQ(recording.positions.front(), std::vector<double>(8, 10.0));
  EXPECT_EQ(recording.positions[10], (std::vector<double>{10, 10, 10, 10, 20, 10, 20, 10})) << "back left first";
  EXPECT_EQ(recording.feet_on_ground[5], 0b1011U);
  EXPECT_EQ(recording.outputs[5], (std::vector<double>{0, 0, 0, 0, 1, 0, 1, 0}));
}

TEST(QuadrupedRecording, TheBodyComesTenPositionsForwardInAWalk) {
  const auto problem = problem_of(QuadrupedNetwork::four_mother, Gait::walk);
  const robots::Recording recording = problem->record(problem->preset(), {}, 200);
  EXPECT_EQ(recording.distance[89], 0);
  EXPECT_EQ(recording.distance[94], 5);
  EXPECT_EQ(recording.distance[99], 10);
  EXPECT_EQ(recording.distance[199], 20);
  const Environment slippery{.weights = {}, .terrain = {.push_factor = 0.5}};
  EXPECT_EQ(problem->record(problem->preset(), slippery, 100).distance.back(), 5);
}

TEST(QuadrupedProblem, SaysWhichPresetsThereAreAndRefusesOthers) {
  for (const QuadrupedNetwork network : all_networks) {
    for (const Gait gait : all_gaits) {
      if (has_preset(network, gait)) {
        EXPECT_FALSE(problem_of(network, gait)->preset().empty()) << name(network, gait);
      } else {
        EXPECT_THROW(problem_of(network, gait), std::invalid_argument) << name(network, gait);
      }
    }
  }
  EXPECT_THROW(problem_of(QuadrupedNetwork::four_mother, Gait::walk, 0), std::invalid_argument);
}

}  // namespace
}  // namespace lamprey::science::problems
