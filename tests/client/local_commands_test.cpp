#include "experiment/parameters.hpp"
#include "tests/client/site.hpp"

#include <gtest/gtest.h>

namespace lamprey::tests {
namespace {

class LocalCommandsTest : public testing::Test {
 protected:
  Site site;
};

TEST_F(LocalCommandsTest, PlanCountsJobsCellsAndCycles) {
  const auto run = site.run({"plan", site.file("small.yaml", small_sweep), "--format", "json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const auto json = run.json();
  EXPECT_EQ(json.begin().key(), "schema");
  EXPECT_EQ(json["schema"], "lamprey/plan/1");
  EXPECT_EQ(json["sweep"], "small");
  EXPECT_EQ(json["jobs"], 8);
  EXPECT_EQ(json["cells"], 4);
  EXPECT_EQ(json["replicates"], 2);
  EXPECT_EQ(json["cycles"], 160);
  EXPECT_EQ(json["grids"][0]["axes"][1]["values"], client::Json({25, 50}));
  EXPECT_EQ(json["first_job"]["parameters"]["steps"], "uniform");
  EXPECT_EQ(json["last_job"]["number"], 7);
  EXPECT_EQ(json["last_job"]["replicate"], 1);
  EXPECT_EQ(json["last_job"]["parameters"]["required_fuel"], 50);
}

TEST_F(LocalCommandsTest, PlanSumsAnAxisOfCyclesAndOtherGridsOnTopOfIt) {
  const auto file = site.file("cycles.yaml",
                              "name: cycles\n"
                              "grids:\n"
                              "  - {cycles: [10, 1000], required_fuel: [25, 50, 75]}\n"
                              "  - {cycles: [7], steps: [normal]}\n"
                              "replicates: 4\n");
  EXPECT_EQ(site.run({"plan", file, "--format", "json"}).json()["cycles"], 4 * (3 * 1010 + 7));
}

TEST_F(LocalCommandsTest, PlanShowsAxesAndFirstAndLastJob) {
  const auto run = site.run({"plan", site.file("small.yaml", small_sweep)});
  EXPECT_NE(run.out.find("8 = 4 cells x 2 replicates"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("required_fuel       2  25, 50\n"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("first job: 0"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("last job: 7"), std::string::npos) << run.out;
}

TEST_F(LocalCommandsTest, PlanNamesFileLineFieldAndValueOfAProblem) {
  const auto file = site.file("bad.yaml", "name: bad\ngrids:\n  - {steps: [unifrom]}\n");
  const auto run = site.run({"plan", file});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_TRUE(run.err.starts_with("lamprey: error: " + file + ":3:")) << run.err;
  EXPECT_NE(run.err.find("grids[0].steps"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("did you mean 'uniform'?"), std::string::npos) << run.err;
}

TEST_F(LocalCommandsTest, EvaluateGivesThePublishedFitnessOfTheWalk) {
  const auto run = site.run({"evaluate", "gait=walk", "--format", "json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const auto json = run.json();
  EXPECT_EQ(json["schema"], "lamprey/evaluate/1");
  EXPECT_EQ(json["stability"], 80);
  EXPECT_EQ(json["distance"], 60);
  EXPECT_EQ(json["fuel"], 83);
  EXPECT_EQ(json["total"], 223);
}

TEST_F(LocalCommandsTest, EvaluateWeighsTheTotalByTheRequirements) {
  EXPECT_EQ(site.run({"evaluate", "required_distance=50", "required_fuel=0", "--format", "json"}).json()["total"], 110);
}

TEST_F(LocalCommandsTest, EvaluateExplainsEverythingThatIsWrongAtOnce) {
  const auto run = site.run({"evaluate", "gate=walk", "steps=unifrom", "required_fuel=101", "cycles"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("unknown parameter 'gate'; did you mean 'gait'?"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("did you mean 'uniform'?"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("from 0 to 100"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("'cycles' is not of the form PARAMETER=VALUE"), std::string::npos) << run.err;
}

TEST_F(LocalCommandsTest, ParametersListsTheWholeRegistry) {
  const auto json = site.run({"parameters", "--format", "json"}).json();
  EXPECT_EQ(json["schema"], "lamprey/parameters/2");
  ASSERT_EQ(json["parameters"].size(), experiment::registry().size());
  const auto table = site.run({"parameters"}).out;
  for (const auto& parameter : experiment::registry()) {
    EXPECT_NE(table.find("\n" + std::string(parameter.name) + " "), std::string::npos) << parameter.name;
  }
}

TEST_F(LocalCommandsTest, ParametersSaysWhatANamedOneTakesAndWhenItApplies) {
  const auto json = site.run({"parameters", "mutation_size", "--format", "json"}).json()["parameters"];
  ASSERT_EQ(json.size(), 1U);
  EXPECT_EQ(json[0]["default"], 50);
  EXPECT_EQ(json[0]["minimum"], 0);
  EXPECT_EQ(json[0]["maximum"], 100);
  const auto& condition = json[0]["applies_when"].back();
  EXPECT_EQ(condition["parameter"], "steps");
  EXPECT_EQ(condition["is"], false);
  EXPECT_EQ(condition["values"], client::Json::array({"one_fifth_rule"}));
  EXPECT_NE(site.run({"parameters", "mutation_size"}).out.find("steps is not one_fifth_rule"), std::string::npos);
}

}  // namespace
}  // namespace lamprey::tests
