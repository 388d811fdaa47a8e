#pragma once

#include "science/evolution/gene_plan.hpp"
#include "science/random/stream.hpp"

#include <cstdint>
#include <span>

namespace lamprey::science::evolution {

/// 4.2.2: every unit, one at random, or one symmetric set at random.
enum class MutationTechnique : std::uint8_t { all, one, some };

/// 4.2.3: whole steps uniform in ±size, or normal deviates of mean 0.
struct StepDistribution {
  enum class Kind : std::uint8_t { uniform, normal } kind = Kind::uniform;
  int size = 0;                   ///< uniform
  double standard_deviation = 0;  ///< normal
};

/// Adds a step, times its step unit, to every gene of the chosen units and holds the genes within their bounds. Block
/// (cycle, mutation, i, part) belongs to genes 4·part … 4·part + 3 of unit i, whichever technique chose it. Uniform: a
/// gene takes the word of its place. Normal: the first two genes take Z1 and Z2 of words 0 and 1 (eqs 3.8, 3.9), the
/// other two those of words 2 and 3. The choice takes word 0 of block (cycle, mutation_choice, 0). `some` needs a plan
/// with symmetric units.
void mutate(const random::Stream& stream, std::uint32_t cycle, MutationTechnique technique,
            const StepDistribution& distribution, const GenePlan& plan, std::span<double> genes);

}  // namespace lamprey::science::evolution
