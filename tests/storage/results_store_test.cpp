#include "storage/results_store.hpp"

#include "storage/statement.hpp"
#include "tests/storage/support.hpp"

#include <array>
#include <atomic>
#include <cmath>
#include <csignal>
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace lamprey::storage::testing {
namespace {

using ::testing::HasSubstr;
using Kind = StorageError::Kind;

class ResultsStoreTest : public ::testing::Test {
 protected:
  TemporaryDirectory directory_;
  std::string path_ = directory_.file("results.db");
  SweepCase sweep_ = operator_sweep("operators");
};

TEST_F(ResultsStoreTest, EpochRisesAtEachOpeningAndTheIdStays) {
  std::optional<experiment::Id128> id;
  for (std::uint64_t epoch = 1; epoch <= 3; ++epoch) {
    const ResultsStore store(path_);
    EXPECT_EQ(store.epoch(), epoch);
    EXPECT_EQ(store.database_id(), id.value_or(store.database_id()));
    id = store.database_id();
  }
  const ResultsStore other(directory_.file("other.db"));
  EXPECT_NE(other.database_id(), *id);
}

TEST_F(ResultsStoreTest, AddedSweepIsReadBackAfterReopening) {
  {
    ResultsStore store(path_);
    const auto added = store.add_sweep(sweep_.what);
    EXPECT_FALSE(added.existed);
    EXPECT_EQ(added.sweep.what.jobs, 18U);
  }
  const ResultsStore store(path_);
  const auto sweeps = store.sweeps();
  ASSERT_EQ(sweeps.size(), 1U);
  EXPECT_EQ(sweeps[0].what.id, sweep_.what.id);
  EXPECT_EQ(sweeps[0].what.name, "operators");
  EXPECT_EQ(sweeps[0].what.specification, sweep_.what.specification);
  EXPECT_EQ(sweeps[0].what.source, sweep_.what.source);
  EXPECT_EQ(sweeps[0].what.seed, 2006U);
  EXPECT_EQ(sweeps[0].science_version, experiment::science_version);
  EXPECT_EQ(sweeps[0].state, SweepState::running);
  EXPECT_GT(sweeps[0].created_unix_milliseconds, 0);
}

TEST_F(ResultsStoreTest, SameSweepAgainIsTheOneThatExists) {
  ResultsStore store(path_);
  const auto first = store.add_sweep(sweep_.what);
  const auto again = store.add_sweep(sweep_.what);
  EXPECT_TRUE(again.existed);
  EXPECT_EQ(again.sweep.row, first.sweep.row);
  EXPECT_EQ(store.sweeps().size(), 1U);
}

TEST_F(ResultsStoreTest, AnotherSweepOfTheSameNameIsRefusedByName) {
  ResultsStore store(path_);
  store.add_sweep(sweep_.what);
  std::string message;
  EXPECT_EQ(error_of([&] { store.add_sweep(operator_sweep("operators", 2).what); }, &message), Kind::name_taken);
  EXPECT_THAT(message, HasSubstr("'operators'"));
  EXPECT_EQ(store.sweeps().size(), 1U);
}

TEST_F(ResultsStoreTest, SeedsOf64BitsSurvive) {
  idl::SweepSpecification specification = sweep_.specification;
  specification.set_seed(0xfedcba9876543210);
  const auto sweep = sweep_case(specification);
  ResultsStore store(path_);
  const auto row = store.add_sweep(sweep.what).sweep.row;
  store.commit({.jobs = {done_job(sweep, row, 4)}});
  const ResultsReader reader(path_);
  EXPECT_EQ(reader.job(row, 4)->seed, 0xfedcba9876543210U);
  EXPECT_EQ(value_of(reader, "SELECT seed FROM result"), "\"18364758544493064720\"");
}

TEST_F(ResultsStoreTest, CommittedJobIsReadBackBitForBit) {
  ResultsStore store(path_);
  const auto row = store.add_sweep(sweep_.what).sweep.row;
  auto outcome = made_up_outcome(5);
  // A REAL column would make 0 of −0, and 1e308 and 5e-324 need every digit.
  outcome.initial = {-0.0, 1e308, 5e-324, 0.1};
  const auto job = done_job(sweep_, row, 7, outcome);
  store.commit({.jobs = {job}});
  const auto stored = ResultsReader(path_).job(row, 7);
  ASSERT_TRUE(stored);
  EXPECT_EQ(stored->identity, job.identity);
  EXPECT_EQ(stored->digest, job.digest);
  EXPECT_EQ(stored->outcome, job.outcome);
  EXPECT_TRUE(std::signbit(stored->outcome->initial.stability));
  EXPECT_EQ(experiment::outcome_digest(*stored->identity, *stored->outcome), *job.digest);
  EXPECT_EQ(stored->parameters, job.parameters);
  EXPECT_EQ(stored->worker, job.worker);
  EXPECT_EQ(stored->attempt, 1U);
  EXPECT_EQ(stored->seconds, 0.004);
}

TEST_F(ResultsStoreTest, MeasuresAreReadBackBitForBitAndNothingIsStoredForNone) {
  ResultsStore store(path_);
  const auto row = store.add_sweep(sweep_.what).sweep.row;
  auto outcome = made_up_outcome(5);
  outcome.measures = {{"recovered", 0, 1}, {"recovered", 4294967295U, 1.0 / 3}, {"z", 0, 5e-324}};
  const auto job = done_job(sweep_, row, 7, outcome);
  store.commit({.jobs = {job, done_job(sweep_, row, 8)}});
  const ResultsReader reader(path_);
  EXPECT_EQ(reader.job(row, 7)->outcome, outcome);
  EXPECT_TRUE(reader.job(row, 8)->outcome->measures.empty());
  EXPECT_EQ(column_of(reader, "SELECT job FROM job WHERE measures IS NULL"), std::vector<std::string>{"8"});
  EXPECT_EQ(text_of(verify(path_)), "");
}

TEST_F(ResultsStoreTest, RestartFindsEndedJobsCountersAndDigests) {
  std::int64_t row = 0;
  {
    ResultsStore store(path_);
    row = store.add_sweep(sweep_.what).sweep.row;
    store.commit({.jobs = {done_job(sweep_, row, 3), done_job(sweep_, row, 4), done_job(sweep_, row, 0)}});
    store.commit({.jobs = {ended_job(sweep_, row, 5, JobState::failed, "no memory"),
                           ended_job(sweep_, row, 9, JobState::quarantined, "five attempts")}});
  }
  const ResultsStore store(path_);
  experiment::JobRanges ended(3, 3);
  ended.add(0, 1);
  ended.add(9, 1);
  EXPECT_EQ(store.ended_jobs(row), ended);
  EXPECT_EQ(store.sweeps()[0].counts, (JobCounts{3, 1, 1, 0}));
  EXPECT_EQ(store.find_job(row, 4)->digest, done_job(sweep_, row, 4).digest);
  EXPECT_EQ(store.find_job(row, 5)->state, JobState::failed);
  EXPECT_FALSE(store.find_job(row, 5)->digest);
  EXPECT_FALSE(store.find_job(row, 1));
  EXPECT_EQ(ResultsReader(path_).job(row, 5)->reason, "no memory");
}

TEST_F(ResultsStoreTest, SweepIsFinishedInTheTransactionOfItsLastJob) {
  ResultsStore store(path_);
  const auto row = store.add_sweep(sweep_.what).sweep.row;
  Batch batch;
  for (std::uint64_t job = 0; job < 17; ++job) batch.jobs.push_back(done_job(sweep_, row, job));
  store.commit(batch);
  EXPECT_EQ(store.sweeps()[0].state, SweepState::running);
  EXPECT_FALSE(store.sweeps()[0].ended_unix_milliseconds);
  store.commit({.jobs = {ended_job(sweep_, row, 17, JobState::failed)}});
  EXPECT_EQ(store.sweeps()[0].state, SweepState::finished);
  EXPECT_TRUE(store.sweeps()[0].ended_unix_milliseconds);
}

TEST_F(ResultsStoreTest, CancellingSweepBecomesCancelledWithItsLastJob) {
  ResultsStore store(path_);
  const auto row = store.add_sweep(sweep_.what).sweep.row;
  Batch batch{.states = {{row, SweepState::cancelling}}};
  for (std::uint64_t job = 0; job < 17; ++job) {
    batch.jobs.push_back(ended_job(sweep_, row, job, JobState::cancelled));
  }
  store.commit(batch);
  EXPECT_EQ(store.sweeps()[0].state, SweepState::cancelling);
  store.commit({.jobs = {done_job(sweep_, row, 17)}});
  EXPECT_EQ(store.sweeps()[0].state, SweepState::cancelled);
  EXPECT_EQ(store.sweeps()[0].counts, (JobCounts{1, 0, 0, 17}));
  // An end is final.
  store.commit({.states = {{row, SweepState::running}}});
  EXPECT_EQ(store.sweeps()[0].state, SweepState::cancelled);
}

TEST_F(ResultsStoreTest, BatchWithARefusedJobLeavesNothingBehind) {
  ResultsStore store(path_);
  const auto row = store.add_sweep(sweep_.what).sweep.row;
  store.commit({.jobs = {done_job(sweep_, row, 2)}});
  Batch batch;
  batch.workers.push_back({.incarnation = 7, .host = "a", .process = 1, .threads = 2, .build = "b", .dds = "c"});
  batch.jobs = {done_job(sweep_, row, 0), done_job(sweep_, row, 1), done_job(sweep_, row, 2)};
  batch.events.push_back({.kind = "lease_lost", .sweep = row, .job = {}, .text = "x"});
  batch.divergences.push_back({.sweep = row, .job = 2});
  std::string message;
  EXPECT_EQ(error_of([&] { store.commit(batch); }, &message), Kind::input_output);
  EXPECT_THAT(message, HasSubstr("job 2"));
  EXPECT_THAT(message, HasSubstr(path_));
  const ResultsReader reader(path_);
  EXPECT_EQ(value_of(reader, "SELECT count(*) FROM job"), "1");
  EXPECT_EQ(value_of(reader, "SELECT count(*) FROM worker"), "0");
  EXPECT_EQ(value_of(reader, "SELECT count(*) FROM event WHERE kind = 'lease_lost'"), "0");
  EXPECT_EQ(store.sweeps()[0].counts.done, 1U);
  EXPECT_EQ(store.sweeps()[0].divergences, 0U);

  // Without the duplicate the same batch goes through.
  batch.jobs.pop_back();
  store.commit(batch);
  EXPECT_EQ(store.sweeps()[0].counts.done, 3U);
  EXPECT_EQ(store.sweeps()[0].divergences, 1U);
}

TEST_F(ResultsStoreTest, InconsistentJobsAreRefused) {
  ResultsStore store(path_);
  const auto row = store.add_sweep(sweep_.what).sweep.row;
  const auto refused = [&](const auto& spoil) {
    auto job = done_job(sweep_, row, 1);
    spoil(job);
    return error_of([&] { store.commit({.jobs = {job}}); }) == Kind::input_output;
  };
  EXPECT_TRUE(refused([](EndedJob& job) { job.digest.reset(); }));
  EXPECT_TRUE(refused([](EndedJob& job) { job.identity.reset(); }));
  EXPECT_TRUE(refused([](EndedJob& job) { job.outcome.reset(); }));
  EXPECT_TRUE(refused([](EndedJob& job) { job.parameters.clear(); }));
  EXPECT_TRUE(refused([](EndedJob& job) { job.state = JobState::failed; }));
  EXPECT_TRUE(refused([](EndedJob& job) { job.attempt = 0; }));
  EXPECT_TRUE(refused([](EndedJob& job) { job.sweep = 99; }));
  EXPECT_TRUE(refused([](EndedJob& job) { job.outcome->evolved.fuel = std::nan(""); }));
  EXPECT_TRUE(refused([](EndedJob& job) { job.outcome->trace[2].score.total = INFINITY; }));
  EXPECT_TRUE(refused([](EndedJob& job) { job.outcome->measures = {{"a\"b", 0, 1}}; }));
  EXPECT_TRUE(refused([](EndedJob& job) { job.outcome->measures = {{"a", 0, INFINITY}}; }));
  EXPECT_TRUE(refused([](EndedJob& job) { job.outcome->measures = {{"a", 1, 1}, {"a", 0, 1}}; }));
  EXPECT_FALSE(refused([](EndedJob&) {}));
}

TEST_F(ResultsStoreTest, WorkersAreInsertedOnceAndBroughtUpToDate) {
  ResultsStore store(path_);
  store.commit({.workers = {{.incarnation = 7, .host = "a", .process = 1, .threads = 2, .build = "b", .dds = "c"}}});
  store.commit({.workers = {{.incarnation = 7, .host = "a", .process = 1, .threads = 4, .build = "b", .dds = "c"}}});
  EXPECT_EQ(column_of(ResultsReader(path_), "SELECT threads FROM worker"), std::vector<std::string>{"4"});
}

TEST_F(ResultsStoreTest, ReaderOfALongTransactionSeesWholeTransactionsOnly) {
  constexpr std::uint64_t batch_size = 6;
  ResultsStore store(path_);
  const auto many = operator_sweep("many", 40);
  const auto row = store.add_sweep(many.what).sweep.row;
  std::atomic<bool> stop = false;
  std::atomic<int> looks = 0;
  std::thread reading([&] {
    const ResultsReader reader(path_);
    while (!stop) {
      const auto seen = reader.query(
          "SELECT (SELECT count(*) FROM job), (SELECT done FROM sweep), (SELECT count(*) FROM event WHERE kind = 'b')");
      const auto jobs = std::stoull(seen.rows[0][0]);
      EXPECT_EQ(jobs % batch_size, 0U);
      EXPECT_EQ(seen.rows[0][1], seen.rows[0][0]);
      EXPECT_EQ(std::stoull(seen.rows[0][2]) * batch_size, jobs);
      ++looks;
    }
  });
  for (std::uint64_t job = 0; job < many.grid.jobs(); job += batch_size) {
    Batch batch{.events = {{.kind = "b", .sweep = row, .job = {}, .text = ""}}};
    for (std::uint64_t i = 0; i < batch_size; ++i) batch.jobs.push_back(done_job(many, row, job + i));
    store.commit(batch);
  }
  stop = true;
  reading.join();
  EXPECT_GT(looks, 0);
}

TEST_F(ResultsStoreTest, SecondOpeningInTheProcessIsRefusedAndHarmless) {
  ResultsStore store(path_);
  const auto row = store.add_sweep(sweep_.what).sweep.row;
  std::string message;
  EXPECT_EQ(error_of([&] { ResultsStore second(path_); }, &message), Kind::in_use);
  EXPECT_THAT(message, HasSubstr(path_));
  store.commit({.jobs = {done_job(sweep_, row, 0)}});
  EXPECT_EQ(store.epoch(), 1U);
}

TEST_F(ResultsStoreTest, StoreOfAnotherProcessIsRefusedUntilThatProcessIsKilled) {
  std::array<int, 2> ready{};
  ASSERT_EQ(pipe(ready.data()), 0);
  const pid_t other = fork();
  if (other == 0) {
    ResultsStore store(path_);
    store.add_sweep(sweep_.what);
    if (write(ready[1], "x", 1) != 1) _exit(1);
    for (;;) pause();
  }
  char byte = 0;
  ASSERT_EQ(read(ready[0], &byte, 1), 1);
  std::string message;
  EXPECT_EQ(error_of([&] { ResultsStore store(path_); }, &message), Kind::in_use);
  EXPECT_THAT(message, HasSubstr(path_));
  EXPECT_EQ(ResultsReader(path_).sweeps().size(), 1U) << "readers must not be kept out";

  kill(other, SIGKILL);
  waitpid(other, nullptr, 0);
  close(ready[0]);
  close(ready[1]);
  const ResultsStore store(path_);
  EXPECT_EQ(store.epoch(), 2U);
  EXPECT_EQ(store.sweeps().size(), 1U);
}

TEST_F(ResultsStoreTest, ConnectionsOfOthersCannotRemoveTheLogOfAnOpenStore) {
  // SQLite's last connection deletes the write-ahead log. Had the refused second opening dropped our locks, a tool in
  // another process would be the last one.
  ResultsStore store(path_);
  const auto row = store.add_sweep(sweep_.what).sweep.row;
  EXPECT_EQ(error_of([&] { ResultsStore second(path_); }), Kind::in_use);
  EXPECT_EQ(std::system(("sqlite3 '" + path_ + "' 'SELECT count(*) FROM sweep' > /dev/null").c_str()), 0);
  EXPECT_TRUE(std::filesystem::exists(path_ + "-wal"));
  store.commit({.jobs = {done_job(sweep_, row, 0)}});
  EXPECT_EQ(value_of(ResultsReader(path_), "SELECT done FROM progress"), "1");
}

TEST_F(ResultsStoreTest, LogIsBoundedUnlessAReaderHoldsItAndSaysSo) {
  ResultsStore store(path_);
  const auto large = operator_sweep("large", 20);
  const auto row = store.add_sweep(large.what).sweep.row;
  const auto outcome = made_up_outcome(1, 6000);  // half a megabyte of trace
  std::uint64_t next = 0;
  const auto commit = [&](int count) {
    for (; count > 0; --count, ++next) store.commit({.jobs = {done_job(large, row, next, outcome)}});
  };
  commit(100);
  EXPECT_LT(store.log_size().bytes, 24U << 20);
  EXPECT_FALSE(store.log_size().held_by_reader);

  auto reader = raw_connection(path_);
  reader.execute("BEGIN; SELECT count(*) FROM job");
  commit(100);
  EXPECT_GT(store.log_size().bytes, 24U << 20);
  EXPECT_TRUE(store.log_size().held_by_reader);

  reader.execute("COMMIT");
  commit(40);
  EXPECT_FALSE(store.log_size().held_by_reader);
}

}  // namespace
}  // namespace lamprey::storage::testing
