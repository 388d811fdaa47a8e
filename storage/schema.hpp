#pragma once

#include "storage/connection.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace lamprey::storage {

/// Version of the tables; PRAGMA user_version. Views are not part of it: they follow the parameter registry.
///   1  the first
///   2  job.measures
///   3  how sweeps are run and stopped, reuse, attempts, checkpoints, audits, and more about jobs and workers
///   4  what robots recorded
inline constexpr int schema_version = 4;
inline constexpr int first_version_with_measures = 2;
inline constexpr int first_version_with_execution = 3;
inline constexpr int first_version_with_recordings = 4;

/// PRAGMA application_id: "LMPR".
inline constexpr std::uint32_t application_id = 0x4c4d5052;

struct Column {
  std::string name;
  std::string definition;  ///< of a table's column: type and constraints; of a view's column: its expression
  std::string description;
};

/// A table or view, with what schema_description says about it: one list is both the SQL and its documentation.
struct SchemaObject {
  std::string name;
  std::string description;
  std::vector<Column> columns;
  std::string rest;  ///< of a table: further constraints; of a view: FROM, WHERE and GROUP BY
};

std::vector<SchemaObject> tables();

/// The public contract: result, trace, measure, progress, provenance, gap, one view per figure, and others that
/// docs/formats/database.md describes. Their columns derive from the parameter registry.
std::vector<SchemaObject> views();

std::string table_sql(const SchemaObject& table);

/// The columns of `table` that have come with schema version 3, as ALTER TABLE takes them; in order.
std::vector<Column> columns_since_version_3(const std::string& table);

std::string view_sql(const SchemaObject& view);

/// Makes the tables of an empty database and its row of `database`. To be called in a transaction.
void create_tables(const Connection& connection);

/// Drops and makes anew views and descriptions if they aren't those of this program; whether that was so. To be called
/// in a transaction.
bool refresh_views(const Connection& connection);

/// PRAGMA user_version.
int stored_schema_version(const Connection& connection);

/// The version, and when it came, in `schema_version` and the header. To be called in a transaction.
void record_schema_version(const Connection& connection);

/// SHA-256 in hex over the views' SQL and all descriptions as they stand in the database.
std::string stored_schema_fingerprint(const Connection& connection);

/// `name` in double quotes, as an SQL identifier.
std::string quoted(const std::string& name);

std::int64_t unix_milliseconds();

}  // namespace lamprey::storage
