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
  const auto count = 2 + std::ranges::count(columns, ',');
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
                     "INSERT INTO worker VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?7) ON CONFLICT (worker) DO UPDATE SET "
                     "host = ?2, process = ?3, threads = ?4, build = ?5, dds = ?6, last_seen = ?7"),
      insert_job_(connection, insert_job_sql()),
      insert_divergence_(connection, "INSERT INTO divergence VALUES (NULL, ?, ?, ?, ?, ?, ?)"),
      insert_event_(connection, "INSERT INTO event VALUES (NULL, ?, ?, ?, ?, ?, ?, ?)"),
      // Finished and cancelled are final.
      change_state_(connection,
                    "UPDATE sweep SET state = ?2, ended = CASE WHEN ?2 IN ('finished', 'cancelled') THEN ?3 END "
                    "WHERE sweep = ?1 AND state IN ('running', 'cancelling')"),
      add_counts_(connection,
                  "UPDATE sweep SET done = done + ?2, failed = failed + ?3, quarantined = quarantined + ?4, "
                  "cancelled = cancelled + ?5, divergences = divergences + ?6, "
                  "last_result = CASE WHEN ?2 + ?3 + ?4 + ?5 > 0 THEN ?7 ELSE last_result END WHERE sweep = ?1"),
      finish_(connection,
              "UPDATE sweep SET state = CASE state WHEN 'cancelling' THEN 'cancelled' ELSE 'finished' END, ended = ?2 "
              "WHERE sweep = ?1 AND state IN ('running', 'cancelling') "
              "AND done + failed + quarantined + cancelled = jobs") {}

void BatchWriter::write(const Batch& batch) {
  now_ = unix_milliseconds();
  for (const auto& worker : batch.workers) write(worker);
  Increases increases;
  for (const auto& job : batch.jobs) write(job, increases);
  for (const auto& divergence : batch.divergences) write(divergence, increases);
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
            std::string_view(worker.build), std::string_view(worker.dds), now_)
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
  ++counter(increases[job.sweep].counts, job.state);
}

void BatchWriter::write(const Divergence& divergence, Increases& increases) {
  insert_divergence_
      .with(now_, divergence.sweep, divergence.job, std::span<const std::uint8_t>(divergence.stored),
            std::span<const std::uint8_t>(divergence.other), unless_zero(divergence.worker))
      .run();
  ++increases[divergence.sweep].divergences;
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
  change_state_.with(change.sweep, std::string_view(state), now_).run();
}

void BatchWriter::update_sweep(std::int64_t sweep, const Increase& increase) {
  const auto& counts = increase.counts;
  add_counts_.with(sweep, counts.done, counts.failed, counts.quarantined, counts.cancelled, increase.divergences, now_)
      .run();
  finish_.with(sweep, now_).run();
}

}  // namespace lamprey::storage
