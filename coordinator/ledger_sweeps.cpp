// Which sweeps there are, which of their jobs wait, and how they are to be given out.
#include "coordinator/ledger.hpp"

#include <algorithm>
#include <utility>

namespace lamprey::coordinator {

void Ledger::add_sweep(const Id128& id, JobRanges open_jobs, SweepPolicy policy) {
  Sweep sweep;
  sweep.policy = std::move(policy);
  sweep.pending = std::move(open_jobs);
  sweep.since = now_;
  may_grant_ = true;
  if (sweeps_.emplace(id, std::move(sweep)).second) order_.push_back(id);
}

void Ledger::add_audit(const Id128& id, std::map<std::uint64_t, JobRanges> jobs_by_author) {
  // What people wait for comes first.
  constexpr std::int32_t below_every_sweep = -1'000'000;
  JobRanges jobs;
  for (const auto& [author, part] : jobs_by_author) jobs.add(part);
  add_sweep(id, std::move(jobs), {.priority = below_every_sweep, .needs = {}});
  sweeps_.at(id).authors = std::move(jobs_by_author);
}

void Ledger::add_jobs(const Id128& id, const JobRanges& jobs) {
  const auto sweep = sweeps_.find(id);
  if (sweep == sweeps_.end()) return;
  if (!has_pending(sweep->second)) sweep->second.since = now_;
  put_back(sweep->second, jobs);
  may_grant_ = true;
}

void Ledger::set_policy(const Id128& id, SweepPolicy policy) {
  const auto sweep = sweeps_.find(id);
  if (sweep == sweeps_.end()) return;
  sweep->second.policy = std::move(policy);
  may_grant_ = true;
}

/// Pending again: those with a checkpoint apart from the others.
void Ledger::put_back(Sweep& sweep, const JobRanges& jobs) {
  JobRanges plain = jobs;
  for (const auto job : sweep.checkpointed) {
    if (plain.take(job)) sweep.resumable.add(job, 1);
  }
  sweep.pending.add(plain);
}

std::vector<messaging::Lease> Ledger::take_leases_back(const Id128& id, const std::string& reason) {
  std::vector<messaging::Lease> revocations;
  for (auto it = leases_.begin(); it != leases_.end();) {
    if (it->second.sweep != id) {
      ++it;
      continue;
    }
    messaging::Lease message;
    message.kind = messaging::LeaseKind::revoke;
    message.lease = it->first;
    message.sweep = id;
    message.interrupt = true;
    message.reason = reason;
    message.origin.worker = it->second.worker;
    revocations.push_back(std::move(message));
    forget(it++);
  }
  return revocations;
}

Ledger::Closed Ledger::close_sweep(const Id128& id) {
  Closed closed;
  const auto found = sweeps_.find(id);
  if (found == sweeps_.end()) return closed;
  Sweep& sweep = found->second;
  closed.open_jobs = std::move(sweep.pending);
  closed.open_jobs.add(sweep.resumable);
  closed.open_jobs.add(sweep.leased);
  for (const auto& part : sweep.suspects) closed.open_jobs.add(part);
  closed.revocations = take_leases_back(id, "the sweep has ended");
  sweeps_.erase(found);
  std::erase(order_, id);
  return closed;
}

std::vector<messaging::Lease> Ledger::pause(const Id128& id) {
  const auto found = sweeps_.find(id);
  if (found == sweeps_.end()) return {};
  Sweep& sweep = found->second;
  sweep.paused = true;
  auto revocations = take_leases_back(id, "the sweep is paused");
  put_back(sweep, std::exchange(sweep.leased, {}));
  return revocations;
}

void Ledger::resume(const Id128& id) {
  const auto sweep = sweeps_.find(id);
  if (sweep == sweeps_.end() || !std::exchange(sweep->second.paused, false)) return;
  sweep->second.since = now_;
  may_grant_ = true;
}

void Ledger::note_checkpoint(const Id128& id, std::uint64_t job) {
  const auto found = sweeps_.find(id);
  if (found == sweeps_.end()) return;
  Sweep& sweep = found->second;
  sweep.checkpointed.insert(job);
  if (sweep.pending.take(job)) sweep.resumable.add(job, 1);
}

bool Ledger::has_checkpoint(const Id128& id, std::uint64_t job) const {
  const auto sweep = sweeps_.find(id);
  return sweep != sweeps_.end() && sweep->second.checkpointed.contains(job);
}

void Ledger::restore_attempts(const Id128& id, std::uint64_t job, const std::vector<std::uint64_t>& workers) {
  const auto found = sweeps_.find(id);
  if (found == sweeps_.end()) return;
  Sweep& sweep = found->second;
  Attempts& attempts = sweep.attempts[job];
  attempts.workers.insert(workers.begin(), workers.end());
  attempts.count = static_cast<std::uint32_t>(attempts.workers.size());
  // What had been suspected stays so: only its next worker, holding nothing else, can tell.
  sweep.losses[job] = losses_before_exclusive;
  if (!sweep.pending.take(job) && !sweep.resumable.take(job)) return;
  sweep.suspects.emplace_back(job, 1);
  may_grant_ = true;
}

std::uint32_t Ledger::maximum_attempts(const Sweep& sweep) const {
  return sweep.policy.attempts > 0 ? sweep.policy.attempts : options_.default_attempts;
}

std::uint64_t Ledger::pending(const Id128& id) const {
  const auto found = sweeps_.find(id);
  if (found == sweeps_.end()) return 0;
  std::uint64_t jobs = found->second.pending.size() + found->second.resumable.size();
  for (const auto& part : found->second.suspects) jobs += part.size();
  return jobs;
}

std::uint64_t Ledger::leased(const Id128& id) const {
  const auto found = sweeps_.find(id);
  return found == sweeps_.end() ? 0 : found->second.leased.size();
}

bool Ledger::is_leased(const Id128& id, std::uint64_t job) const {
  const auto found = sweeps_.find(id);
  return found != sweeps_.end() && found->second.leased.contains(job);
}

std::uint64_t Ledger::waiting_for_another_worker(const Id128& id) const {
  const auto found = sweeps_.find(id);
  if (found == sweeps_.end()) return 0;
  JobRanges waiting = found->second.pending;
  for (const auto& [worker, entry] : workers_) {
    if (!entry.refused && !entry.draining) waiting.remove(allowed(found->second, worker));
  }
  return waiting.size();
}

}  // namespace lamprey::coordinator
