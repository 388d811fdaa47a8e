#include "science/evolution/mutation.hpp"

#include "science/maths/normal_deviate.hpp"
#include "tests/science/evolution/plans.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <vector>

namespace lamprey::science::evolution {
namespace {

using Kind = StepDistribution::Kind;

constexpr StepDistribution uniform_five{.kind = Kind::uniform, .size = 5};
constexpr StepDistribution normal_five{.kind = Kind::normal, .standard_deviation = 5};
/// Far from every bound, so that no step is cut off.
const GenePlan wide = eight_units(-1000, 1000);

Units mutated(std::uint64_t key, std::uint32_t cycle, MutationTechnique technique, const StepDistribution& steps,
              const GenePlan& plan = wide, double start = 0) {
  std::vector<double> genes(32, start);
  mutate(random::Stream(key), cycle, technique, steps, plan, genes);
  return units_of(genes);
}

std::set<std::uint8_t> changed(const Units& units) {
  std::set<std::uint8_t> result;
  for (std::uint8_t unit = 0; unit < units.size(); ++unit) {
    if (units[unit] != Unit{}) result.insert(unit);
  }
  return result;
}

TEST(Mutation, AUniformStepTakesOneWordPerGene) {
  const Units units = mutated(1, 17, MutationTechnique::all, uniform_five);
  for (std::uint32_t unit = 0; unit < 8; ++unit) {
    const auto words = random::Stream(1).block(17, random::Purpose::mutation, unit);
    for (std::size_t gene = 0; gene < 4; ++gene) EXPECT_EQ(units[unit][gene], random::symmetric(words[gene], 5));
  }
}

TEST(Mutation, ANormalStepTakesTwoWordsPerTwoGenes) {
  const Units units = mutated(1, 17, MutationTechnique::all, normal_five);
  for (std::uint32_t unit = 0; unit < 8; ++unit) {
    const auto words = random::Stream(1).block(17, random::Purpose::mutation, unit);
    const auto first = maths::normal_deviates(words[0], words[1]);
    const auto second = maths::normal_deviates(words[2], words[3]);
    EXPECT_EQ(units[unit], (Unit{first.first * 5, first.second * 5, second.first * 5, second.second * 5}));
  }
}

TEST(Mutation, UniformStepsAreWholeAndWithinTheirSize) {
  std::map<double, int> counts;
  for (std::uint32_t cycle = 0; cycle < 500; ++cycle) {
    for (const Unit& unit : mutated(2, cycle, MutationTechnique::all, uniform_five)) {
      for (const double step : unit) ++counts[step];
    }
  }
  EXPECT_EQ(counts.size(), 11U);
  EXPECT_EQ(counts.begin()->first, -5);
  EXPECT_EQ(counts.rbegin()->first, 5);
  for (const auto& [step, count] : counts) EXPECT_EQ(step, std::floor(step));
}

TEST(Mutation, NormalStepsHaveTheirStandardDeviation) {
  double sum = 0;
  double squares = 0;
  int count = 0;
  for (std::uint32_t cycle = 0; cycle < 2000; ++cycle) {
    for (const Unit& unit : mutated(3, cycle, MutationTechnique::all, normal_five)) {
      for (const double step : unit) {
        sum += step;
        squares += step * step;
        ++count;
      }
    }
  }
  // Four standard errors of mean and of variance at n = 64,000.
  EXPECT_NEAR(sum / count, 0, 4 * 5 / std::sqrt(count));
  EXPECT_NEAR(squares / count, 25, 4 * 25 * std::sqrt(2.0 / count));
}

TEST(Mutation, ASizeOfZeroChangesNothing) {
  EXPECT_TRUE(changed(mutated(1, 0, MutationTechnique::all, {.kind = Kind::uniform, .size = 0})).empty());
  EXPECT_TRUE(changed(mutated(1, 0, MutationTechnique::all, {.kind = Kind::normal, .standard_deviation = 0})).empty());
}

TEST(Mutation, GenesAreHeldWithinTheirBounds) {
  const GenePlan plan = eight_units(0, 100);
  bool low = false;
  bool high = false;
  for (std::uint32_t cycle = 0; cycle < 50; ++cycle) {
    for (const double start : {0.0, 100.0}) {
      for (const auto& steps : {uniform_five, normal_five}) {
        for (const Unit& unit : mutated(4, cycle, MutationTechnique::all, steps, plan, start)) {
          for (const double gene : unit) {
            ASSERT_GE(gene, 0);
            ASSERT_LE(gene, 100);
            low |= start == 0 && gene == 0;
            high |= start == 100 && gene == 100;
          }
        }
      }
    }
  }
  EXPECT_TRUE(low && high);
}

TEST(MutateOne, ChangesExactlyTheChosenUnitByTheStepsThatMutateAllGivesIt) {
  std::map<std::uint8_t, int> counts;
  constexpr std::uint32_t cycles = 8000;
  for (std::uint32_t cycle = 0; cycle < cycles; ++cycle) {
    const Units one = mutated(5, cycle, MutationTechnique::one, normal_five);
    const auto units = changed(one);
    ASSERT_EQ(units.size(), 1U);
    const auto unit = *units.begin();
    ASSERT_EQ(unit, random::bounded(random::Stream(5).block(cycle, random::Purpose::mutation_choice, 0)[0], 8));
    if (cycle < 100) {
      ASSERT_EQ(one[unit], mutated(5, cycle, MutationTechnique::all, normal_five)[unit]);
    }
    ++counts[unit];
  }
  double chi_squared = 0;
  for (const auto& [unit, count] : counts) chi_squared += (count - 1000.0) * (count - 1000.0) / 1000;
  EXPECT_EQ(counts.size(), 8U);
  EXPECT_LT(chi_squared, 24.3);  // 7 degrees of freedom; exceeded by one key of a thousand
}

TEST(MutateSome, ChangesTheFourChildrenOfOneOfTheSixPairsOfLegs) {
  std::map<std::set<std::uint8_t>, int> counts;
  for (std::uint32_t cycle = 0; cycle < 6000; ++cycle) {
    ++counts[changed(mutated(6, cycle, MutationTechnique::some, normal_five))];
  }
  EXPECT_EQ(counts.size(), 6U);
  double chi_squared = 0;
  for (const auto& pair : wide.symmetric_units) {
    const int count = counts[std::set<std::uint8_t>(pair.begin(), pair.end())];
    EXPECT_GT(count, 0);
    chi_squared += (count - 1000.0) * (count - 1000.0) / 1000;
  }
  EXPECT_LT(chi_squared, 20.5);  // 5 degrees of freedom; exceeded by one key of a thousand
}

TEST(Mutation, OfACycleDoesNotDependOnTheCyclesBefore) {
  const Units alone = mutated(7, 41, MutationTechnique::some, normal_five);
  for (std::uint32_t cycle = 0; cycle < 41; ++cycle) mutated(7, cycle, MutationTechnique::all, uniform_five);
  EXPECT_EQ(mutated(7, 41, MutationTechnique::some, normal_five), alone);
}

TEST(Mutation, StepsAreScaledByTheGenesUnit) {
  GenePlan tenths = wide;
  for (Gene& gene : tenths.genes) gene.step_unit = 0.5;
  const Units whole = mutated(8, 3, MutationTechnique::all, normal_five);
  const Units halves = mutated(8, 3, MutationTechnique::all, normal_five, tenths);
  for (std::size_t unit = 0; unit < 8; ++unit) {
    for (std::size_t gene = 0; gene < 4; ++gene) EXPECT_EQ(halves[unit][gene], whole[unit][gene] / 2);
  }
}

TEST(Mutation, AUnitOfManyGenesTakesFurtherBlocks) {
  GenePlan plan = wide;
  plan.units = {{0, 1, 2, 3, 4, 5, 6}, {7}};
  std::vector<double> genes(32);
  mutate(random::Stream(9), 5, MutationTechnique::all, uniform_five, plan, genes);
  const auto further = random::Stream(9).block(5, random::Purpose::mutation, 0, 1);
  for (std::size_t i = 4; i < 7; ++i) EXPECT_EQ(genes[i], random::symmetric(further[i - 4], 5));
  EXPECT_EQ(genes[7], random::symmetric(random::Stream(9).block(5, random::Purpose::mutation, 1)[0], 5));
  EXPECT_EQ(genes[8], 0) << "of no unit";
}

}  // namespace
}  // namespace lamprey::science::evolution
