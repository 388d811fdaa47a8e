#include "storage/statement.hpp"
#include "tests/storage/support.hpp"

#include <gmock/gmock.h>

namespace lamprey::storage::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Kind = StorageError::Kind;

/// Two sweeps of one seed: the jobs of the first are the first jobs of the second.
class StoredJobsTest : public ::testing::Test {
 protected:
  void reopen() {
    store_.reset();
    store_.emplace(path_);
  }
  EndedJob reused(std::uint64_t job) const {
    auto row = done_job(other_, other_row_, job);
    row.reused_from = {row_, job};
    return row;
  }

  std::vector<std::vector<std::string>> rows(const std::string& sql) { return ResultsReader(path_).query(sql).rows; }
  std::string findings() const { return text_of(verify(path_)); }

  TemporaryDirectory directory_;
  std::string path_ = directory_.file("results.db");
  std::optional<ResultsStore> store_{path_};
  SweepCase sweep_ = operator_sweep("operators");
  SweepCase other_ = operator_sweep("more", 2);
  std::int64_t row_ = store_->add_sweep(sweep_.what).sweep.row;
  std::int64_t other_row_ = store_->add_sweep(other_.what).sweep.row;
};

TEST_F(StoredJobsTest, CountedAttemptsOfJobsWithoutARowSurviveARestart) {
  store_->commit({.attempts = {{row_, 4, 7, "lost", true, ""},
                               {row_, 2, 7, "lost", true, ""},
                               {row_, 4, 9, "lost", true, ""},
                               {row_, 5, 7, "lost", false, ""},
                               {row_, 6, 7, "lost", true, ""},
                               {other_row_, 4, 7, "refused", true, "malformed"}}});
  store_->commit({.jobs = {done_job(sweep_, row_, 6)}});
  reopen();
  const auto counted = store_->counted_attempts(row_);
  ASSERT_EQ(counted.size(), 2U);
  EXPECT_EQ(counted[0].job, 2U);
  EXPECT_THAT(counted[0].workers, ElementsAre(7U));
  EXPECT_EQ(counted[1].job, 4U);
  EXPECT_THAT(counted[1].workers, ElementsAre(7U, 9U));
  EXPECT_EQ(findings(), "");
}

TEST_F(StoredJobsTest, AttemptsThatEndAsNoneMayAreRefused) {
  EXPECT_TRUE(error_of([&] { store_->commit({.attempts = {{row_, 4, 7, "vanished", true, ""}}}); }));
  EXPECT_TRUE(error_of([&] { store_->commit({.attempts = {{99, 4, 7, "lost", true, ""}}}); }));
}

TEST_F(StoredJobsTest, NewestCheckpointOfAJobSurvivesARestart) {
  const std::string state("\x00\xff state", 8);
  store_->commit({.checkpoints = {{row_, 3, 7, 10, 1.5, "first"}, {row_, 8, 7, 1, 0.5, ""}}});
  store_->commit({.checkpoints = {{row_, 3, 8, 20, 2.5, state}}});
  reopen();
  EXPECT_THAT(store_->checkpointed_jobs(row_), ElementsAre(3U, 8U));
  const auto found = store_->find_checkpoint(row_, 3);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->worker, 8U);
  EXPECT_EQ(found->cycle, 20U);
  EXPECT_EQ(found->seconds, 2.5);
  EXPECT_EQ(found->state, state);
  EXPECT_EQ(store_->find_checkpoint(row_, 8)->state, "");
  EXPECT_FALSE(store_->find_checkpoint(row_, 4));
}

TEST_F(StoredJobsTest, CheckpointGoesWithTheJobsRowAlsoAfterARestart) {
  store_->commit({.checkpoints = {{row_, 3, 7, 10, 1.5, "a"}, {row_, 4, 7, 10, 1.5, "b"}}});
  store_->commit({.jobs = {done_job(sweep_, row_, 3)}});
  EXPECT_THAT(store_->checkpointed_jobs(row_), ElementsAre(4U));
  reopen();
  store_->commit({.jobs = {ended_job(sweep_, row_, 4, JobState::failed)}});
  EXPECT_THAT(store_->checkpointed_jobs(row_), IsEmpty());
}

TEST_F(StoredJobsTest, CheckpointStaysWhenTheRowIsRolledBackAndGoesLater) {
  store_->commit({.checkpoints = {{row_, 3, 7, 10, 1.5, "a"}}});
  auto bad = done_job(sweep_, row_, 4);
  bad.attempt = 0;
  EXPECT_TRUE(error_of([&] { store_->commit({.jobs = {done_job(sweep_, row_, 3), bad}}); }));
  EXPECT_THAT(store_->checkpointed_jobs(row_), ElementsAre(3U));
  store_->commit({.jobs = {done_job(sweep_, row_, 3)}});
  EXPECT_THAT(store_->checkpointed_jobs(row_), IsEmpty());
}

TEST_F(StoredJobsTest, CheckpointOfAJobThatHasEndedIsIgnored) {
  store_->commit({.jobs = {done_job(sweep_, row_, 3)}, .checkpoints = {{row_, 3, 7, 10, 1.5, "a"}}});
  store_->commit({.checkpoints = {{row_, 3, 7, 10, 1.5, "a"}}});
  EXPECT_THAT(store_->checkpointed_jobs(row_), IsEmpty());
  EXPECT_EQ(findings(), "");
}

TEST_F(StoredJobsTest, TimesAndSourceAreReadBack) {
  auto job = done_job(sweep_, row_, 3);
  job.queue_seconds = 1.5;
  job.waited_seconds = 0.25;
  job.commit_seconds = 0.125;
  store_->commit({.jobs = {job}});
  store_->commit({.jobs = {reused(3)}});
  const auto computed = store_->read_job(row_, 3);
  ASSERT_TRUE(computed);
  EXPECT_EQ(computed->queue_seconds, 1.5);
  EXPECT_EQ(computed->waited_seconds, 0.25);
  EXPECT_EQ(computed->commit_seconds, 0.125);
  EXPECT_EQ(computed->outcome, job.outcome);
  EXPECT_FALSE(computed->reused_from);
  const auto copied = store_->read_job(other_row_, 3);
  ASSERT_TRUE(copied && copied->reused_from);
  EXPECT_EQ(copied->reused_from->sweep, row_);
  EXPECT_EQ(copied->reused_from->job, 3U);
  EXPECT_EQ(copied->digest, job.digest);
  EXPECT_EQ(store_->sweeps().at(1).reused, 1U);
  EXPECT_EQ(rows("SELECT reused, done FROM progress WHERE sweep = 'more'")[0], (std::vector<std::string>{"1", "1"}));
  EXPECT_EQ(findings(), "");
}

TEST_F(StoredJobsTest, RowsThatAreAbsentOrMalformedAreNoSource) {
  store_->commit({.jobs = {done_job(sweep_, row_, 3)}});
  EXPECT_FALSE(store_->read_job(row_, 4));
  raw_connection(path_).execute("UPDATE job SET trace = '[[1]]'");
  EXPECT_FALSE(store_->read_job(row_, 3));
}

TEST_F(StoredJobsTest, OnlyDoneJobsAreReused) {
  auto job = ended_job(other_, other_row_, 3, JobState::failed);
  job.reused_from = {row_, 3};
  EXPECT_EQ(error_of([&] { store_->commit({.jobs = {job}}); }), Kind::input_output);
}

TEST_F(StoredJobsTest, ReusedRowsAreCheckedAgainstTheirSource) {
  store_->commit({.jobs = {done_job(sweep_, row_, 3), done_job(sweep_, row_, 4)}});
  store_->commit({.jobs = {reused(3)}});
  EXPECT_EQ(findings(), "");
  raw_connection(path_).execute("UPDATE job SET reused_from_job = 4 WHERE reused_from_job = 3");
  EXPECT_THAT(findings(), HasSubstr("more job 3 identity: "));
  EXPECT_THAT(findings(), HasSubstr("more job 3 digest: "));
  raw_connection(path_).execute("UPDATE job SET reused_from_job = NULL WHERE reused_from_job = 4");
  EXPECT_THAT(findings(), HasSubstr("more reused: stored 1, expected 0"));
}

TEST_F(StoredJobsTest, IdentitiesOfOtherSweepsComeInOrderAndPieces) {
  auto seeded = sweep_.specification;
  seeded.set_seed(1);
  seeded.set_name("another-seed");
  const auto stranger = sweep_case(seeded);
  const auto stranger_row = store_->add_sweep(stranger.what).sweep.row;
  const auto third = operator_sweep("third", 3);
  const auto third_row = store_->add_sweep(third.what).sweep.row;
  store_->commit(
      {.jobs = {done_job(sweep_, row_, 5), done_job(sweep_, row_, 0), ended_job(sweep_, row_, 1, JobState::failed),
                done_job(stranger, stranger_row, 2), done_job(other_, other_row_, 7), done_job(third, third_row, 20)}});
  std::vector<std::pair<std::int64_t, std::uint64_t>> places;
  ResultsStore::Place place;
  for (;;) {
    const auto piece = store_->identities(2006, other_row_, place, 2);
    if (piece.empty()) break;
    EXPECT_LE(piece.size(), 2U);
    for (const auto& found : piece) places.emplace_back(found.place.sweep, found.place.job);
    place = piece.back().place;
    ASSERT_LT(places.size(), 10U);
  }
  EXPECT_THAT(places, ElementsAre(std::pair(row_, 0U), std::pair(row_, 5U), std::pair(third_row, 20U)));
  EXPECT_EQ(store_->identities(2006, other_row_, {}, 1).at(0).identity, *done_job(sweep_, row_, 0).identity);
  EXPECT_EQ(store_->done_jobs(row_).size(), 2U);
}

TEST_F(StoredJobsTest, AuditCountsEachJobOnceAndIsFinishedWithTheLast) {
  store_->commit({.jobs = {done_job(sweep_, row_, 3), done_job(sweep_, row_, 4)}});
  const Audit wanted{.id = {5, 6}, .sweep = row_, .share = 0.1, .seed = ~std::uint64_t{0}, .jobs = 2};
  const auto audit = store_->add_audit(wanted);
  EXPECT_EQ(store_->add_audit(wanted).row, audit.row);
  const auto digest = [&](std::uint64_t job) { return *done_job(sweep_, row_, job).digest; };
  store_->commit({.audited = {{audit.row, 3, 9, digest(3), true}, {audit.row, 3, 9, digest(3), true}}});
  EXPECT_EQ(store_->audited_jobs(audit.row), experiment::JobRanges(3, 1));
  EXPECT_FALSE(store_->audits().at(0).finished());
  const auto second = store_->add_audit({.id = {5, 7}, .sweep = row_, .share = 1, .seed = 0, .jobs = 1});
  store_->commit({.audited = {{audit.row, 4, 9, experiment::Digest{}, false}, {second.row, 3, 8, digest(3), true}}});
  reopen();
  const auto stored = store_->audits().at(0);
  EXPECT_EQ(stored.id, wanted.id);
  EXPECT_EQ(stored.seed, wanted.seed);
  EXPECT_EQ(stored.agreed, 1U);
  EXPECT_EQ(stored.diverged, 1U);
  EXPECT_TRUE(stored.finished());
  EXPECT_EQ(store_->sweeps().at(0).audited, 2U) << "job 3 was audited twice";
  EXPECT_THAT(rows("SELECT sweep, share, jobs, agreed, diverged, state FROM audits"),
              ElementsAre(ElementsAre("\"operators\"", "0.1", "2", "1", "1", "\"finished\""),
                          ElementsAre("\"operators\"", "1", "1", "1", "0", "\"finished\"")));
  EXPECT_EQ(findings(), "");
  EXPECT_EQ(error_of([&] { store_->add_audit({.id = {1, 1}, .sweep = 99, .jobs = 1}); }), Kind::not_possible);
}

TEST_F(StoredJobsTest, AuditsThatContradictTheirRowsAreFound) {
  store_->commit({.jobs = {done_job(sweep_, row_, 3)}});
  const auto audit = store_->add_audit({.id = {5, 6}, .sweep = row_, .share = 1, .seed = 0, .jobs = 2});
  store_->commit({.audited = {{audit.row, 3, 9, *done_job(sweep_, row_, 3).digest, true}}});
  const auto expect_found = [&](const std::string& change, const std::string& undo, const std::string& what) {
    const auto other = raw_connection(path_);
    other.execute(change);
    EXPECT_THAT(findings(), HasSubstr(what)) << change;
    other.execute(undo);
    EXPECT_EQ(findings(), "") << undo;
  };
  expect_found("UPDATE audit SET agreed = 2", "UPDATE audit SET agreed = 1", "audit.agreed: stored 2, expected 1");
  expect_found("UPDATE audit SET diverged = 1", "UPDATE audit SET diverged = 0", "audit.diverged");
  expect_found("UPDATE sweep SET audited = 2 WHERE sweep = 1", "UPDATE sweep SET audited = 1 WHERE sweep = 1",
               "audited: stored 2, expected 1");
  expect_found("UPDATE audit_job SET digest = zeroblob(32)",
               "UPDATE audit_job SET digest = (SELECT digest FROM job WHERE job = 3)", "job 3 audit_job.agreed");
  expect_found("INSERT INTO checkpoint VALUES (1, 3, 0, NULL, 1, 1, X'')", "DELETE FROM checkpoint",
               "job 3 checkpoint.job: the job has ended");
  expect_found("INSERT INTO attempt VALUES (1, 0, 1, 18, NULL, 'lost', 1, '')", "DELETE FROM attempt",
               "job 18 attempt.job: the sweep has 18 jobs only");
}

TEST_F(StoredJobsTest, EventsAreReadForwardsAndTheNewestFirstOfAll) {
  Batch batch;
  for (std::uint64_t i = 0; i < 10; ++i) {
    batch.events.push_back({"e", i % 2 == 0 ? row_ : other_row_, i, 0xfedcba9876543210, std::to_string(i)});
  }
  store_->commit(batch);
  const auto texts = [](const std::vector<ResultsStore::StoredEvent>& events) {
    std::string text;
    for (const auto& event : events) text += event.event.text;
    return text;
  };
  const auto newest = store_->events({}, 0, 3);
  EXPECT_EQ(texts(newest), "789");
  EXPECT_EQ(newest[0].event.kind, "e");
  EXPECT_EQ(newest[0].event.sweep, other_row_);
  EXPECT_EQ(newest[0].event.job, 7U);
  EXPECT_EQ(newest[0].event.worker, 0xfedcba9876543210);
  EXPECT_EQ(texts(store_->events({}, newest[0].number, 10)), "89");
  EXPECT_EQ(texts(store_->events({}, newest[0].number - 5, 2)), "34");
  EXPECT_EQ(texts(store_->events(row_, 0, 2)), "68");
  EXPECT_EQ(texts(store_->events(row_, newest[0].number - 5, 2)), "46");
  EXPECT_TRUE(store_->events({}, newest[2].number, 10).empty());
}

TEST_F(StoredJobsTest, ProvenanceNamesTheWorkerItsBuildAndTheTimes) {
  auto job = done_job(sweep_, row_, 3);
  job.worker = 0xab;
  job.queue_seconds = 1.5;
  job.waited_seconds = 0.25;
  job.commit_seconds = 0.125;
  store_->commit({.workers = {{.incarnation = 0xab,
                               .host = "a",
                               .process = 12,
                               .threads = 2,
                               .build = "0.1.0 (abc)",
                               .flags = "g++ -O2",
                               .processor = "a processor",
                               .instruction_set = "AVX2",
                               .dds = "cyclonedds",
                               .labels = "big,fast"}},
                  .jobs = {job, ended_job(sweep_, row_, 4, JobState::cancelled)}});
  store_->commit({.jobs = {reused(3)}});
  EXPECT_THAT(
      rows("SELECT sweep, job, state, attempt, worker, host, process, processor, instruction_set, build, flags, "
           "dds, queue_seconds, waited_seconds, seconds, commit_seconds, reused_from FROM provenance "
           "WHERE sweep = 'operators' ORDER BY job"),
      ElementsAre(ElementsAre("\"operators\"", "3", "\"done\"", "1", "\"00000000000000ab\"", "\"a\"", "12",
                              "\"a processor\"", "\"AVX2\"", "\"0.1.0 (abc)\"", "\"g++ -O2\"", "\"cyclonedds\"", "1.5",
                              "0.25", "0.004", "0.125", "null"),
                  ElementsAre("\"operators\"", "4", "\"cancelled\"", "1", "null", "null", "null", "null", "null",
                              "null", "null", "null", "null", "null", "0", "null", "null")));
  EXPECT_THAT(rows("SELECT queue_seconds, reused_from, length(ended) FROM provenance WHERE sweep = 'more'"),
              ElementsAre(ElementsAre("null", "\"operators/3\"", "20")));
  EXPECT_EQ(rows("SELECT labels FROM worker")[0][0], "\"big,fast\"");
}

}  // namespace
}  // namespace lamprey::storage::testing
