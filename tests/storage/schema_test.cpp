#include "storage/schema.hpp"

#include "experiment/parameters.hpp"
#include "tests/storage/support.hpp"

#include <gmock/gmock.h>
#include <map>
#include <set>

namespace lamprey::storage::testing {
namespace {

using ::testing::Contains;
using ::testing::Not;

class SchemaTest : public ::testing::Test {
 protected:
  TemporaryDirectory directory_;
  std::string path_ = directory_.file("results.db");
};

/// A JSON literal of plain text without its quotes.
std::string unquoted(const std::string& literal) {
  return literal.substr(1, literal.size() - 2);
}

std::vector<std::string> objects(const ResultsReader& reader) {
  std::vector<std::string> names;
  for (const auto& name : column_of(reader,
                                    "SELECT name FROM sqlite_master WHERE type IN ('table', 'view') "
                                    "AND name NOT LIKE 'sqlite_%'")) {
    names.push_back(unquoted(name));
  }
  return names;
}

std::vector<std::string> columns(const ResultsReader& reader, const std::string& object) {
  std::vector<std::string> names;
  for (const auto& row : reader.query("PRAGMA table_info('" + object + "')").rows) names.push_back(unquoted(row[1]));
  return names;
}

TEST_F(SchemaTest, EveryTableViewAndColumnIsDescribedAndNothingElse) {
  const ResultsStore store(path_);
  const ResultsReader reader(path_);
  std::set<std::string> existing;
  for (const auto& object : objects(reader)) {
    existing.insert(object + ".");
    for (const auto& column : columns(reader, object)) existing.insert(object + "." + column);
  }
  std::set<std::string> described;
  for (const auto& row : reader.query("SELECT object, \"column\", description FROM schema_description").rows) {
    described.insert(unquoted(row[0]) + "." + unquoted(row[1]));
    EXPECT_GT(row[2].size(), 5U) << row[0] << row[1];
  }
  EXPECT_EQ(described, existing);
}

TEST_F(SchemaTest, TablesAndViewsAreThoseOfTheContract) {
  const ResultsStore store(path_);
  EXPECT_THAT(objects(ResultsReader(path_)),
              ::testing::UnorderedElementsAre(
                  "sweep", "job", "worker", "event", "divergence", "database", "schema_version", "schema_description",
                  "attempt", "checkpoint", "audit", "audit_job", "recording", "robot_evaluation", "recordings",
                  "motion", "gap", "provenance", "attempts", "audits", "history", "result", "trace", "measure",
                  "recovery", "gait_change", "variation", "progress", "figure_6_25", "figure_6_27", "figure_6_30",
                  "figure_9_5", "figure_9_6", "figure_8_3", "figure_8_4", "figure_8_5", "figure_8_6", "figure_8_7",
                  "figure_8_8", "figure_8_9", "figure_8_10", "operators", "disturbance_by_mutation_size"));
}

TEST_F(SchemaTest, ResultHasTheColumnsOfTheContract) {
  const ResultsStore store(path_);
  std::vector<std::string> expected = {"sweep", "job", "state", "digest", "attempt", "worker", "seed", "replicate"};
  for (const auto& parameter : experiment::registry()) expected.emplace_back(parameter.name);
  for (const std::string score : {"expected", "initial", "evolved", "highest", "final"}) {
    for (const std::string part : {"stability", "distance", "fuel", "total"}) expected.push_back(score + "_" + part);
  }
  expected.insert(expected.end(), {"success_rate", "seconds", "repeatability"});
  EXPECT_EQ(columns(ResultsReader(path_), "result"), expected);
  EXPECT_EQ(std::set(expected.begin(), expected.end()).size(), expected.size()) << "a parameter takes a reserved name";
}

TEST_F(SchemaTest, ApplicationIdAndVersionsStandInTheFile) {
  const ResultsStore store(path_);
  const ResultsReader reader(path_);
  EXPECT_EQ(value_of(reader, "PRAGMA application_id"), std::to_string(application_id));
  EXPECT_EQ(value_of(reader, "PRAGMA user_version"), "4");
  EXPECT_EQ(value_of(reader, "SELECT version FROM schema_version"), "4");
  // Bytes 18 and 19 of the header: 2 is a write-ahead log.
  EXPECT_EQ(bytes_of(path_).substr(18, 2), "\x02\x02");
}

TEST_F(SchemaTest, ViewsOfAnotherRegistryAreMadeAnewAndForeignViewsKept) {
  { const ResultsStore store(path_); }
  const auto fresh = column_of(ResultsReader(path_), "SELECT sql FROM sqlite_master WHERE type = 'view' ORDER BY name");
  {
    // As a program with fewer parameters, and one more view, would have left it.
    const auto other = raw_connection(path_);
    other.execute(
        "DROP VIEW result; CREATE VIEW result AS SELECT job FROM job; CREATE VIEW figure_old AS SELECT 1 AS a;"
        "DELETE FROM schema_description WHERE object = 'result';"
        "INSERT INTO schema_description VALUES ('result', '', 'fewer'), ('figure_old', '', 'gone');"
        "UPDATE database SET fingerprint = 'another'; CREATE VIEW mine AS SELECT 2 AS b");
  }
  { const ResultsStore store(path_); }
  const ResultsReader reader(path_);
  EXPECT_EQ(column_of(reader, "SELECT sql FROM sqlite_master WHERE type = 'view' AND name <> 'mine' ORDER BY name"),
            fresh);
  EXPECT_THAT(objects(reader), Contains("mine"));
  EXPECT_THAT(objects(reader), Not(Contains("figure_old")));
  EXPECT_EQ(text_of(verify(path_)), "");
}

TEST_F(SchemaTest, OpeningAgainLeavesCurrentViewsAlone) {
  { const ResultsStore store(path_); }
  const auto version = [&] { return value_of(ResultsReader(path_), "PRAGMA schema_version"); };
  const auto before = version();
  { const ResultsStore store(path_); }
  EXPECT_EQ(version(), before);
}

}  // namespace
}  // namespace lamprey::storage::testing
