#include "storage/batch_writer.hpp"

#include "storage/job_row.hpp"
#include "storage/schema.hpp"
#include "storage/trace_text.hpp"

#include <algorithm>
#include <cmath>

namespace lamprey::storage {

namespace {

/// More memory than this isn't kept for the next trace or the next measures.
constexpr std::size_t kept_text_bytes = 1 << 20;

std::string insert_job_sql() {
  const std::string columns = job_columns();
  const auto count = 2 + std::ranges::count(columns, ',');  // ended is one more
  std::string sql = "INSERT INTO job (" + columns + ", ended) VALUES (?";
  for (auto i = count; i > 1; --i) sql += ", ?";
  return sql + ")";
}

std::optional<std::string_view> unless_empty(const std::string& text) {
  return text.empty() ? std::nullopt : std::optional<std::string_view>(text);
}

std::optional<std::uint64_t> unless_zero(std::uint64_t worker) {
  return worker == 0 ? std::nullopt : std::optional(worker);
}

std::uint64_t& counter(JobCounts& counts, JobState state) {
  switch (state) {
    case JobState::done:
      return counts.done;
    case JobState::failed:
      return counts.failed;
    case JobState::quarantined:
      return counts.quarantined;
    case JobState::cancelled:
      return counts.cancelled;
  }
  throw std::logic_error("a job state without a counter");
}

bool is_finite(const experiment::Score& score) {
  return std::ranges::all_of(score_parts(), [&](const ScorePart& part) { return std::isfinite(score.*part.member); });
}

bool is_finite(const experiment::Outcome& outcome) {
  return std::isfinite(outcome.success_rate) &&
         std::ranges::all_of(job_scores(), [&](const JobScore& score) { return is_finite(outcome.*score.member); }) &&
         std::ranges::all_of(outcome.trace, [](const auto& change) { return is_finite(change.score); });
}

}  // namespace

BatchWriter::BatchWriter(const Connection& connection, std::uint64_t epoch)
    : connection_(connection),
      epoch_(epoch),
      upsert_worker_(connection,
                     "INSERT INTO worker (worker, host, process, threads, build, dds, flags, processor, "
                     "instruction_set, labels, first_seen, last_seen) "
                     "VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11, ?11) ON CONFLICT (worker) DO UPDATE SET "
                     "host = ?2, process = ?3, threads = ?4, build = ?5, dds = ?6, flags = ?7, processor = ?8, "
                     "instruction_set = ?9, labels = ?10, last_seen = ?11"),
      insert_job_(connection, insert_job_sql()),
      insert_divergence_(connection, "INSERT INTO divergence VALUES (NULL, ?, ?, ?, ?, ?, ?)"),
      insert_event_(connection, "INSERT INTO event VALUES (NULL, ?, ?, ?, ?, ?, ?, ?)"),
      insert_attempt_(connection, "INSERT INTO attempt VALUES (NULL, ?, ?, ?, ?, ?, ?, ?)"),
      upsert_checkpoint_(connection,
                         "INSERT INTO checkpoint SELECT ?1, ?2, ?3, ?4, ?5, ?6, ?7 "
                         "WHERE NOT EXISTS (SELECT 1 FROM job WHERE sweep = ?1 AND job = ?2) "
                         "ON CONFLICT (sweep, job) DO UPDATE SET "
                         "at = ?3, worker = ?4, cycle = ?5, seconds = ?6, state = ?7"),
      delete_checkpoint_(connection, "DELETE FROM checkpoint WHERE sweep = ? AND job = ?"),
      insert_audited_(connection, "INSERT INTO audit_job VALUES (?, ?, ?, ?, ?, ?) ON CONFLICT DO NOTHING"),
      // Whose sweep it counts for, and whether another audit has computed the same job before.
      count_audited_(connection,
                     "UPDATE audit SET agreed = agreed + ?3, diverged = diverged + NOT ?3 WHERE audit = ?1 "
                     "RETURNING sweep, EXISTS (SELECT 1 FROM audit AS o JOIN audit_job AS j ON j.audit = o.audit "
                     "WHERE o.sweep = audit.sweep AND o.audit <> ?1 AND j.job = ?2)"),
      // Finished and cancelled are final, but for being deleted; a sweep that is being cancelled goes no other way.
      change_state_(connection,
                    "UPDATE sweep SET state = ?2, ended = CASE WHEN ?2 IN ('finished', 'cancelled') THEN ?3 "
                    "WHEN ?2 = 'deleting' THEN ended END, "
                    "reason = CASE WHEN ?4 IS NULL AND (state = ?2 OR ?2 IN ('cancelled', 'deleting')) THEN reason "
                    "ELSE ?4 END WHERE sweep = ?1 AND CASE state WHEN 'running' THEN ?2 <> 'deleting' "
                    "WHEN 'paused' THEN ?2 <> 'deleting' WHEN 'cancelling' THEN ?2 IN ('cancelling', 'cancelled') "
                    "WHEN 'deleting' THEN 0 ELSE ?2 = 'deleting' END"),
      add_counts_(connection,
                  "UPDATE sweep SET done = done + ?2, failed = failed + ?3, quarantined = quarantined + ?4, "
                  "cancelled = cancelled + ?5, divergences = divergences + ?6, reused = reused + ?8, "
                  "audited = audited + ?9, "
                  "last_result = CASE WHEN ?2 + ?3 + ?4 + ?5 > 0 THEN ?7 ELSE last_result END WHERE sweep = ?1"),
      finish_(connection,
              "UPDATE sweep SET state = CASE state WHEN 'cancelling' THEN 'cancelled' ELSE 'finished' END, ended = ?2, "
              "reason = CASE state WHEN 'paused' THEN NULL ELSE reason END "
              "WHERE sweep = ?1 AND state IN ('running', 'paused', 'cancelling') "
              "AND done + failed + quarantined + cancelled = jobs"),
      recordings_(connection) {
  Statement stored(connection, "SELECT sweep, job FROM checkpoint");
  while (stored.step()) checkpointed_.emplace(stored.integer(0), stored.bits(1));
}

void BatchWriter::write(const Batch& batch) {
  now_ = unix_milliseconds();
  for (const auto& worker : batch.workers) write(worker);
  Increases increases;
  for (const auto& job : batch.jobs) write(job, increases);
  for (const auto& divergence : batch.divergences) write(divergence, increases);
  for (const auto& attempt : batch.attempts) write(attempt);
  for (const auto& checkpoint : batch.checkpoints) write(checkpoint);
  for (const auto& job : batch.audited) write(job, increases);
  for (const auto& attempt : batch.recordings) recordings_.write(attempt, now_);
  for (const auto& event : batch.events) insert(event);
  for (const auto& change : batch.states) {
    write(change);
    increases.try_emplace(change.sweep);  // nothing may be left to do for it
  }
  for (const auto& [sweep, increase] : increases) update_sweep(sweep, increase);
}

void BatchWriter::write(const Worker& worker) {
  upsert_worker_
      .with(worker.incarnation, std::string_view(worker.host), worker.process, worker.threads,
            std::string_view(worker.build), std::string_view(worker.dds), std::string_view(worker.flags),
            std::string_view(worker.processor), std::string_view(worker.instruction_set),
            std::string_view(worker.labels), now_)
      .run();
}

void BatchWriter::write(const EndedJob& job, Increases& increases) {
  const auto refuse = [&](const std::string& why) {
    throw StorageError(StorageError::Kind::input_output, connection_.path() + ": sweep " + std::to_string(job.sweep) +
                                                             ", job " + std::to_string(job.job) + ": " + why);
  };
  if (job.outcome && !is_finite(*job.outcome)) refuse("a score is not finite");
  if (job.outcome) {
    if (const auto fault = experiment::measures_fault(job.outcome->measures); !fault.empty()) refuse(fault);
  }
  if (job.reused_from && job.state != JobState::done) refuse("it has no outcome that could be another job's");

  insert_job_.reset();  // a binding that failed would leave those before it
  int index = 0;
  const auto next = [&](const auto& value) { insert_job_.bind(++index, value); };
  const std::string state = to_text(job.state);
  const bool has_parameters = !job.parameters.empty();
  next(job.sweep);
  next(job.job);
  next(std::string_view(state));
  next(job.identity);
  next(job.digest);
  next(job.attempt);
  next(unless_zero(job.worker));
  next(job.seconds);
  next(unless_empty(job.reason));
  next(has_parameters ? std::optional(job.seed) : std::nullopt);
  next(has_parameters ? std::optional(job.replicate) : std::nullopt);
  next(unless_empty(job.parameters));
  if (job.outcome) {
    const auto& outcome = *job.outcome;
    for (const auto& score : job_scores()) {
      for (const auto& part : score_parts()) next(outcome.*score.member.*part.member);
    }
    next(outcome.cycles);
    next(outcome.accepted);
    next(outcome.successes);
    next(outcome.success_rate);
    write_trace(outcome.trace, trace_text_);
    next(std::string_view(trace_text_));
    write_measures(outcome.measures, measures_text_);
    next(outcome.measures.empty() ? std::nullopt : std::optional<std::string_view>(measures_text_));
  } else {
    index += static_cast<int>(job_scores().size() * score_parts().size()) + 6;  // unbound is NULL
  }
  const bool computed = job.worker != 0 && !job.reused_from;
  for (const double seconds : {job.queue_seconds, job.waited_seconds, job.commit_seconds}) {
    next(computed ? std::optional(seconds) : std::nullopt);
  }
  next(job.reused_from ? std::optional(job.reused_from->sweep) : std::nullopt);
  next(job.reused_from ? std::optional(job.reused_from->job) : std::nullopt);
  next(now_);
  try {
    insert_job_.run();
  } catch (const StorageError& error) {
    throw StorageError(error.kind(), std::string(error.what()) + " (sweep " + std::to_string(job.sweep) + ", job " +
                                         std::to_string(job.job) + ")");
  }
  for (auto* text : {&trace_text_, &measures_text_}) {
    if (text->capacity() > kept_text_bytes) std::string().swap(*text);
  }
  delete_checkpoint(job.sweep, job.job);
  auto& increase = increases[job.sweep];
  ++counter(increase.counts, job.state);
  if (job.reused_from) ++increase.reused;
}

void BatchWriter::delete_checkpoint(std::int64_t sweep, std::uint64_t job) {
  // Its number stays in the set: the transaction may yet be rolled back.
  if (checkpointed_.contains({sweep, job})) delete_checkpoint_.with(sweep, job).run();
}

void BatchWriter::write(const Divergence& divergence, Increases& increases) {
  insert_divergence_
      .with(now_, divergence.sweep, divergence.job, std::span<const std::uint8_t>(divergence.stored),
            std::span<const std::uint8_t>(divergence.other), unless_zero(divergence.worker))
      .run();
  ++increases[divergence.sweep].divergences;
}

void BatchWriter::write(const Attempt& attempt) {
  insert_attempt_
      .with(now_, attempt.sweep, attempt.job, unless_zero(attempt.worker), std::string_view(attempt.end),
            attempt.counted, std::string_view(attempt.reason))
      .run();
}

void BatchWriter::write(const Checkpoint& checkpoint) {
  const std::span state(reinterpret_cast<const std::uint8_t*>(checkpoint.state.data()), checkpoint.state.size());
  upsert_checkpoint_
      .with(checkpoint.sweep, checkpoint.job, now_, unless_zero(checkpoint.worker), checkpoint.cycle,
            checkpoint.seconds, state)
      .run();
  checkpointed_.emplace(checkpoint.sweep, checkpoint.job);
}

void BatchWriter::write(const AuditedJob& job, Increases& increases) {
  insert_audited_
      .with(job.audit, job.job, now_, unless_zero(job.worker), std::span<const std::uint8_t>(job.digest), job.agreed)
      .run();
  if (sqlite3_changes(connection_.handle()) == 0) return;  // the audit has it already
  count_audited_.with(job.audit, job.job, job.agreed);
  if (count_audited_.step() && count_audited_.integer(1) == 0) ++increases[count_audited_.integer(0)].audited;
  count_audited_.run();
}

void BatchWriter::write(const Event& event) {
  now_ = unix_milliseconds();
  insert(event);
}

void BatchWriter::insert(const Event& event) {
  insert_event_
      .with(now_, epoch_, std::string_view(event.kind), event.sweep, event.job, unless_zero(event.worker),
            std::string_view(event.text))
      .run();
}

void BatchWriter::write(const Batch::StateChange& change) {
  const std::string state = to_text(change.state);
  change_state_.with(change.sweep, std::string_view(state), now_, unless_empty(change.reason)).run();
}

void BatchWriter::update_sweep(std::int64_t sweep, const Increase& increase) {
  const auto& counts = increase.counts;
  add_counts_
      .with(sweep, counts.done, counts.failed, counts.quarantined, counts.cancelled, increase.divergences, now_,
            increase.reused, increase.audited)
      .run();
  finish_.with(sweep, now_).run();
}

}  // namespace lamprey::storage
