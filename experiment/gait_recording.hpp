#pragma once

#include "experiment/job.hpp"
#include "science/robots/recording.hpp"

#include <cstdint>

namespace lamprey::experiment {

/// The undisturbed gait of these parameters from standing, step by step, in their first environment; where a network
/// has no preset, what its trainer makes of seed 1. Throws as JobRun does.
science::robots::Recording record_gait(const Parameters& parameters, std::int32_t time_steps);

/// The last accepted state of the job when it is finished, from standing in its first environment.
science::robots::Recording record_job(const Job& job, std::int32_t time_steps);

}  // namespace lamprey::experiment
