#pragma once

#include <array>
#include <cstdint>

namespace lamprey::science::random {

/// What a block of random words is for. The values are part of every outcome: never renumber, only add.
enum class Purpose : std::uint32_t {
  disturbance_selection = 1,  ///< which children are disturbed; index: 0 vertical, 1 horizontal
  disturbance = 2,            ///< by how much; index: child
  mutation_choice = 3,        ///< which children are mutated; index 0
  mutation = 4,               ///< by how much; index: child
  acceptance = 5,             ///< annealing's r; index 0
  initial_genes = 6,          ///< genes drawn within their bounds; cycle: member of the population, index: gene / 4
  selection = 7,              ///< who survives or mates; cycle: generation, index: the trainer's
  crossover = 8,              ///< where and how parents mix; cycle: generation, index: pair or child
  outside = 9,  ///< index 0: the seed of an optimiser from outside; index 1: the key of a hybrid's second trainer
};

using Words = std::array<std::uint32_t, 4>;

/// One job's random numbers, addressed, not drawn: a block depends on the key and its address only, never on what was
/// asked for before. Philox4x32-10 (J. K. Salmon et al., Parallel random numbers: as easy as 1, 2, 3, SC 2011): key
/// words are the low and the high half of the key, counter words are {cycle, purpose, index, part}. A value; any
/// thread.
class Stream {
 public:
  explicit Stream(std::uint64_t key) : key_(key) {}

  /// `part` numbers the blocks of one address that needs more than four words.
  Words block(std::uint32_t cycle, Purpose purpose, std::uint32_t index, std::uint32_t part = 0) const;

  std::uint64_t key() const { return key_; }

 private:
  std::uint64_t key_;
};

/// A whole number in 0..count−1 by multiply and shift, for count ≥ 1. No probability is off from 1/count by more than
/// 2⁻³²: far below what any number of experiments could see, and it costs one word always.
constexpr std::uint32_t bounded(std::uint32_t word, std::uint32_t count) {
  return static_cast<std::uint32_t>(std::uint64_t{word} * count >> 32);
}

/// A whole number in −size..size, for size ≥ 0, with the same small bias.
constexpr int symmetric(std::uint32_t word, int size) {
  return static_cast<int>(bounded(word, 2 * static_cast<std::uint32_t>(size) + 1)) - size;
}

/// A multiple of 2⁻⁵³ in [0, 1), uniform.
constexpr double unit_interval(std::uint32_t high, std::uint32_t low) {
  const std::uint64_t bits = (std::uint64_t{high} << 32 | low) >> 11;
  return static_cast<double>(bits) * 0x1p-53;
}

}  // namespace lamprey::science::random
