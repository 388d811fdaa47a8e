#include "client/command.hpp"
#include "client/output/formatting.hpp"
#include "tests/client/site.hpp"

#include <gtest/gtest.h>

namespace lamprey::tests {
namespace {

using testing::TestWithParam;

class CommandLineTest : public testing::Test {
 protected:
  Site site;
};

TEST_F(CommandLineTest, WithoutACommandTheOverviewNamesAllOfThem) {
  const auto run = site.run({});
  EXPECT_EQ(run.exit_code, 2);
  for (const auto& command : client::command_table()) {
    EXPECT_NE(run.out.find("\n  " + std::string(command.name) + " "), std::string::npos) << command.name;
  }
  EXPECT_EQ(site.run({"--help"}).exit_code, 0);
}

TEST_F(CommandLineTest, HelpOfEveryCommandFitsItsWidthAndNamesItsOptions) {
  for (const auto& command : client::command_table()) {
    const auto run = site.run({std::string(command.name), "--help"}, 80);
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_NE(run.out.find("lamprey " + std::string(command.name)), std::string::npos);
    const std::vector<std::string> formats(command.formats.begin(), command.formats.end());
    EXPECT_NE(run.out.find("--format " + client::output::joined(formats, "|")), std::string::npos) << command.name;
    EXPECT_NE(run.out.find("(default: " + formats.front() + ")"), std::string::npos) << command.name;
    std::istringstream lines(run.out.substr(0, run.out.find("\nExample")));
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << command.name << ": " << line;
    EXPECT_EQ(site.run({"help", std::string(command.name)}).out, site.run({std::string(command.name), "-h"}).out);
  }
}

TEST_F(CommandLineTest, VersionNamesBuildAndScience) {
  const auto run = site.run({"--version"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_TRUE(run.out.starts_with("lamprey ")) << run.out;
  EXPECT_NE(run.out.find("science version " + std::to_string(experiment::science_version)), std::string::npos);
}

struct Mistake {
  std::vector<std::string> arguments;
  std::string message;
};

class MistakeTest : public TestWithParam<Mistake> {
 protected:
  Site site;
};

TEST_P(MistakeTest, IsExplainedAndEndsWithTwo) {
  const auto run = site.run(GetParam().arguments);
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_TRUE(run.err.starts_with("lamprey: error: ")) << run.err;
  EXPECT_NE(run.err.find(GetParam().message), std::string::npos) << run.err;
}

INSTANTIATE_TEST_SUITE_P(
    All, MistakeTest,
    testing::Values(
        Mistake{{"plam"}, "unknown command 'plam'; did you mean 'plan'?"},
        Mistake{{"frobnicate"}, "known are plan, run, results"}, Mistake{{"--workers"}, "the command comes first"},
        Mistake{{"plan"}, "plan: FILE is required"}, Mistake{{"plan", "a", "b"}, "plan: unexpected argument: b"},
        Mistake{{"plan", "a", "--formt", "json"}, "unknown option '--formt'; did you mean '--format'?"},
        Mistake{{"plan", "a", "--format", "jsn"}, "--format takes one of table, json, not 'jsn'; did you mean 'json'?"},
        Mistake{{"plan", "a", "--format", "csv"}, "--format takes one of table, json, not 'csv'"},
        Mistake{{"evaluate", "--format"}, "--format needs a value"},
        Mistake{{"run", "a"}, "run: --database is required"},
        Mistake{{"run", "a", "--databse", "b"}, "did you mean '--database'?"},
        Mistake{{"run", "a", "--database", "b", "--workers", "0"},
                "--workers takes a whole number from 1 to 64, not '0'"},
        Mistake{{"run", "a", "--database", "b", "--threads", "x"},
                "--threads takes a whole number from 1 to 1024, not 'x'"},
        Mistake{{"run", "a", "--database", "b", "--isolation", "c"}, "unknown option '--isolation'"},
        Mistake{{"submit"}, "submit: FILE is required"},
        Mistake{{"submit", "a", "--timeout", "0"}, "--timeout takes a number from 0.1 to 86400, not '0'"},
        Mistake{{"status", "a", "b"}, "unexpected argument: b"},
        Mistake{{"status", "--domain", "1000"}, "'1000' is not a DDS domain"},
        Mistake{{"status", "--interface", "127.0.0.2"}, "did you mean '127.0.0.1'?"},
        Mistake{{"status", "--interface", "lo"}, "to stay on this machine take --loopback-only"},
        Mistake{{"status", "--discovery-server", "a"}, "--discovery-server: Cyclone DDS has no discovery server"},
        Mistake{{"net", "--discovery-server", "a", "--dds", "fastdds", "--peer", "b"}, "--discovery-server"},
        Mistake{{"status", "--config", "/nonexistent.yaml"}, "/nonexistent.yaml: no such file"},
        Mistake{{"run", "a", "--database", "b", "--interface", "eth0"}, "unknown option '--interface'"},
        Mistake{{"cancel"}, "cancel: SWEEP is required"}, Mistake{{"results"}, "results: SWEEP is required"},
        Mistake{{"results", "a", "--limit", "-1"}, "--limit takes a whole number from 0 to 4294967295, not '-1'"},
        Mistake{{"replay", "a"}, "replay: JOB is required"},
        Mistake{{"replay", "a", "first"}, "JOB takes a whole number from 0 on, not 'first'"},
        Mistake{{"verify"}, "verify: DATABASE is required"}, Mistake{{"pause"}, "pause: SWEEP is required"},
        Mistake{{"drain"}, "drain: WORKER is required"},
        Mistake{{"adjust", "a"}, "adjust: nothing to change; give --priority, --max-concurrent or both"},
        Mistake{{"adjust", "a", "--priority", "1001"},
                "--priority takes a whole number from -1000 to 1000, not '1001'"},
        Mistake{{"adjust", "a", "--max-concurrent", "-1"},
                "--max-concurrent takes a whole number from 0 to 100000000, not '-1'"},
        Mistake{{"rename", "a", "a b"}, "'a b' is not allowed: a name has 1 to 100 letters"},
        Mistake{{"audit", "a", "--share", "0"}, "--share takes a share above 0 and up to 1"},
        Mistake{{"audit", "a", "--share", "101%"}, "or a percentage such as 5%, not '101%'"},
        Mistake{{"trace", "a", "first"}, "JOB takes a whole number from 0 on, not 'first'"},
        Mistake{{"submit", "a", "--priority", "high"}, "not 'high'"}, Mistake{{"resum"}, "did you mean 'resume'?"},
        Mistake{{"parameters", "gate"}, "unknown parameter 'gate'; did you mean 'gait'?"},
        Mistake{{"plan", "/nonexistent/sweep.yaml"}, "/nonexistent/sweep.yaml: no such file"}));

TEST_F(CommandLineTest, MistakesInAConfigurationFileAreToldWithTheirPlace) {
  const auto file = site.file("site.yaml", "isolation: lab\ndoman: 7\ndds: rti\n");
  const auto run = site.run({"status", "--config", file, "--format", "json"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.json()["error"]["code"], "invalid_input");
  EXPECT_EQ(run.json()["error"]["messages"].size(), 2U) << "one for each problem";
  EXPECT_NE(run.err.find(file + ":2:1: "), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("'doman'; did you mean 'domain'?"), std::string::npos) << run.err;
}

TEST_F(CommandLineTest, MistakesAreDocumentsWhereJsonIsWanted) {
  for (const auto& arguments : {std::vector<std::string>{"plam", "--format", "json"},
                                std::vector<std::string>{"plan", "a", "--formatt", "--format=json"}}) {
    const auto run = site.run(arguments);
    const auto json = run.json();
    ASSERT_TRUE(json.is_object()) << run.out;
    EXPECT_EQ(json.begin().key(), "schema");
    EXPECT_EQ(json["schema"], "lamprey/error/1");
    EXPECT_EQ(json["error"]["code"], "usage");
    EXPECT_EQ(json["error"]["messages"].size(), 1U);
    EXPECT_FALSE(run.err.empty()) << "people get the text as well";
  }
}

TEST_F(CommandLineTest, ControlCharactersOfACommandLineDoNotReachTheTerminal) {
  const auto run = site.run({"\x1b[2Jplan"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.err.find('\x1b'), std::string::npos) << run.err;
}

}  // namespace
}  // namespace lamprey::tests
