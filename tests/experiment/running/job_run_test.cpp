#include "experiment/job_run.hpp"

#include "tests/experiment/running/jobs.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>
#include <vector>

namespace lamprey::experiment {
namespace {

using namespace science::evolution;

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

TEST(JobSettings, MapsEveryParameter) {
  const JobSettings settings = job_settings(parameters_with({{"mutation", text("one")},
                                                             {"steps", text("normal")},
                                                             {"acceptance", text("annealing")},
                                                             {"equilibrium_disturbance", whole(75)},
                                                             {"mutation_size", whole(25)},
                                                             {"system_disturbance", whole(25)},
                                                             {"required_stability", whole(25)},
                                                             {"required_distance", whole(75)},
                                                             {"required_fuel", whole(50)},
                                                             {"cycles", whole(77)},
                                                             {"time_steps", whole(40)},
                                                             {"objective", text("maximise")},
                                                             {"criterion", text("total")},
                                                             {"posture", text("carry")},
                                                             {"temperature", 2.0},
                                                             {"cooling", 0.75},
                                                             {"step_variance", text("root_error")},
                                                             {"first_standard_deviation", 4.0},
                                                             {"success_window", whole(10)},
                                                             {"standard_deviation_factor", 0.9},
                                                             {"minimum_standard_deviation", 0.5},
                                                             {"maximum_standard_deviation", 8.0}}));
  EXPECT_EQ(settings.trial.time_steps, 40);
  EXPECT_EQ(settings.cycles, 77U);
  EXPECT_EQ(settings.disturbance.size, 7);
  EXPECT_EQ(settings.disturbance.per_kind, 1U);
  const Rtea& rtea = settings.rtea;
  EXPECT_EQ(rtea.mutation, MutationTechnique::one);
  EXPECT_EQ(rtea.steps, Steps::normal);
  EXPECT_EQ(rtea.size, 2);
  EXPECT_EQ(rtea.step_variance, StepVariance::root_error);
  EXPECT_EQ(rtea.one_fifth_rule.first_standard_deviation, 4);
  EXPECT_EQ(rtea.one_fifth_rule.window, 10U);
  EXPECT_EQ(rtea.one_fifth_rule.factor, 0.9);
  EXPECT_EQ(rtea.one_fifth_rule.minimum_standard_deviation, 0.5);
  EXPECT_EQ(rtea.one_fifth_rule.maximum_standard_deviation, 8);
  EXPECT_EQ(rtea.objective, Objective::maximise);
  EXPECT_EQ(rtea.criterion, Criterion::total);
  EXPECT_EQ(rtea.acceptance, Acceptance::annealing);
  EXPECT_EQ(rtea.temperature, 2);
  EXPECT_EQ(rtea.cooling, 0.75);
  EXPECT_EQ(rtea.posture, Posture::carry);
  EXPECT_EQ(rtea.weights.stability, 0.25);
  EXPECT_EQ(rtea.weights.distance, 0.75);
  EXPECT_EQ(rtea.weights.fuel, 0.5);
}

TEST(JobSettings, HasAModelForEveryRegisteredChoice) {
  for (const Parameter& parameter : registry()) {
    for (const auto choice : parameter.choices) {
      Parameters parameters;
      parameters.set(parameter.name, std::string(choice));
      EXPECT_NO_THROW(job_settings(parameters)) << parameter.name << " " << choice;
    }
  }
}

TEST(JobSettings, AChoiceWithoutAModelIsRefusedByNameAndValue) {
  try {
    job_settings(parameters_with({{"gait", text("moonwalk")}}));
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "gait is \"moonwalk\", of which there is no model");
  }
}

TEST(JobSettings, MutateSomeDisturbsAllChildren) {
  const auto settings = job_settings(parameters_with({{"mutation", text("some")}, {"system_disturbance", whole(25)}}));
  EXPECT_EQ(settings.disturbance.per_kind, 4U);
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

TEST(AdvanceJob, AJobThatGoesOnFromACopyOfItsStateEndsAlike) {
  for (const Job& job : various_jobs()) {
    const JobSettings settings = job_settings(job.parameters);
    const science::random::Stream stream(stream_key(job));
    JobState state = begin_job(settings, stream);
    for (const std::uint32_t cycles : {1U, 63U, 0U, 20U}) {
      JobState copy = state;
      advance_job(settings, stream, copy, cycles);
      state = copy;
    }
    EXPECT_EQ(state.outcome.cycles, 84U);
    advance_job(settings, stream, state, 1'000'000);
    EXPECT_EQ(state.outcome, outcome_of(job));
  }
}

TEST(RunJob, IsInterruptedByARequestedStop) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_TRUE(std::holds_alternative<Interrupted>(run_job(job_with({}), stop.get_token())));
}

}  // namespace
}  // namespace lamprey::experiment
