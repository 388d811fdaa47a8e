// Who is here and what they hold: heartbeats in, leases out.
#include "coordinator/coordinator.hpp"
#include "experiment/execution_validation.hpp"

#include <algorithm>
#include <spdlog/spdlog.h>
#include <utility>

namespace lamprey::coordinator {

namespace {

/// Who fell silent may be behind a cut link. Its writers are kept for a while: to make others known when it is back
/// took Fast DDS another second. One that was killed leaves them for no longer.
constexpr auto kept_for_the_silent = std::chrono::minutes{1};

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : ",") + word;
  return text;
}

/// Texts end up in logs, tables and protobuf, which takes UTF-8 only; a label that none can have matches no need.
void make_presentable(messaging::WorkerStatus& status) {
  for (auto* text :
       {&status.host, &status.build, &status.flags, &status.processor, &status.instruction_set, &status.dds}) {
    *text = experiment::printable(*text);
  }
  std::erase_if(status.labels,
                [](const std::string& label) { return experiment::label_fault(label, "label").has_value(); });
  for (auto& counter : status.counters) counter.name = experiment::printable(counter.name);
}

}  // namespace

void Coordinator::take_statuses(Clock::time_point now) {
  for (auto& status : statuses_->take()) {
    if (status.origin.worker == 0) {
      ++counters_.statuses_refused;
      continue;
    }
    take_status(std::move(status), now);
  }
}

void Coordinator::take_status(messaging::WorkerStatus status, Clock::time_point now) {
  const std::uint64_t worker = status.origin.worker;
  make_presentable(status);
  look_for_newer_epoch(status);
  auto reaction = ledger_.heartbeat(status, journal_.store().database_id(), now);
  const std::string who = status.host + "/" + std::to_string(status.process);
  if (reaction.left) {
    spdlog::info("worker {:016x} ({}) has left", worker, who);
    journal_.event("worker_left", worker, who);
    ++counters_.workers_left;
    close_writers(worker);
    // It cannot come back: the next process has another incarnation.
    guard(now, [&] { journal_.store().set_draining(worker, false); });
    return;
  }
  if (reaction.joined) greet(status, now);
  counters_.leases_repeated += reaction.repeated_leases;
  if (reaction.adopted_jobs > 0) {
    spdlog::info("worker {:016x} holds {} jobs from earlier leases; they stay with it", worker, reaction.adopted_jobs);
    journal_.event("lease_adopted", worker, std::to_string(reaction.adopted_jobs) + " jobs");
    ++counters_.leases_adopted;
  }
  for (auto& message : reaction.send) {
    if (message.kind == messaging::LeaseKind::refuse) {
      spdlog::warn("worker {:016x} ({}) gets no leases: {}", worker, who, message.reason);
      journal_.event("worker_refused", worker, message.reason);
      ++counters_.workers_refused;
    }
    if (message.kind == messaging::LeaseKind::revoke) ++counters_.leases_revoked;
    guard(now, [&] { send(worker, std::move(message)); });
  }
}

void Coordinator::greet(const messaging::WorkerStatus& status, Clock::time_point now) {
  constexpr auto newcomers_time = std::chrono::seconds{1};
  newcomers_until_ = now + newcomers_time;
  specifications_due_ = now;
  const std::uint64_t worker = status.origin.worker;
  const std::string who = status.host + "/" + std::to_string(status.process);
  spdlog::info("worker {:016x} ({}, {} threads, {}) has joined", worker, who, status.threads, status.dds);
  journal_.event("worker_joined", worker, who);
  journal_.batch().workers.push_back({.incarnation = worker,
                                      .host = status.host,
                                      .process = status.process,
                                      .threads = status.threads,
                                      .build = status.build,
                                      .flags = status.flags,
                                      .processor = status.processor,
                                      .instruction_set = status.instruction_set,
                                      .dds = status.dds,
                                      .labels = joined(status.labels)});
  ++counters_.workers_joined;
}

/// Two coordinators on two copies of one database, or a database put back from a backup: workers obey the higher epoch.
void Coordinator::look_for_newer_epoch(const messaging::WorkerStatus& status) {
  const auto& store = journal_.store();
  if (status.origin.database != store.database_id() || status.origin.epoch <= store.epoch()) return;
  if (std::exchange(said_newer_epoch_, true)) return;
  const std::string text = "worker " + status.host + "/" + std::to_string(status.process) + " has obeyed epoch " +
                           std::to_string(status.origin.epoch) + " of this database, which is at epoch " +
                           std::to_string(store.epoch()) +
                           "; is this file a copy or a backup? Restart the workers to have them serve it";
  spdlog::error("{}", text);
  journal_.event("newer_epoch_seen", status.origin.worker, text);
}

void Coordinator::take_robot_statuses(Clock::time_point now) {
  for (const auto& status : robot_statuses_->take()) note(robots_.heard(status, now));
  note(robots_.fallen_silent(now));
}

void Coordinator::note(const std::vector<RobotEvent>& events) {
  for (const auto& event : events) {
    spdlog::info("{}: {}", event.kind, event.text);
    journal_.event(event.kind, 0, event.text);
  }
}

void Coordinator::expire(Clock::time_point now) {
  auto expired = ledger_.expire(now);
  for (const auto worker : expired.workers) {
    spdlog::warn("worker {:016x} has fallen silent", worker);
    journal_.event("worker_lost", worker, "");
    ++counters_.workers_lost;
    silent_.emplace_back(now + kept_for_the_silent, worker);
  }
  for (const auto& lost : expired.leases) {
    const auto sweep = sweeps_.find(lost.sweep);
    spdlog::warn("lease {:x} of worker {:016x} is lost with {} jobs: {}", lost.lease, lost.worker, lost.jobs,
                 lost.reason);
    journal_.event("lease_lost", lost.worker, std::to_string(lost.jobs) + " jobs: " + lost.reason,
                   sweep == sweeps_.end() ? std::nullopt : std::optional(sweep->second.stored.row));
    ++counters_.leases_lost;
  }
  for (const auto& attempt : expired.attempts) note(attempt);
  for (const auto& job : expired.quarantined) quarantine(job, now);
}

void Coordinator::close_writers(std::uint64_t worker) {
  leases_.close(worker);
  acknowledgements_.close(worker);
}

/// Whoever has not come back by now, of those that fell silent.
void Coordinator::close_writers_of_the_silent(Clock::time_point now) {
  for (; !silent_.empty() && silent_.front().first <= now; silent_.pop_front()) {
    const std::uint64_t worker = silent_.front().second;
    if (!ledger_.knows(worker)) close_writers(worker);
  }
}

void Coordinator::note(const FailedAttempt& attempt) {
  const auto sweep = sweeps_.find(attempt.sweep);
  if (sweep == sweeps_.end()) return;
  journal_.batch().attempts.push_back({.sweep = sweep->second.stored.row,
                                       .job = attempt.job,
                                       .worker = attempt.worker,
                                       .end = attempt.end,
                                       .counted = attempt.counted,
                                       .reason = attempt.reason});
}

void Coordinator::quarantine(const QuarantinedJob& job, Clock::time_point now) {
  if (const auto audit = audits_.find(job.sweep); audit != audits_.end()) {
    // It was done once, and cannot be done again: that is no agreement.
    journal_.event("audit_failed", job.worker, job.reason, audit->second.sweep.row, job.job);
    return end_audited_job(audit->second, job.job, job.worker, {}, false);
  }
  const auto sweep = sweeps_.find(job.sweep);
  // A result of it may be waiting for its commit: then it has ended after all.
  if (sweep == sweeps_.end() || journal_.staged(job.sweep, job.job) != nullptr) return;
  spdlog::error("job {} of sweep {} is quarantined after {} attempts: {}", job.job, sweep->second.stored.what.name,
                job.attempts, job.reason);
  journal_.event("job_quarantined", job.worker, job.reason, sweep->second.stored.row, job.job);
  ++counters_.jobs_quarantined;
  auto row = quarantined_row(sweep->second, job.job, job.attempts, job.worker, job.reason);
  journal_.add(job.sweep, std::move(row), sizeof row, now);
  ledger_.ended(job.sweep, job.job, 0, -1);
}

void Coordinator::grant(Clock::time_point now) {
  for (auto& grant : ledger_.grant(now)) {
    ++counters_.leases_granted;
    send(grant.worker, std::move(grant.lease));
  }
}

/// A grant of a job that somebody has begun says where it goes on. One that does not reach its worker is sent again
/// when it misses it.
void Coordinator::send(std::uint64_t worker, messaging::Lease lease) {
  lease.origin = origin(worker);
  const bool single = lease.ranges.size() == 1 && lease.ranges.front().count == 1;
  const auto sweep = sweeps_.find(lease.sweep);
  if (lease.kind == messaging::LeaseKind::grant && single && sweep != sweeps_.end() &&
      ledger_.has_checkpoint(lease.sweep, lease.ranges.front().first)) {
    const auto checkpoint = journal_.store().find_checkpoint(sweep->second.stored.row, lease.ranges.front().first);
    if (checkpoint) lease.checkpoint.assign(checkpoint->state.begin(), checkpoint->state.end());
  }
  leases_.write(worker, lease);
}

void Coordinator::revoke(std::vector<messaging::Lease> leases) {
  for (auto& message : leases) {
    ++counters_.leases_revoked;
    const std::uint64_t worker = message.origin.worker;
    send(worker, std::move(message));
  }
}

}  // namespace lamprey::coordinator
