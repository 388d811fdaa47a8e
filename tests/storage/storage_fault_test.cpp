#include "storage/statement.hpp"
#include "tests/storage/power_cut_vfs.hpp"
#include "tests/storage/support.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace lamprey::storage::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using Kind = StorageError::Kind;

/// A store whose disk fails. Whatever the fault, what had been committed stays and the same batch goes through later.
class StorageFaultTest : public ::testing::Test {
 protected:
  StorageFaultTest() {
    ResultsStore store(path_);
    row_ = store.add_sweep(sweep_.what).sweep.row;
  }

  /// Every kind of row.
  Batch batch(std::uint64_t number) const {
    Batch made;
    made.workers.push_back(
        {.incarnation = number + 1, .host = "h", .process = 1, .threads = 1, .build = "", .dds = ""});
    for (const std::uint64_t job : {3 * number, 3 * number + 1}) {
      made.jobs.push_back(done_job(sweep_, row_, job, made_up_outcome(job, 150)));
    }
    made.events.push_back({"batch", row_, number, 0, ""});
    made.attempts.push_back({row_, 3 * number + 2, number + 1, "lost", true, "x"});
    made.checkpoints.push_back({row_, 3 * number + 2, number + 1, 5, 1.0, std::string(9000, 'c')});
    return made;
  }

  /// Exactly the first `batches` are there, whole.
  void expect_whole(const ResultsStore& store, std::uint64_t batches, const std::string& when) {
    EXPECT_EQ(store.ended_jobs(row_).size(), 2 * batches) << when;
    EXPECT_EQ(store.sweeps().at(0).counts.done, 2 * batches) << when;
    EXPECT_EQ(store.counted_attempts(row_).size(), batches) << when;
    EXPECT_EQ(store.checkpointed_jobs(row_).size(), batches) << when;
    EXPECT_EQ(text_of(verify(path_)), "") << when;
  }

  /// The fault at each operation of a commit in turn, until none is left that can fail.
  void expect_recovery(int code, int system_error, Kind expected) {
    ResultsStore store(path_, {.vfs = vfs_.name()});
    store.commit(batch(0));
    std::uint64_t at = 1;
    for (;; ++at) {
      vfs_.fail_from(at, code, system_error);
      std::string message;
      const auto kind = error_of([&] { store.commit(batch(1)); }, &message);
      vfs_.repair();
      if (!kind) break;
      EXPECT_EQ(kind, expected) << message;
      EXPECT_THAT(message, HasSubstr(path_));
      ASSERT_LT(at, 200U);
      if (at % 4 == 1) expect_whole(store, 1, "operation " + std::to_string(at));
    }
    EXPECT_GT(at, 5U) << "hardly anything could fail";
    expect_whole(store, 2, "after the fault");
    store.commit(batch(2));
    expect_whole(store, 3, "after a further commit");
  }

  TemporaryDirectory directory_;
  std::string path_ = directory_.file("results.db");
  SweepCase sweep_ = operator_sweep("operators", 40);
  std::int64_t row_ = 0;
  PowerCutVfs vfs_;
};

TEST_F(StorageFaultTest, FullDiskAtEachWriteOfACommit) {
  expect_recovery(SQLITE_FULL, 0, Kind::full);
}

TEST_F(StorageFaultTest, ExhaustedQuotaIsAFullDisk) {
  expect_recovery(SQLITE_IOERR_WRITE, EDQUOT, Kind::full);
}

TEST_F(StorageFaultTest, FileSystemThatHasBecomeReadOnly) {
  expect_recovery(SQLITE_IOERR_WRITE, EROFS, Kind::read_only);
}

TEST_F(StorageFaultTest, BrokenDiskAtEachWriteOfACommit) {
  expect_recovery(SQLITE_IOERR_FSYNC, EIO, Kind::input_output);
}

TEST_F(StorageFaultTest, OtherFunctionsThatWriteLeaveNothingBehindEither) {
  ResultsStore store(path_, {.vfs = vfs_.name()});
  store.commit(batch(0));
  store.commit({.jobs = {ended_job(sweep_, row_, 100, JobState::failed, "x")}});
  const std::array<std::function<void()>, 6> writing = {
      [&] { store.rename(row_, "renamed"); },
      [&] { store.set_archived(row_, true); },
      [&] { store.set_execution(row_, "x"); },
      [&] { store.retry(row_, false); },
      [&] {
        store.add_audit({.id = {1, 2}, .sweep = row_, .share = 1, .seed = 1, .jobs = 1});
      },
      [&] { store.add_sweep(operator_sweep("another").what); }};
  const auto state = [&] {
    std::string text;
    const ResultsReader reader(path_);
    for (const char* sql : {"SELECT * FROM sweep", "SELECT count(*) FROM event", "SELECT count(*) FROM job",
                            "SELECT count(*) FROM audit", "SELECT count(*) FROM attempt"}) {
      for (const auto& row : reader.query(sql).rows) {
        for (const auto& value : row) text += value + '\n';
      }
    }
    return text;
  };
  for (const auto& write : writing) {
    const auto before = state();
    vfs_.fail_from(1, SQLITE_FULL);
    EXPECT_EQ(error_of(write), Kind::full);
    vfs_.repair();
    EXPECT_EQ(state(), before);
    EXPECT_FALSE(error_of(write));
    EXPECT_NE(state(), before);
    EXPECT_EQ(text_of(verify(path_)), "");
  }
}

TEST_F(StorageFaultTest, OtherProgramsWriteTransactionIsBusyAndPasses) {
  ResultsStore store(path_);
  const auto other = raw_connection(path_);
  other.execute("BEGIN IMMEDIATE");
  std::string message;
  EXPECT_EQ(error_of([&] { store.commit(batch(0)); }, &message), Kind::busy);
  EXPECT_THAT(message, AllOf(HasSubstr(path_), HasSubstr("database is locked")));
  EXPECT_TRUE(store.ended_jobs(row_).empty()) << "reading goes on";
  other.execute("ROLLBACK");
  store.commit(batch(0));
  expect_whole(store, 1, "after the lock");
}

/// The page of the file on which the row lies that a table's b-tree has first or last.
std::size_t leaf_page(const std::string& path, const std::string& table, bool last) {
  const auto other = raw_connection(path);
  Statement pages(other, "SELECT pageno FROM dbstat WHERE name = '" + table + "' AND pagetype = 'leaf' ORDER BY path" +
                             (last ? " DESC" : "") + " LIMIT 1");
  if (!pages.step()) throw std::runtime_error("no leaf");
  return static_cast<std::size_t>(pages.integer(0));
}

class DamagedPageTest : public StorageFaultTest {
 protected:
  DamagedPageTest() {
    {
      ResultsStore store(path_);
      for (std::uint64_t number = 0; number < 40; ++number) store.commit(batch(number));
    }
    intact_ = bytes_of(path_);
  }

  void damage(bool last) {
    constexpr std::size_t page_bytes = 4096;
    auto bytes = intact_;
    const auto begin = (leaf_page(path_, "job", last) - 1) * page_bytes;
    for (std::size_t i = begin; i < begin + 100; ++i) bytes[i] = static_cast<char>(bytes[i] ^ 0x5a);
    write_bytes(path_, bytes);
  }

  /// Puts the page back as a repaired disk would: into the same file.
  void repair() {
    std::FILE* file = std::fopen(path_.c_str(), "r+b");
    EXPECT_EQ(std::fwrite(intact_.data(), 1, intact_.size(), file), intact_.size());
    std::fclose(file);
  }

  std::string intact_;
};

TEST_F(DamagedPageTest, WhatTouchesItIsCorruptAndTheRestGoesOn) {
  damage(false);
  ResultsStore store(path_);
  std::string message;
  for (int time = 0; time < 2; ++time) {
    EXPECT_EQ(error_of([&] { store.find_job(row_, 0); }, &message), Kind::corrupt);
    EXPECT_THAT(message, AllOf(HasSubstr(path_), HasSubstr("database disk image is malformed")));
    EXPECT_EQ(error_of([&] { store.read_job(row_, 0); }), Kind::corrupt);
  }
  EXPECT_EQ(store.find_job(row_, 117)->digest, batch(39).jobs[0].digest);
  EXPECT_EQ(store.ended_jobs(row_).size(), 80U);
  store.commit(batch(40));
  EXPECT_EQ(store.sweeps().at(0).counts.done, 82U);
  EXPECT_EQ(error_of([&] { ResultsReader(path_).job(row_, 0); }), Kind::corrupt);
  EXPECT_THAT(text_of(verify(path_)), HasSubstr("integrity check"));
}

TEST_F(DamagedPageTest, CommitThatTouchesItStoresNothingAndGoesThroughOnceItIsRepaired) {
  damage(true);
  ResultsStore store(path_);
  std::string message;
  EXPECT_EQ(error_of([&] { store.commit(batch(40)); }, &message), Kind::corrupt);
  EXPECT_THAT(message, AllOf(HasSubstr(path_), HasSubstr("database disk image is malformed")));
  EXPECT_EQ(store.sweeps().at(0).counts.done, 80U);
  EXPECT_EQ(store.find_job(row_, 0)->digest, batch(0).jobs[0].digest);
  store.commit({.events = {{"seen", row_, {}, 0, "other tables go on"}}});
  repair();
  store.commit(batch(40));
  expect_whole(store, 41, "after the repair");
}

/// Runs in a process of its own; how it ended.
template <typename Action>
int in_child(const Action& action) {
  const pid_t child = fork();
  if (child == 0) {
    int code = 1;
    try {
      code = action();
    } catch (...) {
    }
    _exit(code);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

// A real limit, where the log cannot grow: the system refuses the write, not a VFS of ours.
TEST_F(StorageFaultTest, LogThatMayNotGrowIsAFullDiskUntilItMay) {
  const int code = in_child([&] {
    std::signal(SIGXFSZ, SIG_IGN);
    ResultsStore store(path_);
    store.commit(batch(0));
    rlimit limit{};
    getrlimit(RLIMIT_FSIZE, &limit);
    const auto unlimited = limit.rlim_cur;
    limit.rlim_cur = store.log_size().bytes + 5000;
    if (setrlimit(RLIMIT_FSIZE, &limit) != 0) return 10;
    for (int time = 0; time < 3; ++time) {
      if (error_of([&] { store.commit(batch(1)); }) != Kind::full) return 11;
      if (store.ended_jobs(row_).size() != 2) return 12;
    }
    limit.rlim_cur = unlimited;
    setrlimit(RLIMIT_FSIZE, &limit);
    store.commit(batch(1));
    return store.ended_jobs(row_).size() == 4 ? 0 : 13;
  });
  EXPECT_EQ(code, 0);
  expect_whole(ResultsStore(path_), 2, "after the limit");
}

TEST_F(StorageFaultTest, WriterThatIsKilledLeavesWhatItWasToldIsCommitted) {
  constexpr std::uint64_t most = 1000;
  std::uint64_t committed = 0;
  for (int round = 0; round < 5; ++round) {
    std::array<int, 2> told{};
    ASSERT_EQ(pipe(told.data()), 0);
    const pid_t writer = fork();
    if (writer == 0) {
      try {
        ResultsStore store(path_);
        for (std::uint64_t number = committed; number < most; ++number) {
          store.commit(batch(number));
          if (write(told[1], "x", 1) != 1) _exit(1);
        }
      } catch (...) {
      }
      _exit(1);
    }
    close(told[1]);
    char byte = 0;
    std::uint64_t acknowledged = 0;
    const std::uint64_t until = 3 + 5 * static_cast<std::uint64_t>(round);
    while (acknowledged < until && read(told[0], &byte, 1) == 1) ++acknowledged;
    kill(writer, SIGKILL);
    waitpid(writer, nullptr, 0);
    while (read(told[0], &byte, 1) == 1) ++acknowledged;
    close(told[0]);
    ASSERT_GE(acknowledged, until);
    const ResultsStore store(path_);
    const auto stored = store.ended_jobs(row_).size() / 2;
    EXPECT_GE(stored, committed + acknowledged) << "an acknowledged batch is lost";
    EXPECT_LE(stored, committed + acknowledged + 1);
    expect_whole(store, stored, "round " + std::to_string(round));
    committed = stored;
  }
}

}  // namespace
}  // namespace lamprey::storage::testing
