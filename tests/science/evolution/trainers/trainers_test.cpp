#include "science/evolution/trainers/chapter_six_ga.hpp"
#include "science/evolution/trainers/evolution_strategy.hpp"
#include "science/evolution/trainers/evolutionary_programming.hpp"
#include "science/evolution/trainers/genetic_algorithm.hpp"
#include "science/evolution/trainers/hybrid.hpp"
#include "science/evolution/trainers/ii_rtea.hpp"
#include "science/evolution/trainers/simulated_annealing.hpp"
#include "tests/science/evolution/trainers/trainer_laws.hpp"

#include <limits>
#include <stdexcept>

namespace lamprey::science::evolution::trainers {
namespace {

using known_problems::Named;
using operators::Crossover;
using operators::Selection;

GeneticAlgorithmSettings genetic(Selection selection, Crossover crossover) {
  return {.population = 20, .selection = selection, .crossover = crossover};
}

EvolutionStrategySettings strategy(Strategy kind) {
  return {.strategy = kind, .population = 8, .offspring = 30, .steps = {.first = 1, .smallest = 1e-4, .largest = 10}};
}

template <class Kind, class Settings>
Named named(std::string name, Settings settings) {
  return {std::move(name), [settings] { return std::make_unique<Kind>(settings); }};
}

/// A GA for 100 evaluations, then the II-RTEA from its best.
std::unique_ptr<Trainer> hybrid(std::uint32_t first_evaluations = 100) {
  return std::make_unique<Hybrid>(
      std::make_unique<GeneticAlgorithm>(GeneticAlgorithmSettings{.population = 20}),
      [](std::vector<double> genes) {
        return std::make_unique<IiRtea>(
            IiRteaSettings{.mutation_rate = 25, .first_genes = [genes](std::uint32_t) { return genes; }});
      },
      first_evaluations);
}

std::vector<Named> all_trainers() {
  using enum Selection;
  using enum Crossover;
  using enum Strategy;
  const EvolutionaryProgrammingSettings programming{.population = 12,
                                                    .steps = {.first = 1, .smallest = 1e-4, .largest = 10}};
  auto competing = programming;
  competing.survival = Survival::tournament;
  return {named<ChapterSixGa>("chapter_six_ga", ChapterSixGaSettings{.mutation_rate = 25}),
          named<IiRtea>("ii_rtea", IiRteaSettings{.mutation_rate = 25}),
          named<GeneticAlgorithm>("genetic_algorithm_truncation_one_point", genetic(truncation, one_point)),
          named<GeneticAlgorithm>("genetic_algorithm_roulette_two_point", genetic(roulette, two_point)),
          named<GeneticAlgorithm>("genetic_algorithm_tournament_blend", genetic(tournament, blend)),
          named<GeneticAlgorithm>("genetic_algorithm_truncation_michalewicz", genetic(truncation, michalewicz)),
          named<GeneticAlgorithm>("genetic_algorithm_tournament_blx_alpha", genetic(tournament, blx_alpha)),
          named<SimulatedAnnealing>("simulated_annealing",
                                    SimulatedAnnealingSettings{.first_step = 1, .first_temperature = 10}),
          named<EvolutionStrategy>("one_plus_one", strategy(one_plus_one)),
          named<EvolutionStrategy>("mu_plus_one", strategy(mu_plus_one)),
          named<EvolutionStrategy>("mu_plus_lambda", strategy(mu_plus_lambda)),
          named<EvolutionStrategy>("mu_comma_lambda", strategy(mu_comma_lambda)),
          named<EvolutionaryProgramming>("evolutionary_programming", programming),
          named<EvolutionaryProgramming>("evolutionary_programming_tournament", competing),
          {"hybrid", [] { return hybrid(); }, 1}};
}

}  // namespace
}  // namespace lamprey::science::evolution::trainers

namespace lamprey::science::evolution::known_problems {

INSTANTIATE_TEST_SUITE_P(Trainers, TrainerLaws, testing::ValuesIn(trainers::all_trainers()), name_of);

}  // namespace lamprey::science::evolution::known_problems

namespace lamprey::science::evolution::trainers {
namespace {

class KnownOptima : public testing::TestWithParam<Named> {
 protected:
  /// The lowest cost of 4000 evaluations, the worst of three runs.
  double reached(const known_problems::Minimisation& problem) const {
    double worst = 0;
    for (const std::uint64_t key : {1U, 2U, 3U}) {
      worst = std::max(worst, train(*GetParam().make(), problem, key, 4000).best());
    }
    return worst;
  }
};

TEST_P(KnownOptima, AreReached) {
  // A random point of the sphere costs 42 on average; 0.05 is within 0.11 of its optimum in each of four genes.
  EXPECT_LT(reached(known_problems::sphere()), 0.05);
  EXPECT_LT(reached(known_problems::equation_3_1()), 0.01);
}

INSTANTIATE_TEST_SUITE_P(Trainers, KnownOptima, testing::ValuesIn(all_trainers()), known_problems::name_of);

class ManyValleys : public KnownOptima {};

// A random point costs 56 on average. Below 1.5 at most one gene of three is in a valley next to the lowest one.
TEST_P(ManyValleys, AreLeftByWhatSearchesEverywhere) {
  EXPECT_LT(reached(known_problems::rastrigin()), 1.5);
}

/// Small normal steps stay where they are: evolution strategies and programming are not among these.
std::vector<Named> searching_everywhere() {
  std::vector<Named> trainers = all_trainers();
  std::erase_if(trainers, [](const Named& trainer) {
    return trainer.name.starts_with("mu_") || trainer.name.starts_with("one_") ||
           trainer.name.starts_with("evolutionary_");
  });
  return trainers;
}

INSTANTIATE_TEST_SUITE_P(Trainers, ManyValleys, testing::ValuesIn(searching_everywhere()), known_problems::name_of);

TEST(Trainers, RefuseWhatIsOutOfRangeAndNameIt) {
  const auto message = [](auto make) -> std::string {
    try {
      make();
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(message([] { GeneticAlgorithm({.population = 3}); }), "population is 3, but must be 4..65536");
  EXPECT_EQ(
      message([] { GeneticAlgorithm({.population = 10, .selection = Selection::tournament, .tournament_size = 11}); }),
      "tournament_size is 11, but must be 1..10");
  EXPECT_EQ(message([] { GeneticAlgorithm({.mutation_rate = 101}); }), "mutation_rate is 101, but must be 0..100");
  EXPECT_EQ(message([] { GeneticAlgorithm({.blend_alpha = -1}); }), "blend_alpha is -1, but must be 0..2");
  EXPECT_NE(message([] { ChapterSixGa({.mutation_rate = -1}); }), "accepted");
  EXPECT_NE(message([] { IiRtea({.mutation_rate = std::numeric_limits<double>::quiet_NaN()}); }), "accepted");
  EXPECT_NE(message([] { SimulatedAnnealing({.first_step = 0}); }), "accepted");
  EXPECT_NE(message([] { SimulatedAnnealing({.first_temperature = -1}); }), "accepted");
  EXPECT_NE(message([] { SimulatedAnnealing({.temperature_factor = 1.01}); }), "accepted");
  EXPECT_NE(message([] { SimulatedAnnealing({.tries_per_temperature = 0}); }), "accepted");
  EXPECT_EQ(
      message([] { EvolutionStrategy({.strategy = Strategy::mu_comma_lambda, .population = 40, .offspring = 39}); }),
      "offspring is 39, but must be 40..65536")
      << "3.6.1: λ ≥ μ";
  EXPECT_EQ(
      message([] { EvolutionStrategy({.strategy = Strategy::mu_plus_lambda, .population = 40, .offspring = 1}); }),
      "accepted");
  EXPECT_NE(message([] { EvolutionStrategy({.steps = {.first = 0.1}}); }), "accepted") << "below the smallest";
  EXPECT_NE(message([] { EvolutionStrategy({.success_window = 0}); }), "accepted");
  EXPECT_NE(message([] { EvolutionaryProgramming({.population = 0}); }), "accepted");
  EXPECT_EQ(message([] { EvolutionaryProgramming({.population = 4}); }), "accepted");
  EXPECT_EQ(
      message([] { EvolutionaryProgramming({.population = 4, .survival = Survival::tournament, .opponents = 8}); }),
      "opponents is 8, but must be 1..7");
  EXPECT_NE(message([] {
              Hybrid(
                  nullptr, [](std::vector<double>) { return nullptr; }, 1);
            }),
            "accepted");
  EXPECT_NE(message([] { Hybrid(std::make_unique<IiRtea>(IiRteaSettings{}), nullptr, 1); }), "accepted");
}

TEST(Trainers, OffLineOnesKnowOneEnvironment) {
  const auto problem = known_problems::sphere();
  for (const Named& named : all_trainers()) {
    if (named.name == "ii_rtea") continue;
    EXPECT_THROW(named.make()->meet(known_problems::training(problem, 1)), std::logic_error) << named.name;
  }
}

TEST(Trainers, BeginWithTheGenesThatTheyAreGiven) {
  const auto problem = known_problems::sphere(2);
  const FirstGenes given = [](std::uint32_t member) { return std::vector<double>{member / 100.0, -2}; };
  GeneticAlgorithm trainer({.population = 6, .first_genes = given});
  const auto seen = train(trainer, problem, 1, 5);
  for (std::uint32_t member = 0; member < 6; ++member) EXPECT_EQ(seen.asked[member], given(member));

  GeneticAlgorithm wrong({.first_genes = [](std::uint32_t) { return std::vector<double>{1}; }});
  EXPECT_THROW(wrong.begin(known_problems::training(problem, 1)), std::invalid_argument);
}

}  // namespace
}  // namespace lamprey::science::evolution::trainers
