#include "storage/backup.hpp"

#include "tests/storage/support.hpp"

#include <atomic>
#include <csignal>
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace lamprey::storage::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using Kind = StorageError::Kind;

class BackupTest : public ::testing::Test {
 protected:
  /// A database with `jobs` done jobs of its sweep.
  void make_database(const std::string& path, std::uint64_t jobs) {
    ResultsStore store(path);
    const auto row = store.add_sweep(sweep_.what).sweep.row;
    Batch batch;
    for (std::uint64_t job = 0; job < jobs; ++job) batch.jobs.push_back(done_job(sweep_, row, job));
    store.commit(batch);
  }

  void expect_refused(Kind kind, const std::string& target, const BackupOptions& options, const std::string& reason) {
    const auto before = bytes_of(target);
    std::string message;
    EXPECT_EQ(error_of([&] { back_up(path_, target, options); }, &message), kind) << message;
    EXPECT_THAT(message, AllOf(HasSubstr(target), HasSubstr(reason)));
    EXPECT_EQ(bytes_of(target), before);
    EXPECT_FALSE(std::filesystem::exists(target + ".part"));
  }

  TemporaryDirectory directory_;
  std::string path_ = directory_.file("results.db");
  std::string copy_ = directory_.file("copy.db");
  SweepCase sweep_ = operator_sweep("operators", 200);
};

TEST_F(BackupTest, CopyHoldsTheSameAndCanBeGoneOnWith) {
  make_database(path_, 20);
  const auto before = bytes_of(path_);
  std::uint64_t last = 0;
  std::uint64_t all = 0;
  const auto summary = back_up(path_, copy_, {}, [&](std::uint64_t done, std::uint64_t pages) {
    last = done;
    all = pages;
  });
  EXPECT_EQ(summary.sweeps, 1U);
  EXPECT_EQ(summary.jobs, 20U);
  EXPECT_EQ(summary.schema_version, 4);
  EXPECT_EQ(summary.bytes, std::filesystem::file_size(copy_));
  EXPECT_GT(last, 0U);
  EXPECT_EQ(last, all);
  EXPECT_EQ(bytes_of(path_), before);
  for (const char* suffix : {".part", "-wal", "-shm", ".part-wal", ".part-journal"}) {
    EXPECT_FALSE(std::filesystem::exists(copy_ + suffix)) << suffix;
  }
  EXPECT_EQ(text_of(verify(copy_)), "");
  ResultsStore store(copy_);
  EXPECT_EQ(store.epoch(), 2U);
  store.commit({.jobs = {done_job(sweep_, 1, 20)}});
  EXPECT_EQ(text_of(verify(copy_)), "");
}

TEST_F(BackupTest, CopyBesideAWriterIsOfOneMomentAndHoldsWhatWasCommittedBefore) {
  ResultsStore store(path_);
  const auto row = store.add_sweep(sweep_.what).sweep.row;
  std::atomic<std::uint64_t> committed = 0;
  std::atomic<bool> stop = false;
  std::thread writer([&] {
    for (std::uint64_t job = 0; job + 2 <= sweep_.grid.jobs() && !stop; job += 2) {
      store.commit({.jobs = {done_job(sweep_, row, job, made_up_outcome(job, 300)),
                             done_job(sweep_, row, job + 1, made_up_outcome(job, 300))}});
      committed = job + 2;
    }
  });
  for (int round = 0; round < 4; ++round) {
    while (committed < 20U * static_cast<unsigned>(round + 1)) std::this_thread::yield();
    const auto copy = directory_.file("copy-" + std::to_string(round) + ".db");
    const std::uint64_t before = committed;
    // The writer goes on between the steps of the copy.
    const auto summary = back_up(path_, copy, {}, [&](std::uint64_t, std::uint64_t) {
      const std::uint64_t now = committed;
      while (committed < now + 2 && committed + 2 <= sweep_.grid.jobs()) std::this_thread::yield();
    });
    EXPECT_GE(summary.jobs, before);
    EXPECT_EQ(summary.jobs % 2, 0U) << "a transaction is there in parts";
    EXPECT_EQ(text_of(verify(copy)), "");
    EXPECT_GE(ResultsReader(copy).find_sweep("operators")->counts.done, before);
  }
  stop = true;
  writer.join();
  EXPECT_EQ(text_of(verify(path_)), "");
}

TEST_F(BackupTest, ExistingTargetIsRefusedUnlessItIsADatabaseToBeReplaced) {
  make_database(path_, 5);
  make_database(copy_, 2);
  expect_refused(Kind::not_possible, copy_, {}, "exists already");
  EXPECT_EQ(back_up(path_, copy_, {.replace = true}).jobs, 5U);
  EXPECT_EQ(text_of(verify(copy_)), "");

  const auto notes = directory_.file("notes.txt");
  write_bytes(notes, "important");
  expect_refused(Kind::not_possible, notes, {.replace = true}, "only a Lamprey database is replaced");
  const auto link = directory_.file("link.db");
  std::filesystem::create_symlink(copy_, link);
  expect_refused(Kind::not_possible, link, {.replace = true}, "is a symbolic link");
}

TEST_F(BackupTest, LogOfAReplacedDatabaseIsNotTakenForTheNewOnes) {
  make_database(path_, 5);
  const pid_t child = fork();
  if (child == 0) {
    ResultsStore store(copy_);  // leaves its log behind
    store.add_sweep(operator_sweep("lost", 3).what);
    kill(getpid(), SIGKILL);
  }
  waitpid(child, nullptr, 0);
  ASSERT_GT(std::filesystem::file_size(copy_ + "-wal"), 0U);
  back_up(path_, copy_, {.replace = true});
  EXPECT_FALSE(std::filesystem::exists(copy_ + "-wal"));
  EXPECT_EQ(ResultsReader(copy_).sweeps().at(0).what.name, "operators");
  EXPECT_EQ(text_of(verify(copy_)), "");
}

TEST_F(BackupTest, DatabaseInUseIsNotReplaced) {
  make_database(path_, 5);
  make_database(copy_, 2);
  {
    const ResultsStore store(copy_);
    expect_refused(Kind::in_use, copy_, {.replace = true}, "a coordinator is using");
  }
  const ResultsReader reader(copy_);
  reader.sweeps();
  expect_refused(Kind::in_use, copy_, {.replace = true}, "another program is using");
}

TEST_F(BackupTest, TargetThatIsTheSourceIsRefused) {
  make_database(path_, 5);
  expect_refused(Kind::not_possible, path_, {.replace = true}, "is the database itself");
  const auto link = directory_.file("hard.db");
  std::filesystem::create_hard_link(path_, link);
  expect_refused(Kind::not_possible, link, {.replace = true}, "is the database itself");

  // The name under which the copy would be made.
  const auto part = directory_.file("x.db.part");
  std::filesystem::rename(path_, part);
  std::filesystem::remove(link);
  const auto before = bytes_of(part);
  EXPECT_EQ(error_of([&] { back_up(part, directory_.file("x.db")); }), Kind::not_possible);
  EXPECT_EQ(bytes_of(part), before);
}

TEST_F(BackupTest, WhatCannotBeReadOrWrittenIsNamed) {
  EXPECT_EQ(error_of([&] { back_up(path_, copy_); }), Kind::missing);
  make_database(path_, 5);
  expect_refused(Kind::missing, directory_.file("no/such/copy.db"), {}, "does not exist");
  write_bytes(copy_ + "-wal", "of a lost database");
  expect_refused(Kind::input_output, copy_, {}, "move it back or away");
  EXPECT_FALSE(std::filesystem::exists(copy_));
}

TEST_F(BackupTest, CopyingThatIsEndedOrInterruptedLeavesNothing) {
  make_database(path_, 5);
  EXPECT_THROW(back_up(path_, copy_, {}, [](std::uint64_t, std::uint64_t) { throw std::runtime_error("stop"); }),
               std::runtime_error);
  EXPECT_FALSE(std::filesystem::exists(copy_));
  EXPECT_FALSE(std::filesystem::exists(copy_ + ".part"));
  // What a kill leaves is no obstacle.
  write_bytes(copy_ + ".part", std::string(100000, 'x'));
  write_bytes(copy_ + ".part-wal", std::string(1000, 'x'));
  back_up(path_, copy_);
  EXPECT_EQ(text_of(verify(copy_)), "");
  EXPECT_FALSE(std::filesystem::exists(copy_ + ".part-wal"));
}

TEST_F(BackupTest, DiskThatIsTooSmallIsFullAndNothingIsLeft) {
  make_database(path_, 50);
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit limit{};
    getrlimit(RLIMIT_FSIZE, &limit);
    limit.rlim_cur = std::filesystem::file_size(path_) / 2;
    setrlimit(RLIMIT_FSIZE, &limit);
    _exit(error_of([&] { back_up(path_, copy_); }) == Kind::full ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_FALSE(std::filesystem::exists(copy_));
  EXPECT_FALSE(std::filesystem::exists(copy_ + ".part"));
}

TEST_F(BackupTest, DamageIsFoundBeforeTheCopyGetsItsName) {
  make_database(path_, 400);
  auto bytes = bytes_of(path_);
  const auto middle = bytes.size() / 4096 / 2 * 4096;
  for (std::size_t i = 0; i < 3 * 4096; ++i) bytes[middle + i] = 'x';
  write_bytes(path_, bytes);
  EXPECT_EQ(error_of([&] { back_up(path_, copy_); }), Kind::corrupt);
  EXPECT_FALSE(std::filesystem::exists(copy_));
}

TEST_F(BackupTest, DatabaseOfAnOlderVersionIsCopiedAsItIs) {
  {
    const Connection connection(path_, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, "");
    connection.execute(bytes_of(LAMPREY_VERSION_2_DUMP));
  }
  const auto summary = back_up(path_, copy_);
  EXPECT_EQ(summary.schema_version, 2);
  EXPECT_EQ(summary.sweeps, 3U);
  EXPECT_EQ(summary.jobs, 13U);
  EXPECT_EQ(ResultsReader(copy_).sweeps().size(), 3U);
}

}  // namespace
}  // namespace lamprey::storage::testing
