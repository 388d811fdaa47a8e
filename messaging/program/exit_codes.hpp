#pragma once

/// What every program of ours ends with; part of the command line's contract.
namespace lamprey::messaging::program {

enum ExitCode : int {
  exit_ok = 0,
  exit_failure = 1,        ///< an error within the program
  exit_usage = 2,          ///< a bad command line, environment or sweep file; nothing was done
  exit_unreachable = 3,    ///< no coordinator, no DDS, or no answer in time
  exit_jobs_failed = 4,    ///< the sweep ended, but some of its jobs failed or are quarantined
  exit_mismatch = 5,       ///< verify or replay found other bits than are stored
  exit_storage = 6,        ///< the database can't be opened, read or written
  exit_interrupted = 130,  ///< by SIGINT or SIGTERM, before the work was done
};

}  // namespace lamprey::messaging::program
