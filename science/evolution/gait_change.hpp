#pragma once

#include "science/evolution/mutation.hpp"
#include "science/evolution/trainer.hpp"
#include "science/networks/tonic.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace lamprey::science::evolution {

// Changing gaits (9.3, 9.4; figs 9.5, 9.6): the RTEA mutates the input tonic of the network of fig. 9.1 until the tonic
// is another gait's row of the table, and goes on from there. A mutated tonic is kept, whatever it does. It is a
// failure unless it is a row, and not that of the gait of before.

struct GaitChangeState {
  std::uint32_t cycle = 0;  ///< the number of cycles done, and the next one's number
  std::vector<double> genes;
  networks::TonicGait gait = networks::TonicGait::walk;  ///< the last one reached; at first the preset's
  std::uint32_t changes = 0;
  std::uint32_t failures = 0;  ///< since the last change
  std::vector<Measure> measures;
};

/// Tunes a problem of the network `tonic`, preset to a gait of 9.3's table. Every candidate is tried from standing.
class GaitChange final : public Trainer {
 public:
  /// Throws std::invalid_argument for mutate-some: 9.4 has mutate-all and mutate-one.
  explicit GaitChange(MutationTechnique mutation);

  /// Throws std::invalid_argument for a problem that isn't the tonic network's.
  fitness::Fitness begin(const Training& training) override;

  /// One cycle. The chosen mothers' genes are redrawn, which may leave them as they were: an input is −1 or +1, each
  /// with a chance of a half; a weight, where weights evolve, is uniform within its bounds. Block (cycle, mutation,
  /// mother) has the words: 0 for the input; 1 and 2 for the weight. The choice takes word 0 of block (cycle,
  /// mutation_choice, 0). Every report is accepted; one that changed the gait is a success.
  void advance(const Training& training, std::uint32_t budget, std::vector<CycleReport>& reports) override;

  std::span<const double> genes() const override { return state_.genes; }
  fitness::Fitness meet(const Training& training) override;

  /// For each change of gait: gait_change_failures before it and gait_reached, by networks::TonicGait; then
  /// failures_after_last_change.
  std::vector<Measure> measures() const override;

  bool can_be_saved() const override { return true; }
  void save(const Training& training, saving::Writer& writer) const override;
  void restore(const Training& training, std::uint32_t cycles, saving::Reader& reader) override;
  std::unique_ptr<Trainer> clone() const override { return std::make_unique<GaitChange>(*this); }

  const GaitChangeState& state() const { return state_; }

 private:
  /// The preset's genes and gait; throws as begin() does.
  void start(const Problem& problem);
  void note_change(networks::TonicGait gait, std::uint32_t failures);

  MutationTechnique mutation_;
  GaitChangeState state_;
};

}  // namespace lamprey::science::evolution
