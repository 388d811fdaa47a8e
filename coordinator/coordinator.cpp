#include "coordinator/coordinator.hpp"

#include <algorithm>
#include <filesystem>
#include <spdlog/spdlog.h>
#include <utility>

namespace lamprey::coordinator {

namespace {

/// Rows of a cancelled sweep that one step writes, so that a sweep of millions doesn't stop everything else.
constexpr std::uint64_t cancelled_rows_per_step = 5'000;

/// Specifications repeated at a time: a site with thousands of open sweeps must not flood its network.
constexpr int repeated_specifications = 16;

/// Between two steps; longer ones mean that this program did not run.
constexpr auto longest_pause = std::chrono::seconds{1};

/// A write-ahead log beyond this is reported, if a reader is why.
constexpr std::uint64_t large_log_bytes = std::uint64_t{128} << 20;
constexpr auto log_size_interval = std::chrono::seconds{10};

constexpr std::size_t most_workers = 4'096;
constexpr std::size_t most_clients = 64;

void count(storage::JobState state, storage::JobCounts& counts) {
  switch (state) {
    case storage::JobState::done:
      ++counts.done;
      break;
    case storage::JobState::failed:
      ++counts.failed;
      break;
    case storage::JobState::quarantined:
      ++counts.quarantined;
      break;
    case storage::JobState::cancelled:
      ++counts.cancelled;
      break;
  }
}

}  // namespace

Coordinator::Coordinator(messaging::Participant& participant, storage::ResultsStore store,
                         std::shared_ptr<messaging::Signal> signal, CoordinatorOptions options, Clock::time_point now)
    : participant_(participant),
      store_(std::move(store)),
      options_(options),
      // Lease numbers start with the epoch: those of earlier epochs are lower, and none is ever given twice.
      ledger_(options.ledger, now, store_.epoch() > 1, store_.epoch() << 32),
      statuses_(participant.reader<messaging::WorkerStatus>(signal)),
      results_(participant.reader<messaging::ResultBatch>(signal)),
      requests_(participant.reader<messaging::Request>(signal)),
      specifications_(participant.writer<messaging::SweepSpecification>()),
      progress_(participant.writer<messaging::SweepProgress>()),
      leases_(participant, most_workers),
      acknowledgements_(participant, most_workers),
      replies_(participant, most_clients),
      staged_since_(now),
      retry_storage_at_(now),
      progress_due_(now),
      specifications_due_(now + options.specification_interval),
      log_size_due_(now),
      last_step_(now),
      database_path_(std::filesystem::absolute(store_.path()).string()) {
  if (!store_.migration().empty()) spdlog::info("{} was brought up to date: {}", store_.path(), store_.migration());
  event("coordinator_started", 0, "epoch " + std::to_string(store_.epoch()) + ", over " + participant.vendor());
  for (const auto& stored : store_.sweeps()) {
    if (stored.state == storage::SweepState::running || stored.state == storage::SweepState::cancelling) {
      open(stored, true);
      const auto& sweep = sweeps_.at(stored.what.id);
      spdlog::info("sweep {}: going on, {} of {} jobs have ended", stored.what.name, sweep.stored.counts.ended(),
                   stored.what.jobs);
    } else {
      ended_sweeps_[stored.what.id] = stored.row;
    }
  }
}

void Coordinator::open(const storage::Sweep& stored, bool publish) {
  idl::SweepSpecification specification;
  if (!specification.ParseFromString(stored.what.specification)) {
    throw storage::StorageError(storage::StorageError::Kind::corrupt,
                                store_.path() + ": the specification of sweep " + stored.what.name + " is unreadable");
  }
  if (stored.science_version != experiment::science_version) {
    throw storage::StorageError(storage::StorageError::Kind::other_science,
                                store_.path() + ": sweep " + stored.what.name +
                                    " is not finished and was begun under science version " +
                                    std::to_string(stored.science_version) + "; this coordinator computes version " +
                                    std::to_string(experiment::science_version));
  }
  OpenSweep sweep;
  sweep.stored = stored;
  try {
    sweep.grid = std::make_shared<const experiment::SweepGrid>(specification);
  } catch (const experiment::InvalidInput& error) {
    throw storage::StorageError(storage::StorageError::Kind::corrupt,
                                store_.path() + ": sweep " + stored.what.name + " is no longer valid: " + error.what());
  }
  const auto ended = store_.ended_jobs(stored.row);
  if (stored.state == storage::SweepState::cancelling) {
    sweep.to_cancel = JobRanges(0, stored.what.jobs);
    sweep.to_cancel.remove(ended);
  } else {
    ledger_.add_sweep(stored.what.id, stored.what.jobs, ended);
  }
  const auto& placed = sweeps_.insert_or_assign(stored.what.id, std::move(sweep)).first->second;
  if (publish) publish_specification(placed, stored.state == storage::SweepState::running);
}

messaging::Origin Coordinator::origin(std::uint64_t worker) const {
  return {store_.database_id(), store_.epoch(), worker, experiment::science_version};
}

void Coordinator::event(std::string kind, std::uint64_t worker, std::string text, std::optional<std::int64_t> sweep,
                        std::optional<std::uint64_t> job) {
  batch_.events.push_back({std::move(kind), sweep, job, worker, std::move(text)});
}

void Coordinator::send(std::uint64_t worker, messaging::Lease lease) {
  lease.origin = origin(worker);
  leases_.write(worker, lease);
}

void Coordinator::step(Clock::time_point now) {
  // A machine that was suspended has not listened: silence is no sign of death then.
  if (now - last_step_ > longest_pause) ledger_.forgive(now - last_step_);
  last_step_ = now;
  take_statuses(now);
  take_requests(now);
  // While the disk is full nothing more is taken: it waits in DDS and at the workers, in bounded room.
  if (!storage_failed_) take_results(now);
  expire(now);
  cancel_some();
  commit(now);
  if (!storage_failed_) grant(now);
  publish_progress(now);
  repeat_specifications(now);
  watch_log_size(now);
}

void Coordinator::finish(Clock::time_point now) {
  event("coordinator_stopped", 0, "");
  staged_since_ = now - options_.commit_interval;
  retry_storage_at_ = now;
  commit(now);
  // The end of a sweep that this commit has brought about is an event too.
  staged_since_ = now - options_.commit_interval;
  commit(now);
}

void Coordinator::take_statuses(Clock::time_point now) {
  for (auto& status : statuses_->take()) {
    const std::uint64_t worker = status.origin.worker;
    if (worker == 0) continue;
    // They end up in logs, tables and protobuf, which takes UTF-8 only.
    for (auto* text : {&status.host, &status.build, &status.dds}) *text = experiment::printable(*text);
    look_for_newer_epoch(status);
    auto reaction = ledger_.heartbeat(status, store_.database_id(), now);
    const std::string who = status.host + "/" + std::to_string(status.process);
    if (reaction.left) {
      spdlog::info("worker {:016x} ({}) has left", worker, who);
      event("worker_left", worker, who);
      leases_.close(worker);
      acknowledgements_.close(worker);
      continue;
    }
    if (reaction.joined) {
      spdlog::info("worker {:016x} ({}, {} threads, {}) has joined", worker, who, status.threads, status.dds);
      event("worker_joined", worker, who);
      batch_.workers.push_back({worker, status.host, status.process, status.threads, status.build, status.dds});
    }
    if (reaction.adopted_jobs > 0) {
      spdlog::info("worker {:016x} holds {} jobs from earlier leases; they stay with it", worker,
                   reaction.adopted_jobs);
      event("lease_adopted", worker, std::to_string(reaction.adopted_jobs) + " jobs");
    }
    for (auto& message : reaction.send) {
      if (message.kind == messaging::LeaseKind::refuse) {
        spdlog::warn("worker {:016x} ({}) gets no leases: {}", worker, who, message.reason);
        event("worker_refused", worker, message.reason);
      }
      send(worker, std::move(message));
    }
  }
}

/// Two coordinators on two copies of one database, or a database put back from a backup: workers obey the higher epoch.
void Coordinator::look_for_newer_epoch(const messaging::WorkerStatus& status) {
  if (status.origin.database != store_.database_id() || status.origin.epoch <= store_.epoch()) return;
  if (std::exchange(said_newer_epoch_, true)) return;
  const std::string text = "worker " + status.host + "/" + std::to_string(status.process) + " has obeyed epoch " +
                           std::to_string(status.origin.epoch) + " of this database, which is at epoch " +
                           std::to_string(store_.epoch()) +
                           "; is this file a copy or a backup? Restart the workers to have them serve it";
  spdlog::error("{}", text);
  event("newer_epoch_seen", status.origin.worker, text);
}

void Coordinator::expire(Clock::time_point now) {
  auto expired = ledger_.expire(now);
  for (const auto worker : expired.workers) {
    spdlog::warn("worker {:016x} has fallen silent", worker);
    event("worker_lost", worker, "");
    leases_.close(worker);
    acknowledgements_.close(worker);
  }
  for (const auto& lost : expired.leases) {
    const auto sweep = sweeps_.find(lost.sweep);
    spdlog::warn("lease {:x} of worker {:016x} is lost with {} jobs: {}", lost.lease, lost.worker, lost.jobs,
                 lost.reason);
    event("lease_lost", lost.worker, std::to_string(lost.jobs) + " jobs: " + lost.reason,
          sweep == sweeps_.end() ? std::nullopt : std::optional(sweep->second.stored.row));
  }
  for (const auto& job : expired.quarantined) quarantine(job);
}

void Coordinator::quarantine(const QuarantinedJob& job) {
  const auto sweep = sweeps_.find(job.sweep);
  // A result of it may be waiting for its commit: then it has ended after all.
  if (sweep == sweeps_.end() || staged_.contains({job.sweep, job.job})) return;
  spdlog::error("job {} of sweep {} is quarantined after {} attempts: {}", job.job, sweep->second.stored.what.name,
                job.attempts, job.reason);
  batch_.jobs.push_back(quarantined_row(sweep->second, job.job, job.attempts, job.worker, job.reason));
  event("job_quarantined", job.worker, job.reason, sweep->second.stored.row, job.job);
  staged_.emplace(std::pair(job.sweep, job.job),
                  storage::ResultsStore::StoredJob{storage::JobState::quarantined, std::nullopt, job.worker});
  ledger_.ended(job.sweep, job.job, 0, -1);
}

void Coordinator::grant(Clock::time_point now) {
  for (auto& grant : ledger_.grant(now)) send(grant.worker, std::move(grant.lease));
}

void Coordinator::cancel_some() {
  for (auto& [id, sweep] : sweeps_) {
    if (sweep.to_cancel.empty() || storage_failed_) continue;
    for (const auto& range : sweep.to_cancel.take_lowest(cancelled_rows_per_step).ranges()) {
      for (std::uint64_t job = range.first; job < range.first + range.count; ++job) {
        storage::EndedJob row;
        row.sweep = sweep.stored.row;
        row.job = job;
        row.state = storage::JobState::cancelled;
        batch_.jobs.push_back(std::move(row));
      }
    }
    staged_since_ = {};  // due at once
  }
}

void Coordinator::commit(Clock::time_point now) {
  if (batch_.empty()) {
    if (!answers_.empty()) after_commit(now);
    return;
  }
  if (storage_failed_ ? now < retry_storage_at_
                      : now - staged_since_ < options_.commit_interval && staged_bytes_ < options_.commit_bytes) {
    return;
  }
  try {
    store_.commit(batch_);
  } catch (const storage::StorageError& error) {
    const bool passes =
        error.kind() == storage::StorageError::Kind::full || error.kind() == storage::StorageError::Kind::busy;
    if (!passes) throw;
    // Nothing was stored and nothing acknowledged; the batch waits.
    if (!std::exchange(storage_failed_, true)) spdlog::error("{}; waiting", error.what());
    retry_storage_at_ = now + options_.storage_retry;
    return;
  }
  if (std::exchange(storage_failed_, false)) spdlog::info("{}: going on", store_.path());
  after_commit(now);
}

void Coordinator::after_commit(Clock::time_point now) {
  for (const auto& answer : answers_) {
    if (answer.acknowledgement.verdict != messaging::Verdict::committed) continue;
    ledger_.ended(answer.acknowledgement.sweep, answer.acknowledgement.job, answer.lease, answer.seconds);
  }
  acknowledge(answers_);
  std::map<std::int64_t, storage::Sweep*> by_row;
  for (auto& [id, sweep] : sweeps_) by_row.emplace(sweep.stored.row, &sweep.stored);
  for (const auto& row : batch_.jobs) {
    if (const auto sweep = by_row.find(row.sweep); sweep != by_row.end()) count(row.state, sweep->second->counts);
  }
  for (const auto& divergence : batch_.divergences) {
    if (const auto sweep = by_row.find(divergence.sweep); sweep != by_row.end()) ++sweep->second->divergences;
  }
  batch_ = {};
  answers_.clear();
  staged_.clear();
  staged_bytes_ = 0;
  staged_since_ = now;
  close_ended_sweeps(now);
}

void Coordinator::close_ended_sweeps(Clock::time_point now) {
  for (auto it = sweeps_.begin(); it != sweeps_.end();) {
    OpenSweep& sweep = it->second;
    if (sweep.stored.counts.ended() < sweep.stored.what.jobs) {
      ++it;
      continue;
    }
    const bool cancelled = sweep.stored.state == storage::SweepState::cancelling;
    sweep.stored.state = cancelled ? storage::SweepState::cancelled : storage::SweepState::finished;
    for (auto& message : ledger_.close_sweep(it->first).revocations) send(message.origin.worker, message);
    spdlog::info("sweep {} is {}: {} done, {} failed, {} quarantined, {} cancelled", sweep.stored.what.name,
                 to_text(sweep.stored.state), sweep.stored.counts.done, sweep.stored.counts.failed,
                 sweep.stored.counts.quarantined, sweep.stored.counts.cancelled);
    event(cancelled ? "sweep_cancelled" : "sweep_finished", 0, sweep.stored.what.name, sweep.stored.row);
    sweep.rate.note(now, sweep.stored.counts.ended());
    if (auto result = progress_->write(progress(sweep)); !result) spdlog::debug("progress: {}", result.error);
    publish_specification(sweep, false);
    ended_sweeps_[it->first] = sweep.stored.row;
    it = sweeps_.erase(it);
  }
}

void Coordinator::publish_specification(const OpenSweep& sweep, bool open) {
  messaging::SweepSpecification sample;
  sample.origin = origin();
  sample.sweep = sweep.stored.what.id;
  sample.name = sweep.stored.what.name;
  sample.open = open;
  if (open) {
    const auto& bytes = sweep.stored.what.specification;
    sample.specification.assign(bytes.begin(), bytes.end());
  }
  if (auto result = specifications_->write(sample); !result) {
    spdlog::error("sweep {}: its specification was not published: {}", sample.name, result.error);
  }
}

/// A worker that holds a lease but has missed its sweep's specification must not wait for ever.
void Coordinator::repeat_specifications(Clock::time_point now) {
  if (now < specifications_due_) return;
  specifications_due_ = now + options_.specification_interval;
  auto next = sweeps_.upper_bound(last_repeated_);
  for (int i = 0; i < repeated_specifications && !sweeps_.empty(); ++i) {
    if (next == sweeps_.end()) {
      if (i > 0) break;
      next = sweeps_.begin();
    }
    last_repeated_ = next->first;
    if (next->second.stored.state == storage::SweepState::running) publish_specification(next->second, true);
    ++next;
  }
}

messaging::SweepProgress Coordinator::progress(const OpenSweep& sweep) const {
  messaging::SweepProgress sample;
  sample.origin = origin();
  const auto& stored = sweep.stored;
  sample.sweep = stored.what.id;
  sample.name = stored.what.name;
  sample.state = to_text(stored.state);
  sample.jobs = stored.what.jobs;
  sample.done = stored.counts.done;
  sample.failed = stored.counts.failed;
  sample.quarantined = stored.counts.quarantined;
  sample.cancelled = stored.counts.cancelled;
  sample.divergences = stored.divergences;
  const std::uint64_t open_jobs = stored.what.jobs - stored.counts.ended();
  sample.leased = std::min(ledger_.leased(stored.what.id), open_jobs);
  sample.pending = open_jobs - sample.leased;
  sample.jobs_per_second = sweep.rate.per_second();
  if (sample.jobs_per_second > 0) sample.seconds_left = static_cast<double>(open_jobs) / sample.jobs_per_second;
  sample.workers = static_cast<std::uint32_t>(ledger_.live_workers());
  return sample;
}

void Coordinator::watch_log_size(Clock::time_point now) {
  if (now < log_size_due_) return;
  log_size_due_ = now + log_size_interval;
  const auto log = store_.log_size();
  const bool large = log.held_by_reader && log.bytes > large_log_bytes;
  if (large && !log_is_large_) {
    spdlog::warn("{}: a reader's open transaction keeps the write-ahead log from being reset; it has grown to {} MB",
                 store_.path(), log.bytes >> 20);
  }
  log_is_large_ = large;
}

void Coordinator::publish_progress(Clock::time_point now) {
  if (now < progress_due_) return;
  progress_due_ = now + options_.progress_interval;
  for (auto& [id, sweep] : sweeps_) {
    sweep.rate.note(now, sweep.stored.counts.ended());
    if (auto result = progress_->write(progress(sweep)); !result) spdlog::debug("progress: {}", result.error);
  }
}

}  // namespace lamprey::coordinator
