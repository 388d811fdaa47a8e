// Who gets which jobs next, and how many.
#include "coordinator/ledger.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <limits>
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

/// About lease_work of computation; towards the end less, so that all workers finish together.
std::uint64_t Ledger::lease_jobs(const Sweep& sweep) const {
  if (!sweep.seconds_per_job) return 1;
  const double work = std::chrono::duration<double>(options_.lease_work).count();
  const double jobs =
      std::clamp(work / std::max(*sweep.seconds_per_job, 1e-9), 1.0, static_cast<double>(options_.maximum_lease_jobs));
  const std::uint64_t fair_share = sweep.pending.size() / (2 * std::max<std::uint64_t>(slots_, 1)) + 1;
  return std::min(static_cast<std::uint64_t>(std::llround(jobs)), fair_share);
}

bool Ledger::may_take(const Worker& worker) const {
  return !worker.refused && !worker.exclusive && !worker.draining &&
         worker.status.state == messaging::WorkerState::ready;
}

bool Ledger::has_room(const Worker& worker) const {
  return may_take(worker) && worker.leases.size() < window(worker);
}

/// To be called whenever one of these may have changed: what it holds, may hold, or whether it may hold anything.
void Ledger::note_capacity(std::uint64_t id, Worker& worker) {
  const std::uint32_t slots = worker.refused ? 0 : window(worker);
  slots_ = slots_ - std::exchange(worker.slots, slots) + slots;
  if (!has_room(worker)) {
    with_room_.erase(id);
  } else if (with_room_.insert(id).second) {
    may_grant_ = true;
  }
}

bool Ledger::serves(const Worker& worker, const Id128& id, const Sweep& sweep, Clock::time_point now) {
  if (sweep.paused) return false;
  const auto& labels = worker.status.labels;
  const auto has = [&](const std::string& label) { return std::ranges::find(labels, label) != labels.end(); };
  // A robot's worker takes nothing else, and nothing at all without its claim.
  const bool of_a_robot = std::ranges::any_of(labels, [](const auto& label) { return label.starts_with("bridge="); });
  if (of_a_robot != sweep.policy.needs_robot) return false;
  if (of_a_robot && !has(std::string(messaging::robot_label))) return false;
  if (!std::ranges::all_of(sweep.policy.needs, has)) return false;
  const auto pause = worker.not_before.find(id);
  return pause == worker.not_before.end() || now >= pause->second;
}

/// How many more jobs of the sweep may be leased.
std::uint64_t Ledger::room(const Sweep& sweep) {
  const std::uint64_t most = sweep.policy.max_concurrent;
  if (most == 0) return std::numeric_limits<std::uint64_t>::max();
  return most - std::min(most, sweep.leased.size());
}

/// Pending jobs that the worker may compute: of an audit only others' jobs.
JobRanges Ledger::allowed(const Sweep& sweep, std::uint64_t worker) {
  JobRanges jobs = sweep.pending;
  if (const auto own = sweep.authors.find(worker); own != sweep.authors.end()) jobs.remove(own->second);
  return jobs;
}

/// Of those that have jobs to give. Highest priority first; among equal ones whoever holds the fewest leases, which all
/// last about as long; then in order of submission.
std::vector<Id128> Ledger::grant_order() const {
  std::vector<Id128> order;
  std::ranges::copy_if(order_, std::back_inserter(order), [&](const Id128& id) {
    const Sweep& sweep = sweeps_.at(id);
    return !sweep.paused && (has_pending(sweep) || !sweep.suspects.empty());
  });
  std::ranges::stable_sort(order, {}, [&](const Id128& id) {
    const Sweep& sweep = sweeps_.at(id);
    return std::pair(-std::int64_t{sweep.policy.priority}, sweep.leases);
  });
  return order;
}

/// A look that has granted all it could finds nothing more until something happens: a worker gets room or other labels,
/// jobs become pending, a sweep may have more of them leased, or a pause is over.
bool Ledger::anything_to_grant(Clock::time_point now) {
  if (now < grants_from_) return false;
  for (; !pauses_.empty() && *pauses_.begin() <= now; pauses_.erase(pauses_.begin())) may_grant_ = true;
  return std::exchange(may_grant_, false) && !with_room_.empty() && !grant_order().empty();
}

std::vector<Ledger::Grant> Ledger::grant(Clock::time_point now) {
  now_ = now;
  std::vector<Grant> grants;
  if (!anything_to_grant(now)) return grants;
  const auto each_with_room = [&](const auto& work) {
    for (auto next = with_room_.begin(); next != with_room_.end();) {
      const std::uint64_t id = *next++;  // it may have no room afterwards
      work(id, workers_.at(id));
    }
  };
  // One lease to each worker in turn, until every window is full or nothing is pending.
  bool more = true;
  for (std::size_t round = 1; more; ++round) {
    more = false;
    each_with_room([&](std::uint64_t id, Worker& worker) {
      more = worker.leases.size() >= round || grant_pending(id, worker, grants, now) || more;
    });
  }
  // Parts of lost leases wait until nothing is pending in any sweep: a job that kills workers must not stop the others.
  each_with_room([&](std::uint64_t id, Worker& worker) {
    while (has_room(worker) && grant_suspects(id, worker, grants, now)) {
    }
  });
  return grants;
}

bool Ledger::grant_pending(std::uint64_t id, Worker& worker, std::vector<Grant>& grants, Clock::time_point now) {
  for (const auto& sweep_id : grant_order()) {
    Sweep& sweep = sweeps_.at(sweep_id);
    if (!has_pending(sweep) || room(sweep) == 0 || !serves(worker, sweep_id, sweep, now)) continue;
    JobRanges jobs;
    if (!sweep.resumable.empty()) {
      jobs = sweep.resumable.take_lowest(1);
    } else if (sweep.authors.empty()) {
      jobs = sweep.pending.take_lowest(std::min(lease_jobs(sweep), room(sweep)));
    } else {
      jobs = allowed(sweep, id).take_lowest(lease_jobs(sweep));
      sweep.pending.remove(jobs);
    }
    if (jobs.empty()) continue;
    give(id, worker, sweep_id, std::move(jobs), false, grants, now);
    return true;
  }
  return false;
}

bool Ledger::grant_suspects(std::uint64_t id, Worker& worker, std::vector<Grant>& grants, Clock::time_point now) {
  for (const auto& sweep_id : grant_order()) {
    Sweep& sweep = sweeps_.at(sweep_id);
    if (sweep.suspects.empty() || room(sweep) == 0 || !serves(worker, sweep_id, sweep, now)) continue;
    const auto exclusive = [&](const JobRanges& jobs) {
      if (jobs.size() > 1) return false;
      const auto losses = sweep.losses.find(jobs.ranges().front().first);
      return losses != sweep.losses.end() && losses->second >= losses_before_exclusive;
    };
    const auto part = std::ranges::find_if(
        sweep.suspects, [&](const JobRanges& jobs) { return worker.leases.empty() || !exclusive(jobs); });
    if (part == sweep.suspects.end()) continue;
    const bool alone = exclusive(*part);
    JobRanges jobs = part->take_lowest(room(sweep));
    if (part->empty()) sweep.suspects.erase(part);
    give(id, worker, sweep_id, std::move(jobs), alone, grants, now);
    return true;
  }
  return false;
}

void Ledger::give(std::uint64_t id, Worker& worker, const Id128& sweep_id, JobRanges jobs, bool exclusive,
                  std::vector<Grant>& grants, Clock::time_point now) {
  Sweep& sweep = sweeps_.at(sweep_id);
  Lease lease;
  lease.worker = id;
  lease.sweep = sweep_id;
  lease.remaining = std::move(jobs);
  lease.exclusive = exclusive;
  lease.granted = now;
  lease.renewed = now;
  lease.sent = now;
  sweep.leased.add(lease.remaining);
  ++sweep.leases;
  worker.exclusive = exclusive;
  const std::uint64_t number = next_lease_++;
  grants.push_back({id, grant_message(number, lease)});
  worker.leases.insert(number);
  note_capacity(id, worker);
  leases_.emplace(number, std::move(lease));
}

messaging::Lease Ledger::grant_message(std::uint64_t id, const Lease& lease) const {
  messaging::Lease message;
  message.kind = messaging::LeaseKind::grant;
  message.lease = id;
  message.sequence = id;
  message.sweep = lease.sweep;
  message.ranges = to_messages(lease.remaining);
  message.time_limit = sweeps_.at(lease.sweep).policy.time_limit;
  message.duration_milliseconds = static_cast<std::uint32_t>(
      std::chrono::duration_cast<std::chrono::milliseconds>(options_.lease_duration).count());
  return message;
}

}  // namespace lamprey::coordinator
