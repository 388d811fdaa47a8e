#include "storage/migration.hpp"

#include "experiment/sweep.hpp"
#include "storage/schema.hpp"
#include "storage/sweep_row.hpp"

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

}  // namespace

std::string bring_up_to_date(const Connection& connection) {
  const int stored = stored_schema_version(connection);
  std::string done;
  if (stored < schema_version) {
    if (stored < first_version_with_measures) add_measures(connection);
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
