#include "tests/storage/support.hpp"

#include <cmath>
#include <gmock/gmock.h>

namespace lamprey::storage::testing {
namespace {

using ::testing::ElementsAre;

/// Stores outcomes that are given by their totals and parts, for cells that are found by their values.
class ViewsTest : public ::testing::Test {
 protected:
  using Cell = std::vector<std::pair<std::string, experiment::Value>>;

  struct Scores {
    experiment::Score expected;
    experiment::Score evolved;
    experiment::Score highest;
    double success_rate = 0;
  };

  static SweepCase grid_sweep(const std::string& name, const std::string& objective = "target") {
    auto specification = operator_sweep(name).specification;
    specification.clear_base();
    auto* setting = specification.add_base();
    setting->set_parameter("objective");
    setting->mutable_value()->set_text(objective);
    for (const std::string parameter : {"equilibrium_disturbance", "required_stability"}) {
      auto* axis = specification.mutable_grids(0)->add_axes();
      axis->set_parameter(parameter);
      for (const int percent : {25, 100}) axis->add_values()->set_integer(percent);
    }
    return sweep_case(specification);
  }

  /// The number of the job that has all of these values.
  static std::uint64_t find(const SweepCase& sweep, const Cell& cell) {
    for (std::uint64_t number = 0; number < sweep.grid.jobs(); ++number) {
      const auto parameters = sweep.grid.job(number).parameters;
      bool all = true;
      for (const auto& [name, value] : cell) all = all && parameters.get(name) == value;
      if (all) return number;
    }
    throw std::runtime_error("no such cell");
  }

  void store_done(const SweepCase& sweep, const Cell& cell, const Scores& scores) {
    experiment::Outcome outcome;
    outcome.expected = scores.expected;
    outcome.evolved = scores.evolved;
    outcome.highest = scores.highest;
    outcome.final = scores.evolved;
    outcome.success_rate = scores.success_rate;
    store_.commit({.jobs = {done_job(sweep, row(sweep), find(sweep, cell), outcome)}});
  }

  std::int64_t row(const SweepCase& sweep) { return store_.add_sweep(sweep.what).sweep.row; }

  /// The rows of a query on the present state.
  std::vector<std::vector<std::string>> rows(const std::string& sql) { return ResultsReader(path_).query(sql).rows; }

  TemporaryDirectory directory_;
  std::string path_ = directory_.file("results.db");
  ResultsStore store_{path_};
};

experiment::Value text(const char* value) {
  return std::string(value);
}
experiment::Value whole(std::int64_t value) {
  return value;
}

TEST_F(ViewsTest, BarChartAveragesTheDoneJobsOfItsCellsOnly) {
  const auto sweep = grid_sweep("grid");
  const auto cell = [](const char* mutation, const char* steps, std::int64_t disturbance, std::int64_t stability) {
    return Cell{{"mutation", text(mutation)},
                {"steps", text(steps)},
                {"acceptance", text("simple")},
                {"equilibrium_disturbance", whole(disturbance)},
                {"required_stability", whole(stability)}};
  };
  store_done(sweep, cell("all", "normal", 25, 25), {{80, 60, 83, 163}, {40, 20, 30, 60}, {48, 20, 32, 64}, 0.25});
  store_done(sweep, cell("all", "normal", 100, 100), {{80, 60, 83, 223}, {20, 10, 10, 40}, {32, 10, 12, 54}, 0.75});
  store_done(sweep, cell("all", "uniform", 25, 100), {{80, 60, 83, 223}, {1, 2, 3, 6}, {2, 4, 6, 12}, 0.5});
  // None of these is in figure 8.3: another mutation, the 1/5 rule, jobs that are not done.
  store_done(sweep, cell("one", "normal", 25, 100), {{80, 60, 83, 223}, {7, 7, 7, 21}, {7, 7, 7, 21}, 0.1});
  store_done(sweep, cell("all", "one_fifth_rule", 25, 100), {{80, 60, 83, 223}, {9, 9, 9, 27}, {9, 9, 9, 27}, 0.1});
  store_.commit(
      {.jobs = {ended_job(sweep, row(sweep), find(sweep, cell("all", "normal", 25, 100)), JobState::failed)}});

  EXPECT_THAT(rows("SELECT sweep, steps, acceptance, objective, criterion, posture, cycles, jobs, expected_total, "
                   "evolved_total, highest_total, final_total, success_rate FROM figure_8_3 ORDER BY steps"),
              ElementsAre(ElementsAre("\"grid\"", "\"normal\"", "\"simple\"", "\"target\"", "\"per_component\"",
                                      "\"reset\"", "1000", "2", "193", "50", "59", "50", "0.5"),
                          ElementsAre("\"grid\"", "\"uniform\"", "\"simple\"", "\"target\"", "\"per_component\"",
                                      "\"reset\"", "1000", "1", "223", "6", "12", "6", "0.5")));
  // Weighted stability: (0.25 · 40 + 1 · 20) / 2 = 15 evolved, (0.25 · 48 + 1 · 32) / 2 = 22 at the highest.
  EXPECT_THAT(rows("SELECT expected_stability, expected_weighted_stability, evolved_stability, "
                   "evolved_weighted_stability, evolved_distance, evolved_weighted_distance, evolved_fuel, "
                   "highest_stability, highest_weighted_stability, highest_weighted_fuel "
                   "FROM figure_8_3 WHERE steps = 'normal'"),
              ElementsAre(ElementsAre("80", "50", "30", "15", "15", "15", "20", "40", "22", "22")));
  EXPECT_THAT(rows("SELECT steps, evolved_total FROM figure_8_4"), ElementsAre(ElementsAre("\"normal\"", "21")));
  EXPECT_TRUE(rows("SELECT * FROM figure_8_5").empty());
  EXPECT_THAT(rows("SELECT mutation, acceptance, evolved_total, jobs FROM figure_8_10"),
              ElementsAre(ElementsAre("\"all\"", "\"simple\"", "27", "1")));
  EXPECT_THAT(rows("SELECT mutation, steps, acceptance, jobs, evolved_total FROM operators ORDER BY 1, 2"),
              ElementsAre(ElementsAre("\"all\"", "\"normal\"", "\"simple\"", "2", "50"),
                          ElementsAre("\"all\"", "\"one_fifth_rule\"", "\"simple\"", "1", "27"),
                          ElementsAre("\"all\"", "\"uniform\"", "\"simple\"", "1", "6"),
                          ElementsAre("\"one\"", "\"normal\"", "\"simple\"", "1", "21")));
}

TEST_F(ViewsTest, SurfacesHaveAPointPerDisturbanceAndMutationSize) {
  const auto sweep = grid_sweep("grid");
  const auto store = [&](const char* steps, const char* acceptance, std::int64_t disturbance, std::int64_t stability,
                         double total) {
    store_done(sweep,
               {{"mutation", text("some")},
                {"steps", text(steps)},
                {"acceptance", text(acceptance)},
                {"equilibrium_disturbance", whole(disturbance)},
                {"required_stability", whole(stability)}},
               {{}, {0, 0, 0, total}, {0, 0, 0, 2 * total}, 0});
  };
  store("normal", "simple", 25, 25, 10);
  store("normal", "simple", 25, 100, 30);
  store("normal", "simple", 100, 25, 5);
  store("normal", "annealing", 25, 25, 7);
  store("uniform", "simple", 25, 25, 8);
  store("uniform", "annealing", 25, 25, 9);
  const std::string columns =
      "SELECT mutation, equilibrium_disturbance, mutation_size, jobs, evolved_total, highest_total FROM ";
  EXPECT_THAT(rows(columns + "figure_8_6 ORDER BY 2"),
              ElementsAre(ElementsAre("\"some\"", "25", "50", "2", "20", "40"),
                          ElementsAre("\"some\"", "100", "50", "1", "5", "10")));
  EXPECT_THAT(rows(columns + "figure_8_7"), ElementsAre(ElementsAre("\"some\"", "25", "50", "1", "7", "14")));
  EXPECT_THAT(rows(columns + "figure_8_8"), ElementsAre(ElementsAre("\"some\"", "25", "50", "1", "8", "16")));
  EXPECT_THAT(rows(columns + "figure_8_9"), ElementsAre(ElementsAre("\"some\"", "25", "50", "1", "9", "18")));
  EXPECT_EQ(rows("SELECT * FROM disturbance_by_mutation_size").size(), 5U);
}

TEST_F(ViewsTest, UnrelatedJobsAreNeverAveraged) {
  const Cell cell = {{"mutation", text("all")}, {"steps", text("normal")}, {"acceptance", text("simple")}};
  const auto first = grid_sweep("first");
  const auto second = grid_sweep("second", "maximise");
  auto longer = first.specification;
  longer.set_name("longer");
  auto* setting = longer.add_base();
  setting->set_parameter("time_steps");
  setting->mutable_value()->set_integer(200);
  // In one sweep, cells that differ in a parameter that no figure shows.
  auto* grid = longer.add_grids();
  for (const auto& [parameter, value] : {std::pair("steps", "normal"), std::pair("step_variance", "root_error")}) {
    auto* axis = grid->add_axes();
    axis->set_parameter(parameter);
    axis->add_values()->set_text(value);
  }
  const auto third = sweep_case(longer);
  store_done(first, cell, {{}, {0, 0, 0, 10}, {}, 0});
  store_done(second, cell, {{}, {0, 0, 0, 20}, {}, 0});
  store_done(third, cell, {{}, {0, 0, 0, 30}, {}, 0});
  Cell last = cell;
  last.emplace_back("step_variance", text("root_error"));
  store_done(third, last, {{}, {0, 0, 0, 40}, {}, 0});

  EXPECT_THAT(
      rows("SELECT sweep, objective, evolved_total FROM figure_8_3 ORDER BY 3"),
      ElementsAre(ElementsAre("\"first\"", "\"target\"", "10"), ElementsAre("\"second\"", "\"maximise\"", "20"),
                  ElementsAre("\"longer\"", "\"target\"", "30"), ElementsAre("\"longer\"", "\"target\"", "40")));
  EXPECT_THAT(rows("SELECT json_extract(other_parameters, '$.step_variance'), json_extract(other_parameters, "
                   "'$.time_steps') FROM operators WHERE sweep = 'longer' ORDER BY 1"),
              ElementsAre(ElementsAre("\"constant\"", "200"), ElementsAre("\"root_error\"", "200")));
}

TEST_F(ViewsTest, ParametersAreTypedAndNullWhereTheyDoNotApply) {
  const auto sweep = operator_sweep("operators");
  const auto store = [&](const Cell& cell) { store_done(sweep, cell, {}); };
  store({{"mutation", text("some")}, {"steps", text("one_fifth_rule")}, {"acceptance", text("simple")}});
  store({{"mutation", text("all")}, {"steps", text("normal")}, {"acceptance", text("annealing")}});
  EXPECT_THAT(rows("SELECT mutation, mutation_size, system_disturbance, required_distance, temperature, "
                   "first_standard_deviation FROM result ORDER BY job"),
              ElementsAre(ElementsAre("\"all\"", "50", "100", "50", "1", "null"),
                          ElementsAre("\"some\"", "null", "null", "50", "null", "5")));
  EXPECT_THAT(rows("SELECT DISTINCT typeof(mutation), typeof(required_distance), typeof(cycles), "
                   "typeof(evolved_total), typeof(seed) FROM result"),
              ElementsAre(ElementsAre("\"text\"", "\"integer\"", "\"integer\"", "\"real\"", "\"integer\"")));
  EXPECT_THAT(rows("SELECT typeof(temperature) FROM result WHERE temperature IS NOT NULL"),
              ElementsAre(ElementsAre("\"real\"")));
}

TEST_F(ViewsTest, ResultShowsWhoComputedWhat) {
  const auto sweep = operator_sweep("operators");
  auto job = done_job(sweep, row(sweep), 11);
  job.attempt = 2;
  job.worker = 0xab;
  store_.commit({.jobs = {job, ended_job(sweep, row(sweep), 12, JobState::cancelled)}});
  EXPECT_THAT(rows("SELECT sweep, job, state, digest, attempt, worker, seed, replicate, seconds, repeatability "
                   "FROM result ORDER BY job"),
              ElementsAre(ElementsAre("\"operators\"", "11", "\"done\"", '"' + experiment::to_hex(*job.digest) + '"',
                                      "2", "\"00000000000000ab\"", "2006", "0", "0.004", "\"bitwise\""),
                          ElementsAre("\"operators\"", "12", "\"cancelled\"", "null", "1", "null", "null", "null", "0",
                                      "null")));
  EXPECT_THAT(rows("SELECT evolved_total, mutation, success_rate FROM result WHERE job = 12"),
              ElementsAre(ElementsAre("null", "null", "null")));
}

// SQLite's JSON reader makes 0 of −0, which equals it; the text in job.trace keeps the sign.
TEST_F(ViewsTest, TraceHasARowPerAcceptedChange) {
  const auto sweep = operator_sweep("operators");
  auto outcome = made_up_outcome(1);
  outcome.trace = {{3, {80, 60.5, 1e-7, 0.25}}, {900, {-0.0, 1, 2, 1e300}}};
  store_.commit(
      {.jobs = {done_job(sweep, row(sweep), 4, outcome), done_job(sweep, row(sweep), 5, made_up_outcome(1, 0)),
                ended_job(sweep, row(sweep), 6, JobState::failed)}});
  EXPECT_THAT(rows("SELECT * FROM trace ORDER BY job, cycle"),
              ElementsAre(ElementsAre("\"operators\"", "4", "3", "80", "60.5", "1e-07", "0.25"),
                          ElementsAre("\"operators\"", "4", "900", "0", "1", "2", "1e+300")));
  EXPECT_THAT(rows("SELECT DISTINCT typeof(cycle), typeof(stability) FROM trace"),
              ElementsAre(ElementsAre("\"integer\"", "\"real\"")));
}

TEST_F(ViewsTest, ProgressCountsPendingJobs) {
  const auto sweep = operator_sweep("operators");
  EXPECT_EQ(sweep.what.jobs, 18U);
  const auto key = row(sweep);
  EXPECT_THAT(rows("SELECT sweep, state, jobs, pending, jobs_per_second, seconds_left, ended FROM progress"),
              ElementsAre(ElementsAre("\"operators\"", "\"running\"", "18", "18", "null", "null", "null")));
  store_.commit(
      {.jobs = {done_job(sweep, key, 4), done_job(sweep, key, 5), ended_job(sweep, key, 6, JobState::failed),
                ended_job(sweep, key, 7, JobState::quarantined), ended_job(sweep, key, 8, JobState::cancelled)}});
  raw_connection(path_).execute("UPDATE sweep SET created = 1000000, last_result = 1002000");
  EXPECT_THAT(rows("SELECT pending, done, failed, quarantined, cancelled, jobs_per_second, seconds_left, submitted "
                   "FROM progress"),
              ElementsAre(ElementsAre("13", "2", "1", "1", "1", "2.5", "5.2", "\"1970-01-01T00:16:40Z\"")));
}

}  // namespace
}  // namespace lamprey::storage::testing
