#pragma once

#include "science/evolution/trainers/off_line.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace lamprey::experiment::yardsticks {

/// pagmo2's simple genetic algorithm with its own defaults: tournament of two, exponential crossover, polynomial
/// mutation, the best of parents and children live on.
struct PagmoSgaSettings {
  std::uint32_t population = 40;  ///< at least 4
  science::evolution::trainers::FirstGenes first_genes{};
};

/// pagmo2's simulated annealing (A. Corana et al., 1987) with its own temperatures, 10 to 0.1 in ten levels, and step
/// sizes that adapt. pagmo2 must know a schedule's length beforehand.
struct PagmoSimulatedAnnealingSettings {
  /// What the schedule is fitted to, at least 1: it takes the most evaluations that a whole number of rounds over the
  /// genes at each temperature can, not more than 10,000 of them. Afterwards it begins again, from the best so far.
  std::uint32_t planned_evaluations = 1000;
  science::evolution::trainers::FirstGenes first_genes{};
};

/// pagmo2's CMA-ES (N. Hansen, 2006) with its own defaults: it begins at the fittest of a first population, with half
/// of each gene's range as standard deviation, learns on from generation to generation and never leaves the bounds.
struct PagmoCmaesSettings {
  std::uint32_t population = 40;  ///< at least 5
  science::evolution::trainers::FirstGenes first_genes{};
};

/// An optimiser from outside, the pagmo2 library (F. Biscani and D. Izzo, A parallel global multiobjective framework
/// for optimization: pagmo, 2020), as a yardstick: it minimises the same cost from the same kind of first population,
/// and every evaluation that it asks for is a cycle. Its seed is word 0 of block (0, outside, 0).
///
/// Repeatable by the same build on the same kind of machine only: pagmo2 uses the distributions of the standard library
/// and the elementary functions of the C library.
///
/// A generation, or a schedule of annealing, that a budget cuts short goes on with the next advance: it is run again on
/// the costs that are known and stops where they end, so reports never depend on how evaluations were portioned. Where
/// there are many evaluations, larger budgets save time.
class PagmoTrainer final : public science::evolution::Trainer {
 public:
  /// These throw std::invalid_argument for settings out of their range.
  explicit PagmoTrainer(PagmoSgaSettings settings);
  explicit PagmoTrainer(PagmoSimulatedAnnealingSettings settings);
  explicit PagmoTrainer(PagmoCmaesSettings settings);
  PagmoTrainer(const PagmoTrainer& other);
  ~PagmoTrainer() override;

  science::fitness::Fitness begin(const science::evolution::Training& training) override;
  void advance(const science::evolution::Training& training, std::uint32_t budget,
               std::vector<science::evolution::CycleReport>& reports) override;
  /// The best so far.
  std::span<const double> genes() const override;
  std::unique_ptr<Trainer> clone() const override { return std::make_unique<PagmoTrainer>(*this); }

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lamprey::experiment::yardsticks
