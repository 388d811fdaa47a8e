#pragma once

#include "science/evolution/gene_plan.hpp"
#include "science/evolution/operators/word_sequence.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace lamprey::science::evolution::operators {

/// How two parents mix (3.3.2.6). Every gene of a child is held within its bounds.
/// - one_point: all genes from a point on are exchanged (fig. 3.12); the point is any of 1..n−1;
/// - two_point: the genes between two different such points are exchanged; with fewer than three genes, as one_point;
/// - blend: Radcliff's eq. 3.3, β·P_m + (1 − β)·P_f;
/// - michalewicz: β·(P_m − P_f) + P_m, which leaves the parents' bounds on the mother's side. Eq. 3.4 as printed ends
///   in P_f, which is eq. 3.3 again and leaves no bounds, as the text says that it does;
/// - blx_alpha: each gene of each child uniform between the parents' values and `alpha` times their distance beyond
///   (L. J. Eshelman and J. D. Schaffer, Real-coded genetic algorithms and interval-schemata, 1993).
/// β is one number in [0, 1) for all genes, as printed; the second child has 1 − β (3.3.2.6).
enum class Crossover : std::uint8_t { one_point, two_point, blend, michalewicz, blx_alpha };

struct Children {
  std::vector<double> first;   ///< of an exchange: begins as the mother
  std::vector<double> second;  ///< begins as the father
};

/// `mother` is the fitter of the two. `alpha` ≥ 0, of blx_alpha only. Points take words 0 and 1, β the unit number 0,
/// gene g of child c under blx_alpha the unit number 2g + c.
Children cross(Crossover crossover, double alpha, const GenePlan& plan, std::span<const double> mother,
               std::span<const double> father, WordSequence& words);

/// Each gene from either parent with the same probability, gene g by word g: the discrete recombination of evolution
/// strategies (3.6.1; Schwefel, 1981).
std::vector<double> recombine(std::span<const double> mother, std::span<const double> father, WordSequence& words);

}  // namespace lamprey::science::evolution::operators
