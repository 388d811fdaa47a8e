#pragma once

#include "experiment/batch_engine.hpp"
#include "experiment/job.hpp"
#include "experiment/outcome.hpp"
#include "experiment/outcome_recorder.hpp"
#include "science/evolution/problem.hpp"
#include "science/evolution/trainer.hpp"
#include "science/robots/recording.hpp"

#include <cstdint>
#include <memory>
#include <stop_token>
#include <variant>
#include <vector>

namespace lamprey::experiment {

/// The environment that a job's parameters describe, before any change.
science::fitness::Environment environment(const Parameters& parameters);

/// A job between two steps of its trainer. A value: a copy goes on to the same outcome.
class JobRun {
 public:
  /// Makes the problem and the trainer and tries the first genes. Throws std::invalid_argument, naming parameter and
  /// value, for a choice that this program has no model of.
  explicit JobRun(const Job& job);
  JobRun(const JobRun& other);
  JobRun(JobRun&&) = default;
  JobRun& operator=(const JobRun&) = delete;
  JobRun& operator=(JobRun&&) = delete;
  ~JobRun() = default;

  bool finished() const { return recorder_.cycles() == cycles_; }

  /// Does the trainer's next step, or ends it where the cycles or the environment do.
  void advance();

  /// Of the cycles done; complete only when finished.
  const Outcome& outcome() const { return recorder_.outcome(); }
  Outcome take() && { return std::move(recorder_).take(); }

  /// Of the last accepted state.
  std::span<const double> genes() const { return trainer_->genes(); }
  const science::evolution::Problem& problem() const { return *problem_; }

 private:
  struct Change {
    std::uint32_t cycle = 0;
    science::fitness::Environment environment;
  };

  void meet(const science::fitness::Environment& environment);
  /// The cycle at which the present environment ends.
  std::uint32_t end_of_environment() const;
  void finish_if_done();

  std::shared_ptr<const science::evolution::Problem> problem_;  ///< immutable, shared by copies
  science::evolution::Training training_;
  std::unique_ptr<science::evolution::Trainer> trainer_;
  OutcomeRecorder recorder_;
  std::vector<Change> changes_;
  std::size_t changes_met_ = 0;
  std::uint32_t cycles_ = 0;
  std::vector<science::evolution::CycleReport> reports_;  ///< kept for its memory only
};

/// Runs a job from its beginning to its end. A requested stop ends it between two steps of its trainer, 1024
/// evaluations at most. Throws as JobRun does. Any thread.
std::variant<Outcome, Interrupted> run_job(const Job& job, const std::stop_token& stop);

/// One evaluation of the undisturbed gait from standing, or what is expected where a network has no preset; its total
/// is weighted by the required components.
Score evaluate_preset(const Parameters& parameters);

}  // namespace lamprey::experiment
