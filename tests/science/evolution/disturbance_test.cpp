#include "science/evolution/disturbance.hpp"

#include "science/evolution/rtea.hpp"
#include "science/fitness/quadruped_trial.hpp"
#include "science/gaits/walk.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <set>

namespace lamprey::science::evolution {
namespace {

using networks::FourMotherNetwork;
using Trial = fitness::QuadrupedTrial;

constexpr UnitKinds kinds{networks::vertical_children, networks::horizontal_children};
const GenePlan wide{.minimum = -1000, .maximum = 1000, .symmetric_units = {}};

std::array<Unit, 8> disturbed(std::uint64_t key, const Disturbance& disturbance, const GenePlan& plan = wide) {
  std::array<Unit, 8> units{};
  disturb(random::Stream(key), disturbance, kinds, plan, units);
  return units;
}

TEST(DisturbedPerKind, IsTheShareOfEightHalvedWithoutFractions) {
  EXPECT_EQ(disturbed_per_kind(0), 0U);
  EXPECT_EQ(disturbed_per_kind(24), 0U);
  EXPECT_EQ(disturbed_per_kind(25), 1U);  // 8.2.2: two of eight
  EXPECT_EQ(disturbed_per_kind(50), 2U);
  EXPECT_EQ(disturbed_per_kind(75), 3U);
  EXPECT_EQ(disturbed_per_kind(99), 3U);
  EXPECT_EQ(disturbed_per_kind(100), 4U);
}

TEST(Disturbance, TouchesAsManyVerticalAsHorizontalChildren) {
  for (std::uint32_t per_kind = 0; per_kind <= 4; ++per_kind) {
    for (std::uint64_t key = 0; key < 200; ++key) {
      // In ±1000 a whole unit stays unchanged in one of 10¹³ draws.
      const auto units = disturbed(key, {.size = 1000, .per_kind = per_kind});
      for (const auto& kind : kinds) {
        const auto touched = [&](std::uint8_t unit) { return units[unit] != Unit{}; };
        ASSERT_EQ(std::ranges::count_if(kind, touched), per_kind) << key;
      }
    }
  }
}

TEST(Disturbance, ChoosesEveryPairOfAKindEquallyOften) {
  std::map<std::set<std::uint8_t>, int> counts;
  for (std::uint64_t key = 0; key < 6000; ++key) {
    const auto units = disturbed(key, {.size = 1000, .per_kind = 2});
    std::set<std::uint8_t> chosen;
    for (const auto unit : networks::vertical_children) {
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
  const auto units = disturbed(99, {.size = 7, .per_kind = 4});
  for (std::uint32_t unit = 0; unit < 8; ++unit) {
    const auto words = random::Stream(99).block(0, random::Purpose::disturbance, unit);
    for (std::size_t gene = 0; gene < 4; ++gene) {
      EXPECT_EQ(units[unit][gene], random::symmetric(words[gene], 7));
      EXPECT_LE(std::fabs(units[unit][gene]), 7);
    }
  }
}

TEST(Disturbance, AChildIsDisturbedAlikeHoweverManyOthersAre) {
  const auto all = disturbed(5, {.size = 10, .per_kind = 4});
  for (std::uint32_t per_kind = 1; per_kind < 4; ++per_kind) {
    const auto few = disturbed(5, {.size = 10, .per_kind = per_kind});
    for (std::size_t unit = 0; unit < 8; ++unit) {
      if (few[unit] != Unit{}) {
        EXPECT_EQ(few[unit], all[unit]);
      }
    }
  }
}

TEST(Disturbance, OfNothingOrBySizeZeroLeavesTheGaitAlone) {
  EXPECT_EQ(disturbed(1, {.size = 10, .per_kind = 0}), (std::array<Unit, 8>{}));
  EXPECT_EQ(disturbed(1, {.size = 0, .per_kind = 4}), (std::array<Unit, 8>{}));
}

TEST(Disturbance, LeavesTheMothersAloneAndNoTimeBelowZero) {
  bool reached_zero = false;
  for (std::uint64_t key = 0; key < 50; ++key) {
    FourMotherNetwork network = gaits::walk();
    disturb(random::Stream(key), {.size = 10, .per_kind = 4}, kinds, gene_plan<Trial>(), Trial::units(network));
    ASSERT_EQ(network.mother_times, gaits::walk().mother_times);
    for (const auto& times : network.child_times) {
      for (const double time : times) {
        ASSERT_GE(time, 0);
        ASSERT_LE(time, 100);
        reached_zero |= time == 0;
      }
    }
  }
  EXPECT_TRUE(reached_zero);
}

}  // namespace
}  // namespace lamprey::science::evolution
