#include "storage/migration.hpp"

#include "storage/schema.hpp"
#include "tests/storage/power_cut_vfs.hpp"
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
  EXPECT_EQ(store.migration(), "schema version 1 to 4, parameters of 14 jobs completed");
  EXPECT_EQ(text_of(verify(path_)), "");
  EXPECT_EQ(facts(), before);
  EXPECT_EQ(rows("PRAGMA user_version")[0][0], "4");
  EXPECT_EQ(rows("SELECT group_concat(version) FROM schema_version")[0][0], "\"1,4\"");
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

/// A database that the program of schema version 2 has made: a finished sweep with measures and a divergence, one that
/// was cancelled, with a job that failed, and one that goes on, with a job that was quarantined.
class MigrationFrom2Test : public MigrationTest {
 protected:
  MigrationFrom2Test() {
    for (const char* suffix : {"", "-wal", "-shm"}) std::filesystem::remove(path_ + suffix);
    const Connection connection(path_, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, "");
    connection.execute(bytes_of(LAMPREY_VERSION_2_DUMP));
    connection.execute("PRAGMA journal_mode = WAL");
  }

  /// Every value of every table that version 2 had, by its own columns.
  std::string everything() {
    std::string text;
    for (const char* sql :
         {"SELECT sweep, id, name, state, specification, source, seed, replicates, jobs, science_version, checksum, "
          "created, ended, last_result, done, failed, quarantined, cancelled, divergences FROM sweep ORDER BY sweep",
          "SELECT sweep, job, state, identity, digest, attempt, worker, seconds, ended, reason, seed, replicate, "
          "expected_stability, initial_total, evolved_fuel, highest_distance, final_total, cycles_run, accepted, "
          "successes, success_rate, parameters, trace, measures FROM job ORDER BY sweep, job",
          "SELECT worker, host, process, threads, build, dds, first_seen, last_seen FROM worker ORDER BY worker",
          "SELECT event, at, epoch, kind, sweep, job, worker, text FROM event WHERE event <= 20 ORDER BY event",
          "SELECT * FROM divergence", "SELECT database_id, created FROM database"}) {
      for (const auto& row : rows(sql)) {
        for (const auto& value : row) text += value + '\n';
      }
    }
    return text;
  }
};

TEST_F(MigrationFrom2Test, OpeningForWritingKeepsEveryValueAndAddsDefaults) {
  const auto before = everything();
  const ResultsStore store(path_);
  EXPECT_EQ(store.migration(), "schema version 2 to 4");
  EXPECT_EQ(everything(), before);
  EXPECT_EQ(text_of(verify(path_)), "");
  EXPECT_EQ(rows("SELECT group_concat(version) FROM schema_version")[0][0], "\"2,4\"");
  EXPECT_EQ(rows("SELECT count(*) FROM job WHERE coalesce(queue_seconds, waited_seconds, commit_seconds, "
                 "reused_from_sweep, reused_from_job) IS NOT NULL")[0][0],
            "0");
  EXPECT_EQ(rows("SELECT DISTINCT reused, audited, fresh, archived, reason, hex(execution) FROM sweep"),
            (std::vector<std::vector<std::string>>{{"0", "0", "0", "0", "null", "\"\""}}));
  EXPECT_EQ(rows("SELECT processor, flags FROM provenance WHERE sweep = 'half' AND job = 0"),
            (std::vector<std::vector<std::string>>{{"null", "null"}}));
  EXPECT_EQ(store.sweeps().at(1).state, SweepState::cancelled);
}

TEST_F(MigrationFrom2Test, MigratedDatabaseKeepsItsForeignKeysAndTakesTheNewStates) {
  ResultsStore store(path_);
  const auto stray = ended_job(operator_sweep("stray"), 77, 1, JobState::failed, "x");
  EXPECT_EQ(error_of([&] { store.commit({.jobs = {stray}}); }), Kind::input_output);
  const auto half = store.sweeps().at(2).row;
  store.commit({.states = {{half, SweepState::paused}}});
  EXPECT_EQ(store.sweeps().at(2).state, SweepState::paused);
  EXPECT_EQ(store.retry(half, false), experiment::JobRanges(1, 1));
  EXPECT_EQ(store.add_sweep(operator_sweep("next").what).sweep.row, 4);
  EXPECT_EQ(text_of(verify(path_)), "");
}

TEST_F(MigrationFrom2Test, ViewsThatPeopleHaveAddedGoOn) {
  raw_connection(path_).execute("CREATE VIEW mine AS SELECT s.name, j.job FROM sweep AS s JOIN job AS j USING (sweep)");
  const auto before = rows("SELECT * FROM mine");
  const ResultsStore store(path_);
  EXPECT_EQ(rows("SELECT * FROM mine"), before);
}

TEST_F(MigrationFrom2Test, RowsOfASweepThatDoesNotExistAreNamedAndNothingIsChanged) {
  raw_connection(path_).execute("PRAGMA foreign_keys = OFF; UPDATE divergence SET sweep = 99");
  const auto before = bytes_of(path_);
  std::string message;
  EXPECT_EQ(error_of([&] { ResultsStore store(path_); }, &message), Kind::corrupt);
  EXPECT_THAT(message, AllOf(HasSubstr(path_), HasSubstr("row 1 of the table divergence"), HasSubstr("table sweep")));
  EXPECT_EQ(bytes_of(path_), before);
}

TEST_F(MigrationFrom2Test, ReadersReadItWithoutChangingIt) {
  const auto before = bytes_of(path_);
  const ResultsReader reader(path_);
  EXPECT_EQ(reader.sweeps().size(), 3U);
  const auto job = reader.job(reader.find_sweep("changes")->row, 3);
  ASSERT_TRUE(job && job->outcome);
  EXPECT_FALSE(job->outcome->measures.empty());
  EXPECT_FALSE(job->reused_from);
  std::string message;
  EXPECT_EQ(error_of([&] { reader.query("SELECT * FROM provenance"); }, &message), Kind::input_output);
  EXPECT_THAT(message, HasSubstr("schema version 2"));
  EXPECT_EQ(bytes_of(path_), before);
}

TEST_F(MigrationFrom2Test, FullDiskAtAnyWriteOfTheMigrationLeavesTheOldFile) {
  const auto before = bytes_of(path_);
  const auto values = everything();
  PowerCutVfs vfs;
  std::uint64_t failures = 0;
  for (std::uint64_t at = 1;; at += 3) {
    vfs.fail_from(at, SQLITE_FULL);
    const auto kind = error_of([&] { ResultsStore store(path_, {.vfs = vfs.name()}); });
    vfs.repair();
    if (!kind) break;
    ++failures;
    ASSERT_EQ(kind, Kind::full) << "operation " << at;
    ASSERT_EQ(bytes_of(path_), before) << "operation " << at;
    // When all has been written and only could not be synchronized, it may be found in the log.
    if (rows("PRAGMA user_version")[0][0] == "4") break;
    ASSERT_EQ(everything(), values) << "operation " << at;
  }
  EXPECT_GT(failures, 10U);
  vfs.start_anew();
  const ResultsStore store(path_);
  EXPECT_EQ(everything(), values);
  EXPECT_EQ(text_of(verify(path_)), "");
}

TEST_F(MigrationFrom2Test, PowerCutAtAnyWriteOfTheMigrationLeavesTheOldOrTheNewDatabase) {
  const auto before = bytes_of(path_);
  const auto values = everything();
  std::uint64_t old_ones = 0;
  for (std::uint64_t at = 1;; at += 12) {
    for (const char* suffix : {"-wal", "-shm"}) std::filesystem::remove(path_ + suffix);
    write_bytes(path_, before);
    PowerCutVfs vfs;
    vfs.cut_at(at);
    error_of([&] { ResultsStore store(path_, {.vfs = vfs.name()}); });
    if (!vfs.is_cut()) break;
    vfs.restart(at % 24 == 1 ? PowerCutVfs::Survival::none : PowerCutVfs::Survival::by_chance, at);
    const auto version = rows("PRAGMA user_version")[0][0];
    ASSERT_TRUE(version == "2" || version == "4") << version;
    EXPECT_EQ(everything(), values) << "cut at " << at;
    if (version == "2") ++old_ones;
    const ResultsStore store(path_);
    EXPECT_EQ(text_of(verify(path_)), "") << "cut at " << at;
  }
  EXPECT_GT(old_ones, 3U);
}

/// A database that the program of schema version 3 has made: an audited sweep with measures and a divergence, one that
/// has reused an outcome of it, and one that is paused, with a job that was quarantined and one that has a checkpoint.
class MigrationFrom3Test : public MigrationTest {
 protected:
  MigrationFrom3Test() {
    for (const char* suffix : {"", "-wal", "-shm"}) std::filesystem::remove(path_ + suffix);
    const Connection connection(path_, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, "");
    connection.execute(bytes_of(LAMPREY_VERSION_3_DUMP));
    connection.execute("PRAGMA journal_mode = WAL");
  }

  /// Every value of every table that version 3 had.
  std::string everything() {
    std::string text;
    for (const char* sql :
         {"SELECT * FROM sweep", "SELECT * FROM job", "SELECT * FROM worker", "SELECT * FROM event WHERE event <= 16",
          "SELECT * FROM divergence", "SELECT * FROM attempt", "SELECT * FROM checkpoint", "SELECT * FROM audit",
          "SELECT * FROM audit_job", "SELECT database_id, created FROM database"}) {
      const auto found = rows(sql);
      EXPECT_FALSE(found.empty()) << sql;
      for (const auto& row : found) {
        for (const auto& value : row) text += value + '\n';
      }
    }
    return text;
  }
};

TEST_F(MigrationFrom3Test, OpeningForWritingKeepsEveryValueAndAddsEmptyTables) {
  const auto before = everything();
  const ResultsStore store(path_);
  EXPECT_EQ(store.migration(), "schema version 3 to 4");
  EXPECT_EQ(everything(), before);
  EXPECT_EQ(text_of(verify(path_)), "");
  EXPECT_EQ(rows("SELECT group_concat(version) FROM schema_version")[0][0], "\"3,4\"");
  for (const std::string object : {"recording", "robot_evaluation", "recordings", "motion", "gap"}) {
    EXPECT_EQ(rows("SELECT count(*) FROM " + object)[0][0], "0") << object;
  }
  EXPECT_EQ(rows("SELECT DISTINCT repeatability FROM result WHERE sweep <> 'half'")[0][0], "\"bitwise\"");
  EXPECT_EQ(store.find_checkpoint(3, 2)->cycle, 1U);
}

TEST_F(MigrationFrom3Test, MigratedDatabaseTakesRecordings) {
  ResultsStore store(path_);
  const auto sweep = robot_sweep("robots");
  const auto row = store.add_sweep(sweep.what).sweep.row;
  const auto done = done_job(sweep, row, 0);
  store.commit({.jobs = {done}, .recordings = {{row, 0, done.worker, JobState::done, true, made_up_recording(0)}}});
  EXPECT_EQ(rows("SELECT sweep, evaluations, voided FROM recordings"),
            (std::vector<std::vector<std::string>>{{"\"robots\"", "2", "1"}}));
  EXPECT_EQ(text_of(verify(path_)), "");
}

TEST_F(MigrationFrom3Test, ReadersReadItWithoutChangingIt) {
  const auto before = bytes_of(path_);
  const ResultsReader reader(path_);
  EXPECT_EQ(reader.sweeps().size(), 3U);
  EXPECT_EQ(reader.results("once-more", 0, 10).rows.size(), 2U);
  const auto job = reader.job(reader.find_sweep("once-more")->row, 0);
  ASSERT_TRUE(job && job->reused_from);
  EXPECT_EQ(job->reused_from->job, 3U);
  std::string message;
  EXPECT_EQ(error_of([&] { reader.query("SELECT * FROM gap"); }, &message), Kind::input_output);
  EXPECT_THAT(message, HasSubstr("schema version 3"));
  EXPECT_EQ(bytes_of(path_), before);
}

TEST_F(MigrationFrom3Test, PowerCutAtAnyWriteOfTheMigrationLeavesTheOldOrTheNewDatabase) {
  const auto before = bytes_of(path_);
  const auto values = everything();
  std::uint64_t old_ones = 0;
  for (std::uint64_t at = 1;; at += 12) {
    for (const char* suffix : {"-wal", "-shm"}) std::filesystem::remove(path_ + suffix);
    write_bytes(path_, before);
    PowerCutVfs vfs;
    vfs.cut_at(at);
    error_of([&] { ResultsStore store(path_, {.vfs = vfs.name()}); });
    if (!vfs.is_cut()) break;
    vfs.restart(at % 24 == 1 ? PowerCutVfs::Survival::none : PowerCutVfs::Survival::by_chance, at);
    const auto version = rows("PRAGMA user_version")[0][0];
    ASSERT_TRUE(version == "3" || version == "4") << version;
    EXPECT_EQ(everything(), values) << "cut at " << at;
    if (version == "3") ++old_ones;
    const ResultsStore store(path_);
    EXPECT_EQ(text_of(verify(path_)), "") << "cut at " << at;
  }
  EXPECT_GT(old_ones, 3U);
}

}  // namespace
}  // namespace lamprey::storage::testing
