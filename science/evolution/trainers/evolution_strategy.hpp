#pragma once

#include "science/evolution/operators/word_sequence.hpp"
#include "science/evolution/step_size.hpp"
#include "science/evolution/trainers/off_line.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace lamprey::science::evolution::trainers {

/// Of standard deviations of steps, in step units of genes.
inline constexpr double largest_step = 1000;

/// Standard deviations of normal steps, in step units of genes; 0 < smallest ≤ first ≤ largest ≤ largest_step.
struct StepSizes {
  double first = 5;
  double smallest = 0.3;
  double largest = 10;
};

/// Throws std::invalid_argument for sizes that are not in that order.
void require_ordered(const StepSizes& steps);

/// A member's child by self-adaptation (3.6.1): its own standard deviation adapts first, by the deviate after those of
/// the genes, and is held within the sizes; then every gene steps by it. Changes both.
void mutate_adapted(const GenePlan& plan, const StepSizes& sizes, operators::WordSequence& words,
                    std::vector<double>& genes, double& standard_deviation);

/// 3.6.1, numbers 1 to 4.
enum class Strategy : std::uint8_t { one_plus_one, mu_plus_one, mu_plus_lambda, mu_comma_lambda };

struct EvolutionStrategySettings {
  Strategy strategy = Strategy::one_plus_one;
  std::uint32_t population = 40;  ///< μ; not of one_plus_one
  std::uint32_t offspring = 80;   ///< λ ≥ 1, under mu_comma_lambda at least μ; not of one_plus_one and mu_plus_one
  StepSizes steps{};
  std::uint32_t success_window = 20;  ///< of one_plus_one's 1/5 rule, at least 1
  double step_factor = 0.85;          ///< of the rule, in 0.01..1
  FirstGenes first_genes{};
};

/// Evolution strategies (3.6): all genes of each child step by normal deviates of mean 0 (eqs 3.8, 3.9).
/// - (1+1): the child of the one parent replaces it if it is better; Rechenberg's 1/5 rule sets the step size.
/// - the others: each child recombines two different parents, any of which are as likely: each gene from either, the
///   standard deviation their mean; it steps by its own, self-adapted standard deviation. (μ+1) and (μ+λ) keep the best
///   μ of parents and children, (μ,λ) the best μ of the children. A parent wins a tie.
///
/// Randomness of generation g ≥ 1: parents of child c by block (g, selection, c), recombination by (g, crossover, c),
/// steps by (g, mutation, c).
class EvolutionStrategy final : public OffLine {
 public:
  /// Throws std::invalid_argument for settings out of their range.
  explicit EvolutionStrategy(EvolutionStrategySettings settings);

  std::unique_ptr<Trainer> clone() const override { return std::make_unique<EvolutionStrategy>(*this); }

 private:
  struct Adapted {
    Member member;
    double standard_deviation = 0;
  };
  static void member_fields(auto& archive, const GenePlan& plan, saving::Of<Adapted> auto& adapted) {
    fields(archive, plan, adapted.member);
    saving::real_within(archive, "standard_deviation", adapted.standard_deviation, 0, largest_step);
  }

  void found(std::vector<Member> first) override;
  std::vector<std::vector<double>> breed(const Training& training, std::uint32_t generation) override;
  void survive(const Training& training, std::uint32_t generation, std::vector<Member> children) override;
  void save_population(const Training& training, std::uint32_t generation, saving::Writer& writer) const override;
  void restore_population(const Training& training, std::uint32_t generation, saving::Reader& reader) override;
  std::vector<double> child(const Training& training, std::uint32_t generation, std::uint32_t number);

  EvolutionStrategySettings settings_;
  OneFifthRule rule_;
  OneFifthState rule_state_;
  std::vector<Adapted> parents_;             ///< the fittest first
  std::vector<double> children_deviations_;  ///< of the generation under way
};

}  // namespace lamprey::science::evolution::trainers
