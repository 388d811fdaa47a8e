#include "storage/statement.hpp"
#include "tests/storage/power_cut_vfs.hpp"
#include "tests/storage/support.hpp"

#include <gmock/gmock.h>

namespace lamprey::storage::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Kind = StorageError::Kind;
using Rows = std::vector<std::vector<std::string>>;

constexpr std::uint64_t hand = 0xfedcba9876543210;  ///< who did the jobs of done_job

/// What robots recorded, in a database.
class RecordingsTest : public ::testing::Test {
 protected:
  RecordedAttempt attempt(std::uint64_t job, std::uint64_t number, bool accepted) const {
    return {.sweep = row_,
            .job = job,
            .worker = hand,
            .state = JobState::done,
            .accepted = accepted,
            .recording = made_up_recording(number)};
  }
  RecordedAttempt failed(std::uint64_t job, std::uint64_t number) const {
    auto made = attempt(job, number, false);
    made.state = JobState::failed;
    return made;
  }
  void commit_done(std::uint64_t job, std::uint64_t number) {
    store_.commit({.jobs = {done_job(sweep_, row_, job)}, .recordings = {attempt(job, number, true)}});
  }

  Rows rows(const std::string& sql) { return ResultsReader(path_).query(sql).rows; }
  std::string value(const std::string& sql) { return value_of(ResultsReader(path_), sql); }
  std::string findings() const { return text_of(verify(path_)); }

  TemporaryDirectory directory_;
  std::string path_ = directory_.file("results.db");
  ResultsStore store_{path_};
  SweepCase sweep_ = robot_sweep("robots");
  std::int64_t row_ = store_.add_sweep(sweep_.what).sweep.row;
};

TEST_F(RecordingsTest, AreStoredWithTheJobsRowAndReadWithStockSqlite) {
  commit_done(2, 7);
  const auto recording = made_up_recording(7);
  EXPECT_THAT(rows("SELECT sweep, job, number, robot, token, state, accepted, worker FROM recording"),
              ElementsAre(ElementsAre("1", "2", "1", "\"lamprey-1\"", "47", "\"done\"", "1",
                                      std::to_string(static_cast<std::int64_t>(hand)))));
  EXPECT_THAT(rows("SELECT evaluation, attempt, voided, measured, steps FROM robot_evaluation ORDER BY rowid"),
              ElementsAre(ElementsAre("0", "0", "\"step 2 came 31 ms late\"", "1", "1"),
                          ElementsAre("0", "1", "null", "1", "3"), ElementsAre("1", "0", "null", "1", "3")));
  for (std::size_t tried = 0; tried < 3; ++tried) {
    const auto& of_try = recording.tries[tried];
    for (const auto& [column, values] : {std::pair("commanded", of_try.commanded),
                                         std::pair("reported", of_try.reported), std::pair("feet", of_try.feet_down)}) {
      const auto stored = column_of(
          ResultsReader(path_), "SELECT value FROM robot_evaluation, json_each(" + std::string(column) +
                                    ") WHERE robot_evaluation.rowid = " + std::to_string(tried + 1) + " ORDER BY key");
      std::vector<std::string> expected;
      for (const auto number : values) expected.push_back(std::to_string(number));
      EXPECT_EQ(stored, expected) << column << " of try " << tried;
    }
  }
  EXPECT_EQ(findings(), "");
}

TEST_F(RecordingsTest, EachAttemptHasItsNumberAndOneIsAccepted) {
  store_.commit({.recordings = {failed(0, 1)}});
  commit_done(0, 2);
  store_.commit({.recordings = {attempt(0, 3, false), failed(1, 4)}});
  EXPECT_EQ(rows("SELECT job, number, token, state, accepted FROM recording ORDER BY job, number"),
            (Rows{{"0", "1", "41", "\"failed\"", "0"},
                  {"0", "2", "42", "\"done\"", "1"},
                  {"0", "3", "43", "\"done\"", "0"},
                  {"1", "1", "44", "\"failed\"", "0"}}));
  EXPECT_EQ(findings(), "");
}

TEST_F(RecordingsTest, TheSameAttemptIsStoredOnceHoweverOftenItComes) {
  commit_done(0, 2);
  store_.commit({.recordings = {attempt(0, 2, false), failed(0, 3), failed(0, 3)}});
  store_.commit({.recordings = {attempt(0, 2, true), failed(0, 3)}});
  EXPECT_EQ(rows("SELECT number, accepted, state FROM recording ORDER BY 1"),
            (Rows{{"1", "1", "\"done\""}, {"2", "0", "\"failed\""}}));
  EXPECT_EQ(value("SELECT count(*) FROM robot_evaluation"), "6");
  auto of_another = attempt(0, 2, false);
  of_another.worker = 5;
  store_.commit({.recordings = {of_another}});
  EXPECT_EQ(value("SELECT count(*) FROM recording"), "3");
  EXPECT_EQ(findings(), "");
}

TEST_F(RecordingsTest, OthersThanTheAcceptedOneAreBounded) {
  Batch batch;
  for (std::uint64_t number = 0; number < most_other_recordings + 5; ++number) {
    batch.recordings.push_back(failed(0, number));
  }
  store_.commit(batch);
  EXPECT_EQ(value("SELECT count(*) FROM recording"), std::to_string(most_other_recordings));
  commit_done(0, 1000);
  EXPECT_EQ(value("SELECT number FROM recording WHERE accepted = 1"), std::to_string(most_other_recordings + 1));
  EXPECT_EQ(findings(), "");
}

TEST_F(RecordingsTest, WhatTheParserWouldRefuseIsNotWritten) {
  auto wrong = attempt(0, 1, true);
  wrong.recording.tries[1].commanded.pop_back();
  std::string message;
  EXPECT_EQ(error_of([&] { store_.commit({.jobs = {done_job(sweep_, row_, 0)}, .recordings = {wrong}}); }, &message),
            Kind::input_output);
  EXPECT_THAT(message, AllOf(HasSubstr(path_), HasSubstr("job 0"), HasSubstr("31 positions commanded")));
  EXPECT_EQ(value("SELECT count(*) FROM job"), "0");
}

TEST_F(RecordingsTest, StayWhenARetryTakesTheirJobsBack) {
  store_.commit(
      {.jobs = {ended_job(sweep_, row_, 1, JobState::failed, "void 20 times")}, .recordings = {failed(1, 5)}});
  EXPECT_EQ(store_.retry(row_, false), experiment::JobRanges(1, 1));
  EXPECT_EQ(rows("SELECT number, state, accepted FROM recording"), (Rows{{"1", "\"failed\"", "0"}}));
  EXPECT_EQ(findings(), "");
  commit_done(1, 6);
  EXPECT_EQ(rows("SELECT number, state, accepted FROM recording ORDER BY 1"),
            (Rows{{"1", "\"failed\"", "0"}, {"2", "\"done\"", "1"}}));
  EXPECT_EQ(findings(), "");
}

TEST_F(RecordingsTest, GoWithTheirSweepInBoundedSteps) {
  const auto other = robot_sweep("other");
  const auto other_row = store_.add_sweep(other.what).sweep.row;
  auto stays = attempt(0, 9, false);
  stays.sweep = other_row;
  for (std::uint64_t job = 0; job < 4; ++job) commit_done(job, job);
  store_.commit({.recordings = {failed(2, 77), stays}});
  store_.commit({.states = {{row_, SweepState::cancelling}, {row_, SweepState::cancelled}}});
  store_.commit({.states = {{row_, SweepState::deleting}}});
  const auto left = [&] {
    return std::stoi(
        value("SELECT (SELECT count(*) FROM recording) + (SELECT count(*) FROM robot_evaluation) + "
              "(SELECT count(*) FROM job)"));
  };
  int before = left();
  ASSERT_EQ(before, 6 + 18 + 4);
  while (!store_.delete_some(row_, 3)) {
    EXPECT_EQ(findings(), "");
    EXPECT_GE(left(), before - 3);
    EXPECT_LT(left(), before);
    before = left();
    // What comes late finds no place any more.
    store_.commit({.recordings = {failed(3, 78)}});
    EXPECT_EQ(left(), before);
  }
  EXPECT_EQ(rows("SELECT sweep, number FROM recording"), (Rows{{"2", "1"}}));
  EXPECT_EQ(value("SELECT count(*) FROM robot_evaluation"), "3");
  store_.commit({.recordings = {failed(3, 78)}});
  EXPECT_EQ(findings(), "");
}

TEST_F(RecordingsTest, AreThereWithTheirJobsRowOrNotAtAllWhenTheDiskIsFull) {
  const auto path = directory_.file("full.db");
  PowerCutVfs vfs;
  ResultsStore store(path, {.vfs = vfs.name()});
  const auto row = store.add_sweep(sweep_.what).sweep.row;
  auto recorded = attempt(0, 1, true);
  recorded.sweep = row;
  const Batch batch{.jobs = {done_job(sweep_, row, 0)}, .recordings = {recorded}};
  std::uint64_t at = 1;
  for (;; ++at) {
    vfs.fail_from(at, SQLITE_FULL);
    const auto kind = error_of([&] { store.commit(batch); });
    vfs.repair();
    if (!kind) break;
    ASSERT_LT(at, 200U);
    const ResultsReader reader(path);
    EXPECT_EQ(reader.query("SELECT count(*), (SELECT count(*) FROM job) FROM recording").rows, (Rows{{"0", "0"}}));
  }
  EXPECT_GT(at, 5U);
  EXPECT_EQ(value_of(ResultsReader(path), "SELECT count(*) FROM robot_evaluation"), "3");
  EXPECT_EQ(text_of(verify(path)), "");
}

/// Changes behind the store's back, each undone after.
class TamperedRecordingsTest : public RecordingsTest {
 protected:
  TamperedRecordingsTest() {
    store_.commit({.recordings = {failed(0, 1)}});
    commit_done(0, 2);
    store_.commit({.recordings = {attempt(0, 3, false)}});
  }

  /// What `lamprey verify` says after the change.
  std::string findings_after(const std::string& sql) {
    const auto copy = directory_.file("copy.db");
    std::filesystem::remove(copy);
    raw_connection(path_).execute("VACUUM INTO '" + copy + "'");
    const auto other = raw_connection(copy);
    other.execute("PRAGMA ignore_check_constraints = ON; PRAGMA foreign_keys = OFF");
    other.execute(sql);
    return text_of(verify(copy));
  }
};

TEST_F(TamperedRecordingsTest, ChecksumFindsAnyChangeOfARecordingOrItsEvaluations) {
  EXPECT_EQ(findings_after("SELECT 1"), "");
  const std::string where = " WHERE recording = 2";
  for (const std::string change : {"worker = 7", "worker = NULL", "robot = 'lamprey-2'", "token = token + 1",
                                   "state = 'failed'", "accepted = 0", "checksum = zeroblob(32)"}) {
    EXPECT_THAT(findings_after("UPDATE recording SET " + change + where), HasSubstr("checksum is not that of"))
        << change;
  }
  for (const std::string change :
       {"evaluation = evaluation + 5", "attempt = attempt + 7", "measured = 0", "steps = steps + 1", "steps = 'many'",
        "voided = 'another reason'", "voided = ''", "commanded = replace(commanded, '1', '2')",
        "reported = replace(reported, ',', ', ')", "feet = replace(feet, '[', '[0')", "feet = '[]'",
        "commanded = '[1,2'", "reported = 'nonsense'", "measured = -1"}) {
    EXPECT_THAT(findings_after("UPDATE robot_evaluation SET " + change + where),
                HasSubstr("robots job 0 recording: attempt 2: "))
        << change;
  }
  EXPECT_NE(findings_after("DELETE FROM robot_evaluation" + where + " AND evaluation = 1"), "");
  EXPECT_NE(findings_after("DELETE FROM robot_evaluation" + where), "");
}

TEST_F(TamperedRecordingsTest, EvaluationAndColumnAreNamed) {
  EXPECT_EQ(findings_after("UPDATE robot_evaluation SET reported = '[1,]' WHERE recording = 1 AND evaluation = 1"),
            "robots job 0 recording: attempt 1: evaluation 1, try 0: reported is no list of whole numbers as it is "
            "written\n");
  EXPECT_EQ(findings_after("UPDATE robot_evaluation SET steps = 9 WHERE recording = 1 AND attempt = 1"),
            "robots job 0 recording: attempt 1: evaluation 0, try 1: steps: stored 9, expected 3\n");
}

TEST_F(TamperedRecordingsTest, ReferencesAreChecked) {
  EXPECT_THAT(findings_after("UPDATE recording SET sweep = 9 WHERE recording = 1"),
              HasSubstr("recording.sweep: the row belongs to a sweep that does not exist"));
  EXPECT_THAT(findings_after("UPDATE robot_evaluation SET recording = 99 WHERE recording = 3"),
              HasSubstr("robot_evaluation.recording: the row belongs to a recording that does not exist"));
  EXPECT_THAT(findings_after("UPDATE recording SET job = 8"), HasSubstr("recording.job: the sweep has 8 jobs only"));
  EXPECT_THAT(findings_after("UPDATE recording SET number = 5 WHERE recording = 3"),
              HasSubstr("recording.number: the numbers of its attempts are not 1 to 3"));
  EXPECT_THAT(findings_after("UPDATE recording SET accepted = 1 WHERE recording = 3"),
              HasSubstr("recording.accepted: 2 attempts are the accepted one"));
  EXPECT_THAT(findings_after("DELETE FROM job"), HasSubstr("recording.accepted: the job's row is not the end of"));
  EXPECT_THAT(findings_after("UPDATE job SET worker = 3"), HasSubstr("recording.accepted: the job's row is not the"));
}

TEST_F(TamperedRecordingsTest, JobsThatAreOnNoRobotHaveNone) {
  store_.commit({.jobs = {done_job(sweep_, row_, 5)}, .recordings = {attempt(5, 1, true)}});
  EXPECT_EQ(findings(), "robots job 5 recording.job: the job is not on a robot\n");
}

}  // namespace
}  // namespace lamprey::storage::testing
