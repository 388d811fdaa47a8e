#include "science/maths/normal_deviate.hpp"

#include "tests/science/maths/exact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace lamprey::science::maths {
namespace {

struct Pin {
  std::uint32_t radius_word;
  std::uint32_t angle_word;
  double first;
  double second;
};

TEST(NormalDeviates, HaveTheirPinnedBits) {
  for (const auto& pin : std::vector<Pin>{{0x00000000, 0x00000001, 0x1.4eca4243b6557p-27, 0x1.aa4499161cd47p+2},
                                          {0x12345678, 0x9abcdef0, -0x1.672701d9e13a3p+0, -0x1.d25e6f370f08fp+0},
                                          {0x80000000, 0x20000000, 0x1.aa449913b5daep-1, 0x1.aa449913b5dbp-1},
                                          {0xfffffffe, 0xdeadbeef, -0x1.082a7b82e7494p-16, 0x1.ef21335712deap-17},
                                          {0xffffffff, 0x40000000, 0x0p+0, 0x0p+0},
                                          {0x00ffffff, 0xc0000001, -0x1.aa4499161cd47p+1, 0x1.4eca4243b6557p-28},
                                          {0x6627e8d5, 0xe169c58d, -0x1.d96d5ff0aec98p-1, 0x1.fb7665db1b649p-1}}) {
    const auto [first, second] = normal_deviates(pin.radius_word, pin.angle_word);
    EXPECT_EQ(first, pin.first) << pin.radius_word;
    EXPECT_EQ(second, pin.second) << pin.radius_word;
  }
}

TEST(NormalDeviates, AreWithinFourUnitsInTheLastPlace) {
  std::mt19937_64 generator(4);
  std::uniform_int_distribution<std::uint32_t> word;
  double largest = 0;
  for (int i = 0; i < 60'000; ++i) {
    // Every fourth radius is one of the smallest, where the logarithm is near 0.
    const std::uint32_t radius_word = i % 4 == 0 ? 0xfffffffe - word(generator) % 4096 : word(generator) - 1;
    const std::uint32_t angle_word = word(generator) | 1;
    Exact radius((static_cast<double>(radius_word) + 1) * 0x1p-32);
    if (radius_word == 0xffffffff) continue;  // a radius of 0 has no relative error
    mpfr_log(radius.get(), radius.get(), MPFR_RNDN);
    mpfr_mul_si(radius.get(), radius.get(), -2, MPFR_RNDN);
    mpfr_sqrt(radius.get(), radius.get(), MPFR_RNDN);
    Exact first;
    Exact second;
    exact_sine_and_cosine_of_turn(angle_word * 0x1p-32, first, second);
    mpfr_mul(first.get(), first.get(), radius.get(), MPFR_RNDN);
    mpfr_mul(second.get(), second.get(), radius.get(), MPFR_RNDN);
    const auto computed = normal_deviates(radius_word, angle_word);
    largest = std::max({largest, error_in_ulp(computed.first, first), error_in_ulp(computed.second, second)});
  }
  EXPECT_LT(largest, 4.0);
}

TEST(NormalDeviates, HaveTheMomentsOfTheNormalDistribution) {
  std::mt19937 generator(5);
  constexpr int pairs = 200'000;
  std::array<double, 5> moments{};
  double product = 0;
  int beyond_two = 0;
  for (int i = 0; i < pairs; ++i) {
    const auto radius_word = static_cast<std::uint32_t>(generator());
    const auto angle_word = static_cast<std::uint32_t>(generator());
    const auto [first, second] = normal_deviates(radius_word, angle_word);
    product += first * second;
    for (const double z : {first, second}) {
      double power = 1;
      for (auto& moment : moments) {
        moment += power;
        power *= z;
      }
      beyond_two += std::fabs(z) > 2;
    }
  }
  // Tolerances are four standard errors: the variance of z^k is 1, 2, 15, 96 for k = 1..4 and n is 400,000.
  const double count = moments[0];
  EXPECT_NEAR(moments[1] / count, 0, 4 * std::sqrt(1 / count));
  EXPECT_NEAR(moments[2] / count, 1, 4 * std::sqrt(2 / count));
  EXPECT_NEAR(moments[3] / count, 0, 4 * std::sqrt(15 / count));
  EXPECT_NEAR(moments[4] / count, 3, 4 * std::sqrt(96 / count));
  EXPECT_NEAR(product / pairs, 0, 4 * std::sqrt(1.0 / pairs));
  EXPECT_NEAR(beyond_two / count, 0.0455003, 4 * std::sqrt(0.0455 * 0.9545 / count));
}

TEST(NormalDeviates, NeverExceedTheLargestRadius) {
  const double largest = std::sqrt(64 * std::log(2.0));
  for (std::uint32_t quarter = 0; quarter < 4; ++quarter) {
    const auto [first, second] = normal_deviates(0, quarter << 30);
    EXPECT_NEAR(std::max(std::fabs(first), std::fabs(second)), largest, 1e-14);
    EXPECT_EQ(std::min(std::fabs(first), std::fabs(second)), 0);
  }
}

}  // namespace
}  // namespace lamprey::science::maths
