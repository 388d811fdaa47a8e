#pragma once

#include "science/random/stream.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace lamprey::science::evolution {

/// Genes that are mutated together from one block of random words: four, as a child neuron has times.
using Unit = std::array<double, 4>;

/// What a trainer knows of what it tunes: bounds, and which units belong together. Neurons are not its business.
struct GenePlan {
  double minimum = 0;  ///< of every gene
  double maximum = 0;
  std::span<const std::array<std::uint8_t, 4>> symmetric_units{};  ///< sets that mutate-some chooses from (4.2.2)
};

/// 4.2.2: every unit, one at random, or one symmetric set at random.
enum class MutationTechnique : std::uint8_t { all, one, some };

/// 4.2.3: whole steps uniform in ±size, or normal deviates of mean 0.
struct StepDistribution {
  enum class Kind : std::uint8_t { uniform, normal } kind = Kind::uniform;
  int size = 0;                   ///< uniform
  double standard_deviation = 0;  ///< normal
};

/// Adds a step to every gene of the chosen units and holds the genes within their bounds. Block (cycle, mutation, i)
/// belongs to unit i whichever technique chose it. Uniform: gene g takes word g. Normal: genes 0 and 1 take Z1 and Z2
/// of words 0 and 1 (eqs 3.8, 3.9), genes 2 and 3 those of words 2 and 3. The choice takes word 0 of block (cycle,
/// mutation_choice, 0).
void mutate(const random::Stream& stream, std::uint32_t cycle, MutationTechnique technique,
            const StepDistribution& distribution, const GenePlan& plan, std::span<Unit> units);

}  // namespace lamprey::science::evolution
