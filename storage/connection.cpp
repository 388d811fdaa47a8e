#include "storage/connection.hpp"

#include <cerrno>
#include <cstring>

namespace lamprey::storage {

namespace {

using Kind = StorageError::Kind;

bool is_failed_operation(int code) {
  return (code & 0xff) == SQLITE_IOERR || (code & 0xff) == SQLITE_CANTOPEN;
}

/// The system's reason for the operation that has just failed, 0 if there was none. Not sqlite3_system_errno, which a
/// COMMIT that fails leaves as it was.
int last_system_error(sqlite3* handle) {
  sqlite3_vfs* vfs = nullptr;
  sqlite3_file_control(handle, "main", SQLITE_FCNTL_VFS_POINTER, static_cast<void*>(&vfs));
  if (vfs == nullptr || vfs->xGetLastError == nullptr) return sqlite3_system_errno(handle);
  return vfs->xGetLastError(vfs, 0, nullptr);
}

}  // namespace

Kind system_error_kind(int system_error) {
  switch (system_error) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:  // a limit on the size of files, which may be raised
      return Kind::full;
    case EROFS:
    case EACCES:
    case EPERM:
      return Kind::read_only;
    default:
      return Kind::input_output;
  }
}

void throw_system_error(const std::string& path, const char* doing) {
  const int reason = errno;
  throw StorageError(system_error_kind(reason), path + ": " + doing + ": " + std::strerror(reason));
}

Kind error_kind(int code, int system_error) {
  switch (code & 0xff) {
    case SQLITE_FULL:
      return Kind::full;
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
    case SQLITE_PROTOCOL:  // others have kept getting in first
      return Kind::busy;
    case SQLITE_CORRUPT:
      return Kind::corrupt;
    case SQLITE_NOTADB:
      return Kind::not_a_database;
    case SQLITE_PERM:
      return Kind::read_only;
    case SQLITE_READONLY:
      // The file has been moved: it can be written, but nobody will find it.
      return code == SQLITE_READONLY_DBMOVED ? Kind::input_output : Kind::read_only;
    case SQLITE_CANTOPEN:
      return system_error == ENOENT ? Kind::missing : system_error_kind(system_error);
    default:
      return is_failed_operation(code) ? system_error_kind(system_error) : Kind::input_output;
  }
}

Connection::Connection(const std::string& path, int flags, const std::string& vfs) : path_(path) {
  sqlite3* opened = nullptr;
  errno = 0;
  const int code = sqlite3_open_v2(path.c_str(), &opened, flags, vfs.empty() ? nullptr : vfs.c_str());
  handle_.reset(opened);  // even a failed opening leaves a handle, which holds the reason
  if (code != SQLITE_OK) fail(code, "open");
  sqlite3_extended_result_codes(opened, 1);
  sqlite3_busy_timeout(opened, busy_milliseconds);
}

void Connection::execute(const std::string& sql) const {
  errno = 0;  // what fail() finds must be of this operation
  const int code = sqlite3_exec(handle(), sql.c_str(), nullptr, nullptr, nullptr);
  if (code == SQLITE_OK) return;
  try {
    fail(code, sql.substr(0, sql.find('\n')));
  } catch (...) {
    forget_pages();
    throw;
  }
}

void Connection::fail(int code, const std::string& doing) const {
  std::string reason = handle() != nullptr ? sqlite3_errmsg(handle()) : sqlite3_errstr(code);
  const int system_error = handle() != nullptr && is_failed_operation(code) ? last_system_error(handle()) : 0;
  if (system_error != 0) reason += std::string(": ") + std::strerror(system_error);
  throw StorageError(error_kind(code, system_error),
                     path_ + ": " + doing + ": " + reason + " (SQLite " + std::to_string(code) + ")");
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
