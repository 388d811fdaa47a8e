#include "science/maths/elementary.hpp"

#include "tests/science/maths/exact.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <vector>

namespace lamprey::science::maths {
namespace {

// The pinned bits are part of every outcome that used them: a change of any is a new science version.

struct Pin {
  double argument;
  double value;
};

TEST(Logarithm, HasItsPinnedBits) {
  for (const auto& [x, value] : std::vector<Pin>{{0x1p-32, -0x1.62e42fefa39efp+4},
                                                 {0x1.8p-20, -0x1.aea3a9f52cba9p+3},
                                                 {0x1.999999999999ap-4, -0x1.26bb1bbb55515p+1},
                                                 {0x1p-1, -0x1.62e42fefa39efp-1},
                                                 {0x1.6666666666666p-1, -0x1.6d3c324e13f5p-2},
                                                 {0x1.8p-1, -0x1.269621134db92p-2},
                                                 {0x1.ffffde7210be9p-1, -0x1.0c6f82d74d23p-20},
                                                 {0x1p+0, 0x0p+0},
                                                 {0x1p+1, 0x1.62e42fefa39efp-1},
                                                 {0x1.4p+3, 0x1.26bb1bbb55516p+1},
                                                 {0x1.7e43c8800759cp+996, 0x1.5963447f87fb5p+9}}) {
    EXPECT_EQ(logarithm(x), value) << std::hexfloat << x;
  }
  EXPECT_FALSE(std::signbit(logarithm(1.0)));
}

TEST(Logarithm, IsWithinOneUnitInTheLastPlace) {
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<double> around_one(0.5, 1.5);
  std::uniform_real_distribution<double> mantissa(1, 2);
  std::uniform_int_distribution<int> exponent(-1022, 1023);
  std::uniform_int_distribution<std::uint32_t> word;
  double largest = 0;
  for (int i = 0; i < 60'000; ++i) {
    const double below_one = (static_cast<double>(word(generator)) + 1) * 0x1p-32;
    for (const double x : {around_one(generator), std::ldexp(mantissa(generator), exponent(generator)), below_one}) {
      Exact exact(x);
      mpfr_log(exact.get(), exact.get(), MPFR_RNDN);
      if (x != 1) largest = std::max(largest, error_in_ulp(logarithm(x), exact));
    }
  }
  EXPECT_LT(largest, 1.0);
}

TEST(Exponential, HasItsPinnedBits) {
  for (const auto& [x, value] : std::vector<Pin>{{-0x1.62p+9, 0x1.7c8ab2288c9acp-1022},
                                                 {-0x1.9p+6, 0x1.a8c1f14e2af5cp-145},
                                                 {-0x1.48p+4, 0x1.57a3afeed00acp-30},
                                                 {-0x1p+0, 0x1.78b56362cef38p-2},
                                                 {-0x1p-1, 0x1.368b2fc6f960ap-1},
                                                 {-0x1.0624dd2f1a9fcp-10, 0x1.ff7cfe56f1a9ep-1},
                                                 {0x0p+0, 0x1p+0},
                                                 {0x1.3333333333333p-2, 0x1.599058c8c1a96p+0},
                                                 {0x1p+0, 0x1.5bf0a8b14576ap+1},
                                                 {0x1.4p+3, 0x1.5829dcf95056p+14},
                                                 {0x1.628p+9, 0x1.d422d2be5dc9bp+1022}}) {
    EXPECT_EQ(exponential(x), value) << std::hexfloat << x;
  }
}

TEST(Exponential, IsWithinOneAndAHalfUnitsInTheLastPlace) {
  std::mt19937_64 generator(2);
  std::uniform_real_distribution<double> anywhere(-708, 709);
  std::uniform_real_distribution<double> annealing(-40, 0);
  std::uniform_real_distribution<double> small(-1, 1);
  double largest = 0;
  for (int i = 0; i < 60'000; ++i) {
    for (const double x : {anywhere(generator), annealing(generator), small(generator)}) {
      Exact exact(x);
      mpfr_exp(exact.get(), exact.get(), MPFR_RNDN);
      largest = std::max(largest, error_in_ulp(exponential(x), exact));
    }
  }
  EXPECT_LT(largest, 1.5);
}

TEST(Exponential, BeyondItsRangeIsZeroOrInfinity) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(exponential(-708.0000001), 0.0);
  EXPECT_EQ(exponential(-1e300), 0.0);
  EXPECT_EQ(exponential(-infinity), 0.0);
  EXPECT_EQ(exponential(709.0000001), infinity);
  EXPECT_EQ(exponential(infinity), infinity);
}

struct TurnPin {
  double turn;
  double sine;
  double cosine;
};

TEST(SineAndCosineOfTurn, HaveTheirPinnedBits) {
  for (const auto& pin : std::vector<TurnPin>{{0x1.eb851eb851eb8p-6, 0x1.7fc1c65037a78p-3, 0x1.f6ee5ac2509ffp-1},
                                              {0x1.999999999999ap-4, 0x1.2cf2304755a5ep-1, 0x1.9e3779b97f4a8p-1},
                                              {0x1p-3, 0x1.6a09e667f3bccp-1, 0x1.6a09e667f3bcdp-1},
                                              {0x1.3333333333333p-2, 0x1.e6f0e134455p-1, -0x1.3c6ef372fe94ep-2},
                                              {0x1.199999999999ap-1, -0x1.3c6ef372fe954p-2, -0x1.e6f0e134454ffp-1},
                                              {0x1.3333333333333p-1, -0x1.2cf2304755a5dp-1, -0x1.9e3779b97f4a8p-1},
                                              {0x1.999999999999ap-1, -0x1.e6f0e134454ffp-1, 0x1.3c6ef372fe954p-2},
                                              {0x1.fae147ae147aep-1, -0x1.0130a1be0937dp-4, 0x1.fefd5bfe443fep-1}}) {
    const auto [sine, cosine] = sine_and_cosine_of_turn(pin.turn);
    EXPECT_EQ(sine, pin.sine) << std::hexfloat << pin.turn;
    EXPECT_EQ(cosine, pin.cosine) << std::hexfloat << pin.turn;
  }
}

TEST(SineAndCosineOfTurn, AreExactAndPositiveZeroAtWholeQuarters) {
  const std::vector<TurnPin> quarters{{0, 0, 1}, {0.25, 1, 0}, {0.5, 0, -1}, {0.75, -1, 0}, {1, 0, 1}};
  for (const auto& pin : quarters) {
    const auto [sine, cosine] = sine_and_cosine_of_turn(pin.turn);
    EXPECT_EQ(sine, pin.sine) << pin.turn;
    EXPECT_EQ(cosine, pin.cosine) << pin.turn;
    if (pin.sine == 0) {
      EXPECT_FALSE(std::signbit(sine)) << pin.turn;
    }
    if (pin.cosine == 0) {
      EXPECT_FALSE(std::signbit(cosine)) << pin.turn;
    }
  }
}

TEST(SineAndCosineOfTurn, AreWithinTwoUnitsInTheLastPlace) {
  std::mt19937_64 generator(3);
  std::uniform_real_distribution<double> anywhere(0, 1);
  std::uniform_int_distribution<int> quarter(1, 3);
  std::uniform_int_distribution<int> nearness(-50, -3);
  double largest = 0;
  for (int i = 0; i < 60'000; ++i) {
    const double near_quarter = 0.25 * quarter(generator) + std::ldexp(anywhere(generator) - 0.5, nearness(generator));
    for (const double u : {anywhere(generator), near_quarter}) {
      if (u * 4 == std::floor(u * 4)) continue;
      Exact sine;
      Exact cosine;
      exact_sine_and_cosine_of_turn(u, sine, cosine);
      const auto computed = sine_and_cosine_of_turn(u);
      largest = std::max({largest, error_in_ulp(computed.sine, sine), error_in_ulp(computed.cosine, cosine)});
    }
  }
  EXPECT_LT(largest, 2.0);
}

}  // namespace
}  // namespace lamprey::science::maths
