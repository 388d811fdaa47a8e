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

/// A trial whose fitness is told beforehand, so that the loop can be followed by hand. Its body counts evaluations.
struct ToldTrial {
  struct Genome {
    std::array<Unit, 2> genes{};
    bool operator==(const Genome&) const = default;
  };
  struct Body {
    int evaluations = 0;
  };

  std::deque<Fitness>* told;

  Fitness evaluate(const Genome&, Body& body) const {
    ++body.evaluations;
    const Fitness next = told->front();
    told->pop_front();
    return next;
  }
  static std::span<Unit> units(Genome& genome) { return genome.genes; }
  static constexpr std::array<std::array<std::uint8_t, 4>, 1> symmetric_units{{{0, 1, 0, 1}}};
  static constexpr double minimum_gene = -1e9;
  static constexpr double maximum_gene = 1e9;
};
static_assert(Trial<ToldTrial>);

constexpr Fitness expected{.stability = 80, .distance = 60, .fuel = 83};
const random::Stream stream(1);

/// Reports of the cycles whose candidates score as told; the first of `told` is the initial state's.
struct Trace {
  std::deque<Fitness> told;
  std::vector<CycleReport> reports;
  RteaState<ToldTrial> state;

  Trace(const Rtea& rtea, std::deque<Fitness> scores) : told(std::move(scores)) {
    const ToldTrial trial{&told};
    state = begin(rtea, trial, {});
    while (!told.empty()) reports.push_back(advance(rtea, trial, expected, stream, state));
  }
};

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
  EXPECT_EQ(rejected.state.genome, ToldTrial::Genome{});
  const Trace accepted({}, {{50, 50, 50}, {60, 50, 50}});
  EXPECT_NE(accepted.state.genome, ToldTrial::Genome{});
}

TEST(RteaLoop, TheTotalCriterionTradesOneComponentForAnother) {
  const Rtea rtea{.criterion = Criterion::total};
  const Trace run(rtea, {{50, 50, 50}, {49, 52, 50}, {52, 49, 50}, {51, 49, 50}});
  EXPECT_TRUE(run.reports[0].success);
  EXPECT_TRUE(run.reports[1].accepted);
  EXPECT_FALSE(run.reports[1].success) << "as far as before: kept, no success";
  EXPECT_FALSE(run.reports[2].accepted);
}

TEST(RteaLoop, MaximiseGoesBeyondTheExpectedFitnessAndTargetDoesNot) {
  const std::deque<Fitness> told{expected, {90, 70, 90}};
  EXPECT_FALSE(Trace({}, told).reports[0].accepted);
  EXPECT_TRUE(Trace({.objective = Objective::maximise}, told).reports[0].success);
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
  const Rtea rtea{.acceptance = Acceptance::annealing, .temperature = 1e-9};
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
  EXPECT_EQ(Trace({}, told).state.body.evaluations, 1);
  EXPECT_EQ(Trace({.posture = Posture::carry}, told).state.body.evaluations, 6);
}

TEST(RteaLoop, CarryKeepsTheBodyThroughRejectedCandidates) {
  const Trace run({.posture = Posture::carry}, {{50, 50, 50}, {40, 50, 50}, {40, 50, 50}});
  EXPECT_FALSE(run.reports[0].accepted || run.reports[1].accepted);
  EXPECT_EQ(run.state.body.evaluations, 3);
}

TEST(RteaLoop, TheOneFifthRuleCountsSuccessesOnly) {
  const Rtea rtea{.steps = Steps::one_fifth_rule, .one_fifth_rule = {.window = 4}};
  EXPECT_EQ(Trace(rtea, std::deque<Fitness>(5, expected)).state.one_fifth.standard_deviation, 5 * 0.85)
      << "neutral moves are kept but are no successes";
  EXPECT_EQ(Trace(rtea, {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {5, 0, 0}}).state.one_fifth.standard_deviation,
            5 / 0.85);
}

TEST(StepDistribution, FollowsTheKindOfSteps) {
  const OneFifthState one_fifth{.standard_deviation = 3.5};
  const Errors error{16, 0, 0};
  using Kind = evolution::StepDistribution::Kind;
  Rtea rtea{.steps = Steps::uniform, .size = 7, .step_variance = StepVariance::root_error};
  EXPECT_EQ(step_distribution(rtea, one_fifth, error).kind, Kind::uniform);
  EXPECT_EQ(step_distribution(rtea, one_fifth, error).size, 7);
  rtea.steps = Steps::one_fifth_rule;
  EXPECT_EQ(step_distribution(rtea, one_fifth, error).kind, Kind::normal);
  EXPECT_EQ(step_distribution(rtea, one_fifth, error).standard_deviation, 3.5);
  rtea.steps = Steps::normal;
  EXPECT_EQ(step_distribution(rtea, one_fifth, error).standard_deviation, 7);
  rtea.objective = Objective::maximise;
  EXPECT_EQ(step_distribution(rtea, one_fifth, error).standard_deviation, 3.5) << "there is no error to take a root of";
  rtea.objective = Objective::target;
  rtea.step_variance = StepVariance::constant;
  EXPECT_EQ(step_distribution(rtea, one_fifth, error).standard_deviation, 3.5);
}

}  // namespace
}  // namespace lamprey::science::evolution
