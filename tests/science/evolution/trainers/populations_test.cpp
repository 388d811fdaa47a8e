#include "science/evolution/operators/selection.hpp"
#include "science/evolution/operators/uniform_mutation.hpp"
#include "science/evolution/trainers/chapter_six_ga.hpp"
#include "science/evolution/trainers/genetic_algorithm.hpp"
#include "science/evolution/trainers/hybrid.hpp"
#include "science/evolution/trainers/ii_rtea.hpp"
#include "tests/science/evolution/trainers/known_problems.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace lamprey::science::evolution::trainers {
namespace {

using Genes = std::vector<double>;
using known_problems::Minimisation;

/// What generation `generation` (0-based) of the chapter-6 GA was, after begin()'s one candidate.
std::vector<Genes> generation_of(const std::vector<Genes>& asked, std::size_t generation) {
  const auto first = asked.begin() + 1 + static_cast<std::ptrdiff_t>(40 * generation);
  return {first, first + 40};
}

std::vector<Genes> run_chapter_six(const Minimisation& problem, double mutation_rate, std::uint32_t generations) {
  ChapterSixGa trainer({.mutation_rate = mutation_rate});
  return train(trainer, problem, 6, 40 * generations).asked;
}

/// The genes of a generation, the fittest first.
std::vector<Genes> sorted(const Minimisation& problem, std::vector<Genes> members) {
  std::ranges::stable_sort(members, {}, [&](const Genes& genes) { return problem.at(genes); });
  return members;
}

std::ptrdiff_t differences(const Genes& left, const Genes& right) {
  std::ptrdiff_t count = 0;
  for (std::size_t gene = 0; gene < left.size(); ++gene) count += left[gene] != right[gene];
  return count;
}

TEST(ChapterSixGa, AHundredGenerationsOfFortyAreFourThousandCycles) {
  const auto problem = known_problems::sphere();
  const auto asked = run_chapter_six(problem, 75, 100);
  EXPECT_EQ(asked.size(), 1 + 4000U);
  EXPECT_EQ(asked[1], asked[0]) << "the first generation tries member 0 again";
  for (std::uint32_t member = 0; member < 40; ++member) {
    EXPECT_EQ(asked[1 + member], operators::draw_genes(random::Stream(6), member, problem.plan()));
  }
}

TEST(ChapterSixGa, TheTopHalfGoesOnSortedAndUndisturbed) {
  const auto problem = known_problems::sphere();
  const auto asked = run_chapter_six(problem, 100, 4);
  for (std::size_t generation = 0; generation < 3; ++generation) {
    const auto before = sorted(problem, generation_of(asked, generation));
    const auto now = generation_of(asked, generation + 1);
    EXPECT_TRUE(std::equal(now.begin(), now.begin() + 20, before.begin())) << generation;
  }
}

// 6.2.2.4: random members of the top half, whose adjacent pairs swap from a random point on.
TEST(ChapterSixGa, WithoutMutationABottomPairIsTwoTopMembersCrossedAtOnePoint) {
  const auto problem = known_problems::sphere();
  const auto asked = run_chapter_six(problem, 0, 2);
  const auto top = sorted(problem, generation_of(asked, 0));
  const auto now = generation_of(asked, 1);
  const auto is_crossing = [&](const Genes& first, const Genes& second) {
    for (std::size_t mother = 0; mother < 20; ++mother) {
      for (std::size_t father = 0; father < 20; ++father) {
        for (std::ptrdiff_t point = 1; point < 4; ++point) {
          Genes one = top[mother];
          Genes other = top[father];
          std::swap_ranges(one.begin() + point, one.end(), other.begin() + point);
          if (one == first && other == second) return true;
        }
      }
    }
    return false;
  };
  for (std::size_t place = 20; place < 40; place += 2) EXPECT_TRUE(is_crossing(now[place], now[place + 1])) << place;
}

TEST(ChapterSixGa, TheRateIsHowManyGenesOfEachBottomMemberAreDrawnAnew) {
  const auto problem = known_problems::sphere();
  const auto unmutated = generation_of(run_chapter_six(problem, 0, 2), 1);
  for (const auto& [rate, genes] : {std::pair{12.5, 0}, {25.0, 1}, {75.0, 3}, {100.0, 4}}) {
    const auto mutated = generation_of(run_chapter_six(problem, rate, 2), 1);
    for (std::size_t place = 0; place < 40; ++place) {
      EXPECT_EQ(differences(mutated[place], unmutated[place]), place < 20 ? 0 : genes) << rate << " %, " << place;
    }
  }
}

TEST(ChapterSixGa, WholeGenesStayWhole) {
  const auto problem = known_problems::mixed();
  for (const Genes& genes : run_chapter_six(problem, 50, 5)) {
    EXPECT_EQ(genes[0], std::floor(genes[0]));
    EXPECT_EQ(genes[3], std::floor(genes[3]));
  }
}

// 6.2.2.7, fig. 6.30 (a).
TEST(IiRtea, AQuarterOfTwoGenesIsNoneSoThatNothingEverChanges) {
  const auto problem = known_problems::sphere(2);
  IiRtea trainer({.mutation_rate = 25});
  const auto seen = train(trainer, problem, 1, 100);
  EXPECT_TRUE(std::ranges::all_of(seen.asked, [&](const Genes& genes) { return genes == seen.asked.front(); }));
  EXPECT_TRUE(std::ranges::none_of(seen.accepted, [](bool accepted) { return accepted; }));
}

TEST(IiRtea, AQuarterOfThreeGenesIsOneOfTheLastAcceptedOnes) {
  const auto problem = known_problems::sphere(3);
  IiRtea trainer({.mutation_rate = 25});
  const auto seen = train(trainer, problem, 1, 200);
  Genes state = seen.asked.front();
  for (std::size_t cycle = 0; cycle < 200; ++cycle) {
    EXPECT_EQ(differences(seen.asked[cycle + 1], state), 1) << cycle;
    if (seen.accepted[cycle]) state = seen.asked[cycle + 1];
  }
}

TEST(IiRtea, KeepsAChangeOnlyIfTheErrorFalls) {
  const Minimisation flat(known_problems::alike(4, 0, 1), [](std::span<const double>) { return 1.0; });
  IiRtea trainer({.mutation_rate = 100});
  const auto seen = train(trainer, flat, 1, 50);
  EXPECT_EQ(seen.genes, seen.asked.front());
  EXPECT_TRUE(std::ranges::none_of(seen.accepted, [](bool accepted) { return accepted; }));
}

TEST(IiRtea, StandsAnewOrWalksOn) {
  const auto problem = known_problems::sphere();
  IiRtea standing({.posture = Posture::reset});
  train(standing, problem, 1, 9);
  EXPECT_EQ(problem.evaluations_of_body, 1);
  IiRtea walking({.posture = Posture::carry});
  train(walking, problem, 1, 9);
  EXPECT_EQ(problem.evaluations_of_body, 10);
}

TEST(IiRtea, MeetsAnotherEnvironmentWithTheGenesThatItHas) {
  const auto problem = known_problems::sphere();
  IiRtea trainer({});
  train(trainer, problem, 1, 20);
  const Genes genes(trainer.genes().begin(), trainer.genes().end());
  Training other = known_problems::training(problem, 1);
  other.environment.weights.distance = -1;
  EXPECT_EQ(-trainer.meet(other).distance, problem.at(genes));
  // What was costly is cheap now: nearly any change towards the corners is kept.
  std::vector<CycleReport> reports;
  while (reports.size() < 200) trainer.advance(other, 1, reports);
  EXPECT_GT(problem.at(trainer.genes()), 50);
}

TEST(GeneticAlgorithm, AGenerationCostsItsPopulationButTheBest) {
  const auto problem = known_problems::sphere();
  GeneticAlgorithm trainer({.population = 7});
  const Training given = known_problems::training(problem, 1);
  trainer.begin(given);
  std::vector<CycleReport> reports;
  for (int generation = 0; generation < 4; ++generation) {
    reports.clear();
    trainer.advance(given, 1000, reports);
    EXPECT_EQ(reports.size(), 6U);
  }
}

TEST(GeneticAlgorithm, WithoutMutationAnExchangeMakesNoNewValues) {
  const auto problem = known_problems::sphere();
  GeneticAlgorithm trainer({.population = 10, .crossover = operators::Crossover::two_point, .mutation_rate = 0});
  const auto asked = train(trainer, problem, 1, 200).asked;
  for (std::size_t gene = 0; gene < 4; ++gene) {
    for (const Genes& genes : asked) {
      const auto first_has_it = [&](const Genes& first) { return first[gene] == genes[gene]; };
      EXPECT_TRUE(std::any_of(asked.begin(), asked.begin() + 10, first_has_it));
    }
  }
}

TEST(GeneticAlgorithm, TheFitterOfAPairIsTheMother) {
  // Of two sorts of members, Michalewicz's children of unlike parents lie beyond the cheap one, never the dear one.
  const Minimisation problem(known_problems::alike(1, -100, 100), [](std::span<const double> x) { return -x[0]; });
  const FirstGenes two_sorts = [](std::uint32_t member) { return Genes{member % 2 == 0 ? 10.0 : 0.0}; };
  GeneticAlgorithm trainer({.population = 21,
                            .selection = operators::Selection::roulette,
                            .crossover = operators::Crossover::michalewicz,
                            .mutation_rate = 0,
                            .first_genes = two_sorts});
  const auto asked = train(trainer, problem, 1, 40).asked;
  bool beyond = false;
  for (std::size_t child = 21; child < asked.size(); ++child) {
    EXPECT_TRUE(asked[child][0] == 0 || asked[child][0] >= 10) << asked[child][0];
    beyond |= asked[child][0] > 10;
  }
  EXPECT_TRUE(beyond);
}

TEST(Hybrid, IsItsFirstTrainerForItsShareAndThenRefinesWhatThatFound) {
  const auto problem = known_problems::sphere();
  const GeneticAlgorithmSettings settings{.population = 10};
  GeneticAlgorithm alone(settings);
  const auto first = train(alone, problem, 2, 55);

  Genes handed_over;
  Hybrid hybrid(
      std::make_unique<GeneticAlgorithm>(settings),
      [&](Genes genes) {
        handed_over = genes;
        return std::make_unique<IiRtea>(
            IiRteaSettings{.mutation_rate = 25, .first_genes = [genes](std::uint32_t) { return genes; }});
      },
      55);
  const auto both = train(hybrid, problem, 2, 100);
  EXPECT_TRUE(std::equal(first.costs.begin(), first.costs.end(), both.costs.begin()));
  EXPECT_EQ(handed_over, first.genes);
  EXPECT_EQ(both.asked[56], first.genes) << "the second one's begin, no cycle";
  EXPECT_EQ(differences(both.asked[57], first.genes), 1);
}

TEST(Hybrid, UsesNoRandomNumberTwice) {
  const auto problem = known_problems::sphere();
  const auto refine = [](Genes genes) {
    return std::make_unique<IiRtea>(
        IiRteaSettings{.mutation_rate = 100, .first_genes = [genes](std::uint32_t) { return genes; }});
  };
  Hybrid hybrid(refine({0, 0, 0, 0}), refine, 5);
  const auto asked = train(hybrid, problem, 2, 10).asked;
  for (std::size_t cycle = 0; cycle < 5; ++cycle) EXPECT_EQ(differences(asked[1 + cycle], asked[7 + cycle]), 4);
}

}  // namespace
}  // namespace lamprey::science::evolution::trainers
