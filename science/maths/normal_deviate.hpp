#pragma once

#include "science/maths/elementary.hpp"

#include <cmath>
#include <cstdint>

namespace lamprey::science::maths {

/// Two independent deviates of mean 0 and standard deviation 1.
struct NormalDeviates {
  double first = 0;
  double second = 0;
};

/// Schwefel's formulae, eqs 3.8 and 3.9: Z1 = √(−2 ln U1)·sin 2πU2, Z2 = √(−2 ln U1)·cos 2πU2, with
/// U1 = (radius_word + 1)/2³² in (0, 1] and U2 = angle_word/2³² in [0, 1). |Z| is at most √(64 ln 2) ≈ 6.66, which cuts
/// tails of total probability 2⁻³². Error below 4 ulp. Pure; any thread.
inline NormalDeviates normal_deviates(std::uint32_t radius_word, std::uint32_t angle_word) {
  const double u1 = (static_cast<double>(radius_word) + 1.0) * 0x1p-32;
  const double u2 = static_cast<double>(angle_word) * 0x1p-32;
  // std::sqrt is the IEEE operation, rounded correctly everywhere. 0 − … keeps the radius at U1 = 1 a positive zero.
  const double radius = std::sqrt(0.0 - 2.0 * logarithm(u1));
  const auto [sine, cosine] = sine_and_cosine_of_turn(u2);
  return {radius * sine, radius * cosine};
}

}  // namespace lamprey::science::maths
