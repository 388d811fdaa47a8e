#pragma once

#include "experiment/batch_engine.hpp"
#include "experiment/job.hpp"
#include "experiment/outcome.hpp"
#include "experiment/outcome_recorder.hpp"
#include "science/evolution/problem.hpp"
#include "science/evolution/trainer.hpp"
#include "science/robots/machine.hpp"
#include "science/robots/recording.hpp"

#include <cstdint>
#include <memory>
#include <stop_token>
#include <variant>
#include <vector>

namespace lamprey::experiment {

/// The environment that a job's parameters describe, before any change.
science::fitness::Environment environment(const Parameters& parameters);

/// Where a run is, as far as its job does not tell.
struct RunState {
  std::uint32_t cycle = 0;             ///< the number of cycles done
  std::vector<std::uint8_t> trainer;   ///< octets of science/saving
  std::vector<std::uint8_t> recorder;  ///< likewise
  std::vector<AcceptedChange> trace;   ///< so far
};

/// So few that a requested stop is met soon, however large a population or a schedule is.
inline constexpr std::uint32_t most_cycles_per_step = 1024;

/// A job between two steps of its trainer. A value: a copy goes on to the same outcome.
class JobRun {
 public:
  /// Makes the problem and the trainer and tries the first genes. Throws std::invalid_argument, naming parameter and
  /// value, for a choice that this program has no model of.
  /// A job on a robot runs on `machine`, which outlives it; there must be one then.
  explicit JobRun(const Job& job, science::robots::Machine* machine = nullptr);

  /// Goes on where a run of the same job was saved. Throws science::saving::Invalid, saying why, for what cannot be the
  /// state of such a run; besides, as the other does.
  JobRun(const Job& job, RunState state);

  JobRun(const JobRun& other);
  JobRun(JobRun&&) = default;
  JobRun& operator=(const JobRun&) = delete;
  JobRun& operator=(JobRun&&) = delete;
  ~JobRun() = default;

  bool finished() const { return recorder_.cycles() == cycles_; }

  /// Does the trainer's next step, or ends it where the cycles or the environment do.
  /// At most `most_cycles` of it, which must be at least 1.
  void advance(std::uint32_t most_cycles = most_cycles_per_step);

  /// Of the cycles done; complete only when finished.
  const Outcome& outcome() const { return recorder_.outcome(); }
  Outcome take() && { return std::move(recorder_).take(); }

  /// Not if it is finished, its trainer can't be saved or it is on a robot, which can't be put where it was.
  bool can_be_saved() const { return !finished() && trainer_->can_be_saved() && !on_a_robot_; }
  /// Of a run that can be saved.
  RunState save() const;

  /// Of the last accepted state.
  std::span<const double> genes() const { return trainer_->genes(); }
  const science::evolution::Problem& problem() const { return *problem_; }

 private:
  struct Change {
    std::uint32_t cycle = 0;
    science::fitness::Environment environment;
  };

  /// Made, and not begun.
  struct NotBegun {};
  JobRun(const Job& job, science::robots::Machine* machine, NotBegun);

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
  bool on_a_robot_ = false;
  std::vector<science::evolution::CycleReport> reports_;  ///< kept for its memory only
};

/// Runs a job from its beginning to its end. A requested stop ends it between two steps of its trainer, 1024
/// evaluations at most. Throws as JobRun does. Any thread.
std::variant<Outcome, Interrupted> run_job(const Job& job, const std::stop_token& stop);

/// One evaluation of the undisturbed gait from standing, or what is expected where a network has no preset; its total
/// is weighted by the required components.
Score evaluate_preset(const Parameters& parameters);

}  // namespace lamprey::experiment
