#include "benchmarks/simulation/lease_latency.hpp"

namespace lamprey::benchmarks {

void LeaseLatency::note(const messaging::ResultBatch& batch, Time now) {
  for (const auto& result : batch.results) {
    const auto left = jobs_left_.find(result.lease);
    if (result.fragment + 1 < result.fragments || left == jobs_left_.end() || --left->second > 0) continue;
    jobs_left_.erase(left);
    places_since_[batch.origin.worker].push_back(now);
  }
}

void LeaseLatency::note(const messaging::Lease& lease, Time now) {
  if (lease.kind != messaging::LeaseKind::grant) return;
  std::uint64_t jobs = 0;
  for (const auto& range : lease.ranges) jobs += range.count;
  if (!jobs_left_.emplace(lease.lease, jobs).second) return;  // sent again
  auto& since = places_since_[lease.origin.worker];
  if (since.empty()) return;
  measured_.push_back(std::chrono::duration<double, std::milli>(now - since.front()).count());
  since.pop_front();
}

}  // namespace lamprey::benchmarks
