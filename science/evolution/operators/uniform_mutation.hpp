#pragma once

#include "science/evolution/gene_plan.hpp"
#include "science/evolution/operators/word_sequence.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lamprey::science::evolution::operators {

/// A value of this gene, uniform within its bounds (3.3.2.3, 3.3.2.7), of one word. A whole gene is each whole number
/// within them with the same probability (6.2.2.4); another is minimum + (maximum − minimum)·word/2³². A whole gene's
/// bounds are whole.
double drawn(const Gene& gene, std::uint32_t word);

/// The genes of member `member` of a first population, each drawn within its bounds: gene g by word g % 4 of block
/// (member, initial_genes, g / 4).
std::vector<double> draw_genes(const random::Stream& stream, std::uint32_t member, const GenePlan& plan);

/// How many of `genes` genes are `percent` % of them: ceil(genes·percent/100 − 0.5), so that 0.5 is 0 and 0.75 is 1
/// (6.2.2.7). `percent` in 0..100.
std::uint32_t mutated_count(std::size_t genes, double percent);

/// Draws `count` genes anew, chosen without replacement by `choice` (6.2.2.4); gene g takes word g of `values`.
void redraw_some(const GenePlan& plan, std::uint32_t count, WordSequence& choice, WordSequence& values,
                 std::span<double> genes);

/// Draws each gene anew with a probability of `percent` %: gene g if word 2g/2³² is below it, by word 2g + 1 (3.3.2.7).
void redraw_each(const GenePlan& plan, double percent, WordSequence& words, std::span<double> genes);

}  // namespace lamprey::science::evolution::operators
