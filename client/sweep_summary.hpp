#pragma once

#include "client/exit_code.hpp"
#include "client/json.hpp"
#include "client/output/console.hpp"
#include "messaging/samples.hpp"

#include <string>

namespace lamprey::client {

/// {"jobs": …, "pending": …, "leased": …, "done": …, "failed": …, "quarantined": …, "cancelled": …}
Json counts_json(const messaging::SweepProgress& progress);

/// Name, id, state, counts and divergences, appended to the document.
void add_sweep(Json& document, const messaging::SweepProgress& progress);

/// "18,432 jobs: 18,430 done, 2 failed".
std::string counts_text(const messaging::SweepProgress& progress);

/// exit_mismatch if a job has been computed twice with different outcomes; else exit_jobs_failed if one ended without
/// an outcome (failed, quarantined, cancelled); else exit_ok.
ExitCode exit_code_of(const messaging::SweepProgress& progress);

}  // namespace lamprey::client
