#include "science/evolution/acceptance.hpp"

#include "science/random/stream.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace lamprey::science::evolution {
namespace {

/// Every combination of shrinking (−1), equal (0) and growing (+1) components against errors of 10 each.
template <typename Check>
void for_each_change(Check check) {
  for (int s = -1; s <= 1; ++s) {
    for (int d = -1; d <= 1; ++d) {
      for (int f = -1; f <= 1; ++f) check(s, d, f);
    }
  }
}

constexpr Errors ten{10, 10, 10};

TEST(PerComponent, AcceptsWhatGrowsNowhereAndSucceedsWhereSomethingShrinksBesides) {
  for_each_change([](int s, int d, int f) {
    const auto [acceptable, better] = compare(Criterion::per_component, {10.0 + s, 10.0 + d, 10.0 + f}, ten);
    const bool grows = s > 0 || d > 0 || f > 0;
    const bool shrinks = s < 0 || d < 0 || f < 0;
    EXPECT_EQ(acceptable, !grows) << s << d << f;
    EXPECT_EQ(better, !grows && shrinks) << s << d << f;
  });
}

TEST(Total, AcceptsWhereTheSumDoesNotGrowAndSucceedsWhereItShrinks) {
  for_each_change([](int s, int d, int f) {
    const auto [acceptable, better] = compare(Criterion::total, {10.0 + s, 10.0 + d, 10.0 + f}, ten);
    EXPECT_EQ(acceptable, s + d + f <= 0) << s << d << f;
    EXPECT_EQ(better, s + d + f < 0) << s << d << f;
  });
}

TEST(Metropolis, AcceptsNoGrowthWhateverTheDraw) {
  constexpr double nearly_one = 1 - 0x1p-53;
  EXPECT_TRUE(metropolis_accepts(0, 1, nearly_one));
  EXPECT_TRUE(metropolis_accepts(-3, 1, nearly_one));
  EXPECT_TRUE(metropolis_accepts(0, 0, nearly_one));
}

TEST(Metropolis, AcceptsGrowthWhereBoltzmannsFactorExceedsTheDraw) {
  EXPECT_TRUE(metropolis_accepts(1, 1, 0.36));  // e⁻¹ = 0.3678…
  EXPECT_FALSE(metropolis_accepts(1, 1, 0.37));
  EXPECT_TRUE(metropolis_accepts(10, 10, 0.36));
  EXPECT_FALSE(metropolis_accepts(10, 10, 0.37));
  EXPECT_TRUE(metropolis_accepts(700, 1, 0));
}

TEST(Metropolis, ATemperatureOfZeroAcceptsNoGrowth) {
  EXPECT_FALSE(metropolis_accepts(1e-9, 0, 0));
}

TEST(Metropolis, AcceptsTheShareThatEquation36Says) {
  const random::Stream stream(7);
  int accepted = 0;
  constexpr std::uint32_t draws = 100'000;
  for (std::uint32_t cycle = 0; cycle < draws; ++cycle) {
    const auto words = stream.block(cycle, random::Purpose::acceptance, 0);
    accepted += metropolis_accepts(1.5, 2, random::unit_interval(words[0], words[1]));
  }
  const double share = std::exp(-0.75);
  // Four standard errors of a share of 100,000.
  EXPECT_NEAR(accepted / static_cast<double>(draws), share, 4 * std::sqrt(share * (1 - share) / draws));
}

}  // namespace
}  // namespace lamprey::science::evolution
