#pragma once

#include "experiment/outcome.hpp"
#include "science/evolution/trainer.hpp"
#include "science/saving/archive.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace lamprey::experiment {

/// Fitness as it is stored: with its weighted total.
Score scored(const science::fitness::Fitness& fitness, const science::fitness::Weights& weights);

/// Turns what a trainer reports into an outcome. A value.
class OutcomeRecorder {
 public:
  /// `details`: also how far the genes moved, and on-line and off-line performance.
  explicit OutcomeRecorder(bool details) : details_(details) {}

  /// After the first try, which is of no cycle.
  void begin(const science::evolution::Training& training, const science::fitness::Fitness& first,
             std::span<const double> genes);

  /// The environment is another for the next cycle and all after it: scores no longer compare with those before, so
  /// `expected`, `evolved` and `highest` start anew. `retried` is the last accepted state's fitness in it.
  void change_environment(const science::evolution::Training& training, const science::fitness::Fitness& retried);

  /// One step's reports, in order; `genes` as they are after it.
  void record(const science::evolution::Training& training, std::span<const science::evolution::CycleReport> reports,
              std::span<const double> genes);

  /// Once, at the end: rates, and the trainer's own measures among the others.
  void finish(std::span<const science::evolution::Measure> measures);

  /// Everything that decides what follows, unless the training or the trace gives it; not once it has finished.
  void save(const science::evolution::Training& training, science::saving::Writer& writer) const;

  /// Instead of begin(): goes on where a recorder of the same job was saved after `cycles` cycles with that trace.
  /// `changes`: how often the environment has changed. Throws saving::Invalid for what cannot be its state.
  void restore(const science::evolution::Training& training, std::uint32_t cycles, std::uint32_t changes,
               std::vector<AcceptedChange> trace, science::saving::Reader& reader);

  std::uint32_t cycles() const { return outcome_.cycles; }
  const Outcome& outcome() const { return outcome_; }
  Outcome take() && { return std::move(outcome_); }

 private:
  /// What happened since the latest change of the environment.
  struct Recovery {
    std::uint32_t first_cycle = 0;
    bool pending = false;
  };

  /// Of a recorder that is read or, const, written.
  template <typename Archive, typename Recorder>
  static void fields(Archive& archive, const science::evolution::Training& training, Recorder& recorder);

  void record_one(const science::evolution::Training& training, const science::evolution::CycleReport& report);
  void accept(const science::evolution::Training& training, const science::fitness::Fitness& fitness,
              const Score& score);
  void start_anew(const science::evolution::Training& training, const science::fitness::Fitness& fitness);
  void note_recovery(const Score& score);
  void note_variation(std::span<const double> genes);
  void add_measure(std::string_view name, std::uint32_t index, double value);

  bool details_;
  Outcome outcome_;
  double evolved_error_ = 0;  ///< distance of `evolved` from `expected`: summed weighted error
  std::uint32_t changes_ = 0;
  Recovery recovery_;
  std::vector<double> first_genes_;
  double sum_of_totals_ = 0;
  double sum_of_best_totals_ = 0;
  double best_total_ = 0;
};

}  // namespace lamprey::experiment
