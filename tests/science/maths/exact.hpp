#pragma once

#include <cmath>
#include <mpfr.h>

namespace lamprey::science::maths {

/// A number with 200 bits: for tests exact.
class Exact {
 public:
  Exact() { mpfr_init2(value_, 200); }
  explicit Exact(double value) : Exact() { mpfr_set_d(value_, value, MPFR_RNDN); }
  Exact(const Exact&) = delete;
  Exact& operator=(const Exact&) = delete;
  ~Exact() { mpfr_clear(value_); }

  mpfr_ptr get() { return value_; }

 private:
  mpfr_t value_;
};

/// |computed − exact| in units of the last place of a double as large as `exact`, which is not 0.
inline double error_in_ulp(double computed, Exact& exact) {
  int exponent = 0;
  std::frexp(mpfr_get_d(exact.get(), MPFR_RNDN), &exponent);
  Exact difference;
  mpfr_sub_d(difference.get(), exact.get(), computed, MPFR_RNDN);
  return std::fabs(mpfr_get_d(difference.get(), MPFR_RNDN)) / std::ldexp(1.0, exponent - 53);
}

/// sin 2πu and cos 2πu.
inline void exact_sine_and_cosine_of_turn(double u, Exact& sine, Exact& cosine) {
  Exact angle;
  mpfr_const_pi(angle.get(), MPFR_RNDN);
  mpfr_mul_2ui(angle.get(), angle.get(), 1, MPFR_RNDN);
  mpfr_mul_d(angle.get(), angle.get(), u, MPFR_RNDN);
  mpfr_sin_cos(sine.get(), cosine.get(), angle.get(), MPFR_RNDN);
}

}  // namespace lamprey::science::maths
