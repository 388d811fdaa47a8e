#include "coordinator/ledger.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace lamprey::coordinator {

namespace {

/// A lease that this many heartbeats in a row don't list is sent again; after this many repeats it is given up.
constexpr int heartbeats_before_repeat = 2;
constexpr int maximum_repeats = 3;

/// A heartbeat may have been under way when the lease was sent: one that comes sooner after it says nothing.
constexpr auto sending_time = std::chrono::milliseconds{200};

/// A worker that has received a sweep's lease and does not take it, however often it is sent, is offered no other one
/// of it for so long.
constexpr auto untaken_pause = std::chrono::seconds{30};

/// A lost lease is cut into so many parts; the culprit among a thousand jobs is alone after four deaths.
constexpr std::uint64_t parts_of_a_lost_lease = 8;

/// Weight of the newest job in the running mean of seconds per job.
constexpr double newest_weight = 0.05;

JobRanges to_job_ranges(const std::vector<messaging::JobRange>& ranges) {
  JobRanges jobs;
  for (const auto& range : ranges) {
    if (range.count > 0 && range.first + range.count > range.first) jobs.add(range.first, range.count);
  }
  return jobs;
}

messaging::Lease drain_message() {
  messaging::Lease message;
  message.kind = messaging::LeaseKind::drain;
  return message;
}

messaging::Lease revocation(std::uint64_t lease, const Id128& sweep, std::string reason) {
  messaging::Lease message;
  message.kind = messaging::LeaseKind::revoke;
  message.lease = lease;
  message.sweep = sweep;
  message.reason = std::move(reason);
  return message;
}

}  // namespace

Ledger::Ledger(LedgerOptions options, Clock::time_point start, bool restarted, std::uint64_t first_lease)
    : options_(options),
      now_(start),
      grants_from_(restarted ? start + options.adoption_grace : start),
      next_lease_(first_lease),
      expiry_due_(start) {}

Ledger::Heartbeat Ledger::heartbeat(const messaging::WorkerStatus& status, const Id128& database,
                                    Clock::time_point now) {
  now_ = now;
  Heartbeat reaction;
  const std::uint64_t id = status.origin.worker;
  const auto known = workers_.find(id);
  if (status.state == messaging::WorkerState::leaving) {
    if (known == workers_.end()) return reaction;
    reaction.left = true;
    const auto leases = known->second.leases;
    for (const auto lease : leases) release(lease);
    remove(known);
    draining_.erase(id);
    return reaction;
  }
  // An old heartbeat that DDS delivers late or twice says nothing about now.
  if (known != workers_.end() && status.heartbeat <= known->second.status.heartbeat) return reaction;
  reaction.joined = known == workers_.end();
  Worker& worker = workers_[id];
  // Only what it says of itself can make it serve a sweep that it did not serve before.
  if (worker.status.labels != status.labels) may_grant_ = true;
  worker.status = status;
  worker.heard = now;
  worker.draining = draining_.contains(id);
  if (worker.draining && status.state == messaging::WorkerState::ready) reaction.send.push_back(drain_message());

  if (status.origin.science_version != experiment::science_version) {
    if (!std::exchange(worker.refused, true)) {
      messaging::Lease refusal;
      refusal.kind = messaging::LeaseKind::refuse;
      refusal.reason = "the worker computes science version " + std::to_string(status.origin.science_version) +
                       ", this database holds version " + std::to_string(experiment::science_version);
      reaction.send.push_back(std::move(refusal));
    }
    note_capacity(id, worker);
    return reaction;
  }
  if (reaction.joined) {
    messaging::Lease welcome;
    welcome.kind = messaging::LeaseKind::welcome;
    reaction.send.push_back(std::move(welcome));
  }

  std::set<std::uint64_t> listed;
  for (const auto& held : status.leases) {
    if (held.database != database) continue;
    listed.insert(held.lease);
    const auto lease = leases_.find(held.lease);
    if (lease != leases_.end() && lease->second.worker == id) {
      lease->second.renewed = now;
      lease->second.unlisted_heartbeats = 0;
    } else {
      adopt(worker, held, reaction, now);
    }
  }
  repeat_unlisted(worker, database, listed, reaction, now);
  note_capacity(id, worker);
  return reaction;
}

void Ledger::adopt(Worker& worker, const messaging::HeldLease& held, Heartbeat& reaction, Clock::time_point now) {
  const auto revoke = [&](const char* reason, bool interrupt = false) {
    reaction.send.push_back(revocation(held.lease, held.sweep, reason));
    reaction.send.back().interrupt = interrupt;
  };
  const auto sweep = sweeps_.find(held.sweep);
  if (sweep == sweeps_.end() || sweep->second.paused) return revoke("the sweep is not running", true);
  if (leases_.contains(held.lease)) return revoke("the lease belongs to another worker");
  // Lease numbers grow with the epoch, so every lease that was ever granted has a lower one than the next.
  if (held.lease >= next_lease_) return revoke("no such lease was granted");
  const JobRanges free = take_free(sweep->second, to_job_ranges(held.remaining));
  if (free.empty()) {
    // Nothing to compute any more; results that the worker has already still get their acknowledgement.
    return revoke("its jobs have ended or are leased to others");
  }
  sweep->second.leased.add(free);
  ++sweep->second.leases;
  reaction.adopted_jobs += free.size();
  const std::uint64_t id = worker.status.origin.worker;
  if (free.size() == 1) {
    // Thought dead with this job, and here it is, alive: that attempt was the network's.
    if (const auto losses = sweep->second.losses.find(free.ranges().front().first);
        losses != sweep->second.losses.end() && losses->second > 0) {
      --losses->second;
    }
    const auto attempts = sweep->second.attempts.find(free.ranges().front().first);
    if (attempts != sweep->second.attempts.end() && attempts->second.workers.erase(id) > 0) --attempts->second.count;
  }
  Lease lease;
  lease.worker = id;
  lease.sweep = held.sweep;
  lease.remaining = free;
  lease.granted = now;
  lease.renewed = now;
  lease.sent = now;
  leases_.emplace(held.lease, std::move(lease));
  worker.leases.insert(held.lease);
}

/// Takes those of the wanted jobs that are leased to nobody: pending ones, and parts of leases that were thought lost.
JobRanges Ledger::take_free(Sweep& sweep, const JobRanges& wanted) {
  JobRanges free;
  for (auto* waiting : {&sweep.pending, &sweep.resumable}) {
    const JobRanges shared = waiting->intersection(wanted);
    waiting->remove(shared);
    free.add(shared);
  }
  for (auto part = sweep.suspects.begin(); part != sweep.suspects.end();) {
    const JobRanges shared = part->intersection(wanted);
    part->remove(shared);
    free.add(shared);
    part = part->empty() ? sweep.suspects.erase(part) : std::next(part);
  }
  return free;
}

bool Ledger::take_suspect(Sweep& sweep, std::uint64_t job) {
  for (auto part = sweep.suspects.begin(); part != sweep.suspects.end(); ++part) {
    if (!part->take(job)) continue;
    if (part->empty()) sweep.suspects.erase(part);
    return true;
  }
  return false;
}

void Ledger::repeat_unlisted(Worker& worker, const Id128& database, const std::set<std::uint64_t>& listed,
                             Heartbeat& reaction, Clock::time_point now) {
  const auto own = worker.leases;  // release() changes the original
  for (const auto id : own) {
    if (listed.contains(id)) continue;
    // Where many start at once, leases may take seconds to arrive.
    const bool received = worker.status.origin.database == database && worker.status.last_lease_sequence >= id;
    Lease& lease = leases_.at(id);
    if (now - lease.sent < sending_time) continue;
    if (++lease.unlisted_heartbeats < heartbeats_before_repeat) continue;
    lease.unlisted_heartbeats = 0;
    if (++lease.repeats > maximum_repeats) {
      if (received) {
        worker.not_before[lease.sweep] = now + untaken_pause;
        pauses_.insert(now + untaken_pause);
      }
      release(id);
    } else {
      lease.sent = now;
      ++reaction.repeated_leases;
      reaction.send.push_back(grant_message(id, lease));
    }
  }
}

Ledger::Expired Ledger::expire(Clock::time_point now) {
  now_ = now;
  Expired expired;
  // Moments of hearing and renewal only move on: before the earliest of the last look nothing can have expired.
  if (now <= expiry_due_) return expired;
  auto earliest = now;
  for (auto it = workers_.begin(); it != workers_.end();) {
    if (now - it->second.heard <= options_.lease_duration) {
      earliest = std::min(earliest, it->second.heard);
      ++it;
      continue;
    }
    const auto leases = it->second.leases;
    for (const auto lease : leases) lose(lease, "its worker fell silent", expired);
    expired.workers.push_back(it->first);
    it = remove(it);
  }
  std::vector<std::uint64_t> overdue;
  for (const auto& [id, lease] : leases_) {
    if (now - lease.renewed > options_.lease_duration) {
      overdue.push_back(id);
    } else {
      earliest = std::min(earliest, lease.renewed);
    }
  }
  expiry_due_ = earliest + options_.lease_duration;
  for (const auto id : overdue) {
    expired.leases.push_back({id, leases_.at(id).worker, leases_.at(id).sweep, leases_.at(id).remaining.size(),
                              "its worker no longer lists it"});
    release(id);
  }
  return expired;
}

/// The worker lives or has said goodbye: its jobs are simply pending again.
void Ledger::release(std::uint64_t id) {
  const auto found = leases_.find(id);
  Sweep& sweep = sweeps_.at(found->second.sweep);
  sweep.leased.remove(found->second.remaining);
  put_back(sweep, found->second.remaining);
  forget(found);
}

void Ledger::forget(std::map<std::uint64_t, Lease>::iterator lease) {
  Worker& worker = workers_.at(lease->second.worker);
  worker.leases.erase(lease->first);
  if (lease->second.exclusive) worker.exclusive = false;
  note_capacity(lease->second.worker, worker);
  may_grant_ = true;
  if (const auto sweep = sweeps_.find(lease->second.sweep); sweep != sweeps_.end()) --sweep->second.leases;
  leases_.erase(lease);
}

Ledger::Workers::iterator Ledger::remove(Workers::iterator worker) {
  slots_ -= worker->second.slots;
  with_room_.erase(worker->first);
  may_grant_ = true;
  return workers_.erase(worker);
}

/// The worker died with the lease, and one of its jobs may be why. The lease is cut into parts, again and again if need
/// be. A job that was alone is leased as before once more, for most workers die of something else; then it is given to
/// a worker that holds nothing else, and only such a loss counts against the job.
void Ledger::lose(std::uint64_t id, const std::string& reason, Expired& expired) {
  const auto found = leases_.find(id);
  const Lease lease = found->second;
  expired.leases.push_back({id, lease.worker, lease.sweep, lease.remaining.size(), reason});
  Sweep& sweep = sweeps_.at(lease.sweep);
  JobRanges rest = lease.remaining;
  sweep.leased.remove(rest);
  if (!sweep.authors.empty()) {
    // An audited job has been done before: it is not why.
    put_back(sweep, std::exchange(rest, {}));
  } else if (rest.size() == 1) {
    lose_single(lease, sweep, rest, reason, expired);
  }
  // Those with a checkpoint are leased alone.
  for (const auto job : sweep.checkpointed) {
    if (rest.take(job)) sweep.suspects.emplace_back(job, 1);
  }
  const std::uint64_t part = rest.size() / parts_of_a_lost_lease + 1;
  while (!rest.empty()) sweep.suspects.push_back(rest.take_lowest(part));
  forget(found);
}

/// Leaves in `rest` what is still suspected.
void Ledger::lose_single(const Lease& lease, Sweep& sweep, JobRanges& rest, const std::string& reason,
                         Expired& expired) {
  const std::uint64_t job = rest.ranges().front().first;
  if (!was_running(lease)) return;
  ++sweep.losses[job];
  expired.attempts.push_back({lease.sweep, job, lease.worker, "lost", lease.exclusive, reason});
  if (!lease.exclusive) return;
  if (auto quarantined = count_attempt(sweep, lease.sweep, job, lease.worker, reason)) {
    expired.quarantined.push_back(std::move(*quarantined));
    rest = {};
  }
}

bool Ledger::was_running(const Lease& lease) const {
  return std::ranges::any_of(workers_.at(lease.worker).status.running, [&](const auto& running) {
    return running.sweep == lease.sweep && lease.remaining.contains(running.job);
  });
}

void Ledger::forgive(Clock::duration pause) {
  for (auto& [id, worker] : workers_) worker.heard += pause;
  for (auto& [id, lease] : leases_) lease.renewed += pause;
}

std::optional<QuarantinedJob> Ledger::count_attempt(Sweep& sweep, const Id128& id, std::uint64_t job,
                                                    std::uint64_t worker, const std::string& reason) {
  Attempts& attempts = sweep.attempts[job];
  if (attempts.workers.insert(worker).second) ++attempts.count;
  if (attempts.count < maximum_attempts(sweep)) return std::nullopt;
  return QuarantinedJob{id, job, attempts.count, worker, reason};
}

std::optional<messaging::Lease> Ledger::drain(std::uint64_t id) {
  const auto worker = workers_.find(id);
  if (worker == workers_.end()) return std::nullopt;
  draining_.insert(id);
  worker->second.draining = true;
  note_capacity(id, worker->second);
  return drain_message();
}

void Ledger::remember_draining(const std::vector<std::uint64_t>& workers) {
  draining_.insert(workers.begin(), workers.end());
}

double Ledger::queue_seconds(const Id128& id, std::uint64_t job, std::uint64_t hint) {
  const auto sweep = sweeps_.find(id);
  const auto lease = sweep == sweeps_.end() ? leases_.end() : lease_of(id, job, hint);
  if (lease == leases_.end()) return 0;
  return std::max(0.0, std::chrono::duration<double>(lease->second.granted - sweep->second.since).count());
}

std::vector<Ledger::WorkerView> Ledger::workers() const {
  std::vector<WorkerView> list;
  for (const auto& [id, worker] : workers_)
    list.push_back({&worker.status, worker.leases.size(), worker.heard, worker.refused});
  return list;
}

std::optional<std::string> Ledger::build_of(std::uint64_t worker) const {
  const auto found = workers_.find(worker);
  if (found == workers_.end()) return std::nullopt;
  return found->second.status.build;
}

bool Ledger::is_open(const Id128& id, std::uint64_t job) const {
  const auto found = sweeps_.find(id);
  if (found == sweeps_.end()) return false;
  const Sweep& sweep = found->second;
  return sweep.leased.contains(job) || sweep.pending.contains(job) || sweep.resumable.contains(job) ||
         std::ranges::any_of(sweep.suspects, [job](const JobRanges& part) { return part.contains(job); });
}

std::map<std::uint64_t, Ledger::Lease>::iterator Ledger::lease_of(const Id128& sweep, std::uint64_t job,
                                                                  std::uint64_t hint) {
  const auto holds = [&](const Lease& lease) { return lease.sweep == sweep && lease.remaining.contains(job); };
  const auto hinted = leases_.find(hint);
  if (hinted != leases_.end() && holds(hinted->second)) return hinted;
  return std::ranges::find_if(leases_, [&](const auto& entry) { return holds(entry.second); });
}

void Ledger::ended(const Id128& id, std::uint64_t job, std::uint64_t hint, double seconds) {
  const auto found = sweeps_.find(id);
  if (found == sweeps_.end()) return;
  Sweep& sweep = found->second;
  may_grant_ = true;  // there may be room below the sweep's most concurrent jobs
  sweep.attempts.erase(job);
  sweep.losses.erase(job);
  sweep.checkpointed.erase(job);
  if (seconds >= 0 && std::isfinite(seconds)) {
    sweep.seconds_per_job =
        sweep.seconds_per_job ? *sweep.seconds_per_job + newest_weight * (seconds - *sweep.seconds_per_job) : seconds;
  }
  if (!sweep.leased.take(job)) {
    if (!sweep.pending.take(job) && !sweep.resumable.take(job)) take_suspect(sweep, job);
    return;
  }
  const auto lease = lease_of(id, job, hint);
  if (lease == leases_.end()) return;
  lease->second.remaining.take(job);
  if (lease->second.remaining.empty()) forget(lease);
}

Ledger::Refused Ledger::refused(const Id128& id, std::uint64_t job, std::uint64_t worker_id,
                                const std::string& reason) {
  const auto found = sweeps_.find(id);
  if (found == sweeps_.end()) return {};
  const auto lease = lease_of(id, job, 0);
  if (lease == leases_.end() || lease->second.worker != worker_id) return {};
  Refused reaction;
  Sweep& sweep = found->second;
  reaction.attempt = FailedAttempt{id, job, worker_id, "refused", true, reason};
  reaction.quarantined = count_attempt(sweep, id, job, worker_id, reason);
  const Attempts attempts = sweep.attempts[job];
  ended(id, job, lease->first, -1);
  if (!reaction.quarantined) {
    sweep.attempts[job] = attempts;
    sweep.losses[job] = losses_before_exclusive;
    sweep.suspects.emplace_back(job, 1);
  }
  Worker& worker = workers_.at(worker_id);
  if (++worker.refused_results == options_.maximum_refused_results) {
    worker.refused = true;
    note_capacity(worker_id, worker);
    reaction.farewell.emplace();
    reaction.farewell->kind = messaging::LeaseKind::refuse;
    reaction.farewell->reason =
        std::to_string(worker.refused_results) + " of its results were refused, the last because " + reason;
  }
  return reaction;
}

std::size_t Ledger::live_workers() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(workers_, [](const auto& entry) { return !entry.second.refused; }));
}

std::uint32_t Ledger::attempts(const Id128& id, std::uint64_t job) const {
  const auto found = sweeps_.find(id);
  if (found == sweeps_.end()) return 0;
  const auto attempts = found->second.attempts.find(job);
  return attempts == found->second.attempts.end() ? 0 : attempts->second.count;
}

}  // namespace lamprey::coordinator
