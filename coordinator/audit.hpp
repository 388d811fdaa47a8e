#pragma once

#include "coordinator/ledger.hpp"
#include "experiment/sweep.hpp"
#include "storage/results_store.hpp"

#include <cstdint>
#include <map>
#include <memory>

namespace lamprey::coordinator {

/// Whether an audit of that share and seed takes the job. A function of these alone, so that an audit goes on after a
/// restart. `share`: above 0, up to 1.
bool is_in_audit(double share, std::uint64_t seed, std::uint64_t job);

/// Names the audit: of the same sweep, share and seed there is one.
Id128 audit_id(const Id128& sweep, double share, std::uint64_t seed);

/// The done, bitwise repeatable jobs of the sweep that the audit takes.
JobRanges audit_sample(const experiment::SweepGrid& grid, const JobRanges& done, double share, std::uint64_t seed);

/// An audit that is running.
struct OpenAudit {
  storage::Audit stored;  ///< counts as staged
  storage::Sweep sweep;
  std::shared_ptr<const experiment::SweepGrid> grid;
};

/// Those jobs by the worker that has computed them.
std::map<std::uint64_t, JobRanges> by_author(const storage::ResultsStore& store, std::int64_t sweep,
                                             const JobRanges& jobs);

}  // namespace lamprey::coordinator
