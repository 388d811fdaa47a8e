#pragma once

#include "science/evolution/trainers/evolution_strategy.hpp"
#include "science/evolution/trainers/off_line.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace lamprey::science::evolution::trainers {

/// Who lives on: the better half of parents and children, as 3.7 has it, or whoever costs less than the most of some
/// random opponents (D. B. Fogel, Evolving Artificial Intelligence, 1992).
enum class Survival : std::uint8_t { best_half, tournament };

struct EvolutionaryProgrammingSettings {
  std::uint32_t population = 40;
  Survival survival = Survival::best_half;
  std::uint32_t opponents = 10;  ///< of tournament: 1..2·population − 1
  StepSizes steps{};
  FirstGenes first_genes{};
};

/// Evolutionary programming (3.7): each member has one child, by mutation only: every gene takes a normal step of the
/// child's own self-adapted standard deviation. Half of parents and children live on. Under `tournament` each meets
/// `opponents` different others and scores one for each that does not cost less; the highest scores live on, of equal
/// scores the lower cost, of equal costs parents first and then in order.
///
/// Randomness of generation g ≥ 1: steps of child c by block (g, mutation, c); the opponents of member i of parents and
/// children by (g, selection, i).
class EvolutionaryProgramming final : public OffLine {
 public:
  /// Throws std::invalid_argument for settings out of their range.
  explicit EvolutionaryProgramming(EvolutionaryProgrammingSettings settings);

  std::unique_ptr<Trainer> clone() const override { return std::make_unique<EvolutionaryProgramming>(*this); }

 private:
  struct Adapted {
    Member member;
    double standard_deviation = 0;
    std::uint32_t score = 0;
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
  void compete(const random::Stream& stream, std::uint32_t generation);

  EvolutionaryProgrammingSettings settings_;
  std::vector<Adapted> members_;
  std::vector<double> children_deviations_;  ///< of the generation under way
};

}  // namespace lamprey::science::evolution::trainers
