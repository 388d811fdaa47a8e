#pragma once

#include "experiment/job_ranges.hpp"
#include "messaging/samples.hpp"

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace lamprey::worker {

using experiment::Id128;
using experiment::JobRanges;

/// The leases that a worker holds: which of their jobs have not started and which have no terminal answer yet.
/// Not thread-safe.
class LeaseBook {
 public:
  /// A lease is named by its database too: a worker may serve several coordinators.
  using Key = std::pair<Id128, std::uint64_t>;

  /// A granted lease; nothing happens (and false is returned) if it is held or was held before: DDS and the coordinator
  /// both repeat themselves. An unusable one (no jobs, numbers beyond the largest sweep) is ignored as well.
  bool grant(const messaging::Lease& lease);

  /// Jobs that have not started are dropped; true if the lease was held.
  bool revoke(const Key& key);

  /// The sweep can't be computed here: its leases are no longer held, and the coordinator gives them to others.
  void forget_sweep(const Id128& database, const Id128& sweep);

  /// Up to `most` jobs to start now, of sweeps that `can_start` allows, oldest lease first.
  struct Start {
    Key lease;
    Id128 sweep;
    std::uint64_t job = 0;
    double time_limit = 0;                 ///< seconds; 0: any
    std::vector<std::uint8_t> checkpoint;  ///< where it goes on; empty: from its beginning
  };
  template <class CanStart>
  std::vector<Start> start(std::size_t most, CanStart can_start);

  /// The job has its terminal answer (or will never get one, because it was dropped).
  void settled(const Id128& database, const Id128& sweep, std::uint64_t job);

  std::vector<messaging::HeldLease> held() const;
  bool empty() const { return leases_.empty(); }
  std::size_t size() const { return leases_.size(); }
  /// Forgets everything that is held, for the goodbye.
  void clear() { leases_.clear(); }

 private:
  struct Lease {
    std::uint64_t epoch = 0;
    std::uint64_t arrival = 0;  ///< counts up
    Id128 sweep;
    JobRanges remaining;    ///< without a terminal answer
    JobRanges not_started;  ///< part of remaining
    double time_limit = 0;
    std::vector<std::uint8_t> checkpoint;  ///< of a single job
  };
  void remember(const Key& key);
  std::vector<std::map<Key, Lease>::iterator> by_arrival();

  std::map<Key, Lease> leases_;
  std::uint64_t arrivals_ = 0;
  std::set<Key> ended_;  ///< of the last `remembered` leases
  std::deque<Key> ended_order_;
};

template <class CanStart>
std::vector<LeaseBook::Start> LeaseBook::start(std::size_t most, CanStart can_start) {
  std::vector<Start> starts;
  for (const auto& entry : by_arrival()) {
    auto& [key, lease] = *entry;
    if (starts.size() >= most) break;
    if (lease.not_started.empty() || !can_start(key.first, lease.sweep)) continue;
    for (const auto& range : lease.not_started.take_lowest(most - starts.size()).ranges()) {
      for (std::uint64_t job = range.first; job < range.first + range.count; ++job) {
        starts.push_back({key, lease.sweep, job, lease.time_limit, std::exchange(lease.checkpoint, {})});
      }
    }
  }
  return starts;
}

}  // namespace lamprey::worker
