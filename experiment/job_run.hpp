#pragma once

#include "experiment/batch_engine.hpp"
#include "experiment/job.hpp"
#include "experiment/outcome.hpp"
#include "science/evolution/disturbance.hpp"
#include "science/evolution/rtea.hpp"
#include "science/fitness/quadruped_trial.hpp"
#include "science/random/stream.hpp"

#include <cstdint>
#include <stop_token>
#include <variant>

namespace lamprey::experiment {

/// A job's parameters in the science's own types: the registry's names end here.
struct JobSettings {
  science::fitness::QuadrupedTrial trial;
  science::networks::FourMotherNetwork gait;  ///< undisturbed
  science::evolution::Disturbance disturbance;
  science::evolution::Rtea rtea;
  std::uint32_t cycles = 0;
};

/// Throws std::invalid_argument, naming parameter and value, for a choice that this program has no model of.
JobSettings job_settings(const Parameters& parameters);

/// A job between two cycles: with its settings and its stream it decides all that follows, so a job that goes on from a
/// copy of it ends with the same outcome.
struct JobState {
  science::evolution::RteaState<science::fitness::QuadrupedTrial> rtea;
  science::fitness::Fitness expected;  ///< what `target` aims at
  double evolved_error = 0;            ///< distance of `outcome.evolved` from `expected`: summed weighted error
  Outcome outcome;                     ///< of the cycles done; its success rate only when finished
};

/// Disturbs the gait and tries it once.
JobState begin_job(const JobSettings& settings, const science::random::Stream& stream);

/// Does the next `cycles` cycles, or as many as are left.
void advance_job(const JobSettings& settings, const science::random::Stream& stream, JobState& state,
                 std::uint32_t cycles);

/// Runs a job from its beginning to its end. A requested stop ends it between two cycles, within less than a
/// millisecond at a hundred time steps. Throws as job_settings does. Any thread.
std::variant<Outcome, Interrupted> run_job(const Job& job, const std::stop_token& stop);

/// One evaluation of the undisturbed gait from standing; its total is weighted by the required components.
Score evaluate_preset(const Parameters& parameters);

}  // namespace lamprey::experiment
