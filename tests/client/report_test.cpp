#include "client/evidence.hpp"
#include "client/json.hpp"
#include "client/output/formatting.hpp"
#include "experiment/sweep.hpp"
#include "storage/results_store.hpp"
#include "tests/client/site.hpp"

#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <iterator>
#include <sstream>

namespace lamprey::tests {
namespace {

using client::Json;
using experiment::Outcome;
using experiment::Parameters;
using Outcomes = std::function<Outcome(const Parameters&, std::uint64_t job)>;

/// An outcome with this total wherever there is one.
Outcome with_total(double total, double expected = 100, double success_rate = 0.1) {
  Outcome outcome;
  outcome.expected.total = expected;
  outcome.initial.total = 10;
  outcome.evolved.total = outcome.highest.total = outcome.final.total = total;
  outcome.cycles = 1000;
  outcome.success_rate = success_rate;
  return outcome;
}

/// Adds a sweep whose jobs ended with made-up outcomes.
void add_sweep(const std::string& database, const std::string& yaml, const Outcomes& outcome_of) {
  const auto file = experiment::parse_sweep(yaml, "test.yaml");
  const experiment::SweepGrid grid(file.specification);
  storage::ResultsStore store(database);
  const auto row = store
                       .add_sweep({.id = experiment::sweep_id(file.specification),
                                   .name = file.specification.name(),
                                   .specification = file.specification.SerializeAsString(),
                                   .source = yaml,
                                   .seed = file.specification.seed(),
                                   .replicates = grid.replicates(),
                                   .jobs = grid.jobs()})
                       .sweep.row;
  storage::Batch batch;
  for (std::uint64_t number = 0; number < grid.jobs(); ++number) {
    const auto job = grid.job(number);
    storage::EndedJob ended;
    ended.sweep = row;
    ended.job = number;
    ended.identity = experiment::identity(job);
    ended.parameters = experiment::to_json(job.parameters);
    ended.seed = job.seed;
    ended.replicate = job.replicate;
    ended.outcome = outcome_of(job.parameters, number);
    ended.digest = experiment::outcome_digest(*ended.identity, *ended.outcome);
    batch.jobs.push_back(std::move(ended));
  }
  store.commit(batch);
}

const std::string grid_yaml =
    "grids:\n"
    "  - mutation: [all, one]\n"
    "    steps: [uniform, normal]\n"
    "    acceptance: [simple, annealing]\n"
    "    equilibrium_disturbance: [25, 50, 75]\n"
    "    mutation_size: [25, 50, 75]\n"
    "  - {mutation: [all, one], steps: [one_fifth_rule], acceptance: [simple, annealing], equilibrium_disturbance: "
    "[25, "
    "50, 75]}\n"
    "  - mutation: [some]\n"
    "    steps: [uniform, normal]\n"
    "    acceptance: [simple, annealing]\n"
    "    equilibrium_disturbance: [25, 50, 75]\n"
    "    mutation_size: [25, 50, 75]\n"
    "  - {mutation: [some], steps: [one_fifth_rule], acceptance: [simple, annealing], equilibrium_disturbance: [25, "
    "50, "
    "75]}\n"
    "replicates: 2\n";

std::string grid_sweep(const std::string& name, const std::string& more = "") {
  return "name: " + name + "\nseed: 7\nbase: {cycles: 1000" + more + "}\n" + grid_yaml;
}

/// A world in which claims 1 to 5 hold: normal and uniform are alike, annealing gives the expected 100, simple 60 to
/// 70, mutate-one is ahead with annealing only, mutate-some is worst, and noise is small.
Outcome as_the_thesis_says(const Parameters& parameters, std::uint64_t job) {
  const bool annealing = parameters.choice("acceptance") == "annealing";
  const auto& mutation = parameters.choice("mutation");
  const double noise = 0.1 * static_cast<double>(job * 7919 % 11);
  double total = annealing ? 99 : 70;
  if (mutation == "one") total += annealing ? 5 : -15;
  if (mutation == "some") total -= 20;
  return with_total(total + noise, 100, (annealing ? 0.2 : 0.1) + noise / 1000);
}

class ReportTest : public testing::Test {
 protected:
  Site site;
  std::string database = site.path("results.db");

  Json report() { return site.run({"report", database, "--format", "json"}).json(); }

  static Json claim(const Json& report, int number) {
    for (const auto& claim : report["claims"]) {
      if (claim["number"] == number) return claim;
    }
    return {};
  }
  /// Of the claim's first reading, on that column.
  static std::string verdict(const Json& report, int number, const std::string& column) {
    return claim(report, number)["assessments"].at(0)["verdicts"].value(column, "none");
  }
};

TEST_F(ReportTest, ClaimsHoldInAWorldAsTheThesisHasIt) {
  add_sweep(database, grid_sweep("thesis-chapter-8"), as_the_thesis_says);
  const auto json = report();
  EXPECT_EQ(json["schema"], "lamprey/report/1");
  ASSERT_EQ(json["claims"].size(), 11U);
  for (const int number : {1, 2, 3, 4, 5}) {
    EXPECT_EQ(verdict(json, number, "evolved_total"), "holds") << claim(json, number).dump(1);
    EXPECT_EQ(verdict(json, number, "highest_total"), "holds") << number;
  }
  EXPECT_EQ(verdict(json, 6, "evolved_total"), "does not hold") << "no total depends on the disturbance";
}

TEST_F(ReportTest, ADifferenceBeyondTheMarginIsNoEquality) {
  add_sweep(database, grid_sweep("thesis-chapter-8"), [](const Parameters& parameters, std::uint64_t job) {
    auto outcome = as_the_thesis_says(parameters, job);
    if (parameters.choice("steps") == "normal") outcome.highest.total += 6;  // the margin is 5
    return outcome;
  });
  const auto json = report();
  EXPECT_EQ(verdict(json, 1, "evolved_total"), "holds");
  EXPECT_EQ(verdict(json, 1, "highest_total"), "does not hold");
  const auto differs = claim(json, 1)["assessments"][0]["differs"];
  ASSERT_EQ(differs.size(), 6U) << "every technique and acceptance, on one of two columns";
  EXPECT_NE(differs[0].get<std::string>().find("the thesis has it within ±5"), std::string::npos) << differs[0];
}

TEST_F(ReportTest, ANoisyDifferenceIsNotCalledOne) {
  add_sweep(database, grid_sweep("thesis-chapter-8"), [](const Parameters& parameters, std::uint64_t job) {
    return with_total(50 + static_cast<double>(job * 7919 % 101) +
                      (parameters.choice("acceptance") == "annealing" ? 0.1 : 0));
  });
  EXPECT_EQ(verdict(report(), 2, "evolved_total"), "does not hold");
}

TEST_F(ReportTest, TrendsOverTheSurfaceAreFound) {
  add_sweep(database, grid_sweep("thesis-chapter-8"), [](const Parameters& parameters, std::uint64_t job) {
    const double disturbance = static_cast<double>(parameters.integer("equilibrium_disturbance"));
    const bool sized = parameters.choice("steps") != "one_fifth_rule";
    const double size = sized ? static_cast<double>(parameters.integer("mutation_size")) : 50;
    const bool annealing = parameters.choice("acceptance") == "annealing";
    const bool all = parameters.choice("mutation") == "all";
    const double noise = 0.1 * static_cast<double>(job * 7919 % 11);
    if (!annealing) return with_total(70 - disturbance / 5 + size / 10 + noise);
    return with_total(all ? 80 + disturbance / 10 + size / 10 + noise : 80 + noise);
  });
  const auto json = report();
  EXPECT_EQ(verdict(json, 6, "evolved_total"), "holds") << claim(json, 6).dump(1);
  EXPECT_EQ(verdict(json, 7, "evolved_total"), "holds") << claim(json, 7).dump(1);
  const auto part = claim(json, 6)["assessments"][0]["parts"][0];
  EXPECT_NEAR(part["measured"][0]["estimate"].get<double>(), -5, 0.3) << "25 % more disturbance costs 5";
}

TEST_F(ReportTest, EveryReadingInTheDatabaseIsJudgedByItself) {
  add_sweep(database, grid_sweep("thesis-chapter-8"), as_the_thesis_says);
  add_sweep(database, grid_sweep("chapter-8-carry", ", posture: carry"),
            [](const Parameters&, std::uint64_t job) { return with_total(50 + static_cast<double>(job % 2)); });
  const auto assessments = claim(report(), 2)["assessments"];
  ASSERT_EQ(assessments.size(), 2U) << "simple acceptance has no temperature, and is no reading of its own";
  EXPECT_EQ(assessments[0]["reading"]["posture"], "reset");
  EXPECT_EQ(assessments[0]["verdicts"]["evolved_total"], "holds");
  EXPECT_EQ(assessments[1]["reading"]["posture"], "carry");
  EXPECT_EQ(assessments[1]["verdicts"]["evolved_total"], "does not hold");
}

TEST_F(ReportTest, TheShownQueryGivesTheShownNumber) {
  add_sweep(database, grid_sweep("thesis-chapter-8"), as_the_thesis_says);
  const auto part = claim(report(), 2)["assessments"][0]["parts"][0];
  const auto rows = client::Evidence(database).query(part["sql"].get<std::string>());
  ASSERT_EQ(rows.text(0, "mutation"), "all");
  EXPECT_EQ(rows.number(0, "evolved_total"), part["measured"][0]["estimate"].get<double>());
  EXPECT_EQ(rows.number(0, "n"), 36) << "two kinds of steps, three levels on both axes, two replicates";
}

TEST_F(ReportTest, WhatIsNotInTheDatabaseIsNotRunAndSaysWhatToRun) {
  add_sweep(database, small_sweep, [](const Parameters&, std::uint64_t) { return with_total(1); });
  const auto json = report();
  for (const auto& claim : json["claims"]) {
    EXPECT_TRUE(claim["assessments"].empty());
    EXPECT_FALSE(claim["not_run"].is_null());
    EXPECT_FALSE(claim["run"].empty());
  }
  EXPECT_EQ(claim(json, 8)["run"], Json::parse(R"(["lamprey run sweeps/figure-6-30.yaml"])"));
  const auto text = site.run({"report", database}).out;
  EXPECT_NE(text.find("(not run)"), std::string::npos) << text;
}

TEST_F(ReportTest, APartOfTheGridLeavesAClaimOpen) {
  add_sweep(
      database,
      "name: mutate-all\nseed: 7\nbase: {mutation: all, cycles: 10}\ngrids:\n"
      "  - {steps: [uniform, normal], acceptance: [simple, annealing], mutation_size: [25, 50, 75]}\nreplicates: 1\n",
      as_the_thesis_says);
  EXPECT_EQ(verdict(report(), 1, "evolved_total"), "not run") << "'under every mutation technique'";
}

TEST_F(ReportTest, JumpsAreTheLargestRisesOfTraces) {
  add_sweep(
      database,
      "name: figure-6-30\nseed: 7\nbase: {robot: biped, neuron: net_as_on_time, trainer: ii_rtea, objective: maximise, "
      "cycles: 100, time_steps: 40}\ngrids:\n"
      "  - {network: [feed_forward_pair, recurrent_pair], mutation_rate: [25, 50, 75, 100]}\nreplicates: 3\n",
      [](const Parameters& parameters, std::uint64_t job) {
        const bool recurrent = parameters.choice("network") == "recurrent_pair";
        Outcome outcome = with_total(recurrent ? 40 : 50);
        outcome.final.total += static_cast<double>(job % 3);
        if (parameters.real("mutation_rate") == 25) {
          outcome.final.total = outcome.initial.total;
          return outcome;
        }
        const double jump = (recurrent ? 25 : 5) + static_cast<double>(job % 3);
        outcome.trace = {{3, {0, 0, 0, 12}}, {9, {0, 0, 0, 12 + jump}}, {20, {0, 0, 0, 13 + jump}}};
        return outcome;
      });
  const auto json = report();
  EXPECT_EQ(verdict(json, 8, "final_total"), "holds") << claim(json, 8).dump(1);
  const auto jump = claim(json, 8)["assessments"][0]["parts"][0]["measured"][0];
  EXPECT_NEAR(jump["estimate"].get<double>(), 20, 1e-9);
}

TEST_F(ReportTest, ChangesOfGaitAreCountedFromMeasures) {
  for (const std::string mutation : {"all", "one"}) {
    add_sweep(database,
              "name: figure-9-" + std::string(mutation == "all" ? "5" : "6") +
                  "\nseed: 7\nbase: {network: tonic, mutation: " + mutation + ", cycles: 200}\nreplicates: 5\n",
              [&](const Parameters&, std::uint64_t job) {
                Outcome outcome = with_total(1);
                const double failures = mutation == "one" && job == 0 ? 900 : static_cast<double>(job);
                outcome.measures = {{"failures_after_last_change", 0, 3},
                                    {"gait_change_failures", 0, failures},
                                    {"gait_reached", 0, 1 + static_cast<double>(job % 4)}};
                return outcome;
              });
  }
  const auto json = report();
  const auto parts = claim(json, 11)["assessments"][0]["parts"];
  EXPECT_EQ(parts[0]["measured"][0]["verdict"], "holds") << "mutate all: mean of 0 to 4";
  EXPECT_EQ(parts[0]["measured"][0]["estimate"], 2);
  EXPECT_EQ(verdict(json, 11, "gait_change_failures"), "does not hold") << "mutate one took 900 once";
}

TEST_F(ReportTest, ATextFitsItsWidth) {
  add_sweep(database, grid_sweep("thesis-chapter-8"), as_the_thesis_says);
  const auto run = site.run({"report", database}, 100);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  std::istringstream lines(run.out);
  for (std::string line; std::getline(lines, line);) {
    if (line.find("lamprey run") == std::string::npos) {  // a path may be as long as it likes
      EXPECT_LE(client::output::width(line), 100U) << line;
    }
  }
  EXPECT_NE(run.out.find("Claim 2."), std::string::npos);
}

TEST_F(ReportTest, AnHtmlPageNeedsNoOtherFile) {
  add_sweep(database, grid_sweep("thesis-chapter-8"), as_the_thesis_says);
  const auto path = site.path("findings.html");
  const auto run = site.run({"report", database, "--format", "html", "--output", path, "--quiet"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  std::ifstream file(path);
  const std::string page((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_EQ(page.find("src="), std::string::npos);
  EXPECT_EQ(page.find("<link"), std::string::npos);
  EXPECT_NE(page.find("<svg"), std::string::npos) << run.err;
  EXPECT_NE(page.find("FROM result"), std::string::npos) << "the SQL is shown";
  EXPECT_NE(page.find("steps = 'normal'"), std::string::npos);
}

TEST_F(ReportTest, AFormatThatIsUnknownIsRefused) {
  const auto run = site.run({"report", database, "--format", "table"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("text"), std::string::npos) << run.err;
}

TEST_F(ReportTest, AMissingDatabaseIsAnError) {
  EXPECT_EQ(site.run({"report", site.path("none.db")}).exit_code, 6);
}

}  // namespace
}  // namespace lamprey::tests
