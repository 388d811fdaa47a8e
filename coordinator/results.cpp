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

}  // namespace

void Coordinator::take_results(Clock::time_point now) {
  // Bounded per step, so that heartbeats and requests are heard however many results are queued.
  for (auto& batch : results_->take(64)) {
    // Another database's results are another coordinator's business.
    if (batch.origin.database != store_.database_id() || batch.origin.worker == 0) continue;
    if (batch_.empty() && answers_.empty()) staged_since_ = now;
    for (auto& fragment : batch.results) {
      if (auto whole = assembler_.add(batch.origin.worker, batch.sweep, std::move(fragment))) {
        take_result(batch.origin, batch.sweep, std::move(*whole));
      }
    }
  }
}

void Coordinator::take_result(const messaging::Origin& origin, const Id128& id, messaging::JobResult result) {
  const auto found = sweeps_.find(id);
  if (found == sweeps_.end()) {
    const auto ended = ended_sweeps_.find(id);
    if (ended == ended_sweeps_.end()) return refuse(origin, id, result, "this database has no such sweep");
    return answer_known(nullptr, ended->second, origin, id, result);
  }
  OpenSweep& sweep = found->second;
  const auto staged = staged_.find({id, result.job});
  if (staged != staged_.end() || !ledger_.is_open(id, result.job)) {
    return answer_known(&sweep, sweep.stored.row, origin, id, result);
  }
  auto judgement = judge(sweep, origin, result);
  if (!judgement.row) return refuse(origin, id, result, judgement.refusal);
  judgement.row->attempt = ledger_.attempts(id, result.job) + 1;
  staged_bytes_ += messaging::wire_bytes(result);
  staged_.emplace(std::pair(id, result.job),
                  storage::ResultsStore::StoredJob{judgement.row->state, judgement.row->digest, origin.worker});
  if (judgement.row->state == storage::JobState::failed) {
    spdlog::warn("job {} of sweep {} failed: {}", result.job, sweep.stored.what.name, result.reason);
  }
  batch_.jobs.push_back(std::move(*judgement.row));
  answers_.push_back({origin.worker,
                      {id, result.job, result.digest, messaging::Verdict::committed, {}},
                      result.lease,
                      batch_.jobs.back().seconds});
}

/// The job has ended already, or its row is about to be written: the same digest again is a duplicate, another one is
/// never silently dropped.
void Coordinator::answer_known(OpenSweep* sweep, std::int64_t row, const messaging::Origin& origin, const Id128& id,
                               const messaging::JobResult& result) {
  std::optional<storage::ResultsStore::StoredJob> stored;
  if (const auto staged = staged_.find({id, result.job}); staged != staged_.end()) {
    stored = staged->second;
  } else {
    stored = store_.find_job(row, result.job);
  }
  // Of an open sweep, a job that is not open and has no row is one that is being cancelled.
  const bool waits_for_its_row = sweep != nullptr && result.job < sweep->stored.what.jobs;
  if (!stored && !waits_for_its_row) return refuse(origin, id, result, "the sweep has no such job");
  if (!stored || stored->state == storage::JobState::cancelled) {
    return refuse(origin, id, result, cancelled_job);
  }
  if (result.kind == messaging::ResultKind::done) {
    if (!stored->digest) return refuse(origin, id, result, "the job is stored as " + to_text(stored->state));
    // What is recorded as a divergence must at least be what it claims to be.
    if (origin.science_version != experiment::science_version) {
      return refuse(origin, id, result, "it was computed under another science version");
    }
    if (experiment::outcome_digest(result.identity, result.outcome) != result.digest) {
      return refuse(origin, id, result, "its digest is not that of its values");
    }
  }
  messaging::Acknowledgement answer{id, result.job, result.digest, messaging::Verdict::duplicate, {}};
  const bool differs = result.kind == messaging::ResultKind::done && *stored->digest != result.digest;
  if (differs && !must_agree(sweep, id, result.job, stored->worker, origin.worker)) {
    answer.reason = "another digest is stored, of another build, with which it need not agree";
    spdlog::info("job {} of sweep {}: worker {:016x} has another digest than is stored, but also another build",
                 result.job, experiment::to_hex(id), origin.worker);
  } else if (differs) {
    answer.verdict = messaging::Verdict::divergent;
    answer.reason = "stored with digest " + experiment::to_hex(*stored->digest);
    spdlog::error("DIVERGENCE: job {} of sweep {} has digest {}, worker {:016x} computed {}", result.job,
                  sweep != nullptr ? sweep->stored.what.name : experiment::to_hex(id),
                  experiment::to_hex(*stored->digest), origin.worker, experiment::to_hex(result.digest));
    batch_.divergences.push_back({row, result.job, *stored->digest, result.digest, origin.worker});
    event("divergence", origin.worker, answer.reason, row, result.job);
  }
  answers_.push_back({origin.worker, std::move(answer), result.lease, -1});
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
  return store_.build_of(worker);
}

void Coordinator::refuse(const messaging::Origin& origin, const Id128& id, const messaging::JobResult& result,
                         const std::string& reason) {
  // Late results are what cancelling a sweep is about: no news.
  const auto level = reason == cancelled_job ? spdlog::level::debug : spdlog::level::warn;
  spdlog::log(level, "a result of worker {:016x} for job {} of sweep {} is refused: {}", origin.worker, result.job,
              experiment::to_hex(id), reason);
  auto reaction = ledger_.refused(id, result.job, origin.worker, reason);
  if (reaction.quarantined) quarantine(*reaction.quarantined);
  if (reaction.farewell) {
    spdlog::error("worker {:016x} gets no more leases: {}", origin.worker, reaction.farewell->reason);
    event("worker_refused", origin.worker, reaction.farewell->reason);
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

}  // namespace lamprey::coordinator
