#include "storage/statement.hpp"
#include "tests/storage/power_cut_vfs.hpp"
#include "tests/storage/support.hpp"

#include <gmock/gmock.h>
#include <memory>

namespace lamprey::storage::testing {
namespace {

using Survival = PowerCutVfs::Survival;
using Kind = StorageError::Kind;

constexpr std::uint64_t batch_jobs = 3;

class PowerCutTest : public ::testing::Test {
 protected:
  PowerCutTest() {
    ResultsStore store(path_);
    row_ = store.add_sweep(sweep_.what).sweep.row;
  }

  Batch batch(std::uint64_t number) const {
    Batch made;
    made.workers.push_back(
        {.incarnation = number + 1, .host = "h", .process = 1, .threads = 1, .build = "", .dds = ""});
    for (std::uint64_t i = 0; i < batch_jobs; ++i) {
      const std::uint64_t job = number * batch_jobs + i;
      made.jobs.push_back(done_job(sweep_, row_, job, made_up_outcome(job, static_cast<std::uint32_t>(20 + 37 * i))));
    }
    made.events.push_back({.kind = "batch", .sweep = row_, .job = number, .text = ""});
    return made;
  }

  /// Opens and closes the store again and again, committing batches in between, until they are done or the power goes.
  /// Returns the number of batches whose commit has returned.
  std::uint64_t write_until_cut(std::uint64_t from, std::uint64_t batches) {
    std::uint64_t acknowledged = from;
    try {
      while (acknowledged < batches) {
        ResultsStore store(path_, {.vfs = vfs_.name()});
        for (int i = 0; i < 4 && acknowledged < batches; ++i, ++acknowledged) store.commit(batch(acknowledged));
      }
    } catch (const StorageError&) {
      EXPECT_TRUE(vfs_.is_cut()) << "an error without a power cut";
    }
    return acknowledged;
  }

  /// What is stored after the restart: all acknowledged batches, perhaps the next one, nothing in parts.
  void expect_whole_batches(std::uint64_t acknowledged, const std::string& when) {
    const ResultsStore store(path_);
    const ResultsReader reader(path_);
    const auto events = std::stoull(value_of(reader, "SELECT count(*) FROM event WHERE kind = 'batch'"));
    EXPECT_GE(events, acknowledged) << when << ": an acknowledged batch is lost";
    EXPECT_LE(events, acknowledged + 1) << when;
    EXPECT_EQ(store.ended_jobs(row_), experiment::JobRanges(0, events * batch_jobs)) << when;
    EXPECT_EQ(value_of(reader, "SELECT count(*) FROM worker"), std::to_string(events)) << when;
    EXPECT_EQ(store.sweeps().at(0).counts.done, events * batch_jobs) << when;
    EXPECT_EQ(text_of(verify(path_)), "") << when;
  }

  TemporaryDirectory directory_;
  std::string path_ = directory_.file("results.db");
  SweepCase sweep_ = operator_sweep("operators", 40);
  std::int64_t row_ = 0;
  PowerCutVfs vfs_;
};

TEST_F(PowerCutTest, AcknowledgedBatchesSurviveACutAtAnyOperationAndNoneIsThereInParts) {
  constexpr std::uint64_t batches = 10;
  const std::string before = bytes_of(path_);
  EXPECT_EQ(write_until_cut(0, batches), batches);
  const std::uint64_t operations = vfs_.operations();
  ASSERT_GT(operations, 100U);
  vfs_.start_anew();

  constexpr std::uint64_t stride = 4;  // with two ways to lose writes: enough, and quick
  std::uint64_t cut_in_the_middle = 0;
  for (std::uint64_t at = 1; at <= operations; at += stride) {
    for (const auto survival : {Survival::none, Survival::by_chance}) {
      for (const char* suffix : {"-wal", "-shm"}) std::filesystem::remove(path_ + suffix);
      write_bytes(path_, before);
      const auto cut = at + (survival == Survival::none ? 0 : at % stride);
      vfs_.cut_at(cut);
      const auto acknowledged = write_until_cut(0, batches);
      if (acknowledged > 0 && acknowledged < batches) ++cut_in_the_middle;
      if (!vfs_.is_cut()) vfs_.cut_now();
      vfs_.restart(survival, at);
      expect_whole_batches(acknowledged, "cut at " + std::to_string(cut));
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(cut_in_the_middle, operations / 4) << "hardly any cut came between the commits";
}

TEST_F(PowerCutTest, WorkGoesOnAfterRepeatedCuts) {
  constexpr std::uint64_t batches = 30;
  std::uint64_t acknowledged = 0;
  std::mt19937_64 random(3);
  int cuts = 0;
  while (acknowledged < batches) {
    vfs_.cut_at(20 + random() % 60);
    acknowledged = write_until_cut(acknowledged, batches);
    if (!vfs_.is_cut()) break;
    ++cuts;
    vfs_.restart(Survival::by_chance, random());
    expect_whole_batches(acknowledged, "cut number " + std::to_string(cuts));
    if (HasFailure()) return;
    // The batch that the cut interrupted may have come through; a worker would be told that it is a duplicate.
    acknowledged = ResultsStore(path_).ended_jobs(row_).size() / batch_jobs;
  }
  EXPECT_GT(cuts, 5);
  EXPECT_EQ(ResultsStore(path_).ended_jobs(row_).size(), batches * batch_jobs);
}

TEST_F(PowerCutTest, CutsWhileTheLogIsCopiedAndStartsAnewLoseNothing) {
  // Large enough for a checkpoint, and a log that starts anew, between two commits of an open store.
  constexpr std::uint64_t jobs = 48;
  const auto outcome = made_up_outcome(1, 6000);
  const std::string before = bytes_of(path_);
  const auto write = [&] {
    std::uint64_t acknowledged = 0;
    try {
      ResultsStore store(path_, {.vfs = vfs_.name()});
      for (; acknowledged < jobs; ++acknowledged) {
        store.commit({.jobs = {done_job(sweep_, row_, acknowledged, outcome)}});
      }
    } catch (const StorageError&) {
    }
    return acknowledged;
  };
  const auto first = vfs_.operations();
  ASSERT_EQ(write(), jobs);
  const auto operations = vfs_.operations() - first;
  vfs_.start_anew();
  std::mt19937_64 random(11);
  for (int round = 0; round < 6; ++round) {
    for (const char* suffix : {"-wal", "-shm"}) std::filesystem::remove(path_ + suffix);
    write_bytes(path_, before);
    // The last third is where checkpoints are.
    vfs_.cut_at(operations * 2 / 3 + random() % (operations / 3));
    const auto acknowledged = write();
    if (!vfs_.is_cut()) vfs_.cut_now();
    vfs_.restart(round % 2 == 0 ? Survival::none : Survival::by_chance, random());
    const auto stored = ResultsStore(path_, {.vfs = vfs_.name()}).ended_jobs(row_).size();
    vfs_.start_anew();
    EXPECT_GE(stored, acknowledged);
    EXPECT_LE(stored, acknowledged + 1);
    EXPECT_EQ(text_of(verify(path_)), "");
  }
}

TEST_F(PowerCutTest, DatabaseIsWholeOrAbsentWhenTheFirstOpeningIsCut) {
  const auto path = directory_.file("new.db");
  const auto first = vfs_.operations();
  { const ResultsStore store(path, {.vfs = vfs_.name()}); }
  const auto operations = vfs_.operations() - first;
  vfs_.start_anew();
  for (std::uint64_t at = 1; at <= operations; at += 2) {
    for (const char* suffix : {"", "-wal", "-shm", ".new", ".new-journal"}) std::filesystem::remove(path + suffix);
    vfs_.cut_at(at);
    EXPECT_TRUE(error_of([&] { ResultsStore store(path, {.vfs = vfs_.name()}); }) || at + 20 > operations);
    if (!vfs_.is_cut()) vfs_.cut_now();
    vfs_.restart(at % 4 == 1 ? Survival::none : Survival::by_chance, at);
    EXPECT_NO_THROW(ResultsStore store(path)) << "cut at " << at;
    EXPECT_EQ(text_of(verify(path)), "") << "cut at " << at;
  }
}

TEST_F(PowerCutTest, EpochsNeverRepeat) {
  std::uint64_t last = ResultsStore(path_).epoch();
  for (std::uint64_t at = 1; at < 30; ++at) {
    vfs_.cut_at(at);
    std::uint64_t epoch = last;
    error_of([&] {
      const ResultsStore store(path_, {.vfs = vfs_.name()});
      epoch = store.epoch();
      EXPECT_GT(epoch, last);
    });
    if (!vfs_.is_cut()) vfs_.cut_now();
    vfs_.restart(Survival::none, at);
    last = epoch;
  }
}

/// Commits rows with a plain connection and cuts the power; how many are left.
std::int64_t rows_left(PowerCutVfs& vfs, const std::string& path, const std::string& synchronous) {
  {
    const Connection connection(path, SQLITE_OPEN_READWRITE, vfs.name());
    connection.execute("PRAGMA synchronous = " + synchronous);
    for (int i = 0; i < 10; ++i) connection.execute("INSERT INTO schema_version VALUES (NULL, 0, 'test')");
    vfs.cut_now();
  }
  vfs.restart(Survival::none, 1);
  return std::stoll(value_of(ResultsReader(path), "SELECT count(*) FROM schema_version WHERE program = 'test'"));
}

TEST_F(PowerCutTest, WithoutSynchronizationAcknowledgedRowsAreLost) {
  EXPECT_EQ(rows_left(vfs_, path_, "OFF"), 0);
  EXPECT_EQ(rows_left(vfs_, path_, "FULL"), 10);
}

TEST_F(PowerCutTest, FullDiskIsReportedAsSuchAndTheSameBatchGoesThroughLater) {
  ResultsStore store(path_, {.vfs = vfs_.name()});
  store.commit(batch(0));
  for (std::uint64_t number = 1; number < 12; ++number) {
    vfs_.fail_from(number, SQLITE_FULL);
    const auto kind = error_of([&] { store.commit(batch(number)); });
    vfs_.repair();
    const auto done = [&] { return store.sweeps().at(0).counts.done; };
    if (kind) {
      EXPECT_EQ(kind, Kind::full);
      EXPECT_EQ(done(), number * batch_jobs);
      store.commit(batch(number));
    }
    EXPECT_EQ(done(), (number + 1) * batch_jobs);
  }
  EXPECT_EQ(text_of(verify(path_)), "");
}

TEST_F(PowerCutTest, FailingDiskIsReportedAsSuch) {
  ResultsStore store(path_, {.vfs = vfs_.name()});
  std::string message;
  vfs_.fail_from(1, SQLITE_IOERR_FSYNC);
  EXPECT_EQ(error_of([&] { store.commit(batch(0)); }, &message), Kind::input_output);
  EXPECT_THAT(message, ::testing::HasSubstr("disk I/O error"));
  vfs_.repair();
  store.commit(batch(0));
  EXPECT_EQ(text_of(verify(path_)), "");
}

}  // namespace
}  // namespace lamprey::storage::testing
