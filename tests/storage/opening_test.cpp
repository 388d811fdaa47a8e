#include "storage/database_file.hpp"
#include "storage/schema.hpp"
#include "tests/storage/support.hpp"

#include <cerrno>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

namespace lamprey::storage::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using Kind = StorageError::Kind;

class OpeningTest : public ::testing::Test {
 protected:
  /// Store, reader and verify must all refuse the path with that kind, name it, and leave its bytes alone.
  void expect_refused(const std::string& path, Kind kind, const std::string& reason) {
    const std::string before = bytes_of(path);
    std::string message;
    EXPECT_EQ(error_of([&] { ResultsStore store(path); }, &message), kind) << message;
    EXPECT_THAT(message, AllOf(HasSubstr(path), HasSubstr(reason)));
    expect_reading_refused(path, kind, reason);
    EXPECT_EQ(bytes_of(path), before);
  }

  void expect_reading_refused(const std::string& path, Kind kind, const std::string& reason) {
    std::string message;
    EXPECT_EQ(error_of([&] { ResultsReader reader(path); }, &message), kind) << message;
    EXPECT_THAT(message, AllOf(HasSubstr(path), HasSubstr(reason)));
    EXPECT_EQ(error_of([&] { verify(path); }), kind);
  }

  /// A database of ours with one job, closed.
  std::string make_database(const std::string& name = "results.db") {
    const auto path = directory_.file(name);
    ResultsStore store(path);
    const auto sweep = operator_sweep("operators");
    store.commit({.jobs = {done_job(sweep, store.add_sweep(sweep.what).sweep.row, 3)}});
    return path;
  }

  TemporaryDirectory directory_;
};

TEST_F(OpeningTest, MissingDirectoryIsRefused) {
  expect_refused(directory_.file("no/such/results.db"), Kind::missing, "does not exist");
}

TEST_F(OpeningTest, DirectoryIsRefused) {
  const auto path = directory_.file("directory");
  std::filesystem::create_directory(path);
  expect_refused(path, Kind::not_a_database, "is a directory");
}

TEST_F(OpeningTest, FifoIsRefusedAndNotWaitedFor) {
  const auto path = directory_.file("fifo");
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  std::string message;
  EXPECT_EQ(error_of([&] { ResultsStore store(path); }, &message), Kind::not_a_database);
  EXPECT_THAT(message, HasSubstr("not a regular file"));
}

TEST_F(OpeningTest, TextFileIsRefused) {
  const auto path = directory_.file("notes.txt");
  for (const std::string& text : {std::string("x"), std::string("name: mutate-all\n"), std::string(5000, 'a')}) {
    write_bytes(path, text);
    expect_refused(path, Kind::not_a_database, "is not an SQLite database");
  }
}

TEST_F(OpeningTest, DatabaseOfAnotherApplicationIsRefused) {
  const auto path = directory_.file("photos.db");
  Connection(path, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, "").execute("CREATE TABLE photo (name TEXT)");
  expect_refused(path, Kind::not_a_database, "another application");

  // Also one that uses a write-ahead log of its own.
  raw_connection(path).execute("PRAGMA journal_mode = WAL; INSERT INTO photo VALUES ('a')");
  expect_refused(path, Kind::not_a_database, "another application");
  EXPECT_FALSE(std::filesystem::exists(path + "-shm"));
}

TEST_F(OpeningTest, OurApplicationIdWithoutOurTablesIsRefused) {
  const auto path = directory_.file("bare.db");
  Connection(path, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, "")
      .execute("PRAGMA application_id = " + std::to_string(application_id) + "; CREATE TABLE a (b)");
  expect_refused(path, Kind::not_a_database, "lacks the tables");
}

TEST_F(OpeningTest, NewerSchemaIsRefused) {
  const auto path = make_database();
  raw_connection(path).execute("PRAGMA user_version = " + std::to_string(schema_version + 1));
  expect_refused(path, Kind::newer_schema, "later Lamprey");
}

TEST_F(OpeningTest, NewerSchemaThatStandsInTheLogOnlyIsRefused) {
  const auto path = make_database();
  const auto other = raw_connection(path);
  other.execute("PRAGMA user_version = " + std::to_string(schema_version + 1));
  ASSERT_GT(std::filesystem::file_size(path + "-wal"), 0U);
  expect_refused(path, Kind::newer_schema, "later Lamprey");
}

TEST_F(OpeningTest, NewerSchemaIsNamedWithWhatThisProgramKnows) {
  const auto path = make_database();
  raw_connection(path).execute("PRAGMA user_version = 7");
  expect_refused(path, Kind::newer_schema, "(schema version 7, this program knows up to 4)");
}

TEST_F(OpeningTest, OtherScienceIsRefusedForWritingAndReadable) {
  const auto path = make_database();
  raw_connection(path).execute("UPDATE database SET science_version = science_version + 1");
  const auto before = bytes_of(path);
  std::string message;
  EXPECT_EQ(error_of([&] { ResultsStore store(path); }, &message), Kind::other_science);
  EXPECT_THAT(message, AllOf(HasSubstr("science version " + std::to_string(experiment::science_version + 1)),
                             HasSubstr("computes those of " + std::to_string(experiment::science_version)),
                             HasSubstr("use another database, or the Lamprey that wrote this one")));
  EXPECT_EQ(error_of([&] { verify(path); }, &message), Kind::other_science);
  EXPECT_THAT(message, HasSubstr("check it with the Lamprey that wrote it"));
  EXPECT_EQ(ResultsReader(path).science_version(), experiment::science_version + 1);
  EXPECT_EQ(bytes_of(path), before);
}

TEST_F(OpeningTest, EmptyFileBecomesADatabaseAndIsNoneForReaders) {
  const auto path = directory_.file("empty.db");
  write_bytes(path, "");
  expect_reading_refused(path, Kind::not_a_database, "is empty");
  EXPECT_EQ(ResultsStore(path).epoch(), 1U);
  EXPECT_EQ(ResultsReader(path).sweeps().size(), 0U);
}

TEST_F(OpeningTest, ReadersDoNotMakeADatabase) {
  const auto path = directory_.file("absent.db");
  expect_reading_refused(path, Kind::missing, "does not exist");
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(OpeningTest, LogOfALostDatabaseIsNotDeleted) {
  const auto path = directory_.file("results.db");
  write_bytes(path + "-wal", "results that were acknowledged");
  std::string message;
  EXPECT_EQ(error_of([&] { ResultsStore store(path); }, &message), Kind::input_output);
  EXPECT_THAT(message, HasSubstr(path + "-wal"));
  EXPECT_EQ(bytes_of(path + "-wal"), "results that were acknowledged");
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(OpeningTest, RemainsOfAnInterruptedCreationAreReplaced) {
  const auto path = directory_.file("results.db");
  write_bytes(path + ".new", std::string(9000, 'x'));
  write_bytes(path + ".new-journal", std::string(900, 'x'));
  EXPECT_EQ(ResultsStore(path).epoch(), 1U);
  EXPECT_FALSE(std::filesystem::exists(path + ".new"));
  EXPECT_EQ(text_of(verify(path)), "");
}

TEST_F(OpeningTest, OverwrittenMiddleIsCorruptAndNothingIsWritten) {
  const auto path = make_database();
  auto bytes = bytes_of(path);
  for (std::size_t i = 100; i < bytes.size(); ++i) bytes[i] = 'x';
  write_bytes(path, bytes);
  EXPECT_EQ(error_of([&] { ResultsStore store(path); }), Kind::corrupt);
  EXPECT_EQ(error_of([&] { ResultsReader reader(path); }), Kind::corrupt);
  EXPECT_EQ(bytes_of(path), bytes);
}

TEST(NetworkFileSystem, TypesOfNetworkFileSystemsAreKnown) {
  EXPECT_TRUE(is_network_file_system(0x6969));       // NFS
  EXPECT_TRUE(is_network_file_system(0xff534d42));   // CIFS
  EXPECT_TRUE(is_network_file_system(0xfe534d42));   // SMB2
  EXPECT_TRUE(is_network_file_system(0x00c36400));   // Ceph
  EXPECT_FALSE(is_network_file_system(0xef53));      // ext4
  EXPECT_FALSE(is_network_file_system(0x01021994));  // tmpfs
  EXPECT_FALSE(is_network_file_system(0x9123683e));  // btrfs
  EXPECT_FALSE(is_network_file_system(0x58465342));  // XFS
  EXPECT_FALSE(is_network_file_system(0x794c7630));  // overlayfs
}

TEST(ErrorKind, FollowsSqlitesResultCode) {
  EXPECT_EQ(error_kind(SQLITE_FULL), Kind::full);
  EXPECT_EQ(error_kind(SQLITE_CORRUPT_VTAB), Kind::corrupt);
  EXPECT_EQ(error_kind(SQLITE_CORRUPT_INDEX), Kind::corrupt);
  EXPECT_EQ(error_kind(SQLITE_NOTADB), Kind::not_a_database);
  EXPECT_EQ(error_kind(SQLITE_IOERR_FSYNC), Kind::input_output);
  EXPECT_EQ(error_kind(SQLITE_READONLY), Kind::read_only);
  EXPECT_EQ(error_kind(SQLITE_READONLY_DIRECTORY), Kind::read_only);
  EXPECT_EQ(error_kind(SQLITE_READONLY_DBMOVED), Kind::input_output);
  EXPECT_EQ(error_kind(SQLITE_BUSY_SNAPSHOT), Kind::busy);
  EXPECT_EQ(error_kind(SQLITE_PROTOCOL), Kind::busy);
}

TEST(ErrorKind, FollowsTheSystemsReasonWhereSqliteHasNone) {
  EXPECT_EQ(error_kind(SQLITE_IOERR_WRITE, ENOSPC), Kind::full);
  EXPECT_EQ(error_kind(SQLITE_IOERR_WRITE, EDQUOT), Kind::full);
  EXPECT_EQ(error_kind(SQLITE_IOERR_SHMSIZE, ENOSPC), Kind::full);
  EXPECT_EQ(error_kind(SQLITE_IOERR_WRITE, EROFS), Kind::read_only);
  EXPECT_EQ(error_kind(SQLITE_IOERR_WRITE, EIO), Kind::input_output);
  EXPECT_EQ(error_kind(SQLITE_CANTOPEN, EACCES), Kind::read_only);
  EXPECT_EQ(error_kind(SQLITE_CANTOPEN, ENOENT), Kind::missing);
  EXPECT_EQ(error_kind(SQLITE_CANTOPEN, EMFILE), Kind::input_output);
  // What SQLite says itself counts more than what the system said last.
  EXPECT_EQ(error_kind(SQLITE_CORRUPT, ENOSPC), Kind::corrupt);
}

}  // namespace
}  // namespace lamprey::storage::testing
