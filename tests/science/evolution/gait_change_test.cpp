#include "science/evolution/gait_change.hpp"

#include "science/problems/quadruped_problem.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace lamprey::science::evolution {
namespace {

using networks::TonicGait;

std::unique_ptr<Problem> tonic_problem(gaits::Gait gait = gaits::Gait::walk,
                                       problems::TonicGenes genes = problems::TonicGenes::tonic) {
  return problems::make_quadruped_problem(
      {.network = problems::QuadrupedNetwork::tonic, .gait = gait, .actuator = {}, .tonic_genes = genes});
}

Training training_of(const Problem& problem, std::uint64_t key) {
  return {.problem = problem, .environment = {}, .expected = problem.expected({}), .stream = random::Stream(key)};
}

networks::Tonic tonic_of_trainer(const Trainer& trainer) {
  networks::Tonic tonic;
  for (std::size_t i = 0; i < tonic.size(); ++i) tonic[i] = networks::pulse_of_gene(trainer.genes()[i]);
  return tonic;
}

class GaitChangeOf : public testing::TestWithParam<MutationTechnique> {};

TEST_P(GaitChangeOf, CountsAsAFailureWhateverIsNoRowOfAnotherGait) {
  const auto problem = tonic_problem();
  const Training training = training_of(*problem, 7);
  GaitChange trainer(GetParam());
  trainer.begin(training);
  auto present = TonicGait::walk;
  std::vector<Measure> told;
  double failures = 0;
  std::uint32_t changes = 0;
  std::vector<CycleReport> reports;
  for (int cycle = 0; cycle < 400; ++cycle) {
    trainer.advance(training, 1, reports);
    const auto gait = networks::gait_of(tonic_of_trainer(trainer));
    const bool changed = gait && *gait != present;
    ASSERT_EQ(reports.back().success, changed) << cycle;
    ASSERT_TRUE(reports.back().accepted) << "a mutated tonic is kept";
    if (changed) {
      told.push_back({"gait_change_failures", changes, failures});
      told.push_back({"gait_reached", changes, static_cast<double>(*gait)});
      present = *gait;
      failures = 0;
      ++changes;
    } else {
      ++failures;
    }
  }
  told.push_back({"failures_after_last_change", 0, failures});
  EXPECT_EQ(reports.size(), 400U);
  EXPECT_GT(changes, 10U);
  const auto measures = trainer.measures();
  ASSERT_EQ(measures.size(), told.size());
  for (std::size_t i = 0; i < told.size(); ++i) {
    EXPECT_EQ(measures[i].name, told[i].name);
    EXPECT_EQ(measures[i].index, told[i].index);
    EXPECT_EQ(measures[i].value, told[i].value);
  }
}

TEST_P(GaitChangeOf, ReachesEveryGait) {
  const auto problem = tonic_problem();
  const Training training = training_of(*problem, 1);
  GaitChange trainer(GetParam());
  trainer.begin(training);
  std::vector<CycleReport> reports;
  for (int cycle = 0; cycle < 2000; ++cycle) trainer.advance(training, 1, reports);
  std::map<double, int> reached;
  for (const Measure& measure : trainer.measures()) {
    if (measure.name == "gait_reached") ++reached[measure.value];
  }
  EXPECT_EQ(reached.size(), 4U);
}

TEST_P(GaitChangeOf, ACloneGoesOnAsTheOriginalDoes) {
  const auto problem = tonic_problem(gaits::Gait::trot, problems::TonicGenes::tonic_and_weights);
  const Training training = training_of(*problem, 3);
  GaitChange trainer(GetParam());
  trainer.begin(training);
  std::vector<CycleReport> reports;
  for (int cycle = 0; cycle < 20; ++cycle) trainer.advance(training, 1, reports);
  const auto clone = trainer.clone();
  for (int cycle = 0; cycle < 20; ++cycle) {
    trainer.advance(training, 1, reports);
    clone->advance(training, 1, reports);
  }
  EXPECT_EQ(std::vector<double>(trainer.genes().begin(), trainer.genes().end()),
            std::vector<double>(clone->genes().begin(), clone->genes().end()));
}

INSTANTIATE_TEST_SUITE_P(Mutations, GaitChangeOf, testing::Values(MutationTechnique::all, MutationTechnique::one),
                         [](const auto& tested) {
                           return std::string(tested.param == MutationTechnique::all ? "All" : "One");
                         });

TEST(GaitChange, MutateAllMeetsARowOfAnotherGaitInThreeOfSixteenCycles) {
  const auto problem = tonic_problem();
  const Training training = training_of(*problem, 11);
  GaitChange trainer(MutationTechnique::all);
  trainer.begin(training);
  std::vector<CycleReport> reports;
  constexpr int cycles = 4000;
  int changes = 0;
  for (int cycle = 0; cycle < cycles; ++cycle) trainer.advance(training, 1, reports);
  for (const CycleReport& report : reports) changes += report.success;
  // Binomial with p = 3/16: five standard deviations of √(4000·p·(1 − p)) = 24.7.
  EXPECT_NEAR(changes, cycles * 3.0 / 16, 5 * 24.7);
}

TEST(GaitChange, MutateOneTouchesOneMotherACycle) {
  const auto problem = tonic_problem(gaits::Gait::pace, problems::TonicGenes::tonic_and_weights);
  const Training training = training_of(*problem, 5);
  GaitChange trainer(MutationTechnique::one);
  trainer.begin(training);
  std::vector<CycleReport> reports;
  std::vector<int> touched(networks::tonic_mothers, 0);
  for (int cycle = 0; cycle < 200; ++cycle) {
    const std::vector<double> before(trainer.genes().begin(), trainer.genes().end());
    trainer.advance(training, 1, reports);
    int changed = 0;
    for (std::size_t mother = 0; mother < networks::tonic_mothers; ++mother) {
      const bool moved = trainer.genes()[2 * mother + 1] != before[2 * mother + 1];
      changed += moved;
      touched[mother] += moved;
      if (!moved) {
        EXPECT_EQ(trainer.genes()[2 * mother], before[2 * mother]);
      }
    }
    EXPECT_EQ(changed, 1) << "a weight is redrawn with the input of its mother";
  }
  for (const int times : touched) EXPECT_GT(times, 20);
}

TEST(GaitChange, GenesStayPulsesAndWeightsWithinTheirBounds) {
  const auto problem = tonic_problem(gaits::Gait::gallop, problems::TonicGenes::tonic_and_weights);
  const Training training = training_of(*problem, 2);
  GaitChange trainer(MutationTechnique::all);
  trainer.begin(training);
  std::vector<CycleReport> reports;
  for (int cycle = 0; cycle < 200; ++cycle) {
    trainer.advance(training, 1, reports);
    for (std::size_t mother = 0; mother < networks::tonic_mothers; ++mother) {
      EXPECT_EQ(std::abs(trainer.genes()[2 * mother]), 1);
      const Gene& weight = problem->plan().genes[2 * mother + 1];
      EXPECT_EQ(held(weight, trainer.genes()[2 * mother + 1]), trainer.genes()[2 * mother + 1]);
    }
  }
}

TEST(GaitChange, TriesTheNewNetworkFromStanding) {
  const auto problem = tonic_problem();
  const Training training = training_of(*problem, 9);
  GaitChange trainer(MutationTechnique::one);
  Body standing;
  EXPECT_EQ(trainer.begin(training), problem->evaluate(problem->preset(), {}, standing));
  std::vector<CycleReport> reports;
  for (int cycle = 0; cycle < 30; ++cycle) {
    trainer.advance(training, 1, reports);
    Body again;
    EXPECT_EQ(reports.back().fitness, problem->evaluate(trainer.genes(), {}, again));
    EXPECT_EQ(trainer.meet(training), reports.back().fitness);
  }
}

TEST(GaitChange, TellsBeforeTheFirstChangeThatThereWasNone) {
  const auto problem = tonic_problem();
  const Training training = training_of(*problem, 9);
  GaitChange trainer(MutationTechnique::one);
  trainer.begin(training);
  ASSERT_EQ(trainer.measures().size(), 1U);
  EXPECT_EQ(trainer.measures()[0].name, "failures_after_last_change");
  EXPECT_EQ(trainer.measures()[0].value, 0);
}

TEST(GaitChange, RefusesMutateSomeAndNetworksWithoutATonic) {
  EXPECT_THROW(GaitChange{MutationTechnique::some}, std::invalid_argument);
  const auto problem = problems::make_quadruped_problem({});
  GaitChange trainer(MutationTechnique::all);
  EXPECT_THROW(trainer.begin(training_of(*problem, 1)), std::invalid_argument);
}

}  // namespace
}  // namespace lamprey::science::evolution
