#pragma once

#include "storage/results_store.hpp"

#include <memory>
#include <sqlite3.h>
#include <string>

namespace lamprey::storage {

/// How long a statement waits for another program that holds a lock, such as a user's own write transaction.
inline constexpr int busy_milliseconds = 1000;

/// An open SQLite connection; closed with the object. Statements of the connection must be gone by then.
/// Not thread-safe.
class Connection {
 public:
  /// `flags` as for sqlite3_open_v2; `vfs` empty: the default one. Throws StorageError.
  Connection(const std::string& path, int flags, const std::string& vfs);

  sqlite3* handle() const { return handle_.get(); }
  const std::string& path() const { return path_; }

  /// Runs one or several statements whose rows nobody wants. Throws StorageError.
  void execute(const std::string& sql) const;

  /// Throws the StorageError that SQLite's result code stands for: the file, what was being done, SQLite's own text,
  /// and the system's reason where there is one: errno must have been 0 before the operation.
  [[noreturn]] void fail(int code, const std::string& doing) const;

  /// Drops pages that are kept in memory. To be called after a failure, when its statement has been reset: a page that
  /// could not be used must be read again when the fault is gone.
  void forget_pages() const noexcept { sqlite3_db_release_memory(handle_.get()); }

 private:
  struct Close {
    void operator()(sqlite3* handle) const noexcept { sqlite3_close(handle); }
  };
  std::string path_;
  std::unique_ptr<sqlite3, Close> handle_;
};

/// Which kind of StorageError an (extended) result code is; `system_error` is the errno that came with it, 0 if none
/// is known.
StorageError::Kind error_kind(int code, int system_error = 0);

/// The same of an operation of ours on a file.
StorageError::Kind system_error_kind(int system_error);

/// Throws the StorageError that errno stands for.
[[noreturn]] void throw_system_error(const std::string& path, const char* doing);

/// BEGIN IMMEDIATE (or a read transaction) … COMMIT; rolled back unless committed.
class Transaction {
 public:
  enum class Mode { read, write };
  Transaction(const Connection& connection, Mode mode);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  void commit();

 private:
  const Connection& connection_;
};

}  // namespace lamprey::storage
