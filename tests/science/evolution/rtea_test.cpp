#include "science/evolution/rtea.hpp"

#include <array>
#include <deque>
#include <gtest/gtest.h>
#include <span>
#include <utility>
#include <vector>

namespace lamprey::science::evolution {
namespace {

using fitness::Fitness;

/// A problem whose fitness is told beforehand, so that the loop can be followed by hand. Its body counts evaluations.
class ToldProblem final : public Problem {
 public:
  ToldProblem() {
    plan_.genes.assign(8, {.minimum = -1e9, .maximum = 1e9});
    plan_.units = {{0, 1, 2, 3}, {4, 5, 6, 7}};
    plan_.kinds = {{0, 1}};
  }
  void tell(std::deque<Fitness> scores) { told_ = std::move(scores); }
  bool has_told_all() const { return told_.empty(); }

  const GenePlan& plan() const override { return plan_; }
  std::span<const double> preset() const override { return {}; }
  Fitness evaluate(std::span<const double>, const fitness::Environment&, Body& body) const override {
    body.put(body.get<int>() + 1);
    const Fitness next = told_.front();
    told_.pop_front();
    return next;
  }
  void save(const Body& body, saving::Writer& writer) const override {
    writer.whole("evaluations", body.get<int>(), 0, 1'000'000);
  }
  void restore(saving::Reader& reader, Body& body) const override {
    int evaluations = 0;
    reader.whole("evaluations", evaluations, 0, 1'000'000);
    body.put(evaluations);
  }
  Fitness expected(const fitness::Environment&) const override { return {}; }
  robots::Recording record(std::span<const double>, const fitness::Environment&, std::int32_t) const override {
    return {};
  }

 private:
  GenePlan plan_;
  mutable std::deque<Fitness> told_;
};

constexpr Fitness expected{.stability = 80, .distance = 60, .fuel = 83};
const random::Stream stream(1);

/// Reports of the cycles whose candidates score as told; the first of `told` is the initial state's.
struct Trace {
  std::vector<CycleReport> reports;
  RteaState state;

  Trace(const RteaSettings& settings, std::deque<Fitness> scores, Objective objective = Objective::target) {
    ToldProblem problem;
    problem.tell(std::move(scores));
    const Training training{
        .problem = problem, .environment = {}, .objective = objective, .expected = expected, .stream = stream};
    Rtea rtea(settings, std::vector<double>(8));
    rtea.begin(training);
    while (!problem.has_told_all()) rtea.advance(training, 1, reports);
    state = rtea.state();
  }
};

int evaluations(const Trace& trace) {
  return trace.state.body.get<int>();
}

TEST(RteaLoop, KeepsWhatIsCloserRestoresWhatIsNotAndComparesWithTheLastAccepted) {
  const Trace run({}, {{50, 50, 50}, {60, 50, 50}, {55, 50, 50}, {60, 50, 50}, {60, 55, 49}, {80, 60, 83}});
  const std::array<bool, 5> accepted{true, false, true, false, true};
  const std::array<bool, 5> success{true, false, false, false, true};
  for (std::size_t cycle = 0; cycle < 5; ++cycle) {
    EXPECT_EQ(run.reports[cycle].accepted, accepted[cycle]) << cycle;
    EXPECT_EQ(run.reports[cycle].success, success[cycle]) << cycle;
  }
  EXPECT_EQ(run.state.fitness, expected);
  EXPECT_EQ(run.state.cycle, 5U);
}

TEST(RteaLoop, ARejectedCandidateLeavesTheGenomeAsItWas) {
  const Trace rejected({}, {{50, 50, 50}, {40, 50, 50}});
  EXPECT_EQ(rejected.state.genes, std::vector<double>(8));
  const Trace accepted({}, {{50, 50, 50}, {60, 50, 50}});
  EXPECT_NE(accepted.state.genes, std::vector<double>(8));
}

TEST(RteaLoop, TheTotalCriterionTradesOneComponentForAnother) {
  const RteaSettings rtea{.criterion = Criterion::total};
  const Trace run(rtea, {{50, 50, 50}, {49, 52, 50}, {52, 49, 50}, {51, 49, 50}});
  EXPECT_TRUE(run.reports[0].success);
  EXPECT_TRUE(run.reports[1].accepted);
  EXPECT_FALSE(run.reports[1].success) << "as far as before: kept, no success";
  EXPECT_FALSE(run.reports[2].accepted);
}

TEST(RteaLoop, MaximiseGoesBeyondTheExpectedFitnessAndTargetDoesNot) {
  const std::deque<Fitness> told{expected, {90, 70, 90}};
  EXPECT_FALSE(Trace({}, told).reports[0].accepted);
  EXPECT_TRUE(Trace({}, told, Objective::maximise).reports[0].success);
}

TEST(RteaLoop, AnnealingKeepsSomeGrowingErrorsWithoutCallingThemSuccesses) {
  std::deque<Fitness> told{expected};
  for (int cycle = 0; cycle < 400; ++cycle)
    told.push_back({.stability = 80.0 - 0.5 * (cycle + 1), .distance = 60, .fuel = 83});
  const Trace run({.acceptance = Acceptance::annealing, .temperature = 100}, told);
  int accepted = 0;
  for (const auto& report : run.reports) {
    EXPECT_FALSE(report.success);
    accepted += report.accepted;
  }
  EXPECT_GT(accepted, 300);
  EXPECT_LT(accepted, 400) << "some growth is refused";
}

TEST(RteaLoop, AnnealingKeepsASumThatDoesNotGrowWhateverItsComponentsDo) {
  const RteaSettings rtea{.acceptance = Acceptance::annealing, .temperature = 1e-9};
  const Trace run(rtea, {{50, 50, 50}, {49, 52, 50}, {49, 51, 50}});
  EXPECT_TRUE(run.reports[0].accepted);
  EXPECT_FALSE(run.reports[0].success);
  EXPECT_FALSE(run.reports[1].accepted);
}

TEST(RteaLoop, CoolingMultipliesTheTemperatureAfterEachCycle) {
  const std::deque<Fitness> told(5, expected);
  EXPECT_EQ(Trace({.temperature = 8, .cooling = 0.5}, told).state.temperature, 0.5);
  EXPECT_EQ(Trace({.temperature = 8}, told).state.temperature, 8);
}

TEST(RteaLoop, ResetGivesEachCandidateANewBodyAndCarryTheSameOne) {
  const std::deque<Fitness> told(6, expected);
  EXPECT_EQ(evaluations(Trace({}, told)), 1);
  EXPECT_EQ(evaluations(Trace({.posture = Posture::carry}, told)), 6);
}

TEST(RteaLoop, CarryKeepsTheBodyThroughRejectedCandidates) {
  const Trace run({.posture = Posture::carry}, {{50, 50, 50}, {40, 50, 50}, {40, 50, 50}});
  EXPECT_FALSE(run.reports[0].accepted || run.reports[1].accepted);
  EXPECT_EQ(evaluations(run), 3);
}

TEST(RteaLoop, TheOneFifthRuleCountsSuccessesOnly) {
  const RteaSettings rtea{.steps = Steps::one_fifth_rule, .one_fifth_rule = {.window = 4}};
  EXPECT_EQ(Trace(rtea, std::deque<Fitness>(5, expected)).state.one_fifth.standard_deviation, 5 * 0.85)
      << "neutral moves are kept but are no successes";
  EXPECT_EQ(Trace(rtea, {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {5, 0, 0}}).state.one_fifth.standard_deviation,
            5 / 0.85);
}

TEST(RteaLoop, ANewEnvironmentIsMetByTryingTheLastAcceptedOnce) {
  ToldProblem problem;
  problem.tell({{50, 50, 50}, {60, 50, 50}, {20, 50, 50}, {30, 50, 50}});
  const Training training{.problem = problem, .environment = {}, .expected = expected, .stream = stream};
  Rtea rtea({}, std::vector<double>(8));
  std::vector<CycleReport> reports;
  rtea.begin(training);
  rtea.advance(training, 1, reports);
  const std::vector<double> accepted(rtea.genes().begin(), rtea.genes().end());
  EXPECT_EQ(rtea.meet(training), (Fitness{20, 50, 50}));
  EXPECT_EQ(rtea.state().cycle, 1U) << "meeting is no cycle";
  EXPECT_EQ(std::vector<double>(rtea.genes().begin(), rtea.genes().end()), accepted);
  rtea.advance(training, 1, reports);
  EXPECT_TRUE(reports.back().success) << "30 is better than the 20 that the accepted state has here";
}

TEST(StepDistribution, FollowsTheKindOfSteps) {
  const OneFifthState one_fifth{.standard_deviation = 3.5};
  const Errors error{16, 0, 0};
  using Kind = evolution::StepDistribution::Kind;
  const Objective target = Objective::target;
  RteaSettings rtea{.steps = Steps::uniform, .size = 7, .step_variance = StepVariance::root_error};
  EXPECT_EQ(step_distribution(rtea, target, one_fifth, error).kind, Kind::uniform);
  EXPECT_EQ(step_distribution(rtea, target, one_fifth, error).size, 7);
  rtea.steps = Steps::one_fifth_rule;
  EXPECT_EQ(step_distribution(rtea, target, one_fifth, error).kind, Kind::normal);
  EXPECT_EQ(step_distribution(rtea, target, one_fifth, error).standard_deviation, 3.5);
  rtea.steps = Steps::normal;
  EXPECT_EQ(step_distribution(rtea, target, one_fifth, error).standard_deviation, 7);
  EXPECT_EQ(step_distribution(rtea, Objective::maximise, one_fifth, error).standard_deviation, 3.5)
      << "there is no error to take a root of";
  rtea.step_variance = StepVariance::constant;
  EXPECT_EQ(step_distribution(rtea, target, one_fifth, error).standard_deviation, 3.5);
}

}  // namespace
}  // namespace lamprey::science::evolution
