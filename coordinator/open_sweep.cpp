#include "coordinator/open_sweep.hpp"

#include "experiment/checkpoint.hpp"
#include "experiment/job.hpp"
#include "experiment/models.hpp"

#include <array>
#include <cmath>

namespace lamprey::coordinator {

namespace {

constexpr auto rate_window = std::chrono::seconds{10};

/// More measures are nothing a worker of ours sends: one per accepted change, up to three per change of the environment
/// or the gait, which is one per cycle at most, and some of the whole run.
constexpr std::uint64_t measures_per_cycle = 4;
constexpr std::uint64_t other_measures = 64;

bool finite(const experiment::Score& score) {
  return std::isfinite(score.stability) && std::isfinite(score.distance) && std::isfinite(score.fuel) &&
         std::isfinite(score.total);
}

std::string outcome_fault(const experiment::Outcome& outcome, std::int64_t cycles) {
  for (const auto* score : {&outcome.expected, &outcome.initial, &outcome.evolved, &outcome.highest, &outcome.final}) {
    if (!finite(*score)) return "a score is not a finite number";
  }
  if (!std::isfinite(outcome.success_rate)) return "the success rate is not a finite number";
  if (outcome.cycles != cycles) {
    return "it ran " + std::to_string(outcome.cycles) + " cycles instead of " + std::to_string(cycles);
  }
  if (outcome.accepted != outcome.trace.size()) {
    return "its trace has " + std::to_string(outcome.trace.size()) + " rows for " + std::to_string(outcome.accepted) +
           " accepted changes";
  }
  std::int64_t previous = -1;
  for (const auto& change : outcome.trace) {
    if (!finite(change.score)) return "a score of its trace is not a finite number";
    if (change.cycle <= previous || change.cycle >= cycles) return "the cycles of its trace are out of order or range";
    previous = change.cycle;
  }
  const std::uint64_t most_measures = other_measures + measures_per_cycle * static_cast<std::uint64_t>(cycles);
  if (outcome.measures.size() > most_measures) {
    return "it has " + std::to_string(outcome.measures.size()) + " measures, at most " + std::to_string(most_measures) +
           " are possible";
  }
  return experiment::measures_fault(outcome.measures);
}

/// Of a clock that is not ours.
double sane_seconds(double seconds) {
  return std::isfinite(seconds) && seconds >= 0 ? seconds : 0;
}

storage::EndedJob head(const OpenSweep& sweep, const experiment::Job& job) {
  storage::EndedJob row;
  row.sweep = sweep.stored.row;
  row.job = job.number;
  row.identity = experiment::identity(job);
  row.parameters = experiment::to_json(job.parameters);
  row.seed = job.seed;
  row.replicate = job.replicate;
  return row;
}

}  // namespace

void EndRate::note(Clock::time_point now, std::uint64_t ended) {
  history_.emplace_back(now, ended);
  while (history_.size() > 2 && now - history_.front().first > rate_window) history_.pop_front();
}

double EndRate::per_second() const {
  if (history_.size() < 2) return 0;
  const double seconds = std::chrono::duration<double>(history_.back().first - history_.front().first).count();
  return seconds > 0 ? static_cast<double>(history_.back().second - history_.front().second) / seconds : 0;
}

Judgement judge(const OpenSweep& sweep, const messaging::Origin& origin, const messaging::JobResult& result) {
  const auto refuse = [](std::string why) { return Judgement{std::nullopt, std::move(why)}; };
  if (origin.science_version != sweep.stored.science_version) {
    return refuse("it was computed under science version " + std::to_string(origin.science_version));
  }
  if (result.job >= sweep.stored.what.jobs) return refuse("the sweep has no such job");
  const experiment::Job job = sweep.grid->job(result.job);
  storage::EndedJob row = head(sweep, job);
  if (result.identity != row.identity) return refuse("its identity is not that of the job");
  row.worker = origin.worker;
  row.seconds = sane_seconds(result.seconds);
  row.waited_seconds = sane_seconds(result.waited);
  if (result.kind == messaging::ResultKind::failed) {
    row.state = storage::JobState::failed;
    row.reason = result.reason;
    return {std::move(row), {}};
  }
  if (auto fault = outcome_fault(result.outcome, job.parameters.integer("cycles")); !fault.empty()) {
    return refuse(std::move(fault));
  }
  if (experiment::outcome_digest(*row.identity, result.outcome) != result.digest) {
    return refuse("its digest is not that of its values");
  }
  row.state = storage::JobState::done;
  row.digest = result.digest;
  row.outcome = result.outcome;
  return {std::move(row), {}};
}

JudgedRecording judge_recording(const experiment::Job& job, std::int64_t sweep, const messaging::Origin& origin,
                                const messaging::JobResult& result, bool accepted) {
  if (!experiment::on_a_robot(job.parameters)) return {std::nullopt, "the job is not on a robot"};
  if (result.identity != experiment::identity(job)) return {std::nullopt, "its result's identity is not the job's"};
  auto parsed = storage::parse_recording(result.recording);
  if (!parsed.recording) return {std::nullopt, std::move(parsed.refusal)};
  const bool done = result.kind == messaging::ResultKind::done;
  return {storage::RecordedAttempt{.sweep = sweep,
                                   .job = job.number,
                                   .worker = origin.worker,
                                   .state = done ? storage::JobState::done : storage::JobState::failed,
                                   .accepted = accepted,
                                   .recording = std::move(*parsed.recording)},
          {}};
}

SweepPolicy policy_of(const idl::Execution& execution, const experiment::SweepGrid& grid) {
  return {.priority = execution.priority(),
          .max_concurrent = execution.max_concurrent(),
          .time_limit = execution.time_limit(),
          // Who wants to fail fast wants no second chances either.
          .attempts = execution.fail_fast() ? 1 : execution.attempts(),
          .needs = {execution.needs().begin(), execution.needs().end()},
          .needs_robot = grid.asks_for_robot()};
}

std::string checkpoint_fault(const OpenSweep& sweep, const messaging::Checkpoint& checkpoint) {
  if (checkpoint.origin.science_version != sweep.stored.science_version) return "of another science version";
  if (checkpoint.job >= sweep.stored.what.jobs) return "of no job of the sweep";
  const experiment::Job job = sweep.grid->job(checkpoint.job);
  try {
    const auto head = experiment::read_checkpoint_head(checkpoint.state);
    if (head.identity != experiment::identity(job)) return "of another job";
    if (head.cycle > job.parameters.integer("cycles")) return "beyond the job's last cycle";
    if (head.cycle != checkpoint.cycle) return "its cycle is not that of its state";
  } catch (const experiment::CheckpointError& error) {
    return error.what();
  }
  return {};
}

storage::EndedJob quarantined_row(const OpenSweep& sweep, std::uint64_t job, std::uint32_t attempts,
                                  std::uint64_t worker, const std::string& reason) {
  storage::EndedJob row = head(sweep, sweep.grid->job(job));
  row.state = storage::JobState::quarantined;
  row.attempt = attempts;
  row.worker = worker;
  row.reason = reason;
  return row;
}

}  // namespace lamprey::coordinator
