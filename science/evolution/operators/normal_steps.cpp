#include "science/evolution/operators/normal_steps.hpp"

#include "science/maths/elementary.hpp"

#include <cmath>
#include <cstdint>

namespace lamprey::science::evolution::operators {

void add_normal_steps(const GenePlan& plan, double standard_deviation, WordSequence& words, std::span<double> genes) {
  for (std::uint32_t gene = 0; gene < genes.size(); ++gene) {
    const Gene& bounds = plan.genes[gene];
    genes[gene] = held(bounds, genes[gene] + words.normal(gene) * standard_deviation * bounds.step_unit);
  }
}

double adapted_standard_deviation(double standard_deviation, double normal_deviate, std::size_t genes) {
  return standard_deviation * maths::exponential(normal_deviate / std::sqrt(static_cast<double>(genes)));
}

}  // namespace lamprey::science::evolution::operators
