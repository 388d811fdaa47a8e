#include "science/evolution/operators/normal_steps.hpp"
#include "science/evolution/trainers/evolution_strategy.hpp"
#include "science/evolution/trainers/evolutionary_programming.hpp"
#include "science/evolution/trainers/simulated_annealing.hpp"
#include "tests/science/evolution/trainers/known_problems.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace lamprey::science::evolution::trainers {
namespace {

using Genes = std::vector<double>;
using known_problems::Minimisation;

Minimisation flat(std::size_t genes = 4) {
  return {known_problems::alike(genes, -5, 5), [](std::span<const double>) { return 1.0; }};
}

std::ptrdiff_t differences(const Genes& left, const Genes& right) {
  std::ptrdiff_t count = 0;
  for (std::size_t gene = 0; gene < left.size(); ++gene) count += left[gene] != right[gene];
  return count;
}

// 3.4.2: an atom of the system is displaced.
TEST(SimulatedAnnealing, DisplacesOneGeneOfWhereItIsAndQuenchedNeverClimbs) {
  const auto problem = known_problems::sphere();
  SimulatedAnnealing trainer({.first_step = 1, .first_temperature = 0});
  const auto seen = train(trainer, problem, 1, 300);
  Genes state = seen.asked.front();
  for (std::size_t cycle = 0; cycle < 300; ++cycle) {
    ASSERT_LE(differences(seen.asked[cycle + 1], state), 1) << cycle;
    if (seen.costs[cycle] <= problem.at(state)) state = seen.asked[cycle + 1];
  }
}

TEST(SimulatedAnnealing, MoltenItGoesWhereverItTriesUntilItsTriesAtThatTemperatureAreDone) {
  const auto problem = known_problems::sphere();
  SimulatedAnnealing trainer(
      {.first_step = 1, .first_temperature = 1e12, .temperature_factor = 0, .tries_per_temperature = 60});
  const auto seen = train(trainer, problem, 1, 300);
  bool climbed = false;
  for (std::size_t cycle = 0; cycle < 60; ++cycle) {
    ASSERT_LE(differences(seen.asked[cycle + 1], seen.asked[cycle]), 1) << cycle;
    climbed |= seen.costs[cycle] > problem.at(seen.asked[cycle]);
  }
  EXPECT_TRUE(climbed);
  Genes state = seen.asked[60];
  for (std::size_t cycle = 60; cycle < 300; ++cycle) {
    ASSERT_LE(differences(seen.asked[cycle + 1], state), 1) << cycle;
    if (seen.costs[cycle] <= problem.at(state)) state = seen.asked[cycle + 1];
  }
}

TEST(SimulatedAnnealing, DisplacesEveryGeneAsOftenByItsStandardDeviation) {
  const Minimisation problem(std::vector<Gene>(4, {.minimum = -1e9, .maximum = 1e9, .step_unit = 2}),
                             [](std::span<const double>) { return 1.0; });
  SimulatedAnnealing trainer({.first_step = 3, .first_genes = [](std::uint32_t) { return Genes(4); }});
  const auto asked = train(trainer, problem, 1, 8000).asked;
  std::vector<double> moves(4);
  double squares = 0;
  for (std::size_t cycle = 0; cycle < 8000; ++cycle) {
    for (std::size_t gene = 0; gene < 4; ++gene) {
      const double step = asked[cycle + 1][gene] - asked[cycle][gene];
      moves[gene] += step != 0;
      squares += step * step;
    }
  }
  double chi_squared = 0;
  for (const double count : moves) chi_squared += (count - 2000) * (count - 2000) / 2000;
  EXPECT_LT(chi_squared, 16.3);  // 3 degrees of freedom; exceeded by one key of a thousand
  EXPECT_NEAR(squares / 8000, 36, 4 * 36 * std::sqrt(2.0 / 8000));
}

// 3.6: fewer than one in five are good, so the standard deviation shrinks: by 0.85 after each 20.
TEST(EvolutionStrategy, OnePlusOneStepsAllGenesByWhatTheFifthRuleSays) {
  const auto problem = flat();
  EvolutionStrategy trainer({.strategy = Strategy::one_plus_one, .steps = {.first = 0.5, .smallest = 0.4}});
  const auto seen = train(trainer, problem, 9, 100);
  for (const auto& [cycle, deviation] : {std::pair{0U, 0.5}, {19U, 0.5}, {20U, 0.425}, {39U, 0.425}, {40U, 0.4}}) {
    Genes wanted = seen.asked.front();
    operators::WordSequence words(random::Stream(9), cycle + 1, random::Purpose::mutation, 0);
    operators::add_normal_steps(problem.plan(), deviation, words, wanted);
    EXPECT_EQ(seen.asked[cycle + 1], wanted) << cycle;
  }
}

TEST(EvolutionStrategy, OnePlusOneGoesOnFromWhatIsBetterOnly) {
  const auto problem = known_problems::sphere();
  // A step of 0.01: a candidate is as near to its parent as 6.66 of them.
  EvolutionStrategy trainer({.steps = {.first = 0.01, .smallest = 0.01, .largest = 0.01}});
  const auto seen = train(trainer, problem, 1, 500);
  Genes state = seen.asked.front();
  for (std::size_t cycle = 0; cycle < 500; ++cycle) {
    for (std::size_t gene = 0; gene < 4; ++gene) {
      ASSERT_NEAR(seen.asked[cycle + 1][gene], state[gene], 0.0667) << cycle;
    }
    if (seen.accepted[cycle]) state = seen.asked[cycle + 1];
  }
  EXPECT_LT(seen.best(), seen.first - 1);
}

/// How far the genes of the last 30 candidates are from those of the nearest of eight founders, at most.
double drift(Strategy strategy) {
  EvolutionStrategy trainer({.strategy = strategy,
                             .population = 8,
                             .offspring = 30,
                             .steps = {.first = 0.001, .smallest = 0.001, .largest = 0.001}});
  const auto asked = train(trainer, flat(), 1, 7 + 30 * 200).asked;
  double farthest = 0;
  for (std::size_t child = asked.size() - 30; child < asked.size(); ++child) {
    for (std::size_t gene = 0; gene < 4; ++gene) {
      double nearest = 10;
      for (std::size_t founder = 0; founder < 8; ++founder) {
        nearest = std::min(nearest, std::fabs(asked[child][gene] - asked[founder][gene]));
      }
      farthest = std::max(farthest, nearest);
    }
  }
  return farthest;
}

// Where nothing is better than anything, parents win every tie; (μ,λ) has forgotten them.
TEST(EvolutionStrategy, PlusKeepsItsParentsAndCommaForgetsThem) {
  EXPECT_LT(drift(Strategy::mu_plus_lambda), 0.00667) << "one step of at most 6.66 standard deviations";
  EXPECT_LT(drift(Strategy::mu_plus_one), 0.00667);
  EXPECT_GT(drift(Strategy::mu_comma_lambda), 0.01);
}

TEST(EvolutionStrategy, AGenerationHasAsManyChildrenAsItsStrategySays) {
  const auto problem = known_problems::sphere();
  for (const auto& [strategy, founders, children] : {std::tuple{Strategy::one_plus_one, 0U, 1U},
                                                     {Strategy::mu_plus_one, 5U, 1U},
                                                     {Strategy::mu_plus_lambda, 5U, 9U},
                                                     {Strategy::mu_comma_lambda, 5U, 9U}}) {
    EvolutionStrategy trainer({.strategy = strategy, .population = 6, .offspring = 9});
    const Training given = known_problems::training(problem, 1);
    trainer.begin(given);
    std::vector<CycleReport> reports;
    if (founders > 0) trainer.advance(given, 1000, reports);
    EXPECT_EQ(reports.size(), founders);
    trainer.advance(given, 1000, reports);
    EXPECT_EQ(reports.size(), founders + children);
  }
}

TEST(SelfAdaptation, StepsByTheAdaptedStandardDeviationHeldWithinItsSizes) {
  GenePlan plan;
  plan.genes = known_problems::alike(4, -500, 500);
  bool smallest = false;
  bool largest = false;
  for (std::uint32_t cycle = 0; cycle < 400; ++cycle) {
    const StepSizes sizes{.first = 1, .smallest = 0.6, .largest = 1.5};
    operators::WordSequence words(random::Stream(1), cycle, random::Purpose::mutation, 0);
    Genes genes(4);
    double standard_deviation = 1;
    mutate_adapted(plan, sizes, words, genes, standard_deviation);
    EXPECT_GE(standard_deviation, 0.6);
    EXPECT_LE(standard_deviation, 1.5);
    smallest |= standard_deviation == 0.6;
    largest |= standard_deviation == 1.5;
    Genes wanted(4);
    operators::add_normal_steps(plan, standard_deviation, words, wanted);
    EXPECT_EQ(genes, wanted);
  }
  EXPECT_TRUE(smallest && largest);
}

// Who meets everyone scores how many are no better, so the scores are the order of costs.
TEST(EvolutionaryProgramming, ATournamentAgainstEveryoneKeepsTheBestHalf) {
  const auto problem = known_problems::sphere();
  EvolutionaryProgramming best({.population = 10});
  EvolutionaryProgramming all({.population = 10, .survival = Survival::tournament, .opponents = 19});
  EvolutionaryProgramming one({.population = 10, .survival = Survival::tournament, .opponents = 1});
  const auto wanted = train(best, problem, 1, 500);
  EXPECT_EQ(train(all, problem, 1, 500), wanted);
  EXPECT_NE(train(one, problem, 1, 500), wanted) << "luck decides";
}

TEST(EvolutionaryProgramming, EachMemberHasOneChildNearIt) {
  const auto problem = flat();
  EvolutionaryProgramming trainer({.population = 10, .steps = {.first = 0.001, .smallest = 0.001, .largest = 0.001}});
  const auto asked = train(trainer, problem, 1, 9 + 50).asked;
  for (std::size_t child = 10; child < asked.size(); ++child) {
    for (std::size_t gene = 0; gene < 4; ++gene) {
      EXPECT_NEAR(asked[child][gene], asked[child % 10][gene], 0.00667) << "parents win ties";
      EXPECT_NE(asked[child][gene], asked[child % 10][gene]);
    }
  }
}

}  // namespace
}  // namespace lamprey::science::evolution::trainers
