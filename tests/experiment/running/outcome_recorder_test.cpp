#include "experiment/outcome_recorder.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <optional>
#include <span>
#include <vector>

namespace lamprey::experiment {
namespace {

using namespace science;
using evolution::CycleReport;

/// A problem that only has an expected fitness; the recorder never tries it.
class Wanted final : public evolution::Problem {
 public:
  const evolution::GenePlan& plan() const override { return plan_; }
  std::span<const double> preset() const override { return {}; }
  fitness::Fitness evaluate(std::span<const double>, const fitness::Environment&, evolution::Body&) const override {
    return {};
  }
  void save(const evolution::Body&, saving::Writer&) const override {}
  void restore(saving::Reader&, evolution::Body&) const override {}
  fitness::Fitness expected(const fitness::Environment&) const override { return {}; }
  robots::Recording record(std::span<const double>, const fitness::Environment&, std::int32_t) const override {
    return {};
  }

 private:
  evolution::GenePlan plan_;
};

evolution::Training training(const Wanted& problem, const fitness::Fitness& expected) {
  return {.problem = problem,
          .environment = {},
          .objective = evolution::Objective::maximise,
          .expected = expected,
          .stream = random::Stream(1)};
}

std::optional<double> measure(const Outcome& outcome, std::string_view name, std::uint32_t index) {
  for (const auto& entry : outcome.measures) {
    if (entry.name == name && entry.index == index) return entry.value;
  }
  return std::nullopt;
}

const std::vector<double> origin{0, 0};

CycleReport kept(double distance) {
  return {.fitness = {.distance = distance}, .accepted = true, .success = true};
}
CycleReport refused(double distance) {
  return {.fitness = {.distance = distance}};
}

TEST(OutcomeRecorder, WithoutDetailsAndChangesThereAreNoMeasures) {
  const Wanted problem;
  const auto run = training(problem, {.distance = 100});
  OutcomeRecorder recorder(false);
  recorder.begin(run, {.distance = 10}, origin);
  recorder.record(run, std::vector{kept(20), refused(5)}, origin);
  recorder.finish({});
  EXPECT_TRUE(recorder.outcome().measures.empty());
  EXPECT_EQ(recorder.outcome().success_rate, 0.5);
  EXPECT_EQ(recorder.outcome().accepted, 1U);
}

TEST(OutcomeRecorder, RecoveryIsCountedFromTheChangeToTheFirstAcceptedTotalWithinATwentieth) {
  const Wanted problem;
  auto run = training(problem, {.distance = 100});
  OutcomeRecorder recorder(false);
  recorder.begin(run, {.distance = 10}, origin);
  recorder.record(run, std::vector{kept(20)}, origin);

  run.expected = {.distance = 200};
  recorder.change_environment(run, {.distance = 100});
  recorder.record(run, std::vector{refused(199), kept(189), kept(190)}, origin);
  EXPECT_EQ(recorder.outcome().expected.total, 200);

  run.expected = {.distance = 50};
  recorder.change_environment(run, {.distance = 20});
  EXPECT_EQ(recorder.outcome().highest.total, 20) << "scores of another environment don't compare";
  recorder.record(run, std::vector{kept(30)}, origin);

  run.expected = {.distance = 40};
  recorder.change_environment(run, {.distance = 39});
  recorder.finish({});

  const Outcome& outcome = recorder.outcome();
  EXPECT_EQ(measure(outcome, "environment_expected_total", 0), 200);
  EXPECT_EQ(measure(outcome, "recovered", 0), 1);
  EXPECT_EQ(measure(outcome, "recovery_cycles", 0), 3);
  EXPECT_EQ(measure(outcome, "recovered", 1), 0);
  EXPECT_EQ(measure(outcome, "recovery_cycles", 1), std::nullopt);
  EXPECT_EQ(measure(outcome, "recovered", 2), 1);
  EXPECT_EQ(measure(outcome, "recovery_cycles", 2), 0) << "it never left";
  EXPECT_EQ(outcome.initial.total, 10);
}

TEST(OutcomeRecorder, NeverRecoveredIsSaidAtTheEndToo) {
  const Wanted problem;
  auto run = training(problem, {.distance = 100});
  OutcomeRecorder recorder(false);
  recorder.begin(run, {.distance = 10}, origin);
  recorder.change_environment(run, {.distance = 10});
  recorder.record(run, std::vector{kept(94)}, origin);
  recorder.finish({});
  EXPECT_EQ(measure(recorder.outcome(), "recovered", 0), 0);
}

TEST(OutcomeRecorder, ANegativeExpectationIsRecoveredByATwentiethBelowIt) {
  const Wanted problem;
  auto run = training(problem, {});
  OutcomeRecorder recorder(false);
  recorder.begin(run, {}, origin);
  run.expected = {.distance = -100};
  recorder.change_environment(run, {.distance = -106});
  recorder.record(run, std::vector{kept(-105)}, origin);
  recorder.finish({});
  EXPECT_EQ(measure(recorder.outcome(), "recovery_cycles", 0), 1);
}

TEST(OutcomeRecorder, DetailsAreVariationAndOnLineAndOffLinePerformance) {
  const Wanted problem;
  const auto run = training(problem, {.distance = 100});
  OutcomeRecorder recorder(true);
  recorder.begin(run, {.distance = 10}, origin);
  recorder.record(run, std::vector{kept(20)}, std::vector<double>{1, -2});
  recorder.record(run, std::vector{refused(0)}, std::vector<double>{1, -2});
  recorder.record(run, std::vector{kept(40)}, std::vector<double>{0, 0});
  recorder.finish({});
  const Outcome& outcome = recorder.outcome();
  EXPECT_EQ(measure(outcome, "parameter_variation", 0), 1.5);
  EXPECT_EQ(measure(outcome, "parameter_variation", 1), std::nullopt);
  EXPECT_EQ(measure(outcome, "parameter_variation", 2), 0);
  EXPECT_EQ(measure(outcome, "on_line_performance", 0), (20.0 + 0 + 40) / 3);
  EXPECT_EQ(measure(outcome, "off_line_performance", 0), (20.0 + 20 + 40) / 3);
}

TEST(OutcomeRecorder, MeasuresOfTheTrainerJoinSortedByNameAndIndexWithoutNegativeZero) {
  const Wanted problem;
  const auto run = training(problem, {});
  OutcomeRecorder recorder(true);
  recorder.begin(run, {}, origin);
  recorder.record(run, std::vector{refused(0)}, origin);
  recorder.finish(std::vector<evolution::Measure>{{"z", 0, 1}, {"a", 1, -0.0}, {"a", 0, 2}});
  std::vector<std::string> names;
  for (const auto& entry : recorder.outcome().measures) names.push_back(entry.name + std::to_string(entry.index));
  EXPECT_EQ(names, (std::vector<std::string>{"a0", "a1", "off_line_performance0", "on_line_performance0", "z0"}));
  EXPECT_FALSE(std::signbit(recorder.outcome().measures[1].value));
}

}  // namespace
}  // namespace lamprey::experiment
