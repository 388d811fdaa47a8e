#include "experiment/yardsticks/pagmo_trainer.hpp"

#include "tests/science/evolution/trainers/trainer_laws.hpp"

#include <stdexcept>

namespace lamprey::experiment::yardsticks {
namespace {

using namespace science::evolution;
using known_problems::Named;

template <class Settings>
Named named(std::string name, Settings settings) {
  return {std::move(name), [settings] { return std::make_unique<PagmoTrainer>(settings); }};
}

std::vector<Named> yardsticks() {
  return {named("sga", PagmoSgaSettings{.population = 20}),
          named("simulated_annealing", PagmoSimulatedAnnealingSettings{.planned_evaluations = 200}),
          named("cmaes", PagmoCmaesSettings{.population = 12})};
}

}  // namespace
}  // namespace lamprey::experiment::yardsticks

namespace lamprey::science::evolution::known_problems {

INSTANTIATE_TEST_SUITE_P(Pagmo, TrainerLaws, testing::ValuesIn(experiment::yardsticks::yardsticks()), name_of);

}  // namespace lamprey::science::evolution::known_problems

namespace lamprey::experiment::yardsticks {
namespace {

class PagmoOptima : public testing::TestWithParam<Named> {};

TEST_P(PagmoOptima, AreReached) {
  for (const std::uint64_t key : {1U, 2U, 3U}) {
    // A random point costs 42 on average. pagmo2's GA mutates 2 % of the genes only: slow with four of them.
    EXPECT_LT(train(*GetParam().make(), known_problems::sphere(), key, 4000).best(), 0.2) << key;
    EXPECT_LT(train(*GetParam().make(), known_problems::equation_3_1(), key, 4000).best(), 0.01) << key;
  }
}

INSTANTIATE_TEST_SUITE_P(Pagmo, PagmoOptima, testing::ValuesIn(yardsticks()), known_problems::name_of);

// It learns the shape of a narrow, slanting valley, which is what it is known for.
TEST(PagmoCmaes, ReachesTheEndOfARotatedValleyToManyDigits) {
  const known_problems::Minimisation valley(known_problems::alike(4, -5, 5), [](std::span<const double> x) {
    const double along = x[0] + x[1] + x[2] + x[3] - 2;
    double sum = along * along;
    for (std::size_t gene = 1; gene < 4; ++gene) sum += 1e4 * (x[gene] - x[gene - 1]) * (x[gene] - x[gene - 1]);
    return sum;
  });
  PagmoTrainer trainer(PagmoCmaesSettings{.population = 12});
  EXPECT_LT(train(trainer, valley, 1, 4000).best(), 1e-9);
}

TEST(PagmoTrainer, TriesTheFirstPopulationThatItIsGiven) {
  const auto problem = known_problems::sphere(2);
  const trainers::FirstGenes given = [](std::uint32_t member) { return std::vector<double>{member / 100.0, -2}; };
  PagmoTrainer trainer(PagmoSgaSettings{.population = 6, .first_genes = given});
  const auto seen = train(trainer, problem, 1, 20);
  for (std::uint32_t member = 0; member < 6; ++member) EXPECT_EQ(seen.asked[member], given(member));
}

// An optimiser that has converged, or that sees no difference, goes on for as long as there is a budget.
TEST(PagmoTrainer, GoesOnWhereNothingIsBetterThanAnything) {
  const known_problems::Minimisation flat(known_problems::alike(3, 0, 1), [](std::span<const double>) { return 1.0; });
  for (const Named& named : yardsticks()) {
    const auto seen = train(*named.make(), flat, 1, 5000, 64);
    EXPECT_EQ(seen.costs.size(), 5000U) << named.name;
    EXPECT_EQ(seen.genes, seen.asked.front()) << named.name;
  }
  const auto sphere = known_problems::sphere(2);
  for (const Named& named : yardsticks()) {
    const auto seen = train(*named.make(), sphere, 1, 20'000, 64);
    EXPECT_EQ(seen.costs.size(), 20'000U) << named.name;
    EXPECT_LT(seen.best(), 0.01) << named.name;
  }
}

// 4 genes in 10 temperatures are 40 evaluations a round: 95 planned ones are two rounds, and the third begins anew.
TEST(PagmoSimulatedAnnealing, FitsItsScheduleToTheEvaluationsThatArePlanned) {
  const auto problem = known_problems::sphere();
  PagmoTrainer trainer(PagmoSimulatedAnnealingSettings{.planned_evaluations = 95});
  const Training given = known_problems::training(problem, 1);
  trainer.begin(given);
  std::vector<CycleReport> reports;
  trainer.advance(given, 1000, reports);
  EXPECT_EQ(reports.size(), 80U);
  trainer.advance(given, 1000, reports);
  EXPECT_EQ(reports.size(), 160U);

  PagmoTrainer shortest(PagmoSimulatedAnnealingSettings{.planned_evaluations = 1});
  shortest.begin(given);
  reports.clear();
  shortest.advance(given, 1000, reports);
  EXPECT_EQ(reports.size(), 4U) << "one temperature, one round";
}

TEST(PagmoTrainer, RefusesWhatIsOutOfRangeAndNamesIt) {
  try {
    PagmoTrainer(PagmoCmaesSettings{.population = 4});
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "population is 4, but must be 5..65536");
  }
  EXPECT_THROW(PagmoTrainer(PagmoSgaSettings{.population = 3}), std::invalid_argument);
  EXPECT_THROW(PagmoTrainer(PagmoSimulatedAnnealingSettings{.planned_evaluations = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace lamprey::experiment::yardsticks
