#pragma once

#include "science/saving/archive.hpp"

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace lamprey::science::evolution {

/// One number that a trainer tunes. Trainers know nothing of neurons: bounds and scale are all they see.
struct Gene {
  double minimum = 0;
  double maximum = 0;
  /// What a step of 1 adds. Operators draw steps on the scale of times, whose largest is 10 time steps (8.2.1): a time
  /// has 1, any other gene a tenth of its range.
  double step_unit = 1;
  /// Drawn anew, it is a whole number (6.2.2.4: times of 1 to 10 steps). Steps may make it fractional; models round
  /// times down.
  bool whole = false;

  bool operator==(const Gene&) const = default;
};

/// What belongs together in a vector of genes. All lists hold positions.
struct GenePlan {
  std::vector<Gene> genes;
  /// Genes that mutate together: those of a neuron. Each gene is in exactly one unit.
  std::vector<std::vector<std::uint32_t>> units;
  /// Sets of units that mutate-some chooses from (4.2.2); may be empty.
  std::vector<std::vector<std::uint32_t>> symmetric_units;
  /// Kinds of units of which an equal share is disturbed (8.2.2): vertical and horizontal ones. At least one kind.
  std::vector<std::vector<std::uint32_t>> kinds;
};

/// As many genes as the plan has, each within its bounds.
void fields(auto& archive, const GenePlan& plan, saving::Of<std::vector<double>> auto& genes) {
  if constexpr (!std::is_const_v<std::remove_reference_t<decltype(genes)>>) genes.resize(plan.genes.size());
  for (std::size_t i = 0; i < genes.size(); ++i) {
    saving::real_within(archive, "gene", genes[i], plan.genes[i].minimum, plan.genes[i].maximum);
  }
}

/// `value` within the gene's bounds.
inline double held(const Gene& gene, double value) {
  const double not_below = value < gene.minimum ? gene.minimum : value;
  return not_below > gene.maximum ? gene.maximum : not_below;
}

}  // namespace lamprey::science::evolution
