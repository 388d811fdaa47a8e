#include "tests/client/running_coordinator.hpp"

#include <gtest/gtest.h>

namespace lamprey::tests {
namespace {

class CoordinatorCommandsTest : public testing::Test {
 protected:
  Site site;
  std::string sweep = site.file("small.yaml", small_sweep);
};

TEST_F(CoordinatorCommandsTest, NobodyThereEndsWithThreeAndSaysWhereItLooked) {
  const auto run = site.run(
      {"status", "--timeout", "0.1", "--isolation", "lab", "--domain", "7", "--peer", "host-a", "--format", "json"});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_EQ(run.json()["error"]["code"], "unreachable");
  EXPECT_NE(run.err.find("(in_memory, domain 7, isolation lab, peers host-a)"), std::string::npos) << run.err;
}

TEST_F(CoordinatorCommandsTest, AFileIsOfferedWhereItWouldDo) {
  const auto run = site.run({"results", "small", "--timeout", "0.1"});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_NE(run.err.find("--database FILE"), std::string::npos) << run.err;
}

TEST_F(CoordinatorCommandsTest, AnInterruptEndsTheSearch) {
  site.interrupted = true;
  const auto run = site.run({"status", "--timeout", "3600"});
  EXPECT_EQ(run.exit_code, 130);
  EXPECT_EQ(run.err, "lamprey: interrupted\n");
}

TEST_F(CoordinatorCommandsTest, SubmittingAgainChangesNothing) {
  const RunningCoordinator coordinator(site, site.path("c.db"), false);
  const auto first = site.run({"submit", sweep, "--format", "json"});
  EXPECT_EQ(first.exit_code, 0) << first.err;
  EXPECT_EQ(first.json()["schema"], "lamprey/submit/1");
  EXPECT_EQ(first.json()["jobs"], 8);
  EXPECT_EQ(first.json()["existed"], false);
  EXPECT_EQ(site.run({"submit", sweep, "--format", "json"}).json()["existed"], true);
  EXPECT_EQ(site.run({"status", "--format", "json"}).json()["sweeps"].size(), 1U);
}

TEST_F(CoordinatorCommandsTest, AnotherSweepOfTheSameNameIsRefused) {
  const RunningCoordinator coordinator(site, site.path("c.db"), false);
  EXPECT_EQ(site.run({"submit", sweep}).exit_code, 0);
  std::string other = small_sweep;
  other.replace(other.find("seed: 7"), 7, "seed: 8");
  const auto run = site.run({"submit", site.file("other.yaml", other), "--format", "json"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.json()["error"]["code"], "sweep_changed");
  EXPECT_EQ(run.json()["error"]["details"], client::Json::parse(R"(["seed: 7, now 8"])"));
  EXPECT_EQ(site.run({"submit", site.path("other.yaml"), "--name", "other"}).exit_code, 0);
}

TEST_F(CoordinatorCommandsTest, SubmitWaitsForTheEndAndTheResultsCanBeAskedFor) {
  const RunningCoordinator coordinator(site, site.path("c.db"), true);
  const auto run = site.run({"submit", sweep, "--wait", "--quiet", "--format", "json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.json()["state"], "finished");
  EXPECT_EQ(run.json()["counts"]["done"], 8);

  const auto status = site.run({"status", "small", "--format", "json"}).json();
  EXPECT_EQ(status["schema"], "lamprey/status/1");
  EXPECT_EQ(status["sweeps"][0]["state"], "finished");
  ASSERT_EQ(status["workers"].size(), 1U);
  EXPECT_EQ(status["workers"][0]["host"], "test-host");
  EXPECT_NE(site.run({"status"}).out.find("test-host"), std::string::npos);

  const auto asked = site.run({"results", "small", "--format", "csv"});
  EXPECT_EQ(asked.exit_code, 0) << asked.err;
  EXPECT_EQ(asked.out, site.run({"results", "small", "--format", "csv", "--database", site.path("c.db")}).out);

  EXPECT_EQ(site.run({"replay", "small", "7"}).exit_code, 0);
}

TEST_F(CoordinatorCommandsTest, ResultsOfMoreThanAPageComeWhole) {
  std::string many = small_sweep;
  many.replace(many.find("replicates: 2"), 13, "replicates: 65");
  many.replace(many.find("cycles: 20"), 10, "cycles: 1");
  const RunningCoordinator coordinator(site, site.path("c.db"), true);
  EXPECT_EQ(site.run({"submit", site.file("many.yaml", many), "--wait", "-q"}).exit_code, 0);
  const auto json = site.run({"results", "small", "--columns", "job", "--format", "json"}).json();
  ASSERT_EQ(json["rows"].size(), 260U);
  for (std::size_t i = 0; i < 260; ++i) EXPECT_EQ(json["rows"][i]["job"], i);
  EXPECT_EQ(
      site.run({"results", "small", "--columns", "job", "--limit", "101", "--format", "json"}).json()["rows"].size(),
      101U);
}

TEST_F(CoordinatorCommandsTest, ACancelledSweepEndsTheWaitWithFour) {
  const RunningCoordinator coordinator(site, site.path("c.db"), false);
  EXPECT_EQ(site.run({"submit", sweep}).exit_code, 0);
  const auto cancel = site.run({"cancel", "small", "--format", "json"});
  EXPECT_EQ(cancel.exit_code, 0) << cancel.err;
  EXPECT_EQ(cancel.json()["schema"], "lamprey/cancel/1");
  EXPECT_EQ(cancel.json()["cancelled"], 8);
  const auto wait = site.run({"submit", sweep, "--wait", "-q", "--format", "json"});
  EXPECT_EQ(wait.exit_code, 4);
  EXPECT_EQ(wait.json()["state"], "cancelled");
}

TEST_F(CoordinatorCommandsTest, UnknownSweepsAreAnsweredWithTheNearestName) {
  const RunningCoordinator coordinator(site, site.path("c.db"), false);
  EXPECT_EQ(site.run({"submit", sweep}).exit_code, 0);
  for (const auto& arguments :
       {std::vector<std::string>{"status", "smal"}, std::vector<std::string>{"cancel", "smal"},
        std::vector<std::string>{"results", "smal"}, std::vector<std::string>{"replay", "smal", "0"}}) {
    const auto run = site.run(arguments);
    EXPECT_EQ(run.exit_code, 2) << arguments[0];
    EXPECT_NE(run.err.find("did you mean"), std::string::npos) << run.err;
  }
  const auto replay = site.run({"replay", "small", "0"});
  EXPECT_EQ(replay.exit_code, 2);
  EXPECT_NE(replay.err.find("has not ended"), std::string::npos) << replay.err;
}

}  // namespace
}  // namespace lamprey::tests
