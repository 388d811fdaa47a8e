#pragma once

#include "science/evolution/acceptance.hpp"
#include "science/evolution/mutation.hpp"
#include "science/evolution/objective.hpp"
#include "science/evolution/step_size.hpp"
#include "science/evolution/trainer.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace lamprey::science::evolution {

// The real-time evolutionary algorithm of chapter 4 (fig. 4.1): a population of one, no recombination; mutate, run,
// compare, accept or restore; for ever.

/// 4.2.3 and 4.2.4: what steps are drawn from.
enum class Steps : std::uint8_t { uniform, normal, one_fifth_rule };

/// Between evaluations: stand up and begin anew, or walk on as a physical robot must (appendix C sets it up once).
/// Under `carry` the robot's posture, the mothers' clocks and pending windows live on, also through rejected
/// candidates; the parent is not tried again, and a pending window meets its new times at once.
enum class Posture : std::uint8_t { reset, carry };

struct RteaSettings {
  MutationTechnique mutation = MutationTechnique::all;
  Steps steps = Steps::uniform;
  int size = 5;                                         ///< uniform: steps in ±size; normal: standard deviation size/2
  StepVariance step_variance = StepVariance::constant;  ///< of normal steps under `target`; else not used
  OneFifthRule one_fifth_rule{};
  Criterion criterion = Criterion::per_component;
  Acceptance acceptance = Acceptance::simple;
  double temperature = 1;  ///< of the first cycle, ≥ 0
  double cooling = 1;      ///< the temperature is multiplied by it after each cycle; 1 keeps it
  Posture posture = Posture::reset;
};

/// Everything that the algorithm carries from one cycle to the next: with the settings and the stream it decides all
/// that follows.
struct RteaState {
  std::uint32_t cycle = 0;    ///< the number of cycles done, and the next one's number
  std::vector<double> genes;  ///< last accepted
  fitness::Fitness fitness;   ///< of the last accepted, when it was tried
  Body body;                  ///< where the last evaluation ended, accepted or not
  OneFifthState one_fifth;
  double temperature = 0;
};

/// What the next cycle's steps are drawn from; `last_accepted` are the errors of the last accepted state.
StepDistribution step_distribution(const RteaSettings& settings, Objective objective, const OneFifthState& one_fifth,
                                   const Errors& last_accepted);

class Rtea final : public Trainer {
 public:
  Rtea(const RteaSettings& settings, std::vector<double> first_genes);

  fitness::Fitness begin(const Training& training) override;
  /// One cycle.
  void advance(const Training& training, std::uint32_t budget, std::vector<CycleReport>& reports) override;
  std::span<const double> genes() const override { return state_.genes; }
  fitness::Fitness meet(const Training& training) override;
  bool can_be_saved() const override { return true; }
  void save(const Training& training, saving::Writer& writer) const override;
  void restore(const Training& training, std::uint32_t cycles, saving::Reader& reader) override;
  std::unique_ptr<Trainer> clone() const override { return std::make_unique<Rtea>(*this); }

  const RteaState& state() const { return state_; }

 private:
  bool annealing_accepts(const Training& training, double error_change) const;

  RteaSettings settings_;
  RteaState state_;
  std::vector<double> candidate_;  ///< kept for its memory only
};

}  // namespace lamprey::science::evolution
