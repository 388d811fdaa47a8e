#include "storage/connection.hpp"

namespace lamprey::storage {

StorageError::Kind error_kind(int code) {
  switch (code & 0xff) {
    case SQLITE_FULL:
      return StorageError::Kind::full;
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return StorageError::Kind::busy;
    case SQLITE_CORRUPT:
      return StorageError::Kind::corrupt;
    case SQLITE_NOTADB:
      return StorageError::Kind::not_a_database;
    default:
      return StorageError::Kind::input_output;
  }
}

Connection::Connection(const std::string& path, int flags, const std::string& vfs) : path_(path) {
  sqlite3* opened = nullptr;
  const int code = sqlite3_open_v2(path.c_str(), &opened, flags, vfs.empty() ? nullptr : vfs.c_str());
  handle_.reset(opened);  // even a failed opening leaves a handle, which holds the reason
  if (code != SQLITE_OK) fail(code, "open");
  sqlite3_extended_result_codes(opened, 1);
  sqlite3_busy_timeout(opened, busy_milliseconds);
}

void Connection::execute(const std::string& sql) const {
  const int code = sqlite3_exec(handle(), sql.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) fail(code, sql.substr(0, sql.find('\n')));
}

void Connection::fail(int code, const std::string& doing) const {
  const std::string reason = handle() != nullptr ? sqlite3_errmsg(handle()) : sqlite3_errstr(code);
  throw StorageError(error_kind(code), path_ + ": " + doing + ": " + reason + " (SQLite " + std::to_string(code) + ")");
}

Transaction::Transaction(const Connection& connection, Mode mode) : connection_(connection) {
  connection_.execute(mode == Mode::write ? "BEGIN IMMEDIATE" : "BEGIN");
}

Transaction::~Transaction() {
  // After some errors SQLite has rolled back already.
  if (sqlite3_get_autocommit(connection_.handle()) == 0) {
    sqlite3_exec(connection_.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
  }
}

void Transaction::commit() {
  connection_.execute("COMMIT");
}

}  // namespace lamprey::storage
