#include "science/evolution/disturbance.hpp"

#include "tests/science/evolution/plans.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <set>

namespace lamprey::science::evolution {
namespace {

const GenePlan wide = eight_units(-1000, 1000);

Units disturbed(std::uint64_t key, const Disturbance& disturbance, const GenePlan& plan = wide, double start = 0) {
  std::vector<double> genes(32, start);
  disturb(random::Stream(key), 0, disturbance, plan, genes);
  return units_of(genes);
}

TEST(Disturbance, TouchesTheShareOfEachKindWithoutFractions) {
  // 8.2.2: 25 % of eight are two, one vertical and one horizontal.
  for (const auto& [percent, per_kind] : {std::pair{0, 0}, {24, 0}, {25, 1}, {50, 2}, {75, 3}, {99, 3}, {100, 4}}) {
    for (std::uint64_t key = 0; key < 200; ++key) {
      // In ±1000 a whole unit stays unchanged in one of 10¹³ draws.
      const auto units = disturbed(key, {.size = 1000, .percent = percent});
      for (const auto& kind : wide.kinds) {
        const auto touched = [&](std::uint32_t unit) { return units[unit] != Unit{}; };
        ASSERT_EQ(std::ranges::count_if(kind, touched), per_kind) << key;
      }
    }
  }
}

TEST(Disturbance, ChoosesEveryPairOfAKindEquallyOften) {
  std::map<std::set<std::uint32_t>, int> counts;
  for (std::uint64_t key = 0; key < 6000; ++key) {
    const auto units = disturbed(key, {.size = 1000, .percent = 50});
    std::set<std::uint32_t> chosen;
    for (const auto unit : wide.kinds[0]) {
      if (units[unit] != Unit{}) chosen.insert(unit);
    }
    ++counts[chosen];
  }
  EXPECT_EQ(counts.size(), 6U);
  double chi_squared = 0;
  for (const auto& [chosen, count] : counts) chi_squared += (count - 1000.0) * (count - 1000.0) / 1000;
  EXPECT_LT(chi_squared, 20.5);  // 5 degrees of freedom; exceeded by one set of keys of a thousand
}

TEST(Disturbance, AddsAWholeNumberWithinItsSizeFromTheChildsOwnBlock) {
  const auto units = disturbed(99, {.size = 7, .percent = 100});
  for (std::uint32_t unit = 0; unit < 8; ++unit) {
    const auto words = random::Stream(99).block(0, random::Purpose::disturbance, unit);
    for (std::size_t gene = 0; gene < 4; ++gene) {
      EXPECT_EQ(units[unit][gene], random::symmetric(words[gene], 7));
      EXPECT_LE(std::fabs(units[unit][gene]), 7);
    }
  }
}

TEST(Disturbance, AChildIsDisturbedAlikeHoweverManyOthersAre) {
  const auto all = disturbed(5, {.size = 10, .percent = 100});
  for (const int percent : {25, 50, 75}) {
    const auto few = disturbed(5, {.size = 10, .percent = percent});
    for (std::size_t unit = 0; unit < 8; ++unit) {
      if (few[unit] != Unit{}) {
        EXPECT_EQ(few[unit], all[unit]);
      }
    }
  }
}

TEST(Disturbance, OfNothingOrBySizeZeroLeavesTheGaitAlone) {
  EXPECT_EQ(disturbed(1, {.size = 10, .percent = 0}), Units{});
  EXPECT_EQ(disturbed(1, {.size = 0, .percent = 100}), Units{});
}

TEST(Disturbance, IsAddressedByMemberSoThatMembersDifferAndMemberZeroIsTheJobsOwn) {
  std::vector<double> first(32);
  std::vector<double> second(32);
  disturb(random::Stream(5), 0, {.size = 10, .percent = 100}, wide, first);
  disturb(random::Stream(5), 1, {.size = 10, .percent = 100}, wide, second);
  EXPECT_EQ(units_of(first), disturbed(5, {.size = 10, .percent = 100}));
  EXPECT_NE(first, second);
}

TEST(Disturbance, HoldsGenesWithinTheirBoundsAndScalesStepsByTheirUnit) {
  bool reached_zero = false;
  for (std::uint64_t key = 0; key < 50; ++key) {
    for (const auto& unit : disturbed(key, {.size = 10, .percent = 100}, eight_units(0, 100), 5)) {
      for (const double gene : unit) {
        ASSERT_GE(gene, 0);
        ASSERT_LE(gene, 100);
        reached_zero |= gene == 0;
      }
    }
  }
  EXPECT_TRUE(reached_zero);

  GenePlan tenths = wide;
  for (Gene& gene : tenths.genes) gene.step_unit = 0.25;
  const auto whole = disturbed(3, {.size = 10, .percent = 100});
  const auto quarters = disturbed(3, {.size = 10, .percent = 100}, tenths);
  for (std::size_t unit = 0; unit < 8; ++unit) {
    for (std::size_t gene = 0; gene < 4; ++gene) EXPECT_EQ(quarters[unit][gene], whole[unit][gene] / 4);
  }
}

TEST(Disturbance, AUnitOfManyGenesTakesFurtherBlocks) {
  GenePlan plan = eight_units(-1000, 1000);
  plan.units = {{0, 1, 2, 3, 4, 5, 6}};
  plan.kinds = {{0}};
  std::vector<double> genes(32);
  disturb(random::Stream(8), 0, {.size = 100, .percent = 100}, plan, genes);
  const auto words = random::Stream(8).block(0, random::Purpose::disturbance, 0, 1);
  for (std::size_t i = 4; i < 7; ++i) EXPECT_EQ(genes[i], random::symmetric(words[i - 4], 100));
  EXPECT_EQ(genes[7], 0);
}

}  // namespace
}  // namespace lamprey::science::evolution
