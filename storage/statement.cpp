#include "storage/statement.hpp"

#include <algorithm>
#include <cerrno>
#include <string>

namespace lamprey::storage {

Statement::Statement(const Connection& connection, std::string_view sql) : connection_(&connection) {
  sqlite3_stmt* prepared = nullptr;
  errno = 0;
  const int code = sqlite3_prepare_v3(connection.handle(), sql.data(), static_cast<int>(sql.size()),
                                      SQLITE_PREPARE_PERSISTENT, &prepared, nullptr);
  statement_.reset(prepared);
  if (code != SQLITE_OK) connection.fail(code, std::string(sql));
}

void Statement::check(int code) const {
  if (code != SQLITE_OK) connection_->fail(code, sqlite3_sql(statement_.get()));
}

void Statement::bind(int index, std::string_view text) {
  // SQLite takes a null pointer for NULL, which an empty view may hold.
  check(sqlite3_bind_text64(statement_.get(), index, text.empty() ? "" : text.data(), text.size(), SQLITE_STATIC,
                            SQLITE_UTF8));
}

void Statement::bind(int index, std::span<const std::uint8_t> blob) {
  if (blob.empty()) {
    check(sqlite3_bind_zeroblob(statement_.get(), index, 0));
  } else {
    check(sqlite3_bind_blob64(statement_.get(), index, blob.data(), blob.size(), SQLITE_STATIC));
  }
}

bool Statement::step() {
  errno = 0;
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) return false;
  // The reason must be read before the reset, which is needed in any case: an unfinished statement would keep the
  // transaction open.
  try {
    connection_->fail(code, sqlite3_sql(statement_.get()));
  } catch (...) {
    reset();
    connection_->forget_pages();
    throw;
  }
}

void Statement::run() {
  while (step()) {
  }
  reset();
}

void Statement::reset() {
  sqlite3_reset(statement_.get());  // repeats the error of the last step, which has been thrown
  sqlite3_clear_bindings(statement_.get());
}

std::string_view Statement::text(int column) const {
  const auto* text = sqlite3_column_text(statement_.get(), column);
  if (text == nullptr) return {};
  return {reinterpret_cast<const char*>(text),
          static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column))};
}

std::span<const std::uint8_t> Statement::blob(int column) const {
  const auto* bytes = static_cast<const std::uint8_t*>(sqlite3_column_blob(statement_.get(), column));
  if (bytes == nullptr) return {};
  return {bytes, static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column))};
}

std::optional<experiment::Digest> Statement::digest(int column) const {
  const auto bytes = blob(column);
  experiment::Digest digest{};
  if (type(column) != SQLITE_BLOB || bytes.size() != digest.size()) return std::nullopt;
  std::ranges::copy(bytes, digest.begin());
  return digest;
}

}  // namespace lamprey::storage
