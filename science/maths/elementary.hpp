#pragma once

#include <bit>
#include <cstdint>

namespace lamprey::science::maths {

// Elementary functions whose every bit is ours. A library's differ between versions and processors, so results use
// only these: a fixed sequence of IEEE 754 double + − × ÷ in round-to-nearest, and operations on the bits of an
// exponent. No branch depends on the argument but a selection between two computed values, so that lanes of a vector
// compute the same sequence. The coefficients are those of the Taylor series, rounded once; the number of terms makes
// the truncation less than a tenth of a unit in the last place (ulp). Compile without contraction to FMA and without
// fast-math. All are pure and may be called from any thread.

inline constexpr double log2_e = 0x1.71547652b82fep+0;
/// ln 2 in two parts; the high one ends in 21 zero bits, so that its product with an exponent is exact.
inline constexpr double ln2_high = 0x1.62e42fee00000p-1;
inline constexpr double ln2_low = 0x1.a39ef35793c76p-33;
inline constexpr double two_pi = 0x1.921fb54442d18p+2;
/// Added to a number below 2^51, leaves its nearest whole number in the low bits of the sum.
inline constexpr double rounding_shift = 0x1.8p52;

/// ln x, for a positive normal finite x. Error below 1 ulp; exactly 0 at 1.
///
/// x = 2^k·m with m in [√½, √2); s = (m − 1)/(m + 1); ln m = 2 artanh s = (m − 1) − ((m − 1)²/2 − s·((m − 1)²/2 + R)),
/// R = 2s²/3 + 2s⁴/5 + …: the arrangement of FDLIBM's e_log.c (K. C. Ng, 1993), which keeps the sum's large parts
/// exact.
inline double logarithm(double x) {
  constexpr std::uint64_t root_half = 0x3fe6a09e667f3bcd;
  constexpr std::uint64_t one = 0x3ff0000000000000;
  constexpr std::uint64_t fraction_mask = 0x000fffffffffffff;
  const std::uint64_t shifted = std::bit_cast<std::uint64_t>(x) + (one - root_half);
  const auto exponent = static_cast<double>(static_cast<std::int64_t>(shifted >> 52) - 1023);
  const double m = std::bit_cast<double>((shifted & fraction_mask) + root_half);

  const double f = m - 1.0;
  const double half_square = 0.5 * f * f;
  const double s = f / (2.0 + f);
  const double z = s * s;
  const double w = z * z;
  const double odd = z * (2.0 / 3 + w * (2.0 / 7 + w * (2.0 / 11 + w * (2.0 / 15 + w * (2.0 / 19)))));
  const double even = w * (2.0 / 5 + w * (2.0 / 9 + w * (2.0 / 13 + w * (2.0 / 17))));
  const double r = odd + even;
  return exponent * ln2_high - ((half_square - (s * (half_square + r) + exponent * ln2_low)) - f);
}

/// e^x, for any x but NaN. Error below 1.5 ulp for x in [−708, 709]; below it 0, above it infinity.
///
/// x = k·ln 2 + r with |r| ≤ ln 2 / 2; e^x = 2^k·(1 + r + r²·(1/2! + r/3! + … + r¹¹/13!)).
inline double exponential(double x) {
  constexpr double lowest = -708;
  constexpr double highest = 709;
  const double bounded = x < lowest ? lowest : (x > highest ? highest : x);
  const double shifted = bounded * log2_e + rounding_shift;
  const double k = shifted - rounding_shift;
  const double r = (bounded - k * ln2_high) - k * ln2_low;

  double q = 1.0 / 6227020800.0;
  q = 1.0 / 479001600.0 + r * q;
  q = 1.0 / 39916800.0 + r * q;
  q = 1.0 / 3628800.0 + r * q;
  q = 1.0 / 362880.0 + r * q;
  q = 1.0 / 40320.0 + r * q;
  q = 1.0 / 5040.0 + r * q;
  q = 1.0 / 720.0 + r * q;
  q = 1.0 / 120.0 + r * q;
  q = 1.0 / 24.0 + r * q;
  q = 1.0 / 6.0 + r * q;
  q = 0.5 + r * q;
  const double mantissa = 1.0 + (r + (r * r) * q);

  // The low bits of `shifted` are k; moved to the exponent's place they multiply by 2^k.
  const std::uint64_t scale = (std::bit_cast<std::uint64_t>(shifted) + 1023) << 52;
  const double value = mantissa * std::bit_cast<double>(scale);
  const double not_too_small = x < lowest ? 0.0 : value;
  return x > highest ? std::bit_cast<double>(std::uint64_t{0x7ff0000000000000}) : not_too_small;
}

struct SineAndCosine {
  double sine = 0;
  double cosine = 0;
};

/// sin 2πu and cos 2πu, for u in [0, 1]. Error below 2 ulp of each value; exact at whole quarters of a turn.
///
/// u = q/4 + v with |v| ≤ 1/8 exactly; the series of sine and cosine at θ = 2πv, exchanged and negated by quadrant q.
inline SineAndCosine sine_and_cosine_of_turn(double u) {
  const double shifted = 4.0 * u + rounding_shift;
  const std::uint64_t quadrant = std::bit_cast<std::uint64_t>(shifted);
  const double theta = two_pi * (u - 0.25 * (shifted - rounding_shift));
  const double z = theta * theta;

  double sine = 1.0 / 355687428096000.0;
  sine = -1.0 / 1307674368000.0 + z * sine;
  sine = 1.0 / 6227020800.0 + z * sine;
  sine = -1.0 / 39916800.0 + z * sine;
  sine = 1.0 / 362880.0 + z * sine;
  sine = -1.0 / 5040.0 + z * sine;
  sine = 1.0 / 120.0 + z * sine;
  sine = -1.0 / 6.0 + z * sine;
  sine = theta + theta * (z * sine);

  double cosine = 1.0 / 20922789888000.0;
  cosine = -1.0 / 87178291200.0 + z * cosine;
  cosine = 1.0 / 479001600.0 + z * cosine;
  cosine = -1.0 / 3628800.0 + z * cosine;
  cosine = 1.0 / 40320.0 + z * cosine;
  cosine = -1.0 / 720.0 + z * cosine;
  cosine = 1.0 / 24.0 + z * cosine;
  cosine = 1.0 - (0.5 * z - z * z * cosine);

  const bool exchanged = (quadrant & 1) != 0;
  const double first = exchanged ? cosine : sine;
  const double second = exchanged ? sine : cosine;
  const bool sine_negative = (quadrant & 2) != 0;
  const bool cosine_negative = ((quadrant + 1) & 2) != 0;
  return {sine_negative ? 0.0 - first : first, cosine_negative ? 0.0 - second : second};
}

}  // namespace lamprey::science::maths
