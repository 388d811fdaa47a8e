#include "storage/statement.hpp"
#include "tests/storage/support.hpp"

#include <gmock/gmock.h>

namespace lamprey::storage::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Kind = StorageError::Kind;

/// A sweep of 18 jobs: 0 and 1 done, 2 failed, 3 quarantined after two counted losses, 4 cancelled.
class SweepControlTest : public ::testing::Test {
 protected:
  SweepControlTest() {
    auto quarantined = ended_job(sweep_, row_, 3, JobState::quarantined, "3 workers were lost with it");
    quarantined.attempt = 3;
    store_.commit({.jobs = {done_job(sweep_, row_, 0), done_job(sweep_, row_, 1),
                            ended_job(sweep_, row_, 2, JobState::failed, "no memory"), quarantined,
                            ended_job(sweep_, row_, 4, JobState::cancelled)},
                   .attempts = {{row_, 3, 7, "lost", true, "host a"}, {row_, 3, 8, "lost", true, ""}}});
  }

  Sweep stored() const { return store_.sweeps().at(0); }

  /// Ends all jobs without a row.
  void end_the_rest() {
    Batch batch;
    const auto ended = store_.ended_jobs(row_);
    for (std::uint64_t job = 0; job < sweep_.grid.jobs(); ++job) {
      if (!ended.contains(job)) batch.jobs.push_back(done_job(sweep_, row_, job));
    }
    store_.commit(batch);
  }

  void set_state(SweepState state, const std::string& reason = "") {
    store_.commit({.states = {{row_, state, reason}}});
  }

  std::vector<std::vector<std::string>> rows(const std::string& sql) { return ResultsReader(path_).query(sql).rows; }
  std::string findings() const { return text_of(verify(path_)); }

  TemporaryDirectory directory_;
  std::string path_ = directory_.file("results.db");
  ResultsStore store_{path_};
  SweepCase sweep_ = operator_sweep("operators");
  std::int64_t row_ = store_.add_sweep(sweep_.what).sweep.row;
};

TEST_F(SweepControlTest, RenamedSweepKeepsItsIdAndIsInOrder) {
  store_.rename(row_, "it's another");
  EXPECT_EQ(stored().what.name, "it's another");
  EXPECT_EQ(stored().what.id, sweep_.what.id);
  EXPECT_EQ(findings(), "");
  EXPECT_TRUE(store_.add_sweep(sweep_.what).existed);
  EXPECT_EQ(rows("SELECT sweep, text FROM history WHERE kind = 'sweep_renamed'"),
            (std::vector<std::vector<std::string>>{{"\"it's another\"", "\"operators is now it's another\""}}));
  raw_connection(path_).execute("UPDATE sweep SET name = 'by hand'");
  EXPECT_THAT(findings(), HasSubstr("checksum"));
}

TEST_F(SweepControlTest, NameOfAnotherSweepIsRefusedAndTheOwnOneAccepted) {
  store_.add_sweep(operator_sweep("other", 2).what);
  std::string message;
  EXPECT_EQ(error_of([&] { store_.rename(row_, "other"); }, &message), Kind::name_taken);
  EXPECT_THAT(message, HasSubstr("'other'"));
  store_.rename(row_, "operators");
  EXPECT_EQ(stored().what.name, "operators");
  EXPECT_EQ(error_of([&] { store_.rename(99, "x"); }), Kind::not_possible);
}

TEST_F(SweepControlTest, ExecutionAndFreshnessAreReadBackAndVouchedFor) {
  auto what = operator_sweep("fresh", 2).what;
  what.fresh = true;
  what.execution = std::string("\x08\x00\x05", 3);
  const auto row = store_.add_sweep(what).sweep.row;
  EXPECT_TRUE(store_.sweeps().at(1).what.fresh);
  EXPECT_EQ(store_.sweeps().at(1).what.execution, what.execution);
  store_.set_execution(row, "other");
  EXPECT_EQ(store_.sweeps().at(1).what.execution, "other");
  EXPECT_EQ(findings(), "");
  for (const char* change : {"fresh = 0", "execution = X'00'"}) {
    const auto other = raw_connection(path_);
    other.execute(std::string("BEGIN; UPDATE sweep SET ") + change + " WHERE name = 'fresh'; COMMIT");
    EXPECT_THAT(findings(), HasSubstr("fresh checksum")) << change;
    other.execute("UPDATE sweep SET fresh = 1, execution = CAST('other' AS BLOB) WHERE name = 'fresh'");
  }
}

TEST_F(SweepControlTest, ArchivingIsSeenAndUndone) {
  store_.set_archived(row_, true);
  EXPECT_TRUE(stored().archived);
  EXPECT_EQ(rows("SELECT archived FROM progress")[0][0], "1");
  store_.set_archived(row_, false);
  EXPECT_FALSE(stored().archived);
  EXPECT_EQ(rows("SELECT group_concat(kind) FROM event WHERE kind LIKE '%archived'")[0][0],
            "\"sweep_archived,sweep_unarchived\"");
}

TEST_F(SweepControlTest, PausedSweepRunsAgainWithoutItsReason) {
  set_state(SweepState::paused, "the disk is full");
  EXPECT_EQ(stored().state, SweepState::paused);
  EXPECT_EQ(stored().reason, "the disk is full");
  EXPECT_EQ(rows("SELECT state, reason FROM progress")[0][1], "\"the disk is full\"");
  set_state(SweepState::running);
  EXPECT_EQ(stored().state, SweepState::running);
  EXPECT_EQ(stored().reason, "");
  EXPECT_EQ(findings(), "");
}

TEST_F(SweepControlTest, PausedSweepIsFinishedByItsLastJobOnly) {
  set_state(SweepState::paused);
  store_.commit({.jobs = {done_job(sweep_, row_, 5)}});
  EXPECT_EQ(stored().state, SweepState::paused);
  EXPECT_EQ(findings(), "");
  end_the_rest();
  EXPECT_EQ(stored().state, SweepState::finished);
  EXPECT_TRUE(stored().ended_unix_milliseconds);
  EXPECT_EQ(findings(), "");
}

TEST_F(SweepControlTest, StatesChangeOnlyAsTheyMay) {
  set_state(SweepState::deleting);
  EXPECT_EQ(stored().state, SweepState::running) << "it has not ended";
  set_state(SweepState::cancelling, "highest_total is at least 200");
  set_state(SweepState::running);
  set_state(SweepState::paused);
  EXPECT_EQ(stored().state, SweepState::cancelling);
  end_the_rest();
  EXPECT_EQ(stored().state, SweepState::cancelled);
  EXPECT_EQ(stored().reason, "highest_total is at least 200");
  set_state(SweepState::running);
  EXPECT_EQ(stored().state, SweepState::cancelled);
  set_state(SweepState::deleting);
  EXPECT_EQ(stored().state, SweepState::deleting);
  set_state(SweepState::cancelled);
  EXPECT_EQ(stored().state, SweepState::deleting);
  for (const auto& change : {+[](ResultsStore&store, std::int64_t row) { store.rename(row, "x"); },
                             +[](ResultsStore&store, std::int64_t row) { store.set_archived(row, true); },
                             +[](ResultsStore&store, std::int64_t row) { store.retry(row, true); }}) {
    EXPECT_EQ(error_of([&] { change(store_, row_); }), Kind::not_possible);
  }
  EXPECT_EQ(findings(), "");
}

TEST_F(SweepControlTest, RetryMakesAttemptsOfTheRowsAndTheSweepRunsAgain) {
  end_the_rest();
  ASSERT_EQ(stored().state, SweepState::finished);
  EXPECT_EQ(store_.retry(row_, false), experiment::JobRanges(2, 2));
  EXPECT_EQ(stored().state, SweepState::running);
  EXPECT_FALSE(stored().ended_unix_milliseconds);
  EXPECT_EQ(stored().counts, (JobCounts{15, 0, 0, 1}));
  EXPECT_FALSE(store_.find_job(row_, 2));
  EXPECT_THAT(
      rows("SELECT job, worker, ending, counted, reason FROM attempts ORDER BY job, ending"),
      ElementsAre(ElementsAre("2", "\"fedcba9876543210\"", "\"failed\"", "0", "\"no memory\""),
                  ElementsAre("3", "\"0000000000000007\"", "\"lost\"", "0", "\"host a\""),
                  ElementsAre("3", "\"0000000000000008\"", "\"lost\"", "0", "null"),
                  ElementsAre("3", "\"fedcba9876543210\"", "\"quarantined\"", "0", "\"3 workers were lost with it\"")));
  EXPECT_TRUE(store_.counted_attempts(row_).empty());
  EXPECT_EQ(rows("SELECT sweep, text FROM history WHERE kind = 'jobs_retried'")[0][1], "\"operators: 2 jobs\"");
  EXPECT_EQ(findings(), "");
  EXPECT_TRUE(store_.retry(row_, false).empty());
  end_the_rest();
  EXPECT_EQ(stored().state, SweepState::finished);
  EXPECT_EQ(findings(), "");
}

TEST_F(SweepControlTest, RetryTakesCancelledJobsIfToldTo) {
  set_state(SweepState::cancelling);
  EXPECT_EQ(error_of([&] { store_.retry(row_, true); }), Kind::not_possible);
  end_the_rest();
  ASSERT_EQ(stored().state, SweepState::cancelled);
  EXPECT_EQ(store_.retry(row_, true), experiment::JobRanges(2, 3));
  EXPECT_EQ(stored().counts, (JobCounts{15, 0, 0, 0}));
  EXPECT_EQ(stored().state, SweepState::running);
  EXPECT_EQ(findings(), "");
}

TEST_F(SweepControlTest, RetryWithoutSuchRowsChangesNothing) {
  const auto other = operator_sweep("other", 2);
  const auto row = store_.add_sweep(other.what).sweep.row;
  Batch batch;
  for (std::uint64_t job = 0; job < other.grid.jobs(); ++job) batch.jobs.push_back(done_job(other, row, job));
  store_.commit(batch);
  EXPECT_TRUE(store_.retry(row, true).empty());
  EXPECT_EQ(store_.sweeps().at(1).state, SweepState::finished);
}

TEST_F(SweepControlTest, RetriedJobsOfAPausedSweepWait) {
  set_state(SweepState::paused, "a reason");
  EXPECT_EQ(store_.retry(row_, false).size(), 2U);
  EXPECT_EQ(stored().state, SweepState::paused);
  EXPECT_EQ(stored().reason, "a reason");
}

TEST_F(SweepControlTest, DrainingWorkersAreKnownUntilTheyLeave) {
  const Worker worker{
      .incarnation = 0xfedcba9876543210, .host = "a", .process = 1, .threads = 2, .build = "b", .dds = "c"};
  store_.commit({.workers = {worker}});
  store_.set_draining(worker.incarnation, true);
  store_.commit({.workers = {worker}});
  EXPECT_THAT(store_.draining(), ElementsAre(worker.incarnation));
  store_.set_draining(worker.incarnation, false);
  EXPECT_TRUE(store_.draining().empty());
  EXPECT_EQ(error_of([&] { store_.set_draining(5, true); }), Kind::not_possible);
  EXPECT_FALSE(error_of([&] { store_.set_draining(5, false); }));
}

/// A sweep with rows in every table, beside another that has reused some of its outcomes.
class DeletionTest : public SweepControlTest {
 protected:
  DeletionTest() {
    end_the_rest();
    const auto audit = store_.add_audit({.id = {1, 2}, .sweep = row_, .share = 0.5, .seed = 3, .jobs = 2});
    auto reused = done_job(sweep_, other_row_, 0);
    reused.reused_from = {row_, 0};
    const auto digest = *done_job(sweep_, row_, 1).digest;
    store_.commit({.jobs = {reused},
                   .divergences = {{row_, 1, digest, experiment::Digest{}, 0}},
                   .events = {{"lease_lost", row_, 3, 7, "with 3 jobs"}, {"kept", other_row_, {}, 0, "x"}},
                   .audited = {{audit.row, 1, 9, digest, true}}});
    set_state(SweepState::deleting);
  }

  SweepCase other_ = operator_sweep("other", 2);
  std::int64_t other_row_ = store_.add_sweep(other_.what).sweep.row;
};

TEST_F(DeletionTest, IsDoneInBoundedStepsEachOfWhichIsInOrder) {
  int steps = 0;
  auto rows_left = [&] {
    return std::stoi(
        rows("SELECT (SELECT count(*) FROM job) + (SELECT count(*) FROM attempt) + (SELECT count(*) FROM "
             "audit) + (SELECT count(*) FROM audit_job) + (SELECT count(*) FROM divergence)")[0][0]);
  };
  for (int before = rows_left(); !store_.delete_some(row_, 4); before = rows_left()) {
    EXPECT_LE(before - rows_left(), 4);
    EXPECT_EQ(findings(), "");
    ASSERT_LT(++steps, 20);
  }
  EXPECT_GT(steps, 4);
  EXPECT_EQ(store_.sweeps().size(), 1U);
  EXPECT_EQ(rows_left(), 1) << "the other sweep's";
  EXPECT_EQ(findings(), "");
  EXPECT_TRUE(store_.delete_some(row_, 4)) << "nothing is left of it";
}

TEST_F(DeletionTest, GoesOnAfterARestartInTheMiddle) {
  EXPECT_FALSE(store_.delete_some(row_, 9));
  const auto other_path = directory_.file("copy.db");
  raw_connection(path_).execute("VACUUM INTO '" + other_path + "'");
  ResultsStore restarted(other_path);
  EXPECT_EQ(restarted.sweeps().at(0).state, SweepState::deleting);
  while (!restarted.delete_some(row_, 9)) {
  }
  EXPECT_EQ(text_of(verify(other_path)), "");
}

TEST_F(DeletionTest, EventsStayWithTheSweepsName) {
  while (!store_.delete_some(row_, 100)) {
  }
  EXPECT_THAT(
      rows("SELECT sweep, job, text FROM event WHERE kind IN ('lease_lost', 'sweep_submitted', 'kept', "
           "'sweep_deleted') ORDER BY event"),
      ElementsAre(ElementsAre("null", "null", "\"operators: 18 jobs\""), ElementsAre("2", "null", "\"other: 36 jobs\""),
                  ElementsAre("null", "3", "\"operators: with 3 jobs\""), ElementsAre("2", "null", "\"x\""),
                  ElementsAre("null", "null", "\"operators\"")));
}

TEST_F(DeletionTest, KeyOfTheDeletedSweepDoesNotComeAgainAndReusedRowsSaySo) {
  store_.commit({.states = {{other_row_, SweepState::cancelled}}});
  while (!store_.delete_some(row_, 100)) {
  }
  EXPECT_EQ(rows("SELECT reused_from FROM provenance WHERE sweep = 'other'")[0][0], "\"(deleted)/0\"");
  EXPECT_EQ(findings(), "");
  const auto again = store_.add_sweep(sweep_.what);
  EXPECT_FALSE(again.existed);
  EXPECT_EQ(again.sweep.row, 3);
  EXPECT_EQ(findings(), "");
}

TEST_F(DeletionTest, OnlyASweepInStateDeletingIsDeleted) {
  EXPECT_EQ(error_of([&] { store_.delete_some(other_row_, 10); }), Kind::not_possible);
  EXPECT_EQ(store_.ended_jobs(other_row_).size(), 1U);
}

}  // namespace
}  // namespace lamprey::storage::testing
