#pragma once

#include "science/evolution/operators/crossover.hpp"
#include "science/evolution/operators/selection.hpp"
#include "science/evolution/trainers/off_line.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace lamprey::science::evolution::trainers {

struct GeneticAlgorithmSettings {
  std::uint32_t population = 40;
  operators::Selection selection = operators::Selection::truncation;
  std::uint32_t tournament_size = 2;  ///< of the tournament: 1..population
  operators::Crossover crossover = operators::Crossover::one_point;
  double blend_alpha = 0.5;   ///< of blx_alpha, 0..2
  double mutation_rate = 20;  ///< percent, 0..100: the chance of each gene of a child; usually 1..20 (3.3.2.7)
  FirstGenes first_genes{};
};

/// The continuous-parameter genetic algorithm (3.3.2, fig. 3.5): pairs of parents are selected, mate, and their
/// children mutate; the children and the fittest member so far are the next generation. The fittest is not tried again,
/// so a generation costs population − 1 evaluations, the first one too. Of an odd number of children the last pair's
/// second is not born. Both parents may be the same member.
///
/// Randomness of generation g ≥ 1: parents of pair p by blocks (g, selection, 2p) and (g, selection, 2p + 1), their
/// crossover by (g, crossover, p), mutation of child c by (g, mutation, c).
class GeneticAlgorithm final : public OffLine {
 public:
  /// Throws std::invalid_argument for settings out of their range.
  explicit GeneticAlgorithm(GeneticAlgorithmSettings settings);

  std::unique_ptr<Trainer> clone() const override { return std::make_unique<GeneticAlgorithm>(*this); }

 private:
  void found(std::vector<Member> first) override;
  std::vector<std::vector<double>> breed(const Training& training, std::uint32_t generation) override;
  void survive(const Training& training, std::uint32_t generation, std::vector<Member> children) override;
  void save_population(const Training& training, std::uint32_t generation, saving::Writer& writer) const override;
  void restore_population(const Training& training, std::uint32_t generation, saving::Reader& reader) override;
  operators::Children children(const Training& training, std::uint32_t generation, std::uint32_t pair) const;

  GeneticAlgorithmSettings settings_;
  std::vector<Member> members_;         ///< in order
  std::vector<std::uint32_t> by_rank_;  ///< positions of members, the fittest first
};

}  // namespace lamprey::science::evolution::trainers
