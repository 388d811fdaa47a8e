#pragma once

#include "science/evolution/trainers/off_line.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace lamprey::science::evolution::trainers {

struct ChapterSixGaSettings {
  double mutation_rate = 75;  ///< percent of the genes, 0..100; 6.2.2.4 has 25, 50, 75 and 100, 6.2.2.5 eighths
  FirstGenes first_genes{};
};

/// The genetic algorithm of chapter 6 (6.2.2.4, fig. 6.22), exactly. A population of 40 is evaluated and sorted from
/// the fittest to the least fit. Each member of the bottom half is replaced by a random one of the top half. Adjacent
/// pairs of the bottom half exchange their genes from a random point on. Then, in each member of the bottom half,
/// `mutation_rate` % of the genes (operators::mutated_count, as many as the same author's II-RTEA mutates), chosen
/// without replacement, are drawn anew within their bounds. The top half goes on undisturbed.
///
/// Each generation evaluates every member, as the thesis does, though the top half is known; begin() tries member 0
/// alone, which is no cycle, and the first generation tries it again. So generation k (0-based) is cycles 40k … 40k+39,
/// and the thesis's 100 generations are 4000 cycles.
///
/// Randomness of generation g ≥ 1: replacement of place k by word k of block (g, selection, 0); the point of pair p by
/// block (g, crossover, p); which genes of place k by block (g, mutation_choice, k), their values by (g, mutation, k).
class ChapterSixGa final : public OffLine {
 public:
  static constexpr std::uint32_t population = 40;

  /// Throws std::invalid_argument for a rate out of its range.
  explicit ChapterSixGa(ChapterSixGaSettings settings);

  std::unique_ptr<Trainer> clone() const override { return std::make_unique<ChapterSixGa>(*this); }

 private:
  void found(std::vector<Member> first) override;
  std::vector<std::vector<double>> breed(const Training& training, std::uint32_t generation) override;
  void survive(const Training& training, std::uint32_t generation, std::vector<Member> members) override;
  void save_population(const Training& training, std::uint32_t generation, saving::Writer& writer) const override;
  void restore_population(const Training& training, std::uint32_t generation, saving::Reader& reader) override;

  double mutation_rate_;
  std::vector<Member> members_;  ///< of the generation before; none before the first
};

}  // namespace lamprey::science::evolution::trainers
