#pragma once

#include "storage/results_store.hpp"
#include "storage/schema.hpp"
#include "storage/statement.hpp"

#include <optional>
#include <string>
#include <vector>

namespace lamprey::storage {

/// Names of the columns of `sweep` that read_sweep_row takes, between commas; of a database of an older version, with
/// defaults for those that it lacks.
std::string sweep_columns(int version = schema_version);

/// The present row of a statement that selects sweep_columns(). Throws StorageError (corrupt) if id or state aren't
/// what a ResultsStore writes.
Sweep read_sweep_row(const Statement& row, const std::string& path);

/// In order of submission; also of a database of an older version.
std::vector<Sweep> read_sweeps(const Connection& connection);

/// The sweep whose `column` (unique: sweep, id or name) has the value; also of a database of an older version.
template <typename Value>
std::optional<Sweep> find_sweep_by(const Connection& connection, const std::string& column, const Value& value) {
  Statement find(connection,
                 "SELECT " + sweep_columns(stored_schema_version(connection)) + " FROM sweep WHERE " + column + " = ?");
  find.bind(1, value);
  if (!find.step()) return std::nullopt;
  return read_sweep_row(find, connection.path());
}

/// SHA-256 over every column of `sweep` that is not counted or a matter of the moment, and that nothing else stored
/// repeats in full. What version 3 has added counts where it isn't the default, so that older checksums stay.
experiment::Digest sweep_checksum(const NewSweep& sweep, std::uint32_t science_version);

/// The build that a worker reported; nothing if it has no row.
std::optional<std::string> find_build(const Connection& connection, std::uint64_t worker);

/// The row of `database`.
struct DatabaseRow {
  experiment::Id128 id;
  std::uint32_t science_version = 0;
  std::uint64_t epoch = 0;
};
DatabaseRow read_database_row(const Connection& connection);

}  // namespace lamprey::storage
