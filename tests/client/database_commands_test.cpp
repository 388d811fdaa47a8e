#include "messaging/program/build_info.hpp"
#include "tests/client/site.hpp"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sqlite3.h>

namespace lamprey::tests {
namespace {

/// A database with five computed jobs, one that failed, and two that have not ended.
class DatabaseCommandsTest : public testing::Test {
 protected:
  Site site;
  std::string database = site.database(small_sweep, 5);

  void change(const std::string& sql) const {
    sqlite3* handle = nullptr;
    ASSERT_EQ(sqlite3_open(database.c_str(), &handle), SQLITE_OK);
    EXPECT_EQ(sqlite3_exec(handle, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK) << sqlite3_errmsg(handle);
    sqlite3_close(handle);
  }
};

TEST_F(DatabaseCommandsTest, ResultsHasARowForEveryEndedJob) {
  const auto run = site.run({"results", "small", "--database", database, "--format", "json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const auto json = run.json();
  ASSERT_TRUE(json.is_object()) << run.out;
  EXPECT_EQ(json.begin().key(), "schema");
  EXPECT_EQ(json["schema"], "lamprey/results/1");
  ASSERT_EQ(json["rows"].size(), 6U);
  EXPECT_EQ(json["more"], false);
  EXPECT_EQ(json["rows"][0]["expected_total"], 80 + 60 + 0.25 * 83);
  EXPECT_EQ(json["rows"][5]["state"], "failed");
  EXPECT_EQ(json["rows"][5]["evolved_total"], nullptr);
}

TEST_F(DatabaseCommandsTest, ResultsHonoursLimitAndColumns) {
  const auto json = site.run({"results", "small", "--database", database, "--format", "json", "--limit", "2",
                              "--columns", "job,steps"})
                        .json();
  EXPECT_EQ(json["more"], true);
  EXPECT_EQ(json["rows"], client::Json::parse(R"([{"job":0,"steps":"uniform"},{"job":1,"steps":"uniform"}])"));
  EXPECT_EQ(site.run({"results", "small", "--database", database, "--format", "csv", "--limit", "6", "--columns",
                      "job,state"})
                .out,
            "job,state\n0,done\n1,done\n2,done\n3,done\n4,done\n5,failed\n");
}

TEST_F(DatabaseCommandsTest, AResultsTableShowsWhatDiffersAndFitsItsWidth) {
  const auto run = site.run({"results", "small", "--database", database}, 80);
  EXPECT_EQ(run.exit_code, 0);
  const auto header = run.out.substr(0, run.out.find('\n'));
  EXPECT_NE(header.find("required_fuel"), std::string::npos) << header;
  EXPECT_NE(header.find("evolved_total"), std::string::npos) << header;
  EXPECT_NE(header.find("state"), std::string::npos) << "a job has failed";
  EXPECT_EQ(header.find("gait"), std::string::npos) << "it is the same in all rows";
  EXPECT_LE(header.size(), 80U);
}

TEST_F(DatabaseCommandsTest, ResultsExplainsUnknownNames) {
  const auto sweep = site.run({"results", "smal", "--database", database});
  EXPECT_EQ(sweep.exit_code, 2);
  EXPECT_NE(sweep.err.find("did you mean 'small'?"), std::string::npos) << sweep.err;
  const auto column = site.run({"results", "small", "--database", database, "--columns", "evolved_totl"});
  EXPECT_EQ(column.exit_code, 2);
  EXPECT_EQ(column.out, "");
  EXPECT_NE(column.err.find("did you mean 'evolved_total'?"), std::string::npos) << column.err;
}

TEST_F(DatabaseCommandsTest, ReplayFindsTheSameBits) {
  const auto run = site.run({"replay", "small", "3", "--database", database, "--format", "json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const auto json = run.json();
  EXPECT_EQ(json["schema"], "lamprey/replay/1");
  EXPECT_EQ(json["same"], true);
  EXPECT_EQ(json["stored_digest"], json["computed_digest"]);
  EXPECT_NE(site.run({"replay", "small", "3", "--database", database}).out.find("the same"), std::string::npos);
}

TEST_F(DatabaseCommandsTest, ReplayOfAnotherDigestEndsWithFive) {
  change("UPDATE job SET digest = (SELECT digest FROM job WHERE job = 0) WHERE job = 3");
  const auto run = site.run({"replay", "small", "3", "--database", database});
  EXPECT_EQ(run.exit_code, 5);
  EXPECT_NE(run.out.find("DIFFERENT"), std::string::npos) << run.out;
  EXPECT_EQ(site.run({"replay", "small", "3", "--database", database, "--format", "json"}).json()["same"], false);
}

TEST_F(DatabaseCommandsTest, ReplayOfAnotherBuildsDigestIsNoMismatchWhereOnlyTheSameBuildRepeatsIt) {
  database = site.database(
      "name: outside\nbase: {cycles: 40, trainer: pagmo_sga}\n"
      "grids:\n  - {required_fuel: [10, 20, 30, 40], required_stability: [25, 50]}\n",
      5);
  EXPECT_EQ(site.run({"replay", "outside", "3", "--database", database}).exit_code, 0);
  change("UPDATE job SET digest = (SELECT digest FROM job WHERE job = 0), worker = 7 WHERE job = 3");
  const auto unknown = site.run({"replay", "outside", "3", "--database", database});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_NE(unknown.err.find("was computed by a build that is not known"), std::string::npos) << unknown.err;
  change(
      "INSERT INTO worker (worker, host, process, threads, build, dds, first_seen, last_seen) "
      "VALUES (7, 'host', 1, 1, '0.0.1', 'x', 0, 0)");
  const auto other = site.run({"replay", "outside", "3", "--database", database});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_NE(other.err.find("was computed by build 0.0.1"), std::string::npos) << other.err;
  change("UPDATE worker SET build = '" + messaging::program::build() + "'");
  EXPECT_EQ(site.run({"replay", "outside", "3", "--database", database}).exit_code, 5);
}

TEST_F(DatabaseCommandsTest, ReplayShowsMeasures) {
  database = site.database(
      "name: details\nbase: {cycles: 40, record: details}\n"
      "grids:\n  - {required_fuel: [10, 20, 30, 40], required_stability: [25, 50]}\n",
      5);
  const auto measures =
      site.run({"replay", "details", "3", "--database", database, "--format", "json"}).json()["outcome"]["measures"];
  ASSERT_GE(measures.size(), 2U);
  EXPECT_EQ(measures[0]["name"], "off_line_performance");
  EXPECT_EQ(measures[0]["index"], 0);
  EXPECT_TRUE(measures[0]["value"].is_number());
  const auto table = site.run({"replay", "details", "3", "--database", database}).out;
  EXPECT_NE(table.find("off_line_performance"), std::string::npos) << table;
}

TEST_F(DatabaseCommandsTest, ReplayRefusesWhatItCannotCompare) {
  const auto failed = site.run({"replay", "small", "5", "--database", database});
  EXPECT_EQ(failed.exit_code, 2);
  EXPECT_NE(failed.err.find("it is failed (no memory)"), std::string::npos) << failed.err;
  const auto pending = site.run({"replay", "small", "6", "--database", database});
  EXPECT_NE(pending.err.find("job 6 of sweep small has not ended"), std::string::npos) << pending.err;
  const auto none = site.run({"replay", "small", "8", "--database", database});
  EXPECT_NE(none.err.find("its jobs are 0 to 7"), std::string::npos) << none.err;
  change("UPDATE sweep SET science_version = 999");
  const auto other = site.run({"replay", "small", "3", "--database", database});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_NE(other.err.find("science version 999"), std::string::npos) << other.err;
}

TEST_F(DatabaseCommandsTest, VerifyFindsASoundDatabaseInOrder) {
  const auto run = site.run({"verify", database, "--format", "json"});
  EXPECT_EQ(run.exit_code, 0) << run.out;
  const auto json = run.json();
  EXPECT_EQ(json["schema"], "lamprey/verify/1");
  EXPECT_EQ(json["jobs"], 6);
  EXPECT_TRUE(json["discrepancies"].empty());
}

TEST_F(DatabaseCommandsTest, VerifyNamesTheJobOfAChangedValueAndEndsWithFive) {
  change("UPDATE job SET evolved_total = evolved_total + 1 WHERE job = 2");
  const auto run = site.run({"verify", database, "--format", "json"});
  EXPECT_EQ(run.exit_code, 5);
  const auto found = run.json()["discrepancies"];
  ASSERT_FALSE(found.empty()) << run.out;
  EXPECT_EQ(found[0]["job"], 2);
  EXPECT_NE(site.run({"verify", database}).out.find("what is wrong"), std::string::npos);
}

TEST_F(DatabaseCommandsTest, WhatIsNoDatabaseEndsWithSix) {
  for (const auto& path : {site.path("nothing.db"), site.file("text.db", "this is not a database, but long enough")}) {
    for (const auto& arguments :
         {std::vector<std::string>{"verify", path}, std::vector<std::string>{"results", "small", "--database", path},
          std::vector<std::string>{"replay", "small", "0", "--database", path}}) {
      const auto run = site.run(arguments);
      EXPECT_EQ(run.exit_code, 6) << arguments[0] << ": " << run.err;
      EXPECT_NE(run.err.find(path), std::string::npos) << run.err;
    }
  }
  EXPECT_FALSE(std::filesystem::exists(site.path("nothing.db")));
}

TEST_F(DatabaseCommandsTest, BackupSaysWhatItHasCopiedAndTheCopyIsTheSame) {
  const auto copy = site.path("copy.db");
  const auto run = site.run({"backup", database, copy, "--format", "json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto json = run.json();
  EXPECT_EQ(json["schema"], "lamprey/backup/1");
  EXPECT_EQ(json["database"], database);
  EXPECT_EQ(json["target"], copy);
  EXPECT_EQ(json["sweeps"], 1);
  EXPECT_EQ(json["jobs"], 6);
  EXPECT_EQ(json["bytes"], std::filesystem::file_size(copy));
  EXPECT_EQ(json["schema_version"], 4);
  EXPECT_EQ(site.run({"verify", copy}).exit_code, 0);
  const auto rows = [&](const std::string& path) {
    return site.run({"results", "small", "--database", path, "--format", "csv"}).out;
  };
  EXPECT_EQ(rows(copy), rows(database));
}

TEST_F(DatabaseCommandsTest, BackupReplacesOnlyWhenToldTo) {
  const auto copy = site.path("copy.db");
  EXPECT_NE(site.run({"backup", database, copy}).out.find("copy.db: 1 sweep with 6 ended jobs, "), std::string::npos);
  const auto again = site.run({"backup", database, copy, "--format", "json"});
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_EQ(again.json()["error"]["code"], "not_possible");
  EXPECT_NE(site.run({"backup", database, copy}).err.find("copy.db: exists already"), std::string::npos);
  EXPECT_EQ(site.run({"backup", database, copy, "--replace"}).exit_code, 0);
  EXPECT_EQ(site.run({"backup", database, database, "--replace"}).exit_code, 2);
  EXPECT_EQ(site.run({"backup", site.path("none.db"), copy, "--replace"}).exit_code, 6);
}

TEST_F(DatabaseCommandsTest, RunOfAnEndedSweepOnlySaysSo) {
  std::string yaml = small_sweep;
  const auto file = site.file("small.yaml", yaml);
  change("UPDATE sweep SET state = 'finished', done = 7");
  // No program is beside the tool here: starting one would fail.
  const auto run = site.run({"run", file, "--database", database, "--format", "json"});
  const auto json = run.json();
  ASSERT_TRUE(json.is_object()) << run.out << run.err;
  EXPECT_EQ(run.exit_code, 4) << "one of its jobs has failed";
  EXPECT_EQ(json["schema"], "lamprey/run/1");
  EXPECT_EQ(json["had_ended"], true);
  EXPECT_EQ(json["counts"]["failed"], 1);
}

TEST_F(DatabaseCommandsTest, RunOfAnotherSweepUnderTheSameNameChangesNothing) {
  std::string other = small_sweep;
  other.replace(other.find("seed: 7"), 7, "seed: 8");
  const auto before = std::filesystem::last_write_time(database);
  const auto run = site.run({"run", site.file("other.yaml", other), "--database", database, "--format", "json"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.json()["error"]["code"], "sweep_changed");
  EXPECT_EQ(std::filesystem::last_write_time(database), before);
}

TEST_F(DatabaseCommandsTest, RunWithABadSweepFileCreatesNothing) {
  const auto run = site.run({"run", site.file("bad.yaml", "name: bad\nseeed: 1\n"), "--database", site.path("new.db")});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("bad.yaml:2:"), std::string::npos) << run.err;
  EXPECT_FALSE(std::filesystem::exists(site.path("new.db")));
}

TEST_F(DatabaseCommandsTest, RunWithoutItsProgramsSaysWhichIsMissing) {
  const auto run = site.run({"run", site.file("small.yaml", small_sweep), "--database", site.path("new.db"), "-q"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("lamprey-coordinator is not beside this program"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace lamprey::tests
