#include "storage/migration.hpp"

#include "storage/schema.hpp"
#include "tests/storage/support.hpp"

#include <gmock/gmock.h>

namespace lamprey::storage::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using Kind = StorageError::Kind;

/// A database that the program of schema version 1 has made: a sweep of 14 jobs, one that was cancelled.
class MigrationTest : public ::testing::Test {
 protected:
  MigrationTest() {
    const Connection connection(path_, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, "");
    connection.execute(bytes_of(LAMPREY_VERSION_1_DUMP));
    connection.execute("PRAGMA journal_mode = WAL");
  }

  std::vector<std::vector<std::string>> rows(const std::string& sql) { return ResultsReader(path_).query(sql).rows; }

  /// What a migration must leave alone.
  std::vector<std::vector<std::string>> facts() {
    return rows(
        "SELECT s.name, j.job, j.state, j.identity, j.digest, j.worker, j.seed, j.replicate, j.evolved_total, j.trace, "
        "s.id, s.checksum, d.database_id FROM job AS j JOIN sweep AS s USING (sweep), database AS d ORDER BY 1, 2");
  }

  TemporaryDirectory directory_;
  std::string path_ = directory_.file("results.db");
};

TEST_F(MigrationTest, OpeningForWritingBringsVersion1UpToDateAndKeepsEveryDigest) {
  const auto before = facts();
  ASSERT_EQ(before.size(), 16U);
  const ResultsStore store(path_);
  EXPECT_EQ(store.migration(), "schema version 1 to 2, parameters of 14 jobs completed");
  EXPECT_EQ(text_of(verify(path_)), "");
  EXPECT_EQ(facts(), before);
  EXPECT_EQ(rows("PRAGMA user_version")[0][0], "2");
  EXPECT_EQ(rows("SELECT group_concat(version) FROM schema_version")[0][0], "\"1,2\"");
  EXPECT_EQ(rows("SELECT text FROM event WHERE kind = 'schema_migrated'")[0][0], '"' + store.migration() + '"');
}

TEST_F(MigrationTest, JobsHaveTheDefaultsOfParametersThatCameLater) {
  EXPECT_EQ(rows("SELECT count(*) FROM job WHERE parameters LIKE '%\"trainer\"%'")[0][0], "0");
  const ResultsStore store(path_);
  EXPECT_EQ(rows("SELECT DISTINCT trainer, push_factor, neuron FROM result WHERE state = 'done'"),
            (std::vector<std::vector<std::string>>{{"\"rtea\"", "1", "null"}}));
  EXPECT_EQ(rows("SELECT DISTINCT trainer FROM result WHERE state = 'cancelled'")[0][0], "null");
  EXPECT_EQ(rows("SELECT sum(jobs) FROM operators")[0][0], "14");
}

TEST_F(MigrationTest, MigratedDatabaseTakesNewResultsWithMeasures) {
  ResultsStore store(path_);
  const auto sweep = operator_sweep("later");
  auto outcome = made_up_outcome(3);
  outcome.measures = {{"recovered", 0, 1}};
  store.commit({.jobs = {done_job(sweep, store.add_sweep(sweep.what).sweep.row, 3, outcome)}});
  EXPECT_EQ(rows("SELECT value FROM measure")[0][0], "1");
  EXPECT_EQ(text_of(verify(path_)), "");
}

TEST_F(MigrationTest, MigratedDatabaseIsNotMigratedAgain) {
  { const ResultsStore store(path_); }
  const ResultsStore store(path_);
  EXPECT_EQ(store.migration(), "");
  EXPECT_EQ(rows("SELECT count(*) FROM event WHERE kind = 'schema_migrated'")[0][0], "1");
}

TEST_F(MigrationTest, ReadersReadVersion1WithoutChangingIt) {
  const auto before = bytes_of(path_);
  const ResultsReader reader(path_);
  const auto sweep = reader.find_sweep("operators");
  ASSERT_TRUE(sweep);
  const auto job = reader.job(sweep->row, 3);
  ASSERT_TRUE(job && job->outcome);
  EXPECT_EQ(experiment::outcome_digest(*job->identity, *job->outcome), job->digest);
  EXPECT_EQ(reader.results("operators", 0, 100).rows.size(), 14U);
  EXPECT_EQ(bytes_of(path_), before);
}

TEST_F(MigrationTest, ReadersOfVersion1AreToldWhatToDoAboutWhatItLacks) {
  const ResultsReader reader(path_);
  std::string message;
  EXPECT_EQ(error_of([&] { reader.query("SELECT * FROM measure"); }, &message), Kind::input_output);
  EXPECT_THAT(message, AllOf(HasSubstr(path_), HasSubstr("no such table: measure"), HasSubstr("schema version 1"),
                             HasSubstr("start lamprey-coordinator --database")));
  EXPECT_EQ(error_of([&] { verify(path_); }, &message), Kind::older_schema);
  EXPECT_THAT(message, AllOf(HasSubstr(path_), HasSubstr("start lamprey-coordinator --database")));
}

TEST_F(MigrationTest, MigrationThatFailsLeavesVersion1) {
  const auto before = facts();
  raw_connection(path_).execute(
      "CREATE TRIGGER no BEFORE UPDATE ON job WHEN old.job = 9 BEGIN SELECT raise(ABORT, 'no'); END");
  EXPECT_TRUE(error_of([&] { ResultsStore store(path_); }));
  EXPECT_EQ(rows("PRAGMA user_version")[0][0], "1");
  EXPECT_EQ(rows("SELECT count(*) FROM pragma_table_info('job') WHERE name = 'measures'")[0][0], "0");
  EXPECT_EQ(rows("SELECT count(*) FROM job WHERE parameters LIKE '%\"trainer\"%'")[0][0], "0");
  raw_connection(path_).execute("DROP TRIGGER no");
  const ResultsStore store(path_);
  EXPECT_EQ(facts(), before);
  EXPECT_EQ(text_of(verify(path_)), "");
}

// The registry grows without a new version of the tables, too.
TEST_F(MigrationTest, ParametersAreCompletedWheneverTheViewsAreMadeAnew) {
  { const ResultsStore store(path_); }
  const auto other = raw_connection(path_);
  other.execute("UPDATE job SET parameters = json_remove(parameters, '$.trainer') WHERE job < 3");
  EXPECT_NE(text_of(verify(path_)), "");
  other.execute("UPDATE database SET fingerprint = 'of another registry'");
  const ResultsStore store(path_);
  EXPECT_EQ(store.migration(), "parameters of 3 jobs completed");
  EXPECT_EQ(text_of(verify(path_)), "");
}

}  // namespace
}  // namespace lamprey::storage::testing
