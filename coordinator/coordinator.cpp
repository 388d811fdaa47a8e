#include "coordinator/coordinator.hpp"

#include "coordinator/stop_rule.hpp"

#include <algorithm>
#include <filesystem>
#include <spdlog/spdlog.h>
#include <utility>

namespace lamprey::coordinator {

namespace {

/// Rows that one step writes or deletes in the background, so that a sweep of millions doesn't stop everything else.
constexpr std::uint64_t rows_per_step = 5'000;

/// Between two steps; longer ones mean that this program did not run.
constexpr auto longest_pause = std::chrono::seconds{1};

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
                         std::shared_ptr<messaging::Signal> signal, CoordinatorOptions options, Clock::time_point now,
                         messaging::Participant* robots)
    : participant_(participant),
      signal_(signal),
      options_(options),
      journal_(std::move(store), options.journal, now),
      // Lease numbers start with the epoch: those of earlier epochs are lower, and none is ever given twice.
      ledger_(options.ledger, now, journal_.store().epoch() > 1, journal_.store().epoch() << 32),
      statuses_(participant.reader<messaging::WorkerStatus>(signal)),
      robot_statuses_((robots != nullptr ? *robots : participant).reader<messaging::RobotStatus>(signal)),
      results_(participant.reader<messaging::ResultBatch>(signal)),
      checkpoints_(participant.reader<messaging::Checkpoint>(signal)),
      requests_(participant.reader<messaging::Request>(signal)),
      specifications_(participant.writer<messaging::SweepSpecification>()),
      progress_(participant.writer<messaging::SweepProgress>()),
      leases_(participant, most_workers),
      acknowledgements_(participant, most_workers),
      replies_(participant, most_clients),
      progress_due_(now),
      specifications_due_(now + options.specification_interval),
      newcomers_until_(now),
      log_size_due_(now),
      last_step_(now),
      database_path_(std::filesystem::absolute(journal_.store().path()).string()) {
  const auto& database = journal_.store();
  if (!database.migration().empty())
    spdlog::info("{} was brought up to date: {}", database.path(), database.migration());
  journal_.event("coordinator_started", 0,
                 "epoch " + std::to_string(database.epoch()) + ", over " + participant.vendor());
  ledger_.remember_draining(database.draining());
  for (const auto& stored : database.sweeps()) {
    if (stored.state == storage::SweepState::finished || stored.state == storage::SweepState::cancelled) {
      ended_sweeps_[stored.what.id] = stored.row;
    } else {
      open(stored);
      spdlog::info("sweep {}: {}, {} of {} jobs have ended", stored.what.name, to_text(stored.state),
                   sweeps_.at(stored.what.id).stored.counts.ended(), stored.what.jobs);
    }
  }
  for (const auto& audit : database.audits()) {
    if (!audit.finished()) open_audit(audit);
  }
}

void Coordinator::open(const storage::Sweep& stored) {
  using Kind = storage::StorageError::Kind;
  const std::string where = journal_.store().path() + ": sweep " + stored.what.name;
  OpenSweep sweep;
  sweep.stored = stored;
  if (stored.state != storage::SweepState::deleting) {
    idl::SweepSpecification specification;
    if (!specification.ParseFromString(stored.what.specification) ||
        !sweep.execution.ParseFromString(stored.what.execution)) {
      throw storage::StorageError(Kind::corrupt, where + ": its specification is unreadable");
    }
    if (stored.science_version != experiment::science_version) {
      throw storage::StorageError(Kind::other_science, where + " is not finished and was begun under science version " +
                                                           std::to_string(stored.science_version) +
                                                           "; this coordinator computes version " +
                                                           std::to_string(experiment::science_version));
    }
    try {
      sweep.grid = std::make_shared<const experiment::SweepGrid>(specification);
    } catch (const experiment::InvalidInput& error) {
      throw storage::StorageError(Kind::corrupt, where + " is no longer valid: " + error.what());
    }
  }
  sweeps_.insert_or_assign(stored.what.id, std::move(sweep));
  go_on(stored);
}

/// What is left to do for a sweep that has just come into memory.
void Coordinator::go_on(const storage::Sweep& stored) {
  const auto& store = journal_.store();
  const Id128& id = stored.what.id;
  OpenSweep& sweep = sweeps_.at(id);
  ended_sweeps_.erase(id);
  const bool runs = stored.state == storage::SweepState::running || stored.state == storage::SweepState::paused;
  if (stored.state == storage::SweepState::deleting) return;
  JobRanges open_jobs(0, stored.what.jobs);
  open_jobs.remove(store.ended_jobs(stored.row));
  if (!runs) {
    sweep.to_cancel = std::move(open_jobs);
    return publish_specification(sweep.stored, id, false);
  }
  if (ReuseScan::worth_while(store, stored)) {
    sweep.reuse.emplace(stored, sweep.grid, std::exchange(open_jobs, {}));
  }
  ledger_.add_sweep(id, std::move(open_jobs), policy_of(sweep.execution, *sweep.grid));
  for (const auto job : store.checkpointed_jobs(stored.row)) ledger_.note_checkpoint(id, job);
  for (const auto& counted : store.counted_attempts(stored.row)) {
    ledger_.restore_attempts(id, counted.job, counted.workers);
  }
  if (stored.state == storage::SweepState::paused) ledger_.pause(id);
  publish_specification(sweep.stored, id, true);
}

messaging::Origin Coordinator::origin(std::uint64_t worker) const {
  return {journal_.store().database_id(), journal_.store().epoch(), worker, experiment::science_version};
}

/// Whatever the database does, this program goes on: what the work could not store or read is asked for again.
void Coordinator::guard(Clock::time_point now, const std::function<void()>& work) {
  try {
    work();
  } catch (const storage::StorageError& error) {
    journal_.note_fault(error, now);
  }
}

void Coordinator::step(Clock::time_point now) {
  // A machine that was suspended has not listened: silence is no sign of death then.
  if (now - last_step_ > longest_pause) ledger_.forgive(now - last_step_);
  last_step_ = now;
  take_statuses(now);
  take_robot_statuses(now);
  take_requests(now);
  // While nothing can be stored nothing more is taken: it waits in DDS and at the workers, in bounded room.
  if (journal_.healthy()) {
    guard(now, [&] { take_results(now); });
    guard(now, [&] { take_checkpoints(); });
  }
  expire(now);
  close_writers_of_the_silent(now);
  if (journal_.healthy()) guard(now, [&] { work_in_background(now); });
  commit(now);
  if (journal_.healthy()) guard(now, [&] { grant(now); });
  publish_progress(now);
  repeat_specifications(now);
  watch_log_size(now);
}

void Coordinator::finish(Clock::time_point now) {
  journal_.event("coordinator_stopped", 0, "");
  journal_.hurry();
  commit(now);
  // The end of a sweep that this commit has brought about is an event too.
  journal_.hurry();
  commit(now);
}

void Coordinator::work_in_background(Clock::time_point now) {
  stop_early(now);
  bool more = false;
  for (auto& [id, sweep] : sweeps_) {
    if (sweep.stored.state == storage::SweepState::deleting) {
      more = true;
      continue;
    }
    if (!sweep.to_cancel.empty()) cancel_some(sweep, now);
    if (sweep.reuse && sweep.stored.state == storage::SweepState::running) reuse_some(sweep, now);
    more = more || !sweep.to_cancel.empty() || sweep.reuse;
  }
  const auto deleted = std::ranges::find_if(
      sweeps_, [](const auto& entry) { return entry.second.stored.state == storage::SweepState::deleting; });
  if (deleted != sweeps_.end()) delete_some(deleted->second);
  if (more) signal_->notify();
}

void Coordinator::cancel_some(OpenSweep& sweep, Clock::time_point now) {
  for (const auto& range : sweep.to_cancel.take_lowest(rows_per_step).ranges()) {
    for (std::uint64_t job = range.first; job < range.first + range.count; ++job) {
      storage::EndedJob row;
      row.sweep = sweep.stored.row;
      row.job = job;
      row.state = storage::JobState::cancelled;
      journal_.add(sweep.stored.what.id, std::move(row), sizeof row, now);
    }
  }
  journal_.hurry();
}

void Coordinator::reuse_some(OpenSweep& sweep, Clock::time_point now) {
  auto found = sweep.reuse->step(journal_.store());
  const Id128& id = sweep.stored.what.id;
  for (auto& row : found.rows) {
    const std::size_t bytes = sizeof row + row.outcome->trace.size() * sizeof(experiment::AcceptedChange);
    journal_.add(id, std::move(row), bytes, now);
    ++counters_.outcomes_reused;
    ++sweep.stored.reused;
  }
  ledger_.add_jobs(id, found.to_compute);
  if (!found.finished) return;
  sweep.reuse.reset();
  if (sweep.stored.reused == 0) return;
  spdlog::info("sweep {}: {} outcomes are in the database already; they are not computed again", sweep.stored.what.name,
               sweep.stored.reused);
  journal_.event("outcomes_reused", 0, std::to_string(sweep.stored.reused) + " jobs", sweep.stored.row);
}

void Coordinator::delete_some(OpenSweep& sweep) {
  const storage::Sweep stored = sweep.stored;
  if (!journal_.store().delete_some(stored.row, rows_per_step)) return;
  spdlog::info("sweep {}: deleted", stored.what.name);
  sweeps_.erase(stored.what.id);
}

void Coordinator::commit(Clock::time_point now) {
  if (const auto batch = journal_.commit(now)) {
    after_commit(*batch, now);
  } else if (journal_.empty() && !answers_.empty()) {
    // Nothing to store: they answer what had been stored before.
    acknowledge(std::exchange(answers_, {}));
  }
}

void Coordinator::after_commit(const storage::Batch& batch, Clock::time_point now) {
  for (const auto& answer : answers_) {
    if (answer.acknowledgement.verdict != messaging::Verdict::committed) continue;
    ledger_.ended(answer.acknowledgement.sweep, answer.acknowledgement.job, answer.lease, answer.seconds);
  }
  acknowledge(std::exchange(answers_, {}));
  std::map<std::int64_t, storage::Sweep*> by_row;
  for (auto& [id, sweep] : sweeps_) by_row.emplace(sweep.stored.row, &sweep.stored);
  for (const auto& row : batch.jobs) {
    if (const auto sweep = by_row.find(row.sweep); sweep != by_row.end()) count(row.state, sweep->second->counts);
  }
  for (const auto& divergence : batch.divergences) {
    if (const auto sweep = by_row.find(divergence.sweep); sweep != by_row.end()) ++sweep->second->divergences;
  }
  note_stops(batch);
  close_ended_sweeps(now);
  close_ended_audits();
}

/// Which sweeps have met a condition to stop with what has just been stored.
void Coordinator::note_stops(const storage::Batch& batch) {
  std::map<std::int64_t, OpenSweep*> by_row;
  for (auto& [id, sweep] : sweeps_) {
    const bool conditional = sweep.execution.fail_fast() || sweep.execution.stop_when_size() > 0;
    const auto state = sweep.stored.state;
    const bool runs = state == storage::SweepState::running || state == storage::SweepState::paused;
    if (!conditional || !runs) continue;
    by_row.emplace(sweep.stored.row, &sweep);
    auto reason = reason_to_stop(sweep.execution, sweep.stored.counts, sweep.stored.divergences);
    if (!reason.empty()) to_stop_.try_emplace(id, std::move(reason));
  }
  if (by_row.empty()) return;
  for (const auto& row : batch.jobs) {
    const auto sweep = by_row.find(row.sweep);
    if (sweep == by_row.end() || !row.outcome) continue;
    auto reason = reason_to_stop(sweep->second->execution, *row.outcome);
    if (reason.empty()) continue;
    to_stop_.try_emplace(sweep->second->stored.what.id, "job " + std::to_string(row.job) + ": " + reason);
  }
}

void Coordinator::stop_early(Clock::time_point now) {
  if (to_stop_.empty() || !commit_now(now)) return;
  for (auto it = to_stop_.begin(); it != to_stop_.end(); it = to_stop_.erase(it)) {
    const auto sweep = sweeps_.find(it->first);
    if (sweep != sweeps_.end()) begin_cancelling(sweep->second, it->second);
  }
}

void Coordinator::close_ended_sweeps(Clock::time_point now) {
  for (auto it = sweeps_.begin(); it != sweeps_.end();) {
    OpenSweep& sweep = it->second;
    if (sweep.stored.state == storage::SweepState::deleting || sweep.stored.counts.ended() < sweep.stored.what.jobs) {
      ++it;
      continue;
    }
    const bool cancelled = sweep.stored.state == storage::SweepState::cancelling;
    sweep.stored.state = cancelled ? storage::SweepState::cancelled : storage::SweepState::finished;
    revoke(ledger_.close_sweep(it->first).revocations);
    spdlog::info("sweep {} is {}: {} done, {} failed, {} quarantined, {} cancelled", sweep.stored.what.name,
                 to_text(sweep.stored.state), sweep.stored.counts.done, sweep.stored.counts.failed,
                 sweep.stored.counts.quarantined, sweep.stored.counts.cancelled);
    journal_.event(cancelled ? "sweep_cancelled" : "sweep_finished", 0, sweep.stored.what.name, sweep.stored.row);
    sweep.rate.note(now, sweep.stored.counts.ended());
    if (auto result = progress_->write(progress(sweep)); !result) spdlog::debug("progress: {}", result.error);
    publish_specification(sweep.stored, it->first, false);
    to_stop_.erase(it->first);
    ended_sweeps_[it->first] = sweep.stored.row;
    it = sweeps_.erase(it);
  }
}

}  // namespace lamprey::coordinator
