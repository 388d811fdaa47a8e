#include "storage/backup.hpp"

#include "storage/database_file.hpp"
#include "storage/schema.hpp"
#include "storage/statement.hpp"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <memory>
#include <optional>
#include <unistd.h>

namespace lamprey::storage {

namespace {

namespace fs = std::filesystem;
using Kind = StorageError::Kind;

/// Pages between two calls of the progress function.
constexpr int step_pages = 1024;

bool same_file(const std::string& a, const std::string& b) {
  std::error_code absent;
  return fs::equivalent(a, b, absent) && !absent;
}

void remove_with_log(const std::string& path) {
  for (const char* suffix : {"", "-wal", "-shm", "-journal"}) unlink((path + suffix).c_str());
}

/// The copy while it is being made: locked, empty at first, and gone with the object unless it has been renamed.
class UnfinishedCopy {
 public:
  explicit UnfinishedCopy(std::string path) : path_(std::move(path)), lock_(ExclusiveLock::try_lock(path_, true)) {
    if (!lock_ || !lock_->is_of(path_)) {
      throw StorageError(Kind::in_use, path_ + ": another backup is writing this file");
    }
    // What an interrupted backup has left.
    if (truncate(path_.c_str(), 0) != 0) fail("truncate");
    for (const char* suffix : {"-wal", "-shm", "-journal"}) unlink((path_ + suffix).c_str());
  }
  ~UnfinishedCopy() {
    if (!renamed_) remove_with_log(path_);
  }
  UnfinishedCopy(const UnfinishedCopy&) = delete;
  UnfinishedCopy& operator=(const UnfinishedCopy&) = delete;

  const std::string& path() const { return path_; }

  /// Durable under its new name when it returns.
  void rename_to(const std::string& target, bool replace) {
    lock_->synchronize(path_);
    int result = renameat2(AT_FDCWD, path_.c_str(), AT_FDCWD, target.c_str(), replace ? 0 : RENAME_NOREPLACE);
    if (result != 0 && errno == EINVAL)
      result = std::rename(path_.c_str(), target.c_str());  // not on every file system
    if (result != 0 && errno == EEXIST) throw StorageError(Kind::not_possible, target + ": exists already");
    if (result != 0) fail("rename");
    renamed_ = true;
    synchronize_directory(directory_of(target));
  }

 private:
  [[noreturn]] void fail(const char* doing) const { throw_system_error(path_, doing); }

  std::string path_;
  std::optional<ExclusiveLock> lock_;
  bool renamed_ = false;
};

/// Keeps others from using the database that is replaced; nothing if there is none.
std::optional<ExclusiveLock> lock_replaced(const std::string& target) {
  if (inspect(target, "") == FileContent::nothing && !fs::exists(target)) return std::nullopt;
  auto lock = ExclusiveLock::try_lock(target, false);
  if (!lock) throw StorageError(Kind::in_use, target + ": a coordinator is using this database; it cannot be replaced");
  return lock;
}

/// What may be at the target, before a byte is copied.
void check_target(const std::string& source, const std::string& target, bool replace) {
  for (const auto& path : {target, target + ".part"}) {
    if (same_file(source, path)) throw StorageError(Kind::not_possible, path + ": is the database itself");
  }
  std::error_code absent;
  const auto status = fs::symlink_status(target, absent);
  if (!fs::exists(status)) return refuse_remains(target);
  if (!replace) throw StorageError(Kind::not_possible, target + ": exists already");
  if (fs::is_symlink(status)) throw StorageError(Kind::not_possible, target + ": is a symbolic link");
  try {
    inspect(target, "");
  } catch (const StorageError& error) {
    if (error.kind() != Kind::not_a_database) throw;
    throw StorageError(Kind::not_possible, std::string(error.what()) + "; only a Lamprey database is replaced");
  }
}

void copy_pages(const Connection& source, const Connection& target,
                const std::function<void(std::uint64_t, std::uint64_t)>& progress) {
  struct Finish {
    void operator()(sqlite3_backup* backup) const noexcept { sqlite3_backup_finish(backup); }
  };
  const std::unique_ptr<sqlite3_backup, Finish> backup(
      sqlite3_backup_init(target.handle(), "main", source.handle(), "main"));
  if (!backup) target.fail(sqlite3_errcode(target.handle()), "begin to copy");
  for (int code = SQLITE_OK; code != SQLITE_DONE;) {
    errno = 0;
    code = sqlite3_backup_step(backup.get(), step_pages);
    if (code != SQLITE_OK && code != SQLITE_DONE) {
      // Damage is found in the source; what cannot be written is the copy.
      const bool in_source = (code & 0xff) == SQLITE_CORRUPT;
      (in_source ? source : target).fail(code, "copy");
    }
    if (!progress) continue;
    const int pages = sqlite3_backup_pagecount(backup.get());
    progress(static_cast<std::uint64_t>(pages - sqlite3_backup_remaining(backup.get())),
             static_cast<std::uint64_t>(pages));
  }
}

void check_copy(const Connection& copy) {
  Statement check(copy, "PRAGMA quick_check(1)");
  if (check.step() && check.text(0) == "ok") return;
  throw StorageError(Kind::corrupt,
                     copy.path() + ": the copy, and so the database, is damaged: " + std::string(check.text(0)));
}

BackupSummary summary_of(const Connection& copy) {
  BackupSummary summary;
  Statement counts(copy, "SELECT count(*), coalesce(sum(done + failed + quarantined + cancelled), 0) FROM sweep");
  if (counts.step()) {
    summary.sweeps = counts.bits(0);
    summary.jobs = counts.bits(1);
  }
  summary.schema_version = stored_schema_version(copy);
  return summary;
}

/// The copy, complete and closed.
BackupSummary make_copy(const std::string& source, const std::string& unfinished,
                        const std::function<void(std::uint64_t, std::uint64_t)>& progress) {
  const Connection reading = open_existing(source);
  // A transaction of ours around all steps: they copy what was there when it began.
  Transaction snapshot(reading, Transaction::Mode::read);
  stored_schema_version(reading);
  const Connection copy(unfinished, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, "");
  // Nobody else knows the file, and if anything fails it goes.
  copy.execute("PRAGMA locking_mode = EXCLUSIVE; PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF");
  copy_pages(reading, copy, progress);
  check_copy(copy);
  return summary_of(copy);
}

/// Puts what the log of a database that is replaced holds into its file, so that no log is left which would be taken
/// for the new one's.
void close_replaced(const std::string& target) {
  const auto refuse = [&] {
    throw StorageError(Kind::in_use, target + ": another program is using this database; it cannot be replaced now");
  };
  {
    const Connection connection(target, SQLITE_OPEN_READWRITE, "");
    Statement checkpoint(connection, "PRAGMA wal_checkpoint(TRUNCATE)");
    if (checkpoint.step() && checkpoint.integer(0) != 0) refuse();
  }
  // SQLite removes it with the last connection.
  if (fs::exists(target + "-wal")) refuse();
}

}  // namespace

BackupSummary back_up(const std::string& source, const std::string& target, const BackupOptions& options,
                      const std::function<void(std::uint64_t, std::uint64_t)>& progress) {
  open_existing(source);
  refuse_network_file_system(source);
  check_target(source, target, options.replace);
  const auto replaced = lock_replaced(target);
  UnfinishedCopy unfinished(target + ".part");
  auto summary = make_copy(source, unfinished.path(), progress);
  summary.bytes = fs::file_size(unfinished.path());
  if (replaced) close_replaced(target);
  unfinished.rename_to(target, options.replace);
  return summary;
}

}  // namespace lamprey::storage
