// Results in, acknowledgements out: nothing is acknowledged before it is durable, and every result gets an answer.
#include "coordinator/coordinator.hpp"
#include "experiment/models.hpp"

#include <algorithm>
#include <spdlog/spdlog.h>
#include <utility>

namespace lamprey::coordinator {

namespace {

/// Acknowledgements in one sample: about 32 KB.
constexpr std::size_t answers_per_sample = 400;

constexpr const char* cancelled_job = "the job was cancelled";
constexpr const char* another_attempt = "another attempt is the job's row";
constexpr const char* another_attempt_kept = "another attempt is the job's row; this one is kept beside it";

/// Reasons with numbers in them are one kind for whoever counts.
std::string reason_class(const std::string& reason) {
  std::string text;
  for (const char c : reason) {
    const bool digit = c >= '0' && c <= '9';
    if (!digit || text.empty() || text.back() != 'N') text += digit ? 'N' : c;
  }
  constexpr std::size_t most = 100;
  return text.substr(0, most);
}

/// The jobs of a sweep that has ended; nothing if its specification is no longer valid.
std::shared_ptr<const experiment::SweepGrid> stored_grid(const std::optional<storage::Sweep>& sweep) {
  idl::SweepSpecification specification;
  if (!sweep || !specification.ParseFromString(sweep->what.specification)) return nullptr;
  try {
    return std::make_shared<const experiment::SweepGrid>(specification);
  } catch (const experiment::InvalidInput&) {
    return nullptr;
  }
}

std::optional<experiment::Job> job_of(const std::shared_ptr<const experiment::SweepGrid>& grid, std::uint64_t number) {
  if (grid == nullptr || number >= grid->jobs()) return std::nullopt;
  return grid->job(number);
}

/// What a robot recorded, for the next commit; whether it is kept. The result stands either way.
bool keep_recording(Journal& journal, const experiment::Job& job, std::int64_t sweep, const messaging::Origin& origin,
                    const messaging::JobResult& result, bool accepted) {
  if (result.recording.empty()) return false;
  auto judged = judge_recording(job, sweep, origin, result, accepted);
  if (judged.attempt) {
    journal.add(std::move(*judged.attempt), result.recording.size());
    return true;
  }
  spdlog::warn("the recording of worker {:016x} for job {} of the sweep with the key {} is dropped: {}", origin.worker,
               job.number, sweep, judged.refusal);
  journal.note_dropped_recording();
  return false;
}

}  // namespace

void Coordinator::take_results(Clock::time_point now) {
  // Bounded per step, so that heartbeats and requests are heard however many results are queued.
  for (auto& batch : results_->take(64)) {
    // Another database's results are another coordinator's business.
    if (batch.origin.database != journal_.store().database_id() || batch.origin.worker == 0) {
      counters_.results_ignored += batch.results.size();
      continue;
    }
    for (auto& fragment : batch.results) {
      if (auto whole = assembler_.add(batch.origin.worker, batch.sweep, std::move(fragment))) {
        take_result(batch.origin, batch.sweep, std::move(*whole), now);
      }
    }
  }
}

void Coordinator::take_result(const messaging::Origin& origin, const Id128& id, messaging::JobResult result,
                              Clock::time_point now) {
  if (const auto audit = audits_.find(id); audit != audits_.end()) {
    return take_audit_result(audit->second, origin, result, now);
  }
  const auto found = sweeps_.find(id);
  if (found == sweeps_.end()) {
    const auto ended = ended_sweeps_.find(id);
    if (ended == ended_sweeps_.end()) return refuse(origin, id, result, "this database has no such sweep", now);
    return answer_known(nullptr, ended->second, origin, id, result, now);
  }
  OpenSweep& sweep = found->second;
  if (journal_.staged(id, result.job) != nullptr || !ledger_.is_open(id, result.job)) {
    return answer_known(&sweep, sweep.stored.row, origin, id, result, now);
  }
  auto judgement = judge(sweep, origin, result);
  if (!judgement.row) return refuse(origin, id, result, judgement.refusal, now);
  judgement.row->attempt = ledger_.attempts(id, result.job) + 1;
  judgement.row->queue_seconds = ledger_.queue_seconds(id, result.job, result.lease);
  if (judgement.row->state == storage::JobState::failed) {
    spdlog::warn("job {} of sweep {} failed: {}", result.job, sweep.stored.what.name, result.reason);
  }
  const bool done = judgement.row->state == storage::JobState::done;
  keep_recording(journal_, sweep.grid->job(result.job), sweep.stored.row, origin, result, done);
  result.recording.clear();  // it has been weighed
  ++counters_.results_committed;
  answers_.push_back({origin.worker,
                      {id, result.job, result.digest, messaging::Verdict::committed, {}},
                      result.lease,
                      judgement.row->seconds});
  journal_.add(id, std::move(*judgement.row), messaging::wire_bytes(result), now);
}

/// The job has ended already, or its row is about to be written: the same digest again is a duplicate, another one is
/// never silently dropped. On a robot it is another attempt, which is kept beside the one that counts.
void Coordinator::answer_known(OpenSweep* sweep, std::int64_t row, const messaging::Origin& origin, const Id128& id,
                               const messaging::JobResult& result, Clock::time_point now) {
  std::optional<storage::ResultsStore::StoredJob> stored;
  if (const auto* staged = journal_.staged(id, result.job)) {
    stored = *staged;
  } else {
    stored = journal_.store().find_job(row, result.job);
  }
  // Of an open sweep, a job that is not open and has no row is one that is being cancelled.
  const bool waits_for_its_row = sweep != nullptr && result.job < sweep->stored.what.jobs;
  if (!stored && !waits_for_its_row) return refuse(origin, id, result, "the sweep has no such job", now);
  if (!stored || stored->state == storage::JobState::cancelled) {
    return refuse(origin, id, result, cancelled_job, now);
  }
  if (result.kind == messaging::ResultKind::done) {
    if (!stored->digest) return refuse(origin, id, result, "the job is stored as " + to_text(stored->state), now);
    // What is recorded as a divergence must at least be what it claims to be.
    if (origin.science_version != experiment::science_version) {
      return refuse(origin, id, result, "it was computed under another science version", now);
    }
    if (experiment::outcome_digest(result.identity, result.outcome) != result.digest) {
      return refuse(origin, id, result, "its digest is not that of its values", now);
    }
  }
  messaging::Acknowledgement answer{id, result.job, result.digest, messaging::Verdict::duplicate, {}};
  const bool differs = result.kind == messaging::ResultKind::done && *stored->digest != result.digest;
  std::optional<experiment::Job> job;
  if (differs || !result.recording.empty()) {
    job = job_of(sweep != nullptr ? sweep->grid : stored_grid(find_sweep(experiment::to_hex(id))), result.job);
  }
  const bool kept = job && keep_recording(journal_, *job, row, origin, result, false);
  if (job && experiment::on_a_robot(job->parameters)) {
    ++counters_.results_duplicate;
    const bool sent_again =
        stored->worker == origin.worker && stored->digest.value_or(experiment::Digest{}) == result.digest;
    if (!sent_again) answer.reason = kept ? another_attempt_kept : another_attempt;
  } else if (differs && !must_agree(sweep, id, result.job, stored->worker, origin.worker)) {
    answer.reason = "another digest is stored, of another build, with which it need not agree";
    spdlog::info("job {} of sweep {}: worker {:016x} has another digest than is stored, but also another build",
                 result.job, experiment::to_hex(id), origin.worker);
  } else if (differs) {
    const std::string name = sweep != nullptr ? sweep->stored.what.name : experiment::to_hex(id);
    answer_divergence(name, row, *stored->digest, origin, result, answer);
  } else {
    ++counters_.results_duplicate;
  }
  answers_.push_back({origin.worker, std::move(answer), result.lease, -1});
}

void Coordinator::answer_divergence(const std::string& sweep, std::int64_t row, const experiment::Digest& stored,
                                    const messaging::Origin& origin, const messaging::JobResult& result,
                                    messaging::Acknowledgement& answer) {
  answer.verdict = messaging::Verdict::divergent;
  answer.reason = "stored with digest " + experiment::to_hex(stored);
  spdlog::error("DIVERGENCE: job {} of sweep {} has digest {}, worker {:016x} computed {}", result.job, sweep,
                experiment::to_hex(stored), origin.worker, experiment::to_hex(result.digest));
  journal_.batch().divergences.push_back({row, result.job, stored, result.digest, origin.worker});
  journal_.event("divergence", origin.worker, answer.reason, row, result.job);
  ++counters_.results_divergent;
}

/// Whether two workers' digests of a job have to be the same: those of a bitwise repeatable one always, those of a job
/// that only the same build repeats if both are known to be of one, those of a robot never.
bool Coordinator::must_agree(const OpenSweep* sweep, const Id128& id, std::uint64_t job, std::uint64_t worker,
                             std::uint64_t other) const {
  using experiment::Repeatability;
  const auto grid = sweep != nullptr ? sweep->grid : stored_grid(find_sweep(experiment::to_hex(id)));
  if (grid == nullptr || job >= grid->jobs()) return true;
  const auto repeatability = experiment::repeatability(grid->job(job).parameters);
  if (repeatability != Repeatability::same_build) return repeatability == Repeatability::bitwise;
  const auto build = build_of(worker);
  return build && build == build_of(other);
}

std::optional<std::string> Coordinator::build_of(std::uint64_t worker) const {
  if (auto build = ledger_.build_of(worker)) return build;
  return journal_.store().build_of(worker);
}

void Coordinator::refuse(const messaging::Origin& origin, const Id128& id, const messaging::JobResult& result,
                         const std::string& reason, Clock::time_point now) {
  // Late results are what cancelling a sweep is about: no news.
  const auto level = reason == cancelled_job ? spdlog::level::debug : spdlog::level::warn;
  spdlog::log(level, "a result of worker {:016x} for job {} of sweep {} is refused: {}", origin.worker, result.job,
              experiment::to_hex(id), reason);
  ++counters_.results_refused[reason_class(reason)];
  auto reaction = ledger_.refused(id, result.job, origin.worker, reason);
  if (reaction.attempt) note(*reaction.attempt);
  if (reaction.quarantined) quarantine(*reaction.quarantined, now);
  if (reaction.farewell) {
    spdlog::error("worker {:016x} gets no more leases: {}", origin.worker, reaction.farewell->reason);
    journal_.event("worker_refused", origin.worker, reaction.farewell->reason);
    ++counters_.workers_refused;
    send(origin.worker, std::move(*reaction.farewell));
  }
  answers_.push_back(
      {origin.worker, {id, result.job, result.digest, messaging::Verdict::refused, reason}, result.lease, -1});
}

void Coordinator::acknowledge(const std::vector<StagedAnswer>& answers) {
  std::map<std::uint64_t, messaging::ResultAcknowledgement> samples;
  // Only whom a heartbeat has introduced gets a writer; others send again, after theirs.
  const auto flush = [&](std::uint64_t worker, messaging::ResultAcknowledgement& sample) {
    if (!ledger_.knows(worker)) return sample.results.clear();
    sample.origin = origin(worker);
    acknowledgements_.write(worker, sample);
    sample.results.clear();
  };
  for (const auto& answer : answers) {
    auto& sample = samples[answer.worker];
    sample.results.push_back(answer.acknowledgement);
    if (sample.results.size() >= answers_per_sample) flush(answer.worker, sample);
  }
  for (auto& [worker, sample] : samples) {
    if (!sample.results.empty()) flush(worker, sample);
  }
}

void Coordinator::take_checkpoints() {
  for (auto& checkpoint : checkpoints_->take()) {
    if (checkpoint.origin.database != journal_.store().database_id() || checkpoint.origin.worker == 0) continue;
    take_checkpoint(std::move(checkpoint));
  }
}

/// Of a job that has no row yet, from whoever sends it: what is in it is checked, and by determinism all of a job lead
/// to the same outcome.
void Coordinator::take_checkpoint(messaging::Checkpoint checkpoint) {
  const auto sweep = sweeps_.find(checkpoint.sweep);
  if (sweep == sweeps_.end() || !ledger_.is_open(checkpoint.sweep, checkpoint.job)) return;
  if (journal_.staged(checkpoint.sweep, checkpoint.job) != nullptr) return;
  if (const auto fault = checkpoint_fault(sweep->second, checkpoint); !fault.empty()) {
    ++counters_.checkpoints_refused;
    spdlog::warn("a checkpoint of worker {:016x} for job {} of sweep {} is refused: {}", checkpoint.origin.worker,
                 checkpoint.job, sweep->second.stored.what.name, fault);
    return;
  }
  ++counters_.checkpoints_stored;
  ledger_.note_checkpoint(checkpoint.sweep, checkpoint.job);
  journal_.batch().checkpoints.push_back({.sweep = sweep->second.stored.row,
                                          .job = checkpoint.job,
                                          .worker = checkpoint.origin.worker,
                                          .cycle = checkpoint.cycle,
                                          .seconds = checkpoint.seconds,
                                          .state = {checkpoint.state.begin(), checkpoint.state.end()}});
}

}  // namespace lamprey::coordinator
