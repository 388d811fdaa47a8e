#include "science/problems/biped_problem.hpp"

#include "science/fitness/biped_fitness.hpp"

#include <array>
#include <gtest/gtest.h>
#include <stdexcept>
#include <string>
#include <vector>

namespace lamprey::science::problems {
namespace {

using evolution::Gene;
using enum BipedNetwork;
using enum BipedNeuron;

constexpr std::array all_networks{recurrent_pair, feed_forward_pair};
constexpr std::array all_neurons{threshold, acting_output, net_as_on_time, mcculloch_pitts, timed};

fitness::Fitness evaluate(const BipedSettings& settings, const std::vector<double>& genes) {
  evolution::Body body;
  return make_biped_problem(settings)->evaluate(genes, {}, body);
}

constexpr Gene time{.minimum = 1, .maximum = 10, .step_unit = 1, .whole = true};
constexpr Gene zero_to_one{.minimum = 0, .maximum = 1, .step_unit = 0.1, .whole = false};
constexpr Gene ten_of_either_sign{.minimum = -10, .maximum = 10, .step_unit = 2, .whole = true};
constexpr Gene one_of_either_sign{.minimum = -1, .maximum = 1, .step_unit = 0.2, .whole = false};

std::vector<Gene> genes_of(BipedNetwork network, BipedNeuron neuron, BipedWeights weights = BipedWeights::as_printed) {
  return make_biped_problem({.network = network, .neuron = neuron, .weights = weights, .actuator = {}})->plan().genes;
}

TEST(BipedPlan, ChromosomesAreThoseOfFigures623And624) {
  const Gene z = zero_to_one;
  for (const BipedNeuron neuron : {threshold, acting_output}) {
    EXPECT_EQ(genes_of(recurrent_pair, neuron), (std::vector{time, time, z, z, z, time, time, z, z, z}));
    EXPECT_EQ(genes_of(feed_forward_pair, neuron), (std::vector{time, time, z, z, time, time, z, z}));
  }
}

TEST(BipedPlan, OfTheOtherNeurons) {
  const Gene z = zero_to_one;
  EXPECT_EQ(genes_of(recurrent_pair, net_as_on_time), std::vector(4, ten_of_either_sign));
  EXPECT_EQ(genes_of(feed_forward_pair, net_as_on_time), std::vector(2, ten_of_either_sign));
  EXPECT_EQ(genes_of(recurrent_pair, mcculloch_pitts), std::vector(6, z));
  EXPECT_EQ(genes_of(feed_forward_pair, mcculloch_pitts), std::vector(4, z));
  EXPECT_EQ(genes_of(recurrent_pair, timed), (std::vector{time, z, z, z, time, z, z, z}));
  EXPECT_EQ(genes_of(feed_forward_pair, timed), (std::vector{time, z, z, time, z, z}));
}

TEST(BipedPlan, WeightsMayBeOfEitherSign) {
  const Gene w = one_of_either_sign;
  EXPECT_EQ(genes_of(feed_forward_pair, threshold, BipedWeights::either_sign),
            (std::vector{time, time, w, zero_to_one, time, time, w, zero_to_one}));
  EXPECT_EQ(genes_of(feed_forward_pair, net_as_on_time, BipedWeights::either_sign), std::vector(2, ten_of_either_sign));
}

TEST(BipedPlan, AUnitPerNeuronAllOfOneKind) {
  for (const BipedNetwork network : all_networks) {
    for (const BipedNeuron neuron : all_neurons) {
      const auto problem = make_biped_problem({.network = network, .neuron = neuron, .actuator = {}});
      const evolution::GenePlan& plan = problem->plan();
      ASSERT_EQ(plan.units.size(), 2U);
      std::vector<std::uint32_t> in_units = plan.units[0];
      in_units.insert(in_units.end(), plan.units[1].begin(), plan.units[1].end());
      ASSERT_EQ(in_units.size(), plan.genes.size());
      for (std::uint32_t gene = 0; gene < in_units.size(); ++gene) EXPECT_EQ(in_units[gene], gene);
      EXPECT_EQ(plan.units[0].size(), plan.units[1].size());
      EXPECT_TRUE(plan.symmetric_units.empty());
      EXPECT_EQ(plan.kinds, (std::vector<std::vector<std::uint32_t>>{{0, 1}}));
      EXPECT_TRUE(problem->preset().empty());
    }
  }
}

/// Figs 6.12 and 6.19 with the times of a full stride.
const std::vector<double> recurrent_stride{10, 10, -1, -2, 0.5, 10, 10, -2, -1, 0.5};
const std::vector<double> feed_forward_stride{10, 10, -2, 0.5, 10, 10, -2, 0.5};

TEST(BipedProblem, TheActingOutputNetworksWalkAsExpected) {
  for (const std::int32_t time_steps : {10, 40, 73}) {
    BipedSettings settings{.neuron = acting_output, .actuator = {}, .time_steps = time_steps};
    EXPECT_EQ(evaluate(settings, recurrent_stride), fitness::perfect_antiphase);
    EXPECT_EQ(make_biped_problem(settings)->expected({}), fitness::perfect_antiphase);
    settings.network = feed_forward_pair;
    EXPECT_EQ(evaluate(settings, feed_forward_stride), fitness::perfect_antiphase);
  }
}

TEST(BipedProblem, NetsOfTenWalkAsExpected) {
  EXPECT_EQ(evaluate({.network = feed_forward_pair, .neuron = net_as_on_time, .actuator = {}}, {-10, -10}),
            fitness::perfect_antiphase);
  EXPECT_EQ(evaluate({.network = recurrent_pair, .neuron = net_as_on_time, .actuator = {}}, {-5, -5, -5, -5}),
            fitness::perfect_antiphase);
}

TEST(BipedProblem, ASilentNetworkSinksBothLegs) {
  // Leg 1 from 10, leg 2 from 20, both down: 40 errors of leg 1, 30 of leg 2 as its first ten steps are in range.
  const fitness::Fitness fitness = evaluate({.network = feed_forward_pair, .actuator = {}}, {1, 1, 0, 1, 1, 1, 0, 1});
  EXPECT_EQ(fitness, (fitness::Fitness{.stability = -175, .distance = 0, .fuel = 0}));
}

TEST(BipedProblem, WeightsOfZeroToOneCannotStartTheAntiphase) {
  // N1 must fire first, from inputs of −1: that takes a negative weight, as all worked examples of 6.2.2 have.
  for (const BipedNeuron neuron : {threshold, acting_output}) {
    const auto problem = make_biped_problem({.network = recurrent_pair, .neuron = neuron, .actuator = {}});
    for (const double own : {0.0, 0.5, 1.0}) {
      for (const double partners : {0.0, 0.5, 1.0}) {
        const std::vector<double> genes{10, 10, own, partners, 0, 10, 10, partners, own, 0};
        EXPECT_EQ(problem->record(genes, {}, 1).outputs[0][0], -1) << own << ' ' << partners;
      }
    }
    const std::vector<double> negative{10, 10, 0, -0.5, 0, 10, 10, -0.5, 0, 0};
    EXPECT_EQ(problem->record(negative, {}, 1).outputs[0][0], 1);
  }
}

TEST(BipedProblem, McMinnsNeuronMovesALegUpOnly) {
  // 6.2.2: in all other steps the unit move does nothing. With weights that keep N1 silent, N2 pulses once: from 20 one
  // step takes the body along, and from there the leg is in error in all 40 steps.
  const BipedSettings settings{.network = feed_forward_pair, .neuron = timed, .actuator = {}};
  EXPECT_EQ(evaluate(settings, {1, 0, 0.5, 5, 1, 0.5}),
            (fitness::Fitness{.stability = -100, .distance = 2.5, .fuel = 0}));
}

TEST(BipedProblem, TheWalkGoesOnWhereTheBodyIs) {
  const std::vector<double> genes{7, 4, -0.3, -0.9, 0.1, 6, 5, -0.8, -0.2, 0.2};
  for (const auto path : {actuators::ActuatorPath::unit_move, actuators::ActuatorPath::leaky_chain}) {
    const auto half = make_biped_problem({.actuator = {.path = path}, .time_steps = 4});
    const auto whole = make_biped_problem({.actuator = {.path = path}, .time_steps = 8});
    evolution::Body body;
    const fitness::Fitness first = half->evaluate(genes, {}, body);
    const fitness::Fitness second = half->evaluate(genes, {}, body);
    evolution::Body fresh;
    const fitness::Fitness together = whole->evaluate(genes, {}, fresh);
    EXPECT_NE(first, second) << "or the test shows nothing";
    EXPECT_EQ(together.distance, (first.distance + second.distance) / 2);
    EXPECT_EQ(together.stability, (first.stability + second.stability) / 2);
    body.reset();
    EXPECT_EQ(half->evaluate(genes, {}, body), first);
  }
}

TEST(BipedProblem, TheChainsDefaultsKeepBothLegsInTheWalkingRange) {
  // Its stroke of 5 about 15 reaches 10 and 20 and no further.
  const BipedSettings settings{.neuron = acting_output, .actuator = {.path = actuators::ActuatorPath::leaky_chain}};
  const auto problem = make_biped_problem(settings);
  evolution::Body body;
  const fitness::Fitness fitness = problem->evaluate(recurrent_stride, {}, body);
  EXPECT_EQ(fitness.stability, 0);
  EXPECT_GE(fitness.distance, 90) << "a stride of ten positions fits into ten steps at the highest speed";
  EXPECT_LE(fitness.distance, 100);
  const robots::Recording recording = problem->record(recurrent_stride, {}, 40);
  EXPECT_EQ(recording.positions.front(), (std::vector<double>{10, 20})) << "it stands where the unit move does";
}

TEST(BipedProblem, ARecordingIsTheEvaluationStepByStep) {
  const auto problem = make_biped_problem({.neuron = acting_output, .actuator = {}});
  const robots::Recording recording = problem->record(recurrent_stride, {}, 25);
  EXPECT_EQ(recording.servos, (std::vector<std::string>{"leg 1", "leg 2"}));
  ASSERT_EQ(recording.outputs.size(), 25U);
  ASSERT_EQ(recording.positions.size(), 26U);
  ASSERT_EQ(recording.distance.size(), 25U);
  ASSERT_EQ(recording.feet_on_ground.size(), 25U);
  EXPECT_EQ(recording.outputs[0], (std::vector<double>{1, -1}));
  EXPECT_EQ(recording.outputs[10], (std::vector<double>{-1, 1}));
  EXPECT_EQ(recording.positions[0], (std::vector<double>{10, 20}));
  EXPECT_EQ(recording.positions[10], (std::vector<double>{20, 10}));
  EXPECT_EQ(recording.positions[20], (std::vector<double>{10, 20}));
  EXPECT_EQ(recording.feet_on_ground[3], 1U);
  EXPECT_EQ(recording.feet_on_ground[13], 2U);
  EXPECT_EQ(recording.distance[24], 25);
}

TEST(BipedProblem, TheEnvironmentDoesNotMatterToTheFitness) {
  const auto problem = make_biped_problem({.neuron = acting_output, .actuator = {}});
  fitness::Environment environment{.weights = {0.25, 0.5, 0.75}, .terrain = {}};
  environment.terrain.push_factor = 0.5;
  evolution::Body body;
  EXPECT_EQ(problem->evaluate(recurrent_stride, environment, body), fitness::perfect_antiphase);
  EXPECT_EQ(problem->expected(environment), fitness::perfect_antiphase);
}

TEST(BipedProblem, EveryNetworkNeuronAndActuatorPathCanBeTried) {
  for (const BipedNetwork network : all_networks) {
    for (const BipedNeuron neuron : all_neurons) {
      for (const auto path : {actuators::ActuatorPath::unit_move, actuators::ActuatorPath::leaky_chain}) {
        const auto problem = make_biped_problem({.network = network, .neuron = neuron, .actuator = {.path = path}});
        std::vector<double> genes;
        for (const Gene& gene : problem->plan().genes) genes.push_back((gene.minimum + 3 * gene.maximum) / 4);
        const robots::Recording recording = problem->record(genes, {}, 40);
        evolution::Body body;
        const fitness::Fitness fitness = problem->evaluate(genes, {}, body);
        EXPECT_EQ(fitness.distance, 100 * recording.distance.back() / 40);
        EXPECT_EQ(fitness.fuel, 0);
        EXPECT_LE(fitness.stability, 0);
      }
    }
  }
}

TEST(BipedProblem, RefusesNoTimeAtAll) {
  EXPECT_THROW(make_biped_problem({.actuator = {}, .time_steps = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace lamprey::science::problems
