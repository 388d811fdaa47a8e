#include "experiment/models.hpp"
#include "tests/storage/support.hpp"

#include <gmock/gmock.h>

namespace lamprey::storage::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using Rows = std::vector<std::vector<std::string>>;

/// Sweeps that are given by settings and axes, with made-up outcomes.
class MeasureViewsTest : public ::testing::Test {
 protected:
  using Settings = std::vector<std::pair<std::string, std::string>>;
  using Axis = std::pair<std::string, std::vector<std::string>>;

  static void set(idl::Value& value, const std::string& text) {
    if (text.find_first_not_of("0123456789") == text.npos) {
      value.set_integer(std::stoll(text));
    } else {
      value.set_text(text);
    }
  }

  static SweepCase sweep_of(const std::string& name, const Settings& settings, const std::vector<Axis>& axes) {
    idl::SweepSpecification specification;
    specification.set_name(name);
    specification.set_seed(2006);
    specification.set_replicates(2);
    for (const auto& [parameter, value] : settings) {
      auto* setting = specification.add_base();
      setting->set_parameter(parameter);
      set(*setting->mutable_value(), value);
    }
    auto* grid = specification.add_grids();
    for (const auto& [parameter, values] : axes) {
      auto* axis = grid->add_axes();
      axis->set_parameter(parameter);
      for (const auto& value : values) set(*axis->add_values(), value);
    }
    return sweep_case(specification);
  }

  /// The outcome of a job with these measures and a trace of (cycle, total).
  static experiment::Outcome outcome_of(std::vector<experiment::Measure> measures,
                                        const std::vector<std::pair<std::uint32_t, double>>& trace = {}) {
    experiment::Outcome outcome;
    outcome.measures = std::move(measures);
    for (const auto& [cycle, total] : trace) outcome.trace.push_back({cycle, {0, 0, 0, total}});
    return outcome;
  }

  static experiment::Outcome totals_of(double final, double highest, double success_rate = 0) {
    experiment::Outcome outcome;
    outcome.final.total = final;
    outcome.evolved.total = final;
    outcome.highest.total = highest;
    outcome.success_rate = success_rate;
    return outcome;
  }

  void store(const SweepCase& sweep, std::uint64_t job, const experiment::Outcome& outcome) {
    store_.commit({.jobs = {done_job(sweep, store_.add_sweep(sweep.what).sweep.row, job, outcome)}});
  }

  Rows rows(const std::string& sql) { return ResultsReader(path_).query(sql).rows; }

  TemporaryDirectory directory_;
  std::string path_ = directory_.file("results.db");
  ResultsStore store_{path_};
};

TEST_F(MeasureViewsTest, MeasureHasARowPerMeasureAndNoneForJobsWithout) {
  const auto sweep = operator_sweep("operators");
  store(sweep, 4, outcome_of({{"parameter_variation", 17, 0.5}, {"recovered", 4294967295U, 1}}));
  store(sweep, 5, outcome_of({}));
  store_.commit({.jobs = {ended_job(sweep, 1, 6, JobState::failed)}});
  EXPECT_THAT(rows("SELECT * FROM measure ORDER BY name"),
              ElementsAre(ElementsAre("\"operators\"", "4", "\"parameter_variation\"", "17", "0.5"),
                          ElementsAre("\"operators\"", "4", "\"recovered\"", "4294967295", "1")));
  EXPECT_THAT(rows("SELECT DISTINCT typeof(name), typeof(\"index\"), typeof(value) FROM measure"),
              ElementsAre(ElementsAre("\"text\"", "\"integer\"", "\"real\"")));
}

TEST_F(MeasureViewsTest, RecoveryHasARowPerChangeOfTheEnvironment) {
  const auto sweep =
      sweep_of("changes", {{"objective", "maximise"}, {"mutation", "one"}}, {{"acceptance", {"simple", "annealing"}}});
  store(sweep, 1,
        outcome_of({{"environment_expected_total", 0, 180.5},
                    {"environment_expected_total", 1, 90},
                    {"recovered", 0, 1},
                    {"recovered", 1, 0},
                    {"recovery_cycles", 0, 33}}));
  store(sweep, 2, outcome_of({{"on_line_performance", 0, 3}}));
  EXPECT_THAT(rows("SELECT * FROM recovery ORDER BY change"),
              ElementsAre(ElementsAre("\"changes\"", "1", "0", "\"one\"", "\"uniform\"", "\"annealing\"",
                                      "\"per_component\"", "0", "180.5", "1", "33"),
                          ElementsAre("\"changes\"", "1", "0", "\"one\"", "\"uniform\"", "\"annealing\"",
                                      "\"per_component\"", "1", "90", "0", "null")));
}

TEST_F(MeasureViewsTest, GaitChangeHasARowPerChangeAndItsFiguresAverageThem) {
  const auto sweep = sweep_of("tonic", {{"network", "tonic"}}, {{"mutation", {"all", "one"}}});
  const auto changes = [](double first, double second, double reached) {
    return outcome_of({{"failures_after_last_change", 0, 9},
                       {"gait_change_failures", 0, first},
                       {"gait_change_failures", 1, second},
                       {"gait_reached", 0, reached},
                       {"gait_reached", 1, 2}});
  };
  store(sweep, 0, changes(1, 14, 3));
  store(sweep, 1, changes(18, 1, 4));
  store(sweep, 2, changes(2, 16, 1));
  EXPECT_THAT(rows("SELECT * FROM gait_change ORDER BY job, change LIMIT 3"),
              ElementsAre(ElementsAre("\"tonic\"", "0", "0", "\"all\"", "\"tonic\"", "0", "\"trot\"", "1"),
                          ElementsAre("\"tonic\"", "0", "0", "\"all\"", "\"tonic\"", "1", "\"gallop\"", "14"),
                          ElementsAre("\"tonic\"", "1", "0", "\"one\"", "\"tonic\"", "0", "\"pace\"", "18")));
  EXPECT_THAT(rows("SELECT sweep, tonic_genes, change, jobs, failures FROM figure_9_5 ORDER BY change"),
              ElementsAre(ElementsAre("\"tonic\"", "\"tonic\"", "0", "2", "1.5"),
                          ElementsAre("\"tonic\"", "\"tonic\"", "1", "2", "15")));
  EXPECT_THAT(rows("SELECT change, jobs, failures FROM figure_9_6 ORDER BY change"),
              ElementsAre(ElementsAre("0", "1", "18"), ElementsAre("1", "1", "1")));
}

TEST_F(MeasureViewsTest, VariationJoinsTheAcceptedChangeOfItsCycle) {
  const auto sweep = sweep_of("details", {{"record", "details"}}, {{"mutation", {"all", "one"}}});
  store(sweep, 0,
        outcome_of({{"on_line_performance", 3, 1}, {"parameter_variation", 3, 0.25}, {"parameter_variation", 9, 0.5}},
                   {{3, 100}, {5, 101}, {9, 102}}));
  store(sweep, 1, outcome_of({{"parameter_variation", 3, 7}}, {{3, 50}}));
  store(sweep, 2, outcome_of({}, {{3, 60}}));
  EXPECT_THAT(
      rows("SELECT * FROM variation ORDER BY job, cycle"),
      ElementsAre(ElementsAre("\"details\"", "0", "3", "0.25", "100"),
                  ElementsAre("\"details\"", "0", "9", "0.5", "102"), ElementsAre("\"details\"", "1", "3", "7", "50")));
}

TEST_F(MeasureViewsTest, FiguresOfChapter6AverageReplicatesByNetworkNeuronAndMutationRate) {
  const Settings biped = {{"robot", "biped"}, {"trainer", "chapter_6_ga"}, {"time_steps", "40"}};
  const auto sweep =
      sweep_of("rates", biped, {{"network", {"recurrent_pair", "feed_forward_pair"}}, {"mutation_rate", {"25", "75"}}});
  ASSERT_EQ(sweep.grid.cells(), 4U);
  store(sweep, 1, totals_of(60, 64, 0.25));
  store(sweep, 5, totals_of(80, 90, 0.75));  // its second replicate
  store(sweep, 2, totals_of(10, 20));
  const std::string columns =
      "SELECT network, neuron, mutation_rate, jobs, final_total, highest_total, success_rate FROM ";
  for (const std::string figure : {"figure_6_25", "figure_6_27"}) {
    EXPECT_THAT(rows(columns + figure + " ORDER BY mutation_rate DESC"),
                ElementsAre(ElementsAre("\"recurrent_pair\"", "\"threshold\"", "75", "2", "70", "77", "0.5"),
                            ElementsAre("\"feed_forward_pair\"", "\"threshold\"", "25", "1", "10", "20", "0")));
  }
  EXPECT_THAT(rows("SELECT * FROM figure_6_30"), IsEmpty());

  auto real_time = biped;
  real_time[1].second = "ii_rtea";
  const auto other = sweep_of("real-time", real_time, {{"network", {"recurrent_pair"}}});
  store(other, 0, totals_of(50, 51));
  EXPECT_THAT(rows("SELECT sweep, network, jobs, final_total FROM figure_6_30"),
              ElementsAre(ElementsAre("\"real-time\"", "\"recurrent_pair\"", "1", "50")));
  EXPECT_EQ(rows("SELECT * FROM figure_6_25").size(), 2U);
}

TEST_F(MeasureViewsTest, FiguresOfChapter8HaveNoRowsOfOtherNetworksAndTrainers) {
  store(sweep_of("loop", {{"network", "timed_loop"}, {"steps", "normal"}}, {{"mutation", {"all"}}}), 0,
        totals_of(1, 1));
  store(sweep_of("hybrid", {{"trainer", "hybrid"}, {"steps", "normal"}}, {{"mutation", {"all"}}}), 0, totals_of(1, 1));
  store(sweep_of("ga", {{"trainer", "genetic_algorithm"}}, {{"population", {"40"}}}), 0, totals_of(1, 1));
  for (const std::string view :
       {"figure_8_3", "figure_8_6", "figure_8_10", "operators", "disturbance_by_mutation_size"}) {
    EXPECT_THAT(rows("SELECT * FROM " + view), IsEmpty()) << view;
  }
  store(sweep_of("published", {{"steps", "normal"}}, {{"mutation", {"all"}}}), 0, totals_of(1, 1));
  EXPECT_THAT(rows("SELECT sweep FROM figure_8_3"), ElementsAre(ElementsAre("\"published\"")));
}

TEST_F(MeasureViewsTest, RepeatabilityIsThatOfTheModels) {
  for (const auto& trainer : experiment::trainer_models()) {
    const auto sweep = sweep_of(std::string(trainer.name), {{"trainer", std::string(trainer.name)}},
                                {{"required_fuel", {"25", "50"}}});
    store(sweep, 1, totals_of(1, 1));
    EXPECT_EQ(rows("SELECT repeatability FROM result WHERE sweep = '" + std::string(trainer.name) + "'")[0][0],
              '"' + std::string(to_text(experiment::repeatability(sweep.grid.job(1).parameters))) + '"');
  }
  EXPECT_THAT(rows("SELECT repeatability FROM result WHERE trainer = 'pagmo_cmaes'"),
              ElementsAre(ElementsAre("\"same_build\"")));
  EXPECT_THAT(rows("SELECT repeatability FROM result WHERE trainer = 'rtea'"), ElementsAre(ElementsAre("\"bitwise\"")));
}

}  // namespace
}  // namespace lamprey::storage::testing
