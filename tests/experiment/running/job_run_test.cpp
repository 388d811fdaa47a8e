#include "experiment/job_run.hpp"

#include "tests/experiment/running/jobs.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace lamprey::experiment {
namespace {

TEST(EvaluatePreset, TheWalkScoresEightySixtyEightyThree) {
  EXPECT_EQ(evaluate_preset(Parameters()), (Score{.stability = 80, .distance = 60, .fuel = 83, .total = 223}));
}

TEST(EvaluatePreset, MeanTotalOverTheGridIsThePublishedOne) {
  double sum = 0;
  for (const std::int64_t s : {25, 50, 75, 100}) {
    for (const std::int64_t d : {25, 50, 75, 100}) {
      for (const std::int64_t f : {25, 50, 75, 100}) {
        sum += evaluate_preset(
                   parameters_with({{"required_stability", s}, {"required_distance", d}, {"required_fuel", f}}))
                   .total;
      }
    }
  }
  EXPECT_EQ(sum / 64, 139.375);  // 8.3.2
}

/// Jobs that accept, reject and wander; short.
std::vector<Job> various_jobs() {
  std::vector<Job> jobs;
  for (const char* steps : {"uniform", "normal", "one_fifth_rule"}) {
    for (const char* acceptance : {"simple", "annealing"}) {
      for (const char* posture : {"reset", "carry"}) {
        jobs.push_back(job_with({{"steps", text(steps)},
                                 {"acceptance", text(acceptance)},
                                 {"posture", text(posture)},
                                 {"cycles", whole(150)},
                                 {"temperature", 5.0},
                                 {"required_distance", whole(50)}}));
      }
    }
  }
  return jobs;
}

double error_of(const Outcome& outcome, const Score& score) {
  return std::fabs(outcome.expected.stability - score.stability) +
         0.5 * std::fabs(outcome.expected.distance - score.distance) + std::fabs(outcome.expected.fuel - score.fuel);
}

TEST(RunJob, AnOutcomeAgreesWithItsTrace) {
  for (const Job& job : various_jobs()) {
    const Outcome outcome = outcome_of(job);
    EXPECT_EQ(outcome.expected, (Score{80, 60, 83, 193}));
    EXPECT_EQ(outcome.cycles, 150U);
    EXPECT_EQ(outcome.accepted, outcome.trace.size());
    EXPECT_LE(outcome.successes, outcome.accepted);
    EXPECT_EQ(outcome.success_rate, outcome.successes / 150.0);
    EXPECT_EQ(outcome.final, outcome.trace.empty() ? outcome.initial : outcome.trace.back().score);

    Score highest = outcome.initial;
    Score evolved = outcome.initial;
    std::int64_t last_cycle = -1;
    for (const auto& [cycle, score] : outcome.trace) {
      EXPECT_GT(cycle, last_cycle);
      EXPECT_LT(cycle, 150U);
      last_cycle = cycle;
      EXPECT_EQ(score.total, score.stability + 0.5 * score.distance + score.fuel);
      if (score.total > highest.total) highest = score;
      if (error_of(outcome, score) < error_of(outcome, evolved)) evolved = score;
    }
    EXPECT_EQ(outcome.highest, highest);
    EXPECT_EQ(outcome.evolved, evolved);
  }
}

TEST(RunJob, SimpleAcceptancePerComponentNeverMovesAwayFromTheExpectedFitness) {
  for (const char* steps : {"uniform", "normal", "one_fifth_rule"}) {
    const Outcome outcome = outcome_of(job_with({{"steps", text(steps)}, {"cycles", whole(400)}}));
    Score last = outcome.initial;
    for (const auto& change : outcome.trace) {
      for (double Score::*part : {&Score::stability, &Score::distance, &Score::fuel}) {
        EXPECT_LE(std::fabs(outcome.expected.*part - change.score.*part),
                  std::fabs(outcome.expected.*part - last.*part));
      }
      last = change.score;
    }
    EXPECT_EQ(outcome.evolved.total, outcome.final.total);
  }
}

TEST(RunJob, WithoutDisturbanceAndStepsTheGaitStaysAsItIs) {
  for (const char* posture : {"reset", "carry"}) {
    const Outcome outcome = outcome_of(job_with({{"equilibrium_disturbance", whole(0)},
                                                 {"mutation_size", whole(0)},
                                                 {"posture", text(posture)},
                                                 {"cycles", whole(20)}}));
    EXPECT_EQ(outcome.initial, outcome.expected);
    EXPECT_EQ(outcome.final, outcome.expected);
    EXPECT_EQ(outcome.accepted, 20U) << "neutral moves are kept";
    EXPECT_EQ(outcome.successes, 0U);
  }
}

TEST(RunJob, CarryWalksOnFromWhereTheLastEvaluationEnded) {
  // Of the undisturbed walk in halves of 50 steps, every even half is the first and every odd half the second one. The
  // first is expected; under `carry` the second is tried instead and, unlike it, not accepted; then the first again.
  const std::initializer_list<Setting> settings{{"equilibrium_disturbance", whole(0)},
                                                {"mutation_size", whole(0)},
                                                {"posture", text("carry")},
                                                {"time_steps", whole(50)},
                                                {"cycles", whole(6)}};
  const Outcome outcome = outcome_of(job_with(settings));
  EXPECT_EQ(outcome.expected, (Score{100, 0, 90, 190}));
  std::vector<std::uint32_t> accepted;
  for (const auto& change : outcome.trace) accepted.push_back(change.cycle);
  EXPECT_EQ(accepted, (std::vector<std::uint32_t>{1, 3, 5}));
}

TEST(RunJob, ParametersThatDoNotApplyChangeNeitherIdentityNorOutcome) {
  const std::vector<std::pair<Job, Setting>> cases{
      {job_with({{"cycles", whole(100)}}), {"temperature", 50.0}},
      {job_with({{"cycles", whole(100)}}), {"cooling", 0.5}},
      {job_with({{"cycles", whole(100)}}), {"step_variance", text("root_error")}},
      {job_with({{"cycles", whole(100)}}), {"first_standard_deviation", 1.0}},
      {job_with({{"cycles", whole(100)}, {"steps", text("one_fifth_rule")}}), {"mutation_size", whole(100)}},
      {job_with({{"cycles", whole(100)}, {"mutation", text("some")}}), {"system_disturbance", whole(25)}}};
  for (const auto& [job, setting] : cases) {
    Job other = job;
    other.parameters.set(setting.first, setting.second);
    EXPECT_EQ(identity(other), identity(job)) << setting.first;
    EXPECT_EQ(outcome_of(other), outcome_of(job)) << setting.first;
  }
}

TEST(RunJob, ReplicatesAndSeedsDiffer) {
  const Outcome first = outcome_of(job_with({{"cycles", whole(50)}}, 1, 0));
  EXPECT_NE(outcome_of(job_with({{"cycles", whole(50)}}, 1, 1)), first);
  EXPECT_NE(outcome_of(job_with({{"cycles", whole(50)}}, 2, 0)), first);
  EXPECT_EQ(outcome_of(job_with({{"cycles", whole(50)}}, 1, 0)), first);
}

TEST(JobRun, AJobThatGoesOnFromACopyEndsAlike) {
  for (const Job& job : various_jobs()) {
    JobRun run(job);
    for (int cycle = 0; cycle < 84; ++cycle) run.advance();
    EXPECT_EQ(run.outcome().cycles, 84U);
    JobRun copy(run);
    while (!run.finished()) run.advance();
    while (!copy.finished()) copy.advance();
    EXPECT_EQ(run.outcome(), outcome_of(job));
    EXPECT_EQ(copy.outcome(), run.outcome());
  }
}

TEST(RunJob, IsInterruptedByARequestedStop) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_TRUE(std::holds_alternative<Interrupted>(run_job(job_with({}), stop.get_token())));
}

}  // namespace
}  // namespace lamprey::experiment
