#include "science/evolution/operators/uniform_mutation.hpp"

#include "science/evolution/operators/choice.hpp"

#include <cmath>

namespace lamprey::science::evolution::operators {

double drawn(const Gene& gene, std::uint32_t word) {
  const double range = gene.maximum - gene.minimum;
  if (gene.whole) return gene.minimum + random::bounded(word, static_cast<std::uint32_t>(range) + 1);
  return held(gene, gene.minimum + range * (static_cast<double>(word) * 0x1p-32));
}

std::vector<double> draw_genes(const random::Stream& stream, std::uint32_t member, const GenePlan& plan) {
  std::vector<double> genes(plan.genes.size());
  random::Words words{};
  for (std::uint32_t gene = 0; gene < genes.size(); ++gene) {
    if (gene % 4 == 0) words = stream.block(member, random::Purpose::initial_genes, gene / 4);
    genes[gene] = drawn(plan.genes[gene], words[gene % 4]);
  }
  return genes;
}

std::uint32_t mutated_count(std::size_t genes, double percent) {
  const double share = static_cast<double>(genes) * percent / 100;
  return static_cast<std::uint32_t>(std::ceil(share - 0.5));
}

void redraw_some(const GenePlan& plan, std::uint32_t count, WordSequence& choice, WordSequence& values,
                 std::span<double> genes) {
  for (const std::uint32_t gene : choose_distinct(choice, count, static_cast<std::uint32_t>(genes.size()))) {
    genes[gene] = drawn(plan.genes[gene], values.word(gene));
  }
}

void redraw_each(const GenePlan& plan, double percent, WordSequence& words, std::span<double> genes) {
  const double probability = percent / 100;
  for (std::uint32_t gene = 0; gene < genes.size(); ++gene) {
    if (static_cast<double>(words.word(2 * gene)) * 0x1p-32 >= probability) continue;
    genes[gene] = drawn(plan.genes[gene], words.word(2 * gene + 1));
  }
}

}  // namespace lamprey::science::evolution::operators
