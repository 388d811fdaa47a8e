#pragma once

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

/// A sweep that is running or being cancelled, as the coordinator holds it in memory.
struct OpenSweep {
  storage::Sweep stored;  ///< counters as of the last commit
  std::shared_ptr<const experiment::SweepGrid> grid;
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

/// The row of a job that was given up.
storage::EndedJob quarantined_row(const OpenSweep& sweep, std::uint64_t job, std::uint32_t attempts,
                                  std::uint64_t worker, const std::string& reason);

}  // namespace lamprey::coordinator
