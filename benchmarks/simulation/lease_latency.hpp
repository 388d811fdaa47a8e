#pragma once

#include "messaging/samples.hpp"
#include "worker/job_executor.hpp"

#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <vector>

namespace lamprey::benchmarks {

/// How long a worker waits for the next lease in the place of one whose last result it has written: until the result
/// is taken, stored, and the new lease written. Fed with every result and lease on their way. Not thread-safe.
class LeaseLatency {
 public:
  using Time = std::chrono::steady_clock::time_point;

  void note(const messaging::ResultBatch& batch, Time now);
  void note(const messaging::Lease& lease, Time now);

  /// In milliseconds, in no order.
  const std::vector<double>& measured() const { return measured_; }

 private:
  std::map<std::uint64_t, std::uint64_t> jobs_left_;        ///< by lease
  std::map<std::uint64_t, std::deque<Time>> places_since_;  ///< by worker
  std::vector<double> measured_;
};

}  // namespace lamprey::benchmarks
