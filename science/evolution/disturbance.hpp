#pragma once

#include "science/evolution/gene_plan.hpp"
#include "science/evolution/problem.hpp"
#include "science/random/stream.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace lamprey::science::evolution {

/// How a gait is taken out of equilibrium before it evolves (8.2.1, 8.2.2).
struct Disturbance {
  int size = 0;              ///< each gene of a disturbed unit changes by a whole number in ±size, times its step unit
  std::int64_t percent = 0;  ///< 0..100: the share of each kind of units that is disturbed, fractions dropped (8.2.2)
};

/// Disturbs `genes` and holds them within their bounds. Of each kind, units are chosen without replacement by a partial
/// Fisher–Yates shuffle: draw i swaps place i with place i + bounded(word, left), by word i mod 4 of block
/// (member, disturbance_selection, kind, i / 4). Gene g of unit u moves by word g mod 4 of block
/// (member, disturbance, u, g / 4).
void disturb(const random::Stream& stream, std::uint32_t member, const Disturbance& disturbance, const GenePlan& plan,
             std::span<double> genes);

/// The genes that a trainer begins with, or `member` of its first population: the preset, disturbed; without a preset,
/// each gene drawn within its bounds (6.2.2.4, 6.2.2.7; operators/uniform_mutation.hpp).
std::vector<double> initial_genes(const Problem& problem, const Disturbance& disturbance, const random::Stream& stream,
                                  std::uint32_t member);

}  // namespace lamprey::science::evolution
