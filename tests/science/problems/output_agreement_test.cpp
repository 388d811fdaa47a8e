#include "science/problems/output_agreement.hpp"

#include "science/problems/quadruped_problem.hpp"

#include <gtest/gtest.h>
#include <memory>
#include <vector>

namespace lamprey::science::problems {
namespace {

using evolution::Body;
using fitness::Fitness;

std::unique_ptr<evolution::Problem> frames(QuadrupedNetwork network, int time_steps, bool delay_refirings = true) {
  return make_quadruped_problem({.network = network,
                                 .gait = gaits::Gait::walk_frames,
                                 .actuator = {},
                                 .time_steps = time_steps,
                                 .delay_refirings = delay_refirings});
}

double agreement(const evolution::Problem& problem) {
  Body body;
  return problem.evaluate(problem.preset(), {}, body).stability;
}

TEST(OutputAgreement, TheWantedOutputsAreTheTilesOfFigure713) {
  const auto wanted = figure_7_13_outputs();
  // N1, which swings the back right leg: fig. 7.13(a) has D1 = 4, T_ON = 1, D2 = 3, T_OFF = 1.
  std::vector<int> n1;
  std::vector<int> n4;
  for (const auto& frame : wanted) {
    n1.push_back(frame[networks::child_of_neuron(1)]);
    n4.push_back(frame[networks::child_of_neuron(4)]);
  }
  EXPECT_EQ(n1, (std::vector<int>{0, 0, 0, 0, 1, 0, 0, 0, -1}));
  EXPECT_EQ(n4, (std::vector<int>{1, -1, 0, 0, 0, 0, 0, 0, 0}));
}

TEST(OutputAgreement, OneMotherGivesTheWantedOutputForEver) {
  EXPECT_EQ(agreement(*frames(QuadrupedNetwork::one_mother, 9)), 100);
  EXPECT_EQ(agreement(*frames(QuadrupedNetwork::one_mother, 1000)), 100);
}

TEST(OutputAgreement, TheRecurrentNetworkMissesItInAsManyCellsAsFigure716Does) {
  // Compared with fig. 7.13: N4 at T5 to T9, N3 and N8 at T7 to T9, N7 at T9: 12 of 72 cells.
  EXPECT_EQ(agreement(*frames(QuadrupedNetwork::recurrent_eight, 9, false)), 100.0 * 60 / 72);
  // With delayed re-firings: N4 at T5 to T8, N8 at T9.
  EXPECT_EQ(agreement(*frames(QuadrupedNetwork::recurrent_eight, 9, true)), 100.0 * 67 / 72);
}

TEST(OutputAgreement, ExpectsAHundredPerCentAndNothingElse) {
  for (const auto network : {QuadrupedNetwork::one_mother, QuadrupedNetwork::recurrent_eight}) {
    EXPECT_EQ(frames(network, 100)->expected({}), (Fitness{.stability = 100, .distance = 0, .fuel = 0}));
  }
}

TEST(OutputAgreement, ASilentNetworkAgreesWhereNothingIsWanted) {
  // Of 72 cells 16 are wanted: eight +1, eight −1.
  const auto problem = frames(QuadrupedNetwork::one_mother, 9);
  Body body;
  EXPECT_EQ(problem->evaluate(std::vector<double>(problem->preset().size(), 0.0), {}, body).stability, 100.0 * 56 / 72);
}

TEST(OutputAgreement, AnEvaluationThatGoesOnGoesOnInTheWantedFramesToo) {
  const auto problem = frames(QuadrupedNetwork::one_mother, 7);
  Body body;
  for (int part = 0; part < 5; ++part) EXPECT_EQ(problem->evaluate(problem->preset(), {}, body).stability, 100) << part;
}

TEST(OutputAgreement, RecordsARobotThatTheOutputsMove) {
  const auto problem = frames(QuadrupedNetwork::one_mother, 9);
  const robots::Recording recording = problem->record(problem->preset(), {}, 9);
  EXPECT_EQ(recording.positions[1], (std::vector<double>{10, 10, 10, 10, 11, 10, 11, 10}));
  EXPECT_EQ(recording.positions[9], std::vector<double>(8, 10.0));
  EXPECT_EQ(recording.distance.back(), 1);
}

}  // namespace
}  // namespace lamprey::science::problems
