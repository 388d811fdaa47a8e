#include "storage/migration.hpp"

#include "experiment/sweep.hpp"
#include "storage/schema.hpp"
#include "storage/sweep_row.hpp"

#include <algorithm>

namespace lamprey::storage {

namespace {

std::optional<experiment::SweepGrid> grid_of(const Sweep& sweep) {
  idl::SweepSpecification specification;
  if (!specification.ParseFromString(sweep.what.specification)) return std::nullopt;
  try {
    return experiment::SweepGrid(specification);
  } catch (const experiment::InvalidInput&) {
    return std::nullopt;  // `lamprey verify` says what is wrong with it
  }
}

/// Writes anew the parameters of the sweep's rows that have other ones. Returns how many.
std::uint64_t rewrite_parameters(const Connection& connection, const Sweep& sweep) {
  const auto grid = grid_of(sweep);
  if (!grid) return 0;
  std::uint64_t rewritten = 0;
  // The scan goes by the key, which no update changes.
  Statement rows(connection, "SELECT job, parameters FROM job WHERE sweep = ? AND parameters IS NOT NULL ORDER BY job");
  Statement update(connection, "UPDATE job SET parameters = ? WHERE sweep = ? AND job = ?");
  rows.bind(1, sweep.row);
  while (rows.step()) {
    const std::uint64_t job = rows.bits(0);
    if (job >= grid->jobs()) continue;
    const std::string parameters = experiment::to_json(grid->job(job).parameters);
    if (rows.text(1) == parameters) continue;
    update.with(std::string_view(parameters), sweep.row, job).run();
    ++rewritten;
  }
  return rewritten;
}

void add_measures(const Connection& connection) {
  connection.execute("ALTER TABLE job ADD COLUMN \"measures\" TEXT");
}

const SchemaObject& table_of(const std::vector<SchemaObject>& all, const std::string& name) {
  return *std::ranges::find(all, name, &SchemaObject::name);
}

/// The table with the states that it may have now, and new columns at their defaults. The new one takes the old one's
/// place under its name.
void rebuild_sweep(const Connection& connection, SchemaObject table) {
  std::string kept;
  Statement columns(connection, "SELECT name FROM pragma_table_info('sweep')");
  while (columns.step()) kept += (kept.empty() ? "" : ", ") + quoted(std::string(columns.text(0)));
  columns.reset();
  table.name = "sweep_of_version_3";
  connection.execute(table_sql(table));
  connection.execute("INSERT INTO " + table.name + " (" + kept + ") SELECT " + kept + " FROM sweep");
  connection.execute("DROP TABLE sweep");
  connection.execute("ALTER TABLE " + table.name + " RENAME TO sweep");
}

void refuse_dangling_references(const Connection& connection) {
  Statement check(connection, "PRAGMA foreign_key_check");
  if (!check.step()) return;
  throw StorageError(StorageError::Kind::corrupt, connection.path() + ": cannot be brought up to date: row " +
                                                      std::to_string(check.integer(1)) + " of the table " +
                                                      std::string(check.text(0)) + " names a row of the table " +
                                                      std::string(check.text(2)) + " that does not exist");
}

void add_execution(const Connection& connection) {
  const auto all = tables();
  rebuild_sweep(connection, table_of(all, "sweep"));
  for (const std::string name : {"job", "worker"}) {
    for (const auto& column : columns_since_version_3(name)) {
      connection.execute("ALTER TABLE " + name + " ADD COLUMN " + quoted(column.name) + " " + column.definition);
    }
  }
  for (const auto* name : {"attempt", "checkpoint", "audit", "audit_job"}) {
    connection.execute(table_sql(table_of(all, name)));
  }
  refuse_dangling_references(connection);
}

void add_recordings(const Connection& connection) {
  const auto all = tables();
  for (const auto* name : {"recording", "robot_evaluation"}) connection.execute(table_sql(table_of(all, name)));
}

}  // namespace

TablesMayBeRebuilt::TablesMayBeRebuilt(const Connection& connection) : connection_(connection) {
  connection_.execute("PRAGMA foreign_keys = OFF; PRAGMA legacy_alter_table = ON");
}

TablesMayBeRebuilt::~TablesMayBeRebuilt() {
  // Neither pragma touches the file: they cannot fail for its sake.
  sqlite3_exec(connection_.handle(), "PRAGMA legacy_alter_table = OFF; PRAGMA foreign_keys = ON", nullptr, nullptr,
               nullptr);
}

std::string bring_up_to_date(const Connection& connection) {
  const int stored = stored_schema_version(connection);
  std::string done;
  if (stored < schema_version) {
    if (stored < first_version_with_measures) add_measures(connection);
    if (stored < first_version_with_execution) add_execution(connection);
    if (stored < first_version_with_recordings) add_recordings(connection);
    record_schema_version(connection);
    done = "schema version " + std::to_string(stored) + " to " + std::to_string(schema_version);
  }
  // Views name the parameters: those of another registry are not this program's.
  if (!refresh_views(connection) && done.empty()) return done;
  std::uint64_t rewritten = 0;
  for (const auto& sweep : read_sweeps(connection)) rewritten += rewrite_parameters(connection, sweep);
  if (rewritten > 0) {
    done += (done.empty() ? "" : ", ") + std::string("parameters of ") + std::to_string(rewritten) + " jobs completed";
  }
  return done;
}

}  // namespace lamprey::storage
