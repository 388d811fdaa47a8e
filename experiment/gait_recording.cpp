#include "experiment/gait_recording.hpp"

#include "experiment/job_run.hpp"
#include "experiment/models.hpp"

namespace lamprey::experiment {

science::robots::Recording record_gait(const Parameters& parameters, std::int32_t time_steps) {
  const auto problem = make_problem(parameters);
  if (problem->preset().empty()) return record_job({.seed = 1, .parameters = parameters}, time_steps);
  return problem->record(problem->preset(), environment(parameters), time_steps);
}

science::robots::Recording record_job(const Job& job, std::int32_t time_steps) {
  JobRun run(job);
  while (!run.finished()) run.advance();
  return run.problem().record(run.genes(), environment(job.parameters), time_steps);
}

}  // namespace lamprey::experiment
