#pragma once

#include "coordinator/ledger.hpp"
#include "coordinator/reuse_scan.hpp"
#include "experiment/job_ranges.hpp"
#include "experiment/sweep.hpp"
#include "messaging/samples.hpp"
#include "storage/results_store.hpp"

#include <chrono>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace lamprey::coordinator {

/// How fast a sweep's jobs end, over the last ten seconds.
class EndRate {
 public:
  using Clock = std::chrono::steady_clock;
  void note(Clock::time_point now, std::uint64_t ended);
  double per_second() const;

 private:
  std::deque<std::pair<Clock::time_point, std::uint64_t>> history_;
};

/// A sweep that has not ended, as the coordinator holds it in memory.
struct OpenSweep {
  storage::Sweep stored;  ///< counters as of the last commit
  std::shared_ptr<const experiment::SweepGrid> grid;
  idl::Execution execution;
  std::optional<ReuseScan> reuse;   ///< while it is looked for outcomes that exist
  experiment::JobRanges to_cancel;  ///< jobs that still need their `cancelled` row
  EndRate rate;
};

/// What a result must fulfil to be stored: it belongs to this sweep and science version, has the job's identity, finite
/// values, a trace that fits its counters, well-formed measures and the digest that it claims. Returns the row, or why
/// it is refused.
struct Judgement {
  std::optional<storage::EndedJob> row;
  std::string refusal;
};
Judgement judge(const OpenSweep& sweep, const messaging::Origin& origin, const messaging::JobResult& result);

/// What a robot recorded in the attempt whose end the result is, checked; or why it is not kept. `sweep`: its key in
/// the database. `accepted`: the job's row is this result's.
struct JudgedRecording {
  std::optional<storage::RecordedAttempt> attempt;
  std::string refusal;
};
JudgedRecording judge_recording(const experiment::Job& job, std::int64_t sweep, const messaging::Origin& origin,
                                const messaging::JobResult& result, bool accepted);

/// How the sweep's jobs are to be given out.
SweepPolicy policy_of(const idl::Execution& execution, const experiment::SweepGrid& grid);

/// Why the checkpoint is not one of a job of the sweep; empty if it is.
std::string checkpoint_fault(const OpenSweep& sweep, const messaging::Checkpoint& checkpoint);

/// The row of a job that was given up.
storage::EndedJob quarantined_row(const OpenSweep& sweep, std::uint64_t job, std::uint32_t attempts,
                                  std::uint64_t worker, const std::string& reason);

}  // namespace lamprey::coordinator
