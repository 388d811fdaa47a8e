#pragma once

#include "client/exit_code.hpp"
#include "client/json.hpp"
#include "client/output/console.hpp"
#include "idl/client.pb.h"

#include <string>
#include <vector>

/// How what a coordinator tells looks to people and to programs. Free functions.
namespace lamprey::client::views {

/// Name, id, state, counts, divergences, and everything else that a status says of a sweep.
Json sweep_json(const idl::SweepStatus& sweep, int workers);

/// A table of sweeps; rare columns (quarantined, priority, reused …) only where one of them has something to say, and
/// under a sweep why it was stopped and how many of its results diverge. `details`: also how it is run.
void print_sweeps(const output::Console& console, const std::vector<const idl::SweepStatus*>& sweeps, bool details);

/// The same with bars, for a screen that is rewritten: at most `most` of them, those that go on before those that have
/// ended.
void print_sweep_bars(const output::Console& console, std::vector<const idl::SweepStatus*> sweeps, std::size_t most);

/// How it is run beside its priority and tags, as far as that is not the default: "at most 64 jobs at once, 5 attempts,
/// needs gpu=1".
std::string execution_text(const idl::Execution& execution);

/// What must not be overlooked, on `err`: that nothing can be stored.
void print_alarms(const output::Console& console, const idl::StatusReply& status);

/// Those that a status shows: archived ones only if they are asked for, all together or by name.
std::vector<const idl::SweepStatus*> shown_sweeps(const idl::StatusReply& status, bool archived_too);

/// exit_mismatch if results of one of them diverge from what is stored, else exit_ok.
ExitCode divergent_or_ok(const std::vector<const idl::SweepStatus*>& sweeps);

}  // namespace lamprey::client::views
