#pragma once

#include "experiment/identifiers.hpp"
#include "storage/connection.hpp"

#include <concepts>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <sqlite3.h>
#include <string_view>

namespace lamprey::storage {

/// A prepared statement. Text and blobs are bound without copying: they must live until the statement is reset.
/// Every function throws StorageError. The connection must outlive the statement and stay where it is.
class Statement {
 public:
  Statement(const Connection& connection, std::string_view sql);

  /// Binds parameter `index`, counted from 1. Unsigned 64-bit numbers keep their bits: those from 2^63 on read as
  /// negative in SQL.
  template <std::integral Integer>
  void bind(int index, Integer value) {
    check(sqlite3_bind_int64(statement_.get(), index, static_cast<sqlite3_int64>(value)));
  }
  void bind(int index, double value) { check(sqlite3_bind_double(statement_.get(), index, value)); }
  void bind(int index, std::string_view text);
  void bind(int index, std::span<const std::uint8_t> blob);
  void bind(int index, std::nullptr_t) { check(sqlite3_bind_null(statement_.get(), index)); }
  template <typename Type>
  void bind(int index, const std::optional<Type>& value) {
    if (value) {
      bind(index, *value);
    } else {
      bind(index, nullptr);
    }
  }

  /// Binds all parameters in order.
  template <typename... Values>
  Statement& with(const Values&... values) {
    int index = 0;
    (bind(++index, values), ...);
    return *this;
  }

  /// Whether there is a further row.
  bool step();

  /// Steps to the end and makes the statement ready for the next use.
  void run();

  void reset();

  int columns() const { return sqlite3_column_count(statement_.get()); }
  std::string_view name(int column) const { return sqlite3_column_name(statement_.get(), column); }

  /// Values of the present row, columns counted from 0. Views are valid until the next step or reset.
  int type(int column) const { return sqlite3_column_type(statement_.get(), column); }
  bool is_null(int column) const { return type(column) == SQLITE_NULL; }
  std::int64_t integer(int column) const { return sqlite3_column_int64(statement_.get(), column); }
  std::uint64_t bits(int column) const { return static_cast<std::uint64_t>(integer(column)); }
  double real(int column) const { return sqlite3_column_double(statement_.get(), column); }
  std::string_view text(int column) const;
  std::span<const std::uint8_t> blob(int column) const;
  std::optional<experiment::Digest> digest(int column) const;

 private:
  void check(int code) const;

  struct Finalize {
    void operator()(sqlite3_stmt* statement) const noexcept { sqlite3_finalize(statement); }
  };
  const Connection* connection_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

}  // namespace lamprey::storage
