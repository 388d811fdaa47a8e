// Who gets which jobs next, and how many.
#include "coordinator/ledger.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lamprey::coordinator {

namespace {

std::vector<messaging::JobRange> to_messages(const JobRanges& jobs) {
  std::vector<messaging::JobRange> ranges;
  for (const auto& range : jobs.ranges()) ranges.push_back({range.first, range.count});
  return ranges;
}

}  // namespace

std::uint32_t Ledger::window(const Worker& worker) const {
  return std::min(worker.status.window, options_.maximum_window);
}

std::uint64_t Ledger::slots() const {
  std::uint64_t slots = 0;
  for (const auto& [id, worker] : workers_) {
    if (!worker.refused) slots += window(worker);
  }
  return std::max<std::uint64_t>(slots, 1);
}

/// About lease_work of computation; towards the end less, so that all workers finish together.
std::uint64_t Ledger::lease_jobs(const Sweep& sweep) const {
  if (!sweep.seconds_per_job) return 1;
  const double work = std::chrono::duration<double>(options_.lease_work).count();
  const double jobs =
      std::clamp(work / std::max(*sweep.seconds_per_job, 1e-9), 1.0, static_cast<double>(options_.maximum_lease_jobs));
  const std::uint64_t fair_share = sweep.pending.size() / (2 * slots()) + 1;
  return std::min(static_cast<std::uint64_t>(std::llround(jobs)), fair_share);
}

bool Ledger::may_take(const Worker& worker) const {
  return !worker.refused && !worker.exclusive && worker.status.state == messaging::WorkerState::ready;
}

bool Ledger::serves(const Worker& worker, const Id128& sweep, Clock::time_point now) {
  const auto pause = worker.not_before.find(sweep);
  return pause == worker.not_before.end() || now >= pause->second;
}

std::vector<Ledger::Grant> Ledger::grant(Clock::time_point now) {
  std::vector<Grant> grants;
  if (now < grants_from_) return grants;
  // One lease to each worker in turn, until every window is full or nothing is pending.
  bool more = true;
  for (std::size_t round = 1; more; ++round) {
    more = false;
    for (auto& [id, worker] : workers_) {
      if (!may_take(worker) || worker.leases.size() >= window(worker)) continue;
      more = worker.leases.size() >= round || grant_pending(id, worker, grants, now) || more;
    }
  }
  // Parts of lost leases wait until nothing is pending in any sweep: a job that kills workers must not stop the others.
  for (auto& [id, worker] : workers_) {
    while (may_take(worker) && worker.leases.size() < window(worker) && grant_suspects(id, worker, grants, now)) {
    }
  }
  return grants;
}

bool Ledger::grant_pending(std::uint64_t id, Worker& worker, std::vector<Grant>& grants, Clock::time_point now) {
  for (const auto& sweep_id : order_) {
    Sweep& sweep = sweeps_.at(sweep_id);
    if (sweep.pending.empty() || !serves(worker, sweep_id, now)) continue;
    give(id, worker, sweep_id, sweep.pending.take_lowest(lease_jobs(sweep)), false, grants, now);
    return true;
  }
  return false;
}

bool Ledger::grant_suspects(std::uint64_t id, Worker& worker, std::vector<Grant>& grants, Clock::time_point now) {
  for (const auto& sweep_id : order_) {
    Sweep& sweep = sweeps_.at(sweep_id);
    if (!serves(worker, sweep_id, now)) continue;
    const auto part = std::ranges::find_if(
        sweep.suspects, [&](const JobRanges& jobs) { return jobs.size() > 1 || worker.leases.empty(); });
    if (part == sweep.suspects.end()) continue;
    JobRanges jobs = std::move(*part);
    sweep.suspects.erase(part);
    const bool exclusive = jobs.size() == 1;
    give(id, worker, sweep_id, std::move(jobs), exclusive, grants, now);
    return true;
  }
  return false;
}

void Ledger::give(std::uint64_t id, Worker& worker, const Id128& sweep, JobRanges jobs, bool exclusive,
                  std::vector<Grant>& grants, Clock::time_point now) {
  Lease lease;
  lease.worker = id;
  lease.sweep = sweep;
  lease.remaining = std::move(jobs);
  lease.sequence = worker.next_sequence++;
  lease.exclusive = exclusive;
  lease.renewed = now;
  lease.sent = now;
  sweeps_.at(sweep).leased.add(lease.remaining);
  worker.exclusive = exclusive;
  const std::uint64_t number = next_lease_++;
  grants.push_back({id, grant_message(number, lease)});
  worker.leases.insert(number);
  leases_.emplace(number, std::move(lease));
}

messaging::Lease Ledger::grant_message(std::uint64_t id, const Lease& lease) const {
  messaging::Lease message;
  message.kind = messaging::LeaseKind::grant;
  message.lease = id;
  message.sequence = lease.sequence;
  message.sweep = lease.sweep;
  message.ranges = to_messages(lease.remaining);
  message.duration_milliseconds = static_cast<std::uint32_t>(
      std::chrono::duration_cast<std::chrono::milliseconds>(options_.lease_duration).count());
  return message;
}

}  // namespace lamprey::coordinator
