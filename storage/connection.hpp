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

  /// Throws the StorageError that SQLite's result code stands for: the file, what was being done, SQLite's own text.
  [[noreturn]] void fail(int code, const std::string& doing) const;

 private:
  struct Close {
    void operator()(sqlite3* handle) const noexcept { sqlite3_close(handle); }
  };
  std::string path_;
  std::unique_ptr<sqlite3, Close> handle_;
};

/// Which kind of StorageError an (extended) result code is.
StorageError::Kind error_kind(int code);

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
