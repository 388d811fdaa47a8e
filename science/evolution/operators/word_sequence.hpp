#pragma once

#include "science/maths/normal_deviate.hpp"
#include "science/random/stream.hpp"

#include <cstdint>

namespace lamprey::science::evolution::operators {

/// The random words of one address, by number: word n is word n % 4 of its part n / 4. What a number gives depends on
/// the address and the number only, never on what was asked for before. A value, used by one thread at a time.
class WordSequence {
 public:
  WordSequence(const random::Stream& stream, std::uint32_t cycle, random::Purpose purpose, std::uint32_t index)
      : stream_(stream), cycle_(cycle), purpose_(purpose), index_(index), words_(block(0)) {}

  std::uint32_t word(std::uint32_t n) { return part(n / 4)[n % 4]; }

  /// Uniform in [0, 1), of words 2n and 2n + 1.
  double unit(std::uint32_t n) { return random::unit_interval(word(2 * n), word(2 * n + 1)); }

  /// Of mean 0 and standard deviation 1 (eqs 3.8, 3.9): Z1 and Z2 of words 0 and 1, Z1 and Z2 of words 2 and 3, …
  double normal(std::uint32_t n) {
    const std::uint32_t pair = n - n % 2;
    const auto deviates = maths::normal_deviates(word(pair), word(pair + 1));
    return n % 2 == 0 ? deviates.first : deviates.second;
  }

 private:
  random::Words block(std::uint32_t number) const { return stream_.block(cycle_, purpose_, index_, number); }
  const random::Words& part(std::uint32_t number) {
    if (number != part_) {
      words_ = block(number);
      part_ = number;
    }
    return words_;
  }

  random::Stream stream_;
  std::uint32_t cycle_;
  random::Purpose purpose_;
  std::uint32_t index_;
  std::uint32_t part_ = 0;
  random::Words words_;
};

}  // namespace lamprey::science::evolution::operators
