#pragma once

#include "coordinator/journal.hpp"
#include "messaging/samples.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace lamprey::coordinator {

/// What the coordinator counts while it lives; all start at 0 with it.
struct Counters {
  std::uint64_t workers_joined = 0;
  std::uint64_t workers_left = 0;
  std::uint64_t workers_lost = 0;
  std::uint64_t workers_refused = 0;
  std::uint64_t statuses_refused = 0;  ///< of nobody, or from a worker that is not what it says
  std::uint64_t leases_granted = 0;
  std::uint64_t leases_repeated = 0;
  std::uint64_t leases_adopted = 0;
  std::uint64_t leases_revoked = 0;
  std::uint64_t leases_lost = 0;
  std::uint64_t results_committed = 0;
  std::uint64_t results_duplicate = 0;
  std::uint64_t results_divergent = 0;
  std::uint64_t results_ignored = 0;                     ///< of another database
  std::map<std::string, std::uint64_t> results_refused;  ///< by reason
  std::uint64_t outcomes_reused = 0;
  std::uint64_t jobs_quarantined = 0;
  std::uint64_t jobs_retried = 0;
  std::uint64_t checkpoints_stored = 0;
  std::uint64_t checkpoints_refused = 0;
  std::uint64_t jobs_audited = 0;
  std::map<std::string, std::uint64_t> requests;  ///< by kind; "malformed" among them
};

/// What else there is to see at this moment.
struct Gauges {
  std::uint64_t epoch = 0;
  std::uint64_t malformed_samples = 0;
  std::uint64_t log_bytes = 0;
  std::size_t leases = 0;
  struct Sweep {
    std::string name;
    std::string state;
    std::uint64_t pending = 0;
    std::uint64_t leased = 0;
    storage::JobCounts counts;
    std::uint64_t divergences = 0;
  };
  std::vector<Sweep> sweeps;                           ///< that have not ended
  std::map<std::string, std::uint64_t> workers;        ///< by state
  std::map<std::string, std::uint64_t> worker_totals;  ///< sums of what the present workers count
};

/// The page in the Prometheus text format 0.0.4.
std::string metrics_page(const Counters& counters, const Journal& journal, const Gauges& gauges);

}  // namespace lamprey::coordinator
