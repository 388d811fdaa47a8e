#pragma once

#include "science/evolution/trainers/off_line.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace lamprey::science::evolution::trainers {

struct SimulatedAnnealingSettings {
  double first_step = 5;                    ///< standard deviation of a step, in step units; more than 0, at most 1000
  double first_temperature = 100;           ///< ≥ 0
  double temperature_factor = 0.99;         ///< in 0..1: what the temperature is multiplied by
  std::uint32_t tries_per_temperature = 1;  ///< at least 1: how often the system is re-configured at each (3.4.3)
  FirstGenes first_genes{};
};

/// Simulated annealing (3.4): one string of genes, begun anywhere. Each try displaces one gene, an atom of the system
/// (3.4.2), by a small normal deviate (3.4.3, eq. 3.7), and moves there if ΔE ≤ 0 or exp(−ΔE/T) > r (eq. 3.6, k_B = 1;
/// evolution::metropolis_accepts). The temperature falls geometrically. Off-line: its report calls accepted what is the
/// best so far, not where it has moved to.
///
/// Randomness of try t ≥ 1: the gene by block (t, mutation_choice, 0), the deviate by (t, mutation, 0), r by
/// (t, acceptance, 0).
class SimulatedAnnealing final : public OffLine {
 public:
  /// Throws std::invalid_argument for settings out of their range.
  explicit SimulatedAnnealing(SimulatedAnnealingSettings settings);

  std::unique_ptr<Trainer> clone() const override { return std::make_unique<SimulatedAnnealing>(*this); }

 private:
  void found(std::vector<Member> first) override;
  std::vector<std::vector<double>> breed(const Training& training, std::uint32_t generation) override;
  void survive(const Training& training, std::uint32_t generation, std::vector<Member> tried) override;
  void save_population(const Training& training, std::uint32_t generation, saving::Writer& writer) const override;
  void restore_population(const Training& training, std::uint32_t generation, saving::Reader& reader) override;

  SimulatedAnnealingSettings settings_;
  Member state_;
  double temperature_;
};

}  // namespace lamprey::science::evolution::trainers
